"""Strokes of a pen: plain JSON, and arrays.

    {"strokes": [[[x, y], [x, y], ...], ...], "width": 800, "height": 600}

A point is [x, y], with time and pressure after them if it has them, or {"x": ..., "y": ...}. A stroke is a list of
points or {"points": [...], "dashed": true}. Width and height, of the sheet, and everything else may be left out; so may
the braces around a bare list of strokes.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from sketch2shape.errors import LimitError, PointsError
from sketch2shape.model import Picture, VectorLine
from sketch2shape.reading.json_values import listed, number, points_of
from sketch2shape.reading.sheet import MOST_LINES, picture_of


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
    strokes = listed(held.get("strokes"), "strokes")
    if len(strokes) > MOST_LINES:
        raise LimitError(f"{len(strokes)} strokes are too many", remedy=f"at most {MOST_LINES}")
    return picture_of([_line(stroke) for stroke in strokes], page=_page(held), source=source)


def _page(held: Mapping[str, Any]) -> tuple[float, float] | None:
    sides = held.get("width"), held.get("height")
    if sides == (None, None):
        return None
    return number(sides[0], "width"), number(sides[1], "height")


def _line(stroke: Any) -> VectorLine:
    given = stroke if isinstance(stroke, Mapping) else {"points": stroke}
    return VectorLine(points_of(given.get("points")), dashed=given.get("dashed") is True)
