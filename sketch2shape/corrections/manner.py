"""How an object is drawn, in a corrections file: what its proportions depend on besides its vertices."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, cast, get_args

import numpy as np

from sketch2shape.errors import UsageError
from sketch2shape.model import Bools, Floats, Lines

MANNERS = ("lines", "noise", "f2_drawn", "page")

_FARTHEST = 1e6


def manner_from(entry: Mapping[str, Any], vertices: int, where: str) -> dict[str, Any]:
    """What an entry tells of it, by the fields of TwoFaceObject; nothing for what it leaves out.

    vertices : number of those of the back face and its holes

    Raises UsageError for what a report never has.
    """
    told = {name: read(entry[name], f"{where}, {name}") for name, read in _READ.items() if entry.get(name) is not None}
    seen = told.get("f2_drawn")
    if seen is not None and len(seen) != vertices:
        raise _wrong(f"{where}, f2_drawn tells of {len(seen)} vertices; the back face has {vertices}")
    return told


def _lines(data: Any, where: str) -> Lines:
    for known in get_args(Lines):
        if data == known:
            return cast(Lines, known)
    raise _wrong(f"{where} must be one of {', '.join(get_args(Lines))}")


def _noise(data: Any, where: str) -> float:
    if type(data) not in (int, float) or not 0.0 <= data <= _FARTHEST:
        raise _wrong(f"{where} must be a number of pixels")
    return float(data)


def _drawn(data: Any, where: str) -> Bools:
    if not isinstance(data, list | tuple) or not all(type(seen) is bool for seen in data):
        raise _wrong(f"{where} must be a list of true and false")
    return np.array(data, bool)


def _page(data: Any, where: str) -> Floats:
    rows = data if isinstance(data, list | tuple) and len(data) == 3 else ()
    numbers = [c for row in rows if isinstance(row, list | tuple) and len(row) == 3 for c in row]
    if len(numbers) != 9 or not all(type(c) in (int, float) and math.isfinite(c) for c in numbers):
        raise _wrong(f"{where} must be three rows of three numbers")
    page = np.array(numbers, float).reshape(3, 3)
    if np.abs(page).max() > _FARTHEST or abs(float(np.linalg.det(page))) < 1.0 / _FARTHEST:
        raise _wrong(f"{where} is no view of a page")
    return page


_READ: dict[str, Callable[[Any, str], Any]] = {"lines": _lines, "noise": _noise, "f2_drawn": _drawn, "page": _page}


def _wrong(message: str) -> UsageError:
    return UsageError(message, remedy="the words of a report, or leave it out")
