"""Small files that claim to be huge: refused from the header; each in a fresh process that is measured."""

from __future__ import annotations

import io
import json
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

from PIL import Image

_MEASURE = """
import json, resource, sys, time
from sketch2shape.errors import LimitError, Sketch2ShapeError
from sketch2shape.reading.read import read_picture
from sketch2shape.writing import quiet_stderr
read_picture({sound!r})
begin, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
try:
    with quiet_stderr():
        read_picture({bomb!r})
    kind = "read"
except Sketch2ShapeError as error:
    kind = type(error).__name__
seconds, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(json.dumps([kind, seconds, after / 1024, (after - before) / 1024]))
"""


def run() -> dict[str, object]:
    """Every bomb, its time and the peak memory of the process that met it."""
    findings, slowest, peak = [], 0.0, 0.0
    with tempfile.TemporaryDirectory() as folder:
        sound = Path(folder, "sound.png")
        Image.new("L", (9, 9)).save(sound)
        for name, data in bombs().items():
            bomb = Path(folder, name)
            bomb.write_bytes(data)
            code = _MEASURE.format(sound=str(sound), bomb=str(bomb))
            done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
            kind, seconds, megabytes, _ = json.loads(done.stdout)
            slowest, peak = max(slowest, seconds), max(peak, megabytes)
            if kind not in ("LimitError", "UnreadableError") or seconds > 0.3 or megabytes > 200:
                findings.append(f"{name}: {kind}, {seconds:.2f} s, {megabytes:.0f} MB")
    return {
        "bombs": len(bombs()),
        "slowest, s": round(slowest, 3),
        "largest process, MB": round(peak),
        "findings": findings,
    }


def _chunk(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def _png(width: int, height: int, kind: int = 0, bits: int = 8, extra: bytes = b"", rows: int = 3000) -> bytes:
    """A PNG with a true header and compressed rows of nothing."""
    header = _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0))
    press = zlib.compressobj(9)
    row = bytes(1 + width * {0: 1, 2: 3, 6: 4}[kind] * bits // 8)
    data = b"".join(press.compress(row) for _ in range(min(rows, height))) + press.flush()
    return b"\x89PNG\r\n\x1a\n" + header + extra + _chunk(b"IDAT", data) + _chunk(b"IEND", b"")


def _tiff(width: int, height: int, *, strips: int = 1, offset: int = 8) -> bytes:
    tags = [
        (256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1),
        (273, 4, strips, offset), (277, 3, 1, 1), (278, 4, 1, height), (279, 4, strips, 10),
    ]  # fmt: skip
    body = b"".join(struct.pack("<HHII", *tag) for tag in tags)
    return b"II*\0" + struct.pack("<I", 8) + struct.pack("<H", len(tags)) + body + bytes(4) + bytes(64)


def _gif(width: int, height: int, frame: tuple[int, int] | None = None) -> bytes:
    w, h = frame or (width, height)
    screen = struct.pack("<HHBBB", width, height, 0xF0, 0, 0) + b"\0\0\0\xff\xff\xff"
    return b"GIF89a" + screen + b"," + struct.pack("<HHHHB", 0, 0, w, h, 0) + b"\x02\x02\x4c\x01\0;"


def _jpeg(width: int, height: int) -> bytes:
    out = io.BytesIO()
    Image.new("L", (16, 16)).save(out, "JPEG")
    data = bytearray(out.getvalue())
    at = data.index(b"\xff\xc0")
    data[at + 5 : at + 9] = struct.pack(">HH", height, width)
    return bytes(data)


def _webp(kind: bytes, body: bytes) -> bytes:
    chunk = kind + struct.pack("<I", len(body)) + body
    return b"RIFF" + struct.pack("<I", 4 + len(chunk)) + b"WEBP" + chunk


def _bmp(width: int, height: int, compression: int = 0) -> bytes:
    info = struct.pack("<IiiHHIIiiII", 40, width, height, 1, 8, compression, 0, 0, 0, 2, 0)
    return b"BM" + struct.pack("<IHHI", 1000, 0, 0, 62) + info + b"\0\0\0\0\xff\xff\xff\0" + bytes(900)


def bombs() -> dict[str, bytes]:
    """Name -> file."""
    text = _chunk(b"zTXt", b"Comment\0\0" + zlib.compress(bytes(200_000_000), 9))
    profile = _chunk(b"iCCP", b"p\0\0" + zlib.compress(bytes(200_000_000), 9))
    return {
        "grey.png": _png(30_000, 30_000),
        "rgb.png": _png(30_000, 30_000, 2),
        "rgba16.png": _png(20_000, 20_000, 6, 16, rows=50),
        "wide.png": _png(60_000_000, 1),
        "tall.png": _png(1, 60_000_000),
        "largest.png": _png(2**31 - 1, 2**31 - 1, rows=0),
        "text.png": _png(30_000, 30_000, extra=text, rows=1),
        "profile.png": _png(30_000, 30_000, extra=profile, rows=1),
        "large.jpg": _jpeg(65_500, 65_500),
        "wide.jpg": _jpeg(65_500, 2_000),
        "large.tif": _tiff(100_000, 100_000),
        "strips.tif": _tiff(100_000, 100_000, strips=2**28),
        "largest.tif": _tiff(2**32 - 1, 2**32 - 1),
        "large.gif": _gif(65_535, 65_535),
        "frame.gif": _gif(10, 10, (65_535, 65_535)),
        "large.bmp": _bmp(50_000, 50_000),
        "rle.bmp": _bmp(60_000, 60_000, 1),
        "negative.bmp": _bmp(50_000, -50_000),
        "canvas.webp": _webp(b"VP8X", b"\x10\0\0\0" + b"\xff\xff\xff" * 2),
        "lossless.webp": _webp(b"VP8L", b"\x2f" + struct.pack("<I", 16383 | 16383 << 14) + bytes(20)),
        "lossy.webp": _webp(b"VP8 ", b"\x10\0\0\x9d\x01\x2a" + struct.pack("<HH", 16383, 16383) + bytes(20)),
        "large.pgm": b"P5\n40000 40000\n255\n" + bytes(100),
        "digits.pgm": b"P2\n" + b"9" * 5000 + b" 9\n255\n",
    }
