"""Small sound pictures in every core format and many of their variants, to be damaged."""

from __future__ import annotations

import io

import cv2
import numpy as np
from PIL import Image


def drawing(width: int = 96, height: int = 72) -> Image.Image:
    """A box in cabinet projection."""
    pixels = np.full((height, width, 3), 255, np.uint8)
    front = np.array([[12, 24], [60, 24], [60, 62], [12, 62]]) * [width / 96, height / 72]
    back = front + np.array([22, -14]) * [width / 96, height / 72]
    for ring in (front, back):
        cv2.polylines(pixels, [ring.round().astype(np.int32)], True, (0, 0, 0), 1, cv2.LINE_AA)
    for a, b in zip(front, back, strict=True):
        cv2.line(pixels, a.round().astype(int).tolist(), b.round().astype(int).tolist(), (0, 0, 0), 1, cv2.LINE_AA)
    return Image.fromarray(pixels)


def _encoded(image: Image.Image, kind: str, **options: object) -> bytes:
    out = io.BytesIO()
    image.save(out, kind, **options)
    return out.getvalue()


def samples() -> dict[str, bytes]:
    """Name -> encoded picture."""
    rgb = drawing()
    grey, rgba, palette = rgb.convert("L"), rgb.convert("RGBA"), rgb.quantize(16)
    deep = Image.fromarray(np.asarray(grey).astype(np.uint16) * 257)
    exif = Image.Exif()
    exif[0x0112], exif[0x010E] = 6, "a drawing"
    return {
        "grey.png": _encoded(grey, "PNG"),
        "rgba.png": _encoded(rgba, "PNG", exif=exif, dpi=(300, 300)),
        "palette.png": _encoded(palette, "PNG", transparency=0),
        "deep.png": _encoded(deep, "PNG"),
        "moving.png": _encoded(rgb, "PNG", save_all=True, append_images=[rgb.rotate(90)]),
        "rgb.jpg": _encoded(rgb, "JPEG", exif=exif),
        "cmyk.jpg": _encoded(rgb.convert("CMYK"), "JPEG"),
        "progressive.jpg": _encoded(grey, "JPEG", progressive=True, optimize=True),
        "lossy.webp": _encoded(rgb, "WEBP", exif=exif),
        "lossless.webp": _encoded(rgba, "WEBP", lossless=True),
        "moving.webp": _encoded(rgb, "WEBP", save_all=True, append_images=[rgb.rotate(180)]),
        "raw.tif": _encoded(rgb, "TIFF"),
        "lzw.tif": _encoded(rgb, "TIFF", compression="tiff_lzw"),
        "deflate.tif": _encoded(deep, "TIFF", compression="tiff_adobe_deflate"),
        "fax.tif": _encoded(grey.convert("1"), "TIFF", compression="group4"),
        "jpeg.tif": _encoded(rgb, "TIFF", compression="jpeg"),
        "float.tif": _encoded(Image.fromarray(np.asarray(grey).astype(np.float32)), "TIFF"),
        "pages.tif": _encoded(rgb, "TIFF", save_all=True, append_images=[rgb.rotate(180)]),
        "rgb.bmp": _encoded(rgb, "BMP"),
        "palette.bmp": _encoded(palette, "BMP"),
        "plain.gif": _encoded(palette, "GIF"),
        "moving.gif": _encoded(palette, "GIF", save_all=True, append_images=[palette.rotate(90)]),
        "rgb.ppm": _encoded(rgb, "PPM"),
        "grey.pgm": _encoded(grey, "PPM"),
        "bits.pbm": _encoded(grey.convert("1"), "PPM"),
        "text.ppm": b"P3\n4 3\n255\n" + b" ".join(b"%d" % (i * 7) for i in range(36)) + b"\n",
    }


#: values on which arithmetic of lengths and offsets goes wrong
_EDGES = [0, 1, 2, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF]


def mutated(data: bytes, rng: np.random.Generator) -> bytes:
    """The same bytes with a few things wrong."""
    broken = bytearray(data)
    for _ in range(min(8, rng.geometric(0.5))):
        _MUTATIONS[rng.integers(0, len(_MUTATIONS))](broken, rng)
    return bytes(broken)


def _place(data: bytearray, rng: np.random.Generator) -> int:
    """A position, more often than not in the header."""
    end = max(1, len(data))
    return int(rng.integers(0, min(end, 128) if rng.random() < 0.6 else end))


def _flip(data: bytearray, rng: np.random.Generator) -> None:
    if data:
        data[_place(data, rng)] ^= 1 << int(rng.integers(0, 8))


def _byte(data: bytearray, rng: np.random.Generator) -> None:
    if data:
        data[_place(data, rng)] = int(rng.integers(0, 256))


def _number(data: bytearray, rng: np.random.Generator) -> None:
    at, size = _place(data, rng), int(rng.choice([1, 2, 4]))
    value = _EDGES[rng.integers(0, len(_EDGES))] & (256**size - 1)
    data[at : at + size] = value.to_bytes(size, "little" if rng.random() < 0.5 else "big")


def _cut(data: bytearray, rng: np.random.Generator) -> None:
    del data[_place(data, rng) if rng.random() < 0.3 else int(rng.integers(0, len(data) + 1)) :]


def _remove(data: bytearray, rng: np.random.Generator) -> None:
    at = _place(data, rng)
    del data[at : at + int(rng.integers(1, 33))]


def _repeat(data: bytearray, rng: np.random.Generator) -> None:
    at, size = _place(data, rng), int(rng.integers(1, 65))
    data[at:at] = data[at : at + size] * int(rng.integers(1, 9))


def _noise(data: bytearray, rng: np.random.Generator) -> None:
    at = _place(data, rng)
    data[at : at + 16] = rng.integers(0, 256, 16, np.uint8).tobytes()


def _move(data: bytearray, rng: np.random.Generator) -> None:
    a, b, size = _place(data, rng), _place(data, rng), int(rng.integers(1, 33))
    data[a : a + size] = data[b : b + size]


_MUTATIONS = (_flip, _byte, _number, _cut, _remove, _repeat, _noise, _move)
