"""A class at work: many browsers, connections that say nothing, a worker that dies, a shared page."""

from __future__ import annotations

import json
import os
import re
import signal
import socket
import time
import urllib.error
import urllib.request
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from http.client import HTTPConnection
from pathlib import Path
from urllib.parse import urlsplit

import pytest

from sketch2shape.ui.app import PAGE_MODULES
from sketch2shape.ui.guard import Refusal, Uploads

from .here import BACK, FRONT
from .server import Address, start_app

SIDES = [(f[a], f[(a + 1) % 4]) for f in (FRONT, BACK) for a in range(4)]
STROKES = {"strokes": [{"points": line} for line in [*SIDES, *zip(FRONT, BACK, strict=True)]]}
PARTS = ["/", "/style.css", "/icon.svg", "/viewer.js", "/about", *(f"/{name}.js" for name in PAGE_MODULES)]
BROWSERS, HALF_OPEN = 30, 120


def connect(address: str) -> HTTPConnection:
    place = urlsplit(address)
    return HTTPConnection(str(place.hostname), place.port, timeout=120)


def half_open(address: str, stack: ExitStack) -> None:
    """A connection that begins a request and says no more."""
    place = urlsplit(address)
    line = stack.enter_context(socket.create_connection((place.hostname, place.port), timeout=60))
    line.sendall(b"POST /api/sketch HTTP/1.1\r\nHost: ")


def browse(address: str) -> int:
    """What a fresh browser asks for; how many answers were whole."""
    whole = 0
    line = connect(address)
    for part in PARTS:
        line.request("GET", part)
        answer = line.getresponse()
        whole += answer.status == 200 and len(answer.read()) > 0
    line.request("POST", "/api/sketch", json.dumps(STROKES), {"Content-Type": "application/json"})
    answer = line.getresponse()
    whole += answer.status == 200 and len(json.loads(answer.read())["objects"]) == 1
    line.close()
    return whole


def test_thirty_browsers_are_served_though_others_keep_the_door_open(address: Address) -> None:
    with ExitStack() as stack:
        for _ in range(HALF_OPEN):
            half_open(address, stack)
        with ThreadPoolExecutor(BROWSERS) as crowd:
            assert list(crowd.map(browse, [address] * BROWSERS)) == [len(PARTS) + 1] * BROWSERS


def test_who_says_nothing_is_let_go(address: Address) -> None:
    place = urlsplit(address)
    with socket.create_connection((place.hostname, place.port), timeout=60) as line:
        line.sendall(b"GET / HTTP/1.1\r\n")
        begin = time.monotonic()
        assert line.recv(100) == b""
        assert time.monotonic() - begin < 40


def workers_of(pid: int) -> list[int]:
    """Processes that work for the app: children, and children of children."""
    found: list[int] = []
    for status in Path("/proc").glob("[0-9]*/status"):
        try:
            parent = re.search(r"^PPid:\s*(\d+)", status.read_text(), re.MULTILINE)
        except OSError:
            continue
        if parent and int(parent[1]) == pid:
            found += [int(status.parent.name), *workers_of(int(status.parent.name))]
    return found


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="no /proc to find the workers in")
def test_a_worker_that_is_killed_is_told_and_replaced(address: Address) -> None:
    browse(address)
    with ThreadPoolExecutor(6) as crowd:
        work = [crowd.submit(browse, address) for _ in range(6)]
        time.sleep(0.3)
        for pid in workers_of(address.pid):
            if b"spawn_main" in (Path("/proc") / str(pid) / "cmdline").read_bytes():
                os.kill(pid, signal.SIGKILL)
        assert all(w.result() >= len(PARTS) for w in work)  # pages are whole, an answer may be an apology
    assert browse(address) == len(PARTS) + 1


def test_bodies_together_are_limited() -> None:
    uploads = Uploads(10, together=15)
    uploads.hold(10)
    with pytest.raises(Refusal, match="too much"):
        uploads.hold(6)
    uploads.hold(5)


def ask(address: str, cookie: str = "") -> tuple[int, str]:
    request = urllib.request.Request(address, headers={"Cookie": cookie} if cookie else {})
    opener = urllib.request.build_opener(NoRedirect)
    try:
        with opener.open(request, timeout=60) as answer:
            return answer.status, answer.headers.get("Set-Cookie", "")
    except urllib.error.HTTPError as error:
        return error.code, error.headers.get("Set-Cookie", "")


class NoRedirect(urllib.request.HTTPRedirectHandler):
    def redirect_request(self, *_: object) -> None:
        return None


def test_a_shared_page_is_for_those_who_have_its_key() -> None:
    with start_app("--share") as address:
        bare, _, key = address.partition("?key=")
        assert len(key) >= 20
        for part in ("", "style.css", "api/lift", f"?key={key[:-1]}x", "?key=", f"style.css?key={key}"):
            assert ask(bare + part)[0] == 403, part
        status, cookie = ask(address)
        assert status == 303
        assert "HttpOnly" in cookie
        assert "SameSite=lax" in cookie
        shown = cookie.partition(";")[0]
        assert ask(bare, shown)[0] == 200
        assert ask(bare + "about", shown)[0] == 200
        assert ask(bare, shown[:-1] + "~")[0] == 403
        line = connect(bare)
        line.request("GET", "/", headers={"Cookie": shown, "Host": "evil.example"})
        assert line.getresponse().status == 421  # the other guards stay
