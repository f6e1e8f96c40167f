"""A small drawing surface: smooth lines, dashes, dots, filled rings and words on a NumPy image.

Strategy: everything but words is painted on an image a few times larger and averaged down at the end, which gives the
same smooth edges on every machine (a large picture at its own size); words are set last, at the final size. The same
calls give the same bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from sketch2shape.model import Floats
from sketch2shape.pictures.palette import INK, PAPER, Colour

Pixels = NDArray[np.uint8]
"""(h, w, 3) RGB."""

_OVERSAMPLE = 3
_LARGE = 2_000_000
"""Final pixels from which a picture is painted at its own size: its lines are wide, and smooth enough as they are."""
_COMPRESSION = 4
"""Of PNG, 0 to 9. An overlay of 4.5 megapixels takes 0.3 s and 2.1 MB at 4, 0.8 s and 1.9 at 6, 12 s and 1.6 at 9."""
_SUBPIXEL_BITS = 4


@dataclass(frozen=True)
class Words:
    """A line of text waiting to be set: where, what and how (units: final pixels)."""

    at: tuple[float, float]
    text: str
    size: float
    colour: Colour
    anchor: str
    bold: bool


class Canvas:
    """A picture in the making; coordinates are its own pixels unless `view` moved them."""

    def __init__(self, width: int, height: int, background: Colour = PAPER) -> None:
        """Start with an even background, `width` x `height` final pixels."""
        self.width, self.height = width, height
        self._fine = _OVERSAMPLE if width * height < _LARGE else 1
        self._big: Pixels = np.empty((height * self._fine, width * self._fine, 3), np.uint8)
        cv2.rectangle(self._big, (0, 0), (self._big.shape[1], self._big.shape[0]), background, cv2.FILLED)
        self._words: list[Words] = []
        self._scale, self._offset = 1.0, np.zeros(2)

    def view(self, scale: float = 1.0, offset: Sequence[float] | Floats = (0.0, 0.0)) -> Canvas:
        """Let later calls mean p * scale + offset wherever they say p; returns itself."""
        self._scale, self._offset = scale, np.asarray(offset, float)
        return self

    def place(self, point: Floats) -> Floats:
        """Where a point in view coordinates comes to lie, final pixels."""
        final: Floats = np.asarray(point, float) * self._scale + self._offset
        return final

    def paste(self, pixels: Pixels, left: int, top: int) -> None:
        """Put a picture down, unscaled, its corner at (left, top) final pixels."""
        h, w = pixels.shape[:2]
        size = (w * self._fine, h * self._fine)
        large = pixels if self._fine == 1 else cv2.resize(pixels, size, interpolation=cv2.INTER_LINEAR)
        y, x = top * self._fine, left * self._fine
        self._big[y : y + h * self._fine, x : x + w * self._fine] = large

    def line(
        self,
        a: Floats,
        b: Floats,
        colour: Colour = INK,
        width: float = 1.5,
        dash: tuple[float, float] | None = None,
        alpha: float = 1.0,
    ) -> None:
        """Draw a straight line, dashed if `dash` gives (on, off); width and dash in final pixels."""
        self.path(np.array([a, b]), colour, width, dash, alpha)

    def path(
        self,
        points: Floats,
        colour: Colour = INK,
        width: float = 1.5,
        dash: tuple[float, float] | None = None,
        alpha: float = 1.0,
    ) -> None:
        """Draw a line through points (k, 2), as `line`."""
        along = self._large(points)
        pieces = [along] if dash is None else _dashes(along, dash[0] * self._fine, dash[1] * self._fine)
        thick = max(1, round(width * self._fine))

        def stroke(target: Pixels, corner: Floats) -> None:
            for piece in pieces:
                for ends in pairwise(_fixed(piece - corner)):
                    p, q = (tuple(int(v) for v in e) for e in ends)
                    cv2.line(target, p, q, colour, thick, cv2.LINE_AA, _SUBPIXEL_BITS)

        self._blend(stroke, along, thick, alpha)

    def dot(
        self, at: Floats, radius: float, colour: Colour = INK, rim: Colour | None = PAPER, rim_width: float = 1.2
    ) -> None:
        """Draw a disc, `radius` final pixels, with a rim that sets it off from what lies below."""
        centre = tuple(int(v) for v in _fixed(self._large(np.array([at])))[0])
        step = self._fine << _SUBPIXEL_BITS
        if rim is not None:
            cv2.circle(self._big, centre, round((radius + rim_width) * step), rim, -1, cv2.LINE_AA, _SUBPIXEL_BITS)
        cv2.circle(self._big, centre, round(radius * step), colour, -1, cv2.LINE_AA, _SUBPIXEL_BITS)

    def fill(self, rings: Sequence[Floats], colour: Colour, alpha: float = 1.0) -> None:
        """Fill the region inside an odd number of rings."""
        large = [self._large(ring) for ring in rings]

        def flood(target: Pixels, corner: Floats) -> None:
            cv2.fillPoly(target, [_fixed(ring - corner) for ring in large], colour, cv2.LINE_AA, _SUBPIXEL_BITS)

        self._blend(flood, np.concatenate(large), 0, alpha)

    def box(self, left: float, top: float, width: float, height: float, colour: Colour) -> None:
        """Fill an upright rectangle, final pixels."""
        x0, y0, x1, y1 = (round(v * self._fine) for v in (left, top, left + width, top + height))
        self._big[max(y0, 0) : y1, max(x0, 0) : x1] = colour

    def words(
        self,
        at: tuple[float, float],
        text: str,
        size: float = 14,
        colour: Colour = INK,
        anchor: str = "la",
        *,
        bold: bool = False,
    ) -> None:
        """Set a line of text at final pixels `at`; `anchor` as in Pillow ("la" left-ascender, "mm" middle)."""
        self._words.append(Words(at, shown(text), size, colour, anchor, bold))

    def finish(self) -> Pixels:
        """The picture, (height, width, 3) uint8 RGB."""
        size = (self.width, self.height)
        small = self._big if self._fine == 1 else cv2.resize(self._big, size, interpolation=cv2.INTER_AREA)
        if not self._words:
            return small.astype(np.uint8)
        image = Image.fromarray(small)
        pen = ImageDraw.Draw(image)
        for w in self._words:
            for shift in (0.0, w.size / 30) if w.bold else (0.0,):  # the typeface has one weight: set it twice
                pen.text((w.at[0] + shift, w.at[1]), w.text, w.colour, font(w.size), anchor=w.anchor)
        return np.asarray(image).copy()

    def _blend(self, paint: Callable[[Pixels, Floats], None], points: Floats, margin: int, alpha: float) -> None:
        """Paint around the points and mix it in, so that one call is evenly transparent even where it overlaps itself.

        paint : told a part of the enlarged image and the place of its upper left corner
        """
        if alpha >= 1:
            paint(self._big, np.zeros(2))
            return
        h, w = self._big.shape[:2]
        x0, y0 = np.clip(np.floor(points.min(axis=0)) - margin - 2, 0, [w, h]).astype(int)
        x1, y1 = np.clip(np.ceil(points.max(axis=0)) + margin + 3, 0, [w, h]).astype(int)
        if x0 >= x1 or y0 >= y1:
            return
        part = self._big[y0:y1, x0:x1]
        target = part.copy()
        paint(target, np.array([x0, y0], float))
        part[:] = cv2.addWeighted(target, alpha, part, 1 - alpha, 0)

    def _large(self, points: Floats) -> Floats:
        """Points in view coordinates as points of the enlarged image (pixel centres kept at whole numbers)."""
        return (self.place(points) + 0.5) * self._fine - 0.5


@lru_cache(maxsize=32)
def font(size: float) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    """The typeface that comes with Pillow, so that no machine's own fonts change the picture."""
    return ImageFont.load_default(size)


def text_width(text: str, size: float) -> float:
    """Width of a line of text, pixels."""
    return float(font(size).getlength(text))


def shown(name: str) -> str:
    """A name as it can be shown: bytes of a file name that are no UTF-8 become U+FFFD."""
    return name.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def shorten(text: str, size: float, width: float, keep: Literal["start", "end"] = "start") -> str:
    """The text, cut with an ellipsis where it is wider than `width` pixels."""
    text = shown(text)
    if text_width(text, size) <= width:
        return text
    while text and text_width("..." + text, size) > width:
        text = text[:-1] if keep == "start" else text[1:]
    return text + "..." if keep == "start" else "..." + text


def fit(pixels: Pixels, width: int, height: int) -> tuple[Pixels, float]:
    """The picture resized to fit a box whole, and the scale used; the aspect ratio is kept."""
    h, w = pixels.shape[:2]
    scale = min(width / w, height / h)
    size = (max(1, round(w * scale)), max(1, round(h * scale)))
    mode = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
    return cv2.resize(pixels, size, interpolation=mode).astype(np.uint8), scale


def encode_png(pixels: Pixels) -> bytes:
    """The picture as PNG bytes, without dates or names, so that equal pictures are equal files."""
    ok, data = cv2.imencode(
        ".png", np.ascontiguousarray(pixels[..., ::-1]), [cv2.IMWRITE_PNG_COMPRESSION, _COMPRESSION]
    )
    if not ok:
        raise ValueError(f"OpenCV could not encode a picture of shape {pixels.shape}")
    return data.tobytes()


def encode_jpeg(pixels: Pixels) -> bytes:
    """The picture as JPEG bytes: smaller, for thumbnails and photos."""
    options = [cv2.IMWRITE_JPEG_QUALITY, 86]
    ok, data = cv2.imencode(".jpg", np.ascontiguousarray(pixels[..., ::-1]), options)
    if not ok:
        raise ValueError(f"OpenCV could not encode a picture of shape {pixels.shape}")
    return data.tobytes()


def _fixed(points: Floats) -> NDArray[np.int32]:
    """Points in OpenCV's fixed-point coordinates, kept inside what it can hold."""
    return np.clip(np.rint(points * (1 << _SUBPIXEL_BITS)), -(2**30), 2**30).astype(np.int32)


def _dashes(path: Floats, on: float, off: float) -> list[Floats]:
    """A line through points (k, 2) cut into dashes that begin and end on ink, spread evenly."""
    if len(path) > 2:
        return _bent_dashes(path, on, off)
    ends = path
    length = float(np.linalg.norm(ends[1] - ends[0]))
    gaps = max(0, round((length - on) / (on + off)))
    if gaps == 0 or length > 1e6:
        return [ends]
    stretch = length / (gaps * (on + off) + on)
    starts = np.arange(gaps + 1) * (on + off) * stretch / length
    stops = starts + on * stretch / length
    return [ends[0] + np.array([[s], [t]]) * (ends[1] - ends[0]) for s, t in zip(starts, stops, strict=True)]


def _bent_dashes(path: Floats, on: float, off: float) -> list[Floats]:
    """As `_dashes`, round the bends of a path."""
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    length = float(at[-1])
    gaps = max(0, round((length - on) / (on + off)))
    if gaps == 0 or length > 1e6:
        return [path]
    stretch = length / (gaps * (on + off) + on)
    dashes: list[Floats] = []
    for start in np.arange(gaps + 1) * (on + off) * stretch:
        places = np.concatenate([[start], at[(at > start) & (at < start + on * stretch)], [start + on * stretch]])
        dashes.append(np.stack([np.interp(places, at, path[:, 0]), np.interp(places, at, path[:, 1])], axis=1))
    return dashes
