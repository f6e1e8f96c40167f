"""Units of length as the file formats know them, and solids in the unit that a format needs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sketch2shape.model import Solid

#: millimetres in one unit; a pixel counts as a millimetre where a format must have a unit
MILLIMETRES: dict[str, float] = {"px": 1.0, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}


def in_millimetres(solids: Sequence[Solid]) -> list[Solid]:
    """The solids in millimetres, as programs take the numbers of formats without units; pixels stay pixels."""
    return [solid if solid.unit == "px" else _scaled(solid, MILLIMETRES[solid.unit], "mm") for solid in solids]


def _scaled(solid: Solid, factor: float, unit: str) -> Solid:
    camera = None if solid.camera is None else solid.camera * [1.0 / factor, 1.0 / factor, 1.0 / factor, 1.0]
    return replace(solid, boundary=solid.boundary.scaled(factor), unit=unit, camera=camera)
