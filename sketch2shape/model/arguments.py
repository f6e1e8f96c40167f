"""Checks of plain arguments, so that a wrong one is said by its name before any work."""

from __future__ import annotations

import math
from typing import Any

from sketch2shape.errors import UsageError


def checked_number(name: str, value: Any, low: float, high: float = math.inf) -> float:
    """The value as a finite float from `low` to `high`. Raises UsageError."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if isinstance(value, str) or not (math.isfinite(number) and low <= number <= high):
        meant = f"a number from {low:g} to {high:g}" if math.isfinite(high) else f"a number, {low:g} or more"
        raise UsageError(f"{name} is {value!r}", remedy=f"{name}= {meant}")
    return number


def checked_count(name: str, value: Any, low: int = 1) -> int:
    """The value as a whole number, `low` or more. Raises UsageError."""
    number = checked_number(name, value, low)
    if number != int(number):
        raise UsageError(f"{name} is {value!r}", remedy=f"{name}= a whole number")
    return int(number)
