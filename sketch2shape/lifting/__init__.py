"""From the flat two-face object to the solid it shows."""

from __future__ import annotations

from sketch2shape.lifting.front import choose_front
from sketch2shape.lifting.options import LiftOptions
from sketch2shape.lifting.projection import OTHER_PAIRS
from sketch2shape.lifting.stage import lift

__all__ = ["OTHER_PAIRS", "LiftOptions", "choose_front", "lift"]
