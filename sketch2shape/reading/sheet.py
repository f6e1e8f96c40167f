"""From lines in a file's own coordinates to a vector drawing on a sheet, and a view of it for people."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.model import Floats, Picture, VectorDrawing, VectorLine

MOST_POINTS = 100_000
"""Points of all lines together: the longest drawing by hand has a tenth of it."""
MOST_LINES = 5_000
"""Lines of a drawing; shading by dots has the most."""
LONGEST = 250.0
"""Length of all lines together, in diagonals of what they cover; a hatched drawing by hand has 60."""
LARGEST = 1e9
"""Coordinates beyond this are none of a drawing."""
BORDER = 0.05
"""Empty border around lines that come without a sheet, as a part of their longer side."""
SMALLEST = 200.0
"""Longer side below which a sheet is enlarged by tens: its lengths are no pixels but inches, or parts of a window."""
VIEW = 960
"""Longer side of the view, pixels, at most."""
INK = (30, 30, 30)
"""Colour of the lines in the view."""


def picture_of(
    lines: Sequence[VectorLine], *, page: tuple[float, float] | None = None, source: str = "<strokes>"
) -> Picture:
    """A picture of lines in their own coordinates.

    page : width and height of the sheet whose upper left corner is (0, 0); None: a sheet that fits. It begins at (0, 0)
           unless some coordinate is negative

    Raises UnreadableError for coordinates that are no numbers, LimitError for too many points.
    """
    drawing = _placed([line for line in lines if len(line.points)], page)
    return _seen(drawing, source)


def _placed(lines: list[VectorLine], page: tuple[float, float] | None) -> VectorDrawing:
    points = checked_points([line.points for line in lines])
    diagonal = float(np.hypot(*np.ptp(points, axis=0))) if len(points) else 0.0
    if _length(points, lines) > LONGEST * diagonal:
        raise LimitError("its lines are too many or too long: a scribble", remedy="a drawing of one object")
    origin, size = _sheet(points, page)
    scale = 10.0 ** math.ceil(max(0.0, math.log10(SMALLEST / max(float(size.max()), 1e-9))))
    width, height = (max(1, math.ceil(round(n, 3))) for n in (size * scale).tolist())
    moved = tuple(line.mapped(origin, scale) for line in lines)
    return VectorDrawing(moved, (width, height), (float(origin[0]), float(origin[1])), scale)


def _length(points: Floats, lines: list[VectorLine]) -> float:
    """Of all lines together, whose points (n, 2) these are."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    ends = np.cumsum([len(line.points) for line in lines], dtype=np.intp)[:-1] - 1
    return float(steps.sum() - steps[ends].sum())


def checked_points(lines: Sequence[Floats]) -> Floats:
    """(n, 2) the points of all lines. Raises LimitError where they are too many, UnreadableError where too large."""
    count = sum(map(len, lines))
    if count > MOST_POINTS or len(lines) > MOST_LINES:
        what = f"{count} points" if count > MOST_POINTS else f"{len(lines)} lines"
        raise LimitError(f"{what} are too many", remedy=f"at most {MOST_POINTS} points in {MOST_LINES} lines")
    points = np.concatenate([np.zeros((0, 2)), *lines])
    if not (np.abs(points) <= LARGEST).all():
        raise UnreadableError("it holds coordinates that are no numbers, or huge ones", remedy="save it again")
    return points


def _sheet(points: Floats, page: tuple[float, float] | None) -> tuple[Floats, Floats]:
    """Upper left corner and size of the sheet, in the lines' own coordinates."""
    if page is not None and all(0 < side <= LARGEST for side in page):
        return np.zeros(2), np.array(page, np.float64)
    if not len(points):
        return np.zeros(2), np.array([SMALLEST, SMALLEST])
    low, high = points.min(axis=0), points.max(axis=0)
    border = BORDER * max(float((high - low).max()), 1e-9)
    origin = np.zeros(2) if (low >= 0).all() else np.floor(low - border)
    return origin, high + border - origin


def _seen(drawing: VectorDrawing, source: str) -> Picture:
    """The drawing with a view of it, which is reduced by a whole number where the sheet is large."""
    width, height = drawing.size
    step = -(-max(width, height) // VIEW)
    pixels = np.full((max(1, height // step), max(1, width // step), 3), 255, np.uint8)
    for dashed, lines in groupby(drawing.lines, key=lambda line: line.dashed):
        _draw(pixels, [line.points for line in lines], step, dashed)
    return Picture(pixels, source, drawing.size if step > 1 else None, drawing)


def _draw(pixels: NDArray[np.uint8], paths: list[Floats], step: int, dashed: bool) -> None:
    placed = (np.concatenate(paths) + 0.5) / step - 0.5
    fixed = np.rint(np.clip(placed, -(2**15), 2**15) * 16).astype(np.int32)
    parts = np.split(fixed, np.cumsum([len(path) for path in paths])[:-1])
    cv2.polylines(pixels, parts, False, INK if not dashed else (150, 150, 150), 2, cv2.LINE_AA, 4)
