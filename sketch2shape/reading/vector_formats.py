"""Formats that hold lines, not pixels: which one it is, and what is too much of it."""

from __future__ import annotations

import json
from typing import Any

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.model import Picture
from sketch2shape.reading.pen_strokes import from_json

#: values in a JSON file that are read at most: as many as the largest drawing has, with time and pressure
_MOST_VALUES = 600_000


def read_json(data: bytes, source: str) -> Picture:
    """The drawing in a JSON file. Raises UnreadableError, LimitError."""
    if data.count(b",") > _MOST_VALUES:
        raise LimitError("it holds too many points", remedy="a drawing, not a data set")
    try:
        held: Any = json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:
        reason = (str(error).splitlines() or [""])[0][:80]
        raise UnreadableError(f"damaged JSON ({reason})", remedy="save it again") from None
    if isinstance(held, list) or (isinstance(held, dict) and "strokes" in held):
        return from_json(held, source)
    raise UnreadableError("JSON that holds no drawing", remedy='{"strokes": [[[x, y], ...], ...]}')
