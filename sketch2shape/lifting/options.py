"""What a user may fix about a solid: projection, sizes, unit, axes, reading."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Literal

from sketch2shape.errors import UsageError

Family = Literal["auto", "oblique", "axonometric", "perspective"]
Unit = Literal["px", "mm", "cm", "m", "in"]

#: length of each unit in millimetres; a pixel has none
_MILLIMETRES: dict[str, float] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}

#: sizes that a user may give, as the upright solid has them
SIZES = ("width", "height", "depth")

#: the least and the largest length, whatever its unit: beyond them the numbers of a file no longer tell vertices apart
_LEAST, _LARGEST = 1e-6, 1e9

_LENGTH = re.compile(r"\s*([0-9]*\.?[0-9]+(?:[eE][+-]?[0-9]+)?)\s*(mm|cm|m|in|px)?\s*")


@dataclass(frozen=True)
class LiftOptions:
    """How a drawing is lifted to a solid.

    projection  : "auto" tells the family from the drawing; a name imposes it
    width       : size of the upright solid from left to right, as "40mm", "1.5in" or a number in `unit`
    height      : its size upward, likewise
    depth       : its size from front to back, likewise
    fit         : its largest size, likewise; instead of the others
    depth_ratio : drawn over true length of receding edges in an oblique drawing; None: 0.5 (cabinet) unless the drawing
                  says otherwise
    unit        : unit of length of the solid; "px" with a size in millimetres means millimetres
    up          : "z" or "y" stands the solid upright on 0 of that axis, centred over the origin; "camera" keeps the
                  viewer's axes (x right, y down, z away)
    necker      : take the mirrored reading, in which near and far are exchanged
    reading     : 1 takes the likeliest reading, 2 the next best, ...
    beautify    : make nearly right angles, parallels, equal lengths and symmetry exact

    Raises UsageError for values that make no sense.
    """

    projection: Family = "auto"
    width: str | float | None = None
    height: str | float | None = None
    depth: str | float | None = None
    fit: str | float | None = None
    depth_ratio: float | None = None
    unit: Unit = "px"
    up: Literal["z", "y", "camera"] = "z"
    necker: bool = False
    reading: int = 1
    beautify: bool = True

    def __post_init__(self) -> None:
        """Refuse what cannot be meant, before any work is done."""
        _one_of("projection", self.projection, ("auto", "oblique", "axonometric", "perspective"))
        _one_of("unit", self.unit, ("px", *_MILLIMETRES))
        _one_of("up", self.up, ("z", "y", "camera"))
        for name in (*SIZES, "fit"):
            length(getattr(self, name), "mm")
        if self.fit is not None and any(getattr(self, name) is not None for name in SIZES):
            raise UsageError("fit sets the largest size: no other can be given", remedy="one of the two")
        if self.reading < 1:
            raise UsageError(f"there is no reading {self.reading}", remedy="1 for the likeliest, 2 for the next")
        ratio = self.depth_ratio
        if ratio is not None and not (math.isfinite(ratio) and 0.05 <= ratio <= 5.0):
            raise UsageError(f"depth ratio {ratio} is not between 0.05 and 5", remedy="0.5 (cabinet) or 1 (cavalier)")

    @property
    def solid_unit(self) -> str:
        """The unit the solid will have: `unit`, or the unit of the first size given if `unit` is left at pixels."""
        if self.unit != "px":
            return self.unit
        for size in (self.width, self.height, self.depth, self.fit):
            match = _LENGTH.fullmatch(size) if isinstance(size, str) else None
            if match and match[2] not in (None, "px"):
                return match[2]
        return "px"

    def sizes(self) -> tuple[float | None, float | None, float | None]:
        """Width, height and depth asked for, in `solid_unit`."""
        unit = self.solid_unit
        return length(self.width, unit), length(self.height, unit), length(self.depth, unit)

    def largest(self) -> float:
        """What `fit` asks for, in `solid_unit`; 0 if nothing."""
        return length(self.fit, self.solid_unit) or 0.0


def length(text: str | float | None, unit: str) -> float | None:
    """A length such as "40mm", "1.5 in" or 12.5 in the unit given; a bare number is already in it.

    >>> length("40mm", "cm")
    4.0

    Raises UsageError if it is not a positive length, or one that no file can hold.
    """
    if text is None:
        return None
    match = _LENGTH.fullmatch(str(text))
    value = float(match[1]) if match else math.nan
    if not (match and 0.0 < value < math.inf):
        raise UsageError(f"{text!r} is not a length", remedy="a positive number with mm, cm, m or in, as in 40mm")
    if not _LEAST <= value <= _LARGEST:
        how = "small" if value < _LEAST else "large"
        raise UsageError(f"{text} is too {how} for a solid", remedy=f"a length from {_LEAST:g} to {_LARGEST:g}")
    own = match[2] or unit
    if own == unit or "px" in (own, unit):
        return value
    return value * _MILLIMETRES[own] / _MILLIMETRES[unit]


def _one_of(name: str, value: object, allowed: tuple[object, ...]) -> None:
    if value not in allowed:
        words = ", ".join(str(a) for a in allowed if a is not None)
        raise UsageError(f"{name} cannot be {value!r}", remedy=f"one of {words}")
