"""Values from JSON of strangers: of the kind they should be, or refused."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.model import Floats

_REMEDY = "save it again"


def number(given: Any, name: str) -> float:
    """A number. Raises UnreadableError."""
    if isinstance(given, bool) or not isinstance(given, int | float):
        raise UnreadableError(f"its {name} is {type(given).__name__}, not a number", remedy=_REMEDY)
    try:
        return float(given)
    except OverflowError:
        raise UnreadableError(f"its {name} is too large a number", remedy=_REMEDY) from None


def listed(given: Any, name: str, most: int | None = None) -> Sequence[Any]:
    """A list. Raises UnreadableError, LimitError if it has more than the most."""
    if not isinstance(given, list | tuple):
        raise UnreadableError(f"its {name} are {type(given).__name__}, not a list", remedy=_REMEDY)
    if most is not None and len(given) > most:
        raise LimitError(f"{len(given)} {name} are too many", remedy="a drawing of one object")
    return given


def mapped(given: Any, name: str) -> Mapping[str, Any]:
    """An object with named values. Raises UnreadableError."""
    if not isinstance(given, Mapping):
        raise UnreadableError(f"{name} is {type(given).__name__}, not an object", remedy=_REMEDY)
    return given


def points_of(given: Any) -> Floats:
    """(n, 2) float of a list of points, each [x, y, ...] or {"x": ..., "y": ...}. Raises UnreadableError."""
    return np.array([_point(point) for point in listed(given, "points")], np.float64).reshape(-1, 2)


def _point(given: Any) -> tuple[float, float]:
    if isinstance(given, Mapping):
        return number(given.get("x"), "x"), number(given.get("y"), "y")
    if isinstance(given, list | tuple) and len(given) >= 2:
        return number(given[0], "x"), number(given[1], "y")
    raise UnreadableError("one of its points is none", remedy=_REMEDY)
