"""Strokes of a pen: plain JSON, and arrays.

    {"strokes": [[[x, y], [x, y], ...], ...], "width": 800, "height": 600}

A point is [x, y], with time and pressure after them if it has them, or {"x": ..., "y": ...}. A stroke is a list of
points or {"points": [...], "dashed": true}. Width and height, of the sheet, and everything else may be left out; so may
the braces around a bare list of strokes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sketch2shape.errors import PointsError, UnreadableError
from sketch2shape.model import Floats, Picture, VectorLine
from sketch2shape.reading.sheet import picture_of

_REMEDY = '{"strokes": [[[x, y], ...], ...]}'


def from_strokes(strokes: Any, source: str = "<strokes>") -> Picture:
    """A picture of strokes given as arrays (n, 2). Raises PointsError for what is none, LimitError for too many."""
    if isinstance(strokes, str | bytes | Mapping) or not hasattr(strokes, "__iter__"):
        raise PointsError(f"strokes is {type(strokes).__name__}", remedy="strokes=[(n, 2) array, ...]")
    lines = []
    for k, stroke in enumerate(strokes):
        try:
            points = np.asarray(stroke, np.float64)
        except (TypeError, ValueError):
            raise PointsError(f"stroke {k} is no array of points", remedy="strokes=[(n, 2) array, ...]") from None
        if points.ndim != 2 or points.shape[1] != 2 or not np.isfinite(points).all():
            what = f"has the shape {points.shape}" if points.ndim != 2 or points.shape[1] != 2 else "is not finite"
            raise PointsError(f"stroke {k} {what}", remedy="strokes=[(n, 2) array, ...]")
        lines.append(VectorLine(points))
    return picture_of(lines, source=source)


def from_json(data: Any, source: str) -> Picture:
    """A picture of what a JSON file of strokes holds. Raises UnreadableError, LimitError."""
    held = data if isinstance(data, Mapping) else {"strokes": data}
    strokes = held.get("strokes")
    if not isinstance(strokes, Sequence) or isinstance(strokes, str):
        raise UnreadableError("its strokes are no list", remedy=_REMEDY)
    return picture_of([_line(stroke) for stroke in strokes], page=_page(held), source=source)


def _page(held: Mapping[str, Any]) -> tuple[float, float] | None:
    sides = held.get("width"), held.get("height")
    if sides == (None, None):
        return None
    return number(sides[0], "width"), number(sides[1], "height")


def _line(stroke: Any) -> VectorLine:
    given = stroke if isinstance(stroke, Mapping) else {"points": stroke}
    return VectorLine(points_of(given.get("points")), dashed=given.get("dashed") is True)


def points_of(given: Any) -> Floats:
    """(n, 2) float of a list of points from JSON, each [x, y, ...] or {"x": ..., "y": ...}. Raises UnreadableError."""
    if not isinstance(given, Sequence) or isinstance(given, str):
        raise UnreadableError("its points are no list", remedy=_REMEDY)
    return np.array([_point(point) for point in given], np.float64).reshape(-1, 2)


def _point(given: Any) -> tuple[float, float]:
    if isinstance(given, Mapping):
        return number(given.get("x"), "x"), number(given.get("y"), "y")
    if isinstance(given, Sequence) and not isinstance(given, str) and len(given) >= 2:
        return number(given[0], "x"), number(given[1], "y")
    raise UnreadableError("one of its points is none", remedy=_REMEDY)


def number(given: Any, name: str) -> float:
    """A number from JSON. Raises UnreadableError."""
    if isinstance(given, bool) or not isinstance(given, int | float):
        raise UnreadableError(f"its {name} is {type(given).__name__}, not a number", remedy="save it again")
    return float(given)
