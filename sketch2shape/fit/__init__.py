"""Moving a hypothesis to the ink, and taking needless vertices away."""

from __future__ import annotations

from sketch2shape.fit.polishing import polished
from sketch2shape.fit.refinement import EXACT, on_map, refine
from sketch2shape.fit.simplification import FLAT, simplified, turns

__all__ = ["EXACT", "FLAT", "on_map", "polished", "refine", "simplified", "turns"]
