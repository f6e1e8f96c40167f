"""Units of length as the file formats know them."""

from __future__ import annotations

#: millimetres in one unit; a pixel counts as a millimetre where a format must have a unit
MILLIMETRES: dict[str, float] = {"px": 1.0, "mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
