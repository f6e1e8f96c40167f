"""From files and arrays to pixels: what a picture is, what it may cost, and how it is decoded safely."""

from __future__ import annotations

from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import read_picture

__all__ = ["Limits", "read_picture"]
