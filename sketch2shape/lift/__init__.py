"""From the flat two-face object to the solid it shows."""

from __future__ import annotations

from sketch2shape.lift.front import choose_front
from sketch2shape.lift.options import LiftOptions
from sketch2shape.lift.solid import lift

__all__ = ["LiftOptions", "choose_front", "lift"]
