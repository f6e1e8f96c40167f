"""Strokes to ink: anti-aliased coverage, dashes and dots, the grain of a pencil, the pressure of a pen."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats
from synthetic.hand import Stroke

Coverage = NDArray[np.float32]


@dataclass(frozen=True)
class Pen:
    """A drawing tool.

    width   : stroke width, pixels
    colour  : RGB of the ink
    alpha   : 0..1, how much of the paper the ink covers
    grain   : 0..1, how much the paper's texture breaks the stroke up (pencil, chalk)
    uneven  : 0..1, variation of the ink along the strokes (ball pen)
    dash    : (drawn, left out) lengths of hidden strokes, in pen widths + 4 pixels; drawn 0 = dots, None = unbroken
    faint   : 0..1, how much less ink hidden strokes get
    crisp   : edges without grey in between, as old programs and thresholded scans have them
    """

    width: float = 2.0
    colour: tuple[int, int, int] = (20, 20, 20)
    alpha: float = 1.0
    grain: float = 0.0
    uneven: float = 0.0
    dash: tuple[float, float] | None = (1.6, 1.1)
    faint: float = 0.0
    crisp: bool = False


def coverage(strokes: list[Stroke], pen: Pen, size: tuple[int, int], rng: np.random.Generator) -> Coverage:
    """(h, w) float32 in 0..1: how much ink lies on each pixel of a sheet of `size` (w, h)."""
    w, h = size
    fine = 4 if w * h <= 1_500_000 else 2
    canvas = np.zeros((h * fine, w * fine), np.uint8)
    # Faint strokes first: others cross over them.
    for stroke in sorted(strokes, key=lambda s: not s.hidden):
        ink = round(255 * (1 - pen.faint)) if stroke.hidden else 255
        for path in dashes(stroke.path, pen) if stroke.hidden else [stroke.path]:
            _draw(canvas, path, pen.width * stroke.weight, fine, ink)
    out = cv2.resize(canvas, (w, h), interpolation=cv2.INTER_AREA).astype(np.float32) / 255
    if pen.crisp:
        out = np.round(out)
    if pen.grain:
        out *= 1 - pen.grain * _texture(size, 0.8, rng)
    if pen.uneven:
        out *= 1 - pen.uneven * _texture(size, 14.0, rng)
    return np.asarray(out, np.float32)


def dashes(path: Floats, pen: Pen) -> list[Floats]:
    """The polyline cut into dashes (or dots, as very short pieces); the last dash reaches the end."""
    if pen.dash is None:
        return [path]
    unit = pen.width + 4
    drawn, gap = pen.dash[0] * unit, pen.dash[1] * unit
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    total = float(steps[-1])
    count = max(round((total + gap) / (drawn + gap)), 1)
    stretch = total / (count * (drawn + gap) - gap) if total > gap else 1.0
    out = []
    for i in range(count):
        t = np.clip(np.array([i * (drawn + gap), i * (drawn + gap) + max(drawn, 0.01)]) * stretch, 0, total)
        inside = steps[(steps > t[0]) & (steps < t[1])]
        at = np.r_[t[0], inside, t[1]]
        out.append(np.c_[np.interp(at, steps, path[:, 0]), np.interp(at, steps, path[:, 1])])
    return out


def _draw(canvas: NDArray[np.uint8], path: Floats, width: float, fine: int, ink: int) -> None:
    points = np.round(((path + 0.5) * fine - 0.5) * 16).astype(np.int32)
    thickness = max(round(width * fine), 1)
    cv2.polylines(canvas, [points.reshape(-1, 1, 2)], False, ink, thickness, cv2.LINE_8, 4)


def _texture(size: tuple[int, int], grain: float, rng: np.random.Generator) -> Coverage:
    """Noise of the given grain (pixels), spread over 0..1."""
    w, h = size
    shrink = max(grain / 2, 1.0)
    noise = rng.random((int(h / shrink) + 2, int(w / shrink) + 2)).astype(np.float32)
    soft = cv2.GaussianBlur(noise, (0, 0), max(min(grain, 1.5), 0.6))
    noise = np.asarray(cv2.resize(soft, (w, h), interpolation=cv2.INTER_LINEAR), np.float32)
    low, high = np.percentile(noise[:: max(h // 200, 1), :: max(w // 200, 1)], [5, 95])
    return np.asarray(np.clip((noise - low) / (high - low), 0, 1), np.float32)
