"""Changes to a picture that leave what is drawn the same: each gives the pixels and where every point went."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats

Pixels = NDArray[np.uint8]
Transform = Callable[[Pixels], tuple[Pixels, Floats]]
"""(h, w, 3) uint8 RGB to the same and the (3, 3) homography from the old picture to the new."""

SHIFT = (37, 23)
"""Paper added at the left and the top: no multiple of anything, pixels."""
PADDING = 0.2
"""Paper added on all sides, fraction of the longer side."""
INK = (1.0, 0.6, 0.25)
"""What is left of the darkness in red, green, blue: black ink becomes blue."""
SHADE = 0.7
"""Light at the darkest corner, where 1 is full light."""


def _as_pixels(array: NDArray[np.generic]) -> Pixels:
    return np.ascontiguousarray(np.clip(np.round(np.asarray(array, np.float32)), 0, 255).astype(np.uint8))


def _paper(pixels: Pixels) -> list[float]:
    """The paper's colour: what the picture's border mostly shows."""
    border = np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]])
    return [float(v) for v in np.median(border, axis=0)]


def _bordered(pixels: Pixels, left: int, top: int, right: int, bottom: int) -> tuple[Pixels, Floats]:
    out = cv2.copyMakeBorder(pixels, top, bottom, left, right, cv2.BORDER_CONSTANT, value=_paper(pixels))
    return _as_pixels(out), np.array([[1, 0, left], [0, 1, top], [0, 0, 1.0]])


def _padded(pixels: Pixels) -> tuple[Pixels, Floats]:
    margin = round(PADDING * max(pixels.shape[:2]))
    return _bordered(pixels, margin, margin, margin, margin)


def _turned(quarters: int) -> Transform:
    """A turn by quarters, clockwise."""

    def turn(pixels: Pixels) -> tuple[Pixels, Floats]:
        h, w = pixels.shape[:2]
        move = {
            1: np.array([[0, -1, h - 1], [1, 0, 0], [0, 0, 1.0]]),
            2: np.array([[-1, 0, w - 1], [0, -1, h - 1], [0, 0, 1.0]]),
            3: np.array([[0, 1, 0], [-1, 0, w - 1], [0, 0, 1.0]]),
        }[quarters]
        return np.ascontiguousarray(np.rot90(pixels, -quarters)), move

    return turn


def _mirrored(pixels: Pixels) -> tuple[Pixels, Floats]:
    return np.ascontiguousarray(pixels[:, ::-1]), np.array([[-1, 0, pixels.shape[1] - 1], [0, 1, 0], [0, 0, 1.0]])


def _scaled(factor: float) -> Transform:
    """Enlarged or reduced."""

    def scale(pixels: Pixels) -> tuple[Pixels, Floats]:
        h, w = pixels.shape[:2]
        size = (max(round(w * factor), 1), max(round(h * factor), 1))
        out = cv2.resize(pixels, size, interpolation=cv2.INTER_AREA if factor < 1 else cv2.INTER_CUBIC)
        fx, fy = size[0] / w, size[1] / h
        return _as_pixels(out), np.array([[fx, 0, (fx - 1) / 2], [0, fy, (fy - 1) / 2], [0, 0, 1]])

    return scale


def _inverted(pixels: Pixels) -> tuple[Pixels, Floats]:
    return _as_pixels(255 - pixels.astype(np.float32)), np.eye(3)


def _coloured(pixels: Pixels) -> tuple[Pixels, Floats]:
    return _as_pixels(255 - (255 - pixels.astype(np.float32)) * np.array(INK, np.float32)), np.eye(3)


def _pressed(quality: int) -> Transform:
    """Through JPEG."""

    def press(pixels: Pixels) -> tuple[Pixels, Floats]:
        data = cv2.imencode(".jpg", pixels[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
        return _as_pixels(np.asarray(cv2.imdecode(data, cv2.IMREAD_COLOR))[..., ::-1]), np.eye(3)

    return press


def _shaded(pixels: Pixels) -> tuple[Pixels, Floats]:
    h, w = pixels.shape[:2]
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    light = 1 - (1 - SHADE) * (0.6 * x / w + 0.4 * y / h)
    return _as_pixels(pixels.astype(np.float32) * light[..., None]), np.eye(3)


TRANSFORMS: dict[str, Transform] = {
    "shift": lambda pixels: _bordered(pixels, *SHIFT, 0, 0),
    "padding": _padded,
    "turn 90": _turned(1),
    "turn 180": _turned(2),
    "turn 270": _turned(3),
    "mirror": _mirrored,
    "scale 0.5": _scaled(0.5),
    "scale 0.75": _scaled(0.75),
    "scale 1.5": _scaled(1.5),
    "scale 2": _scaled(2.0),
    "inverted": _inverted,
    "coloured": _coloured,
    "JPEG 80": _pressed(80),
    "JPEG 50": _pressed(50),
    "shade": _shaded,
}


def mapped(thing: dict[str, list[list[float]]], move: Floats) -> dict[str, list[list[float]]]:
    """A pair of rings, `f1` and `f2`, moved by a homography."""
    rings = {k: np.c_[thing[k], np.ones(len(thing[k]))] @ move.T for k in ("f1", "f2")}
    return {k: (ring[:, :2] / ring[:, 2:]).tolist() for k, ring in rings.items()}
