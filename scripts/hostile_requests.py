"""Send the web app requests that no page of its own would send, and see that it answers each properly and goes on.

    python scripts/hostile_requests.py [COUNT] [SEED] [ui|serve]

Starts `sketch2shape ui`, or `serve`, on a free port of this machine, sends COUNT (1,000) requests made from SEED, and
prints how many got which status and how the memory of the processes grew. Exits 1 if a status was wrong or the app
stopped answering.
"""

from __future__ import annotations

import random
import re
import socket
import struct
import subprocess
import sys
import zlib
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

TIMEOUT = 60.0
#: what the service may answer to any of these requests: it has fewer pages, and refuses in other places
REFUSED = frozenset({400, 403, 404, 405, 408, 413, 415, 421, 422, 431, 0})
POST = b"POST /api/lift HTTP/1.1\r\nHost: 127.0.0.1\r\n"


@dataclass(frozen=True)
class Attack:
    """A request as bytes, and the statuses that are proper; 0 stands for a connection closed without an answer.

    With `hang_up` the sender says that nothing more will come, in the middle of what it announced.
    """

    kind: str
    request: bytes
    statuses: frozenset[int]
    hang_up: bool = False


def http(method: str, path: str, headers: dict[str, str], body: bytes = b"", host: str = "127.0.0.1") -> bytes:
    lines = [f"{method} {path} HTTP/1.1", f"Host: {host}", "Connection: close"]
    lines += [f"{k}: {v}" for k, v in {"Content-Length": str(len(body)), **headers}.items()]
    return "\r\n".join(lines).encode("latin-1") + b"\r\n\r\n" + body


def png_header(width: int, height: int) -> bytes:
    """A PNG that claims to be this large and holds nothing."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + header + chunk(b"IDAT", zlib.compress(b"\0" * 100)) + chunk(b"IEND", b"")


def wrong_host(rng: random.Random) -> Attack:
    host = rng.choice(
        ["evil.example", "127.0.0.1.evil.example", "localhost@evil.example", "127.0.0.1:80:80", " ", "[::2]"]
    )
    path = rng.choice(["/", "/app.js", "/about", "/api/lift"])
    return Attack("wrong Host", http(rng.choice(["GET", "POST"]), path, {}, host=host), frozenset({421, 400}))


def wrong_origin(rng: random.Random) -> Attack:
    headers = {"Content-Type": "application/json", "Origin": rng.choice(["http://evil.example", "null", "file://"])}
    return Attack("wrong Origin", http("POST", "/api/lift", headers, b"{}"), frozenset({403}))


def oversized_claim(rng: random.Random) -> Attack:
    size = rng.choice([10**8, 10**12, 10**18, 10**30])
    headers = {"Content-Type": "image/png", "Content-Length": str(size)}
    return Attack("oversized, by its length", http("POST", "/api/reconstruct", headers), frozenset({413, 400}))


def oversized_stream(rng: random.Random) -> Attack:
    chunk = b"100000\r\n" + b"\0" * 2**20 + b"\r\n"
    head = http("POST", "/api/reconstruct", {"Content-Type": "image/png", "Transfer-Encoding": "chunked"})
    head = head.replace(b"Content-Length: 0\r\n", b"")
    return Attack("oversized, in chunks", head + chunk * rng.choice([5, 6]) + b"0\r\n\r\n", frozenset({413, 0}))


def wrong_type(rng: random.Random) -> Attack:
    kind = rng.choice(["text/plain", "text/html", "application/x-www-form-urlencoded", "", "image", "a" * 5000])
    path = rng.choice(["/api/lift", "/api/stages", "/api/export/stl"])
    return Attack("wrong type", http("POST", path, {"Content-Type": kind}, rng.randbytes(50)), frozenset({415}))


def broken_multipart(rng: random.Random) -> Attack:
    body = b'--x\r\nContent-Disposition: form-data; name="file"; filename="../../etc/passwd"\r\n\r\n' + rng.randbytes(
        200
    )
    headers = {"Content-Type": "multipart/form-data" + rng.choice(["", "; boundary=x", "; boundary=" + "y" * 500])}
    return Attack("broken multipart", http("POST", "/api/reconstruct", headers, body), frozenset({415}))


def no_picture(rng: random.Random) -> Attack:
    body = rng.choice(
        [b"", b"GIF89a", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"%PDF-", b"<svg>", b"BM", b"II*\0"]
    ) + rng.randbytes(rng.choice([0, 10, 3000]))
    kind = rng.choice(["image/png", "image/tiff", "application/octet-stream"])
    proper = frozenset({415, 413, 501})
    return Attack("no picture", http("POST", "/api/reconstruct", {"Content-Type": kind}, body), proper)


def huge_picture(rng: random.Random) -> Attack:
    body = png_header(rng.choice([30000, 60000, 2**31 - 1]), rng.choice([30000, 60000]))
    return Attack(
        "900 megapixels", http("POST", "/api/reconstruct", {"Content-Type": "image/png"}, body), frozenset({413, 415})
    )


def corrections(objects: str, size: str = '"width":100,"height":100') -> str:
    return '{"schema":"sketch2shape-corrections/1",' + size + ',"objects":' + objects + "}"


FALSE_MANNERS = (
    '"noise":-1', '"noise":1e999', '"lines":["wire"]', '"f2_drawn":[1,0,1]', '"f2_drawn":[true]',
    '"page":[[0,0,0],[0,0,0],[0,0,0]]', '"page":[[1e300,0,0],[0,1e300,0],[0,0,1]]',
    '"page":[[NaN,0,0],[0,1,0],[0,0,1]]',
)  # fmt: skip
"""What no report tells of how an object is drawn."""


def bad_json(rng: random.Random) -> Attack:
    point = rng.choice(["[1e999,0]", "[NaN,0]", "[null,0]", '["1",0]', "[1]", "[1e7,0]", "[[],0]", "true"])
    ring = "[" + ",".join([point] * rng.choice([1, 3, 4])) + "]"
    bodies = [
        "{",
        "[]",
        "null",
        "[" * 100_000,
        '{"a":' * 20_000,
        "\x00",
        "{}",
        '{"schema":1}',
        corrections('[{"f1":' + ring + ',"f2":' + ring + "}]"),
        corrections('[{"f1":[[0,0],[9,0],[0,9]],"d":[5,5]}]', '"width":1e9,"height":-1'),
        corrections(rng.choice(["{}", "[[]]", '[{"f1":"/etc/passwd"}]', "7"])),
        corrections('[{"f1":[[0,0],[9,0],[0,9]],"d":[5,5],' + rng.choice(FALSE_MANNERS) + "}]"),
        '{"front":' + ring + ',"back":' + ring + "}",
        '{"picture":"/etc/passwd"}',
        '{"picture":[],"corrections":{}}',
    ]
    body = rng.choice(bodies)
    path = rng.choice(["/api/lift", "/api/stages", "/api/connect", "/api/export/stl", "/api/export/..%2f..%2fx"])
    proper = frozenset({400, 404, 415})
    return Attack("bad JSON", http("POST", path, {"Content-Type": "application/json"}, body.encode()), proper)


def strange_path(rng: random.Random) -> Attack:
    path = rng.choice(
        [
            "/../../etc/passwd",
            "/examples/../../etc/passwd.png",
            "/examples/%2e%2e%2fsecret.png",
            "/page/index.html",
            "//evil.example/",
            "/%00",
            "/examples/" + "a" * 8000 + ".png",
            "/api/export/",
            "/static/../app.py",
            "/.git/config",
            "/app.js/../jobs.py",
        ]
    )
    return Attack("strange path", http("GET", path, {}), frozenset({404}))


def strange_method(rng: random.Random) -> Attack:
    method = rng.choice(["PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "BREW", "GET"])
    path = "/api/lift" if method == "GET" else rng.choice(["/", "/api/lift"])
    return Attack("strange method", http(method, path, {}), frozenset({405, 400, 404}))


def broken_http(rng: random.Random) -> Attack:
    request = rng.choice(
        [
            b"\r\n\r\n",
            b"GET\r\n\r\n",
            b"GET / HTTP/9.9\r\n\r\n",
            rng.randbytes(300),
            b"\x16\x03\x01\x02\x00\x01\x00",
            b"GET / HTTP/1.1\r\n\r\n",
            b"GET / HTTP/1.1\r\nHost: a\r\nHost: 127.0.0.1\r\n\r\n",
            POST + b"Content-Length: -5\r\n\r\n",
            POST + b"Content-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n",
            POST + b"Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\nXYZ\r\n",
        ]
    )
    return Attack("broken HTTP", request, frozenset({400, 421, 431, 0}), True)


def long_header(rng: random.Random) -> Attack:
    headers = {"X": "a" * rng.choice([20_000, 100_000, 1_000_000])}  # served if it arrives in one piece
    return Attack("long header", http("GET", "/", headers), frozenset({200, 400, 431, 0}))


def cut_off(_rng: random.Random) -> Attack:
    headers = {"Content-Type": "image/png", "Content-Length": "5000"}
    return Attack("cut off", http("POST", "/api/reconstruct", headers, b"\x89PNG"), frozenset({400, 0}), True)


KINDS: list[Callable[[random.Random], Attack]] = [
    wrong_host, wrong_origin, oversized_claim, oversized_stream, wrong_type, broken_multipart, no_picture,
    huge_picture, bad_json, bad_json, strange_path, strange_method, broken_http, long_header, cut_off,
]  # fmt: skip


def send(port: int, attack: Attack) -> int:
    """The status of the answer, 0 if the connection ended without one."""
    answer = b""
    with socket.create_connection(("127.0.0.1", port), TIMEOUT) as connection:
        try:
            connection.sendall(attack.request)
            if attack.hang_up:
                connection.shutdown(socket.SHUT_WR)
        except OSError:  # it hung up while we were still sending, which is its right; it may have answered before
            pass
        try:
            while b"\r\n" not in answer:
                part = connection.recv(65536)
                if not part:
                    break
                answer += part
        except ConnectionError:
            pass
    words = answer.split(b" ", 2)
    return int(words[1]) if len(words) > 1 and words[1].isdigit() else 0


def memory_of(pid: int) -> int:
    """Resident bytes of a process and its children; 0 where the system does not tell."""
    total, seen = 0, [pid]
    while seen:
        one = seen.pop()
        try:
            status = Path(f"/proc/{one}/status").read_text()
            total += next(int(line.split()[1]) * 1024 for line in status.splitlines() if line.startswith("VmRSS"))
            for children in Path(f"/proc/{one}/task").glob("*/children"):
                seen += map(int, children.read_text().split())
        except (OSError, StopIteration):
            continue
    return total


@dataclass(frozen=True)
class Verdict:
    """What came of it: wrong answers in words, counts of (kind, status), the app's memory before and after in bytes."""

    wrong: list[str]
    counts: Counter[tuple[str, int]]
    memory: tuple[int, int]


def addressed(attack: Attack) -> Attack:
    """The same request to the service."""
    request = attack.request
    for path in (b"/api/reconstruct", b"/api/lift", b"/api/stages", b"/api/export/stl"):
        request = request.replace(b" " + path + b" ", b" /v1/reconstruct ")
    return replace(attack, request=request, statuses=REFUSED)


def run(count: int, seed: int, served: str = "ui") -> Verdict:
    """Start the app, attack it, see that it still serves its page."""
    rng = random.Random(seed)
    command = [sys.executable, "-m", "sketch2shape", served, "--port", "0", "--max-upload", "4"]
    wrong, counts, before = [], Counter[tuple[str, int]](), 0
    with subprocess.Popen(command + ["--no-browser"] * (served == "ui"), stdout=subprocess.PIPE, text=True) as app:
        try:
            told = app.stdout.readline() if app.stdout else ""
            port = int(re.findall(r"\d{4,5}", told)[-1])
            for k in range(count):
                attack = KINDS[k % len(KINDS)](rng)
                if served == "serve":
                    attack = addressed(attack)
                status = send(port, attack)
                counts[attack.kind, status] += 1
                if status not in attack.statuses:
                    wrong.append(f"{attack.kind}: {status} for {attack.request[:160]!r}")
                if k == min(count - 1, 10 * len(KINDS)):
                    before = memory_of(app.pid)
            page = "/" if served == "ui" else "/health"
            if send(port, Attack("own page", http("GET", page, {}), frozenset({200}))) != 200 or app.poll() is not None:
                wrong.append("the app no longer serves its page")
            memory = (before, memory_of(app.pid))
        finally:
            app.terminate()
            app.wait(20)
    return Verdict(wrong, counts, memory)


def main() -> int:
    given = [int(a) for a in sys.argv[1:3]]
    count, seed = given + [1000, 1][len(given) :]
    verdict = run(count, seed, *sys.argv[3:4])
    for (kind, status), times in sorted(verdict.counts.items()):
        print(f"{times:5d}  {kind}: {status or 'closed'}")
    print(
        f"memory after warm-up and at the end: {verdict.memory[0] / 2**20:.0f} and {verdict.memory[1] / 2**20:.0f} MB"
    )
    print("\n".join(verdict.wrong) or f"all {count} requests were answered properly")
    return bool(verdict.wrong)


if __name__ == "__main__":
    sys.exit(main())
