"""Objects with arcs or a point: what could be their outlines, and how these become the back face."""

from __future__ import annotations

from sketch2shape.sweeps.cells import Cells
from sketch2shape.sweeps.eroded import eroded_outline
from sketch2shape.sweeps.joined import joined
from sketch2shape.sweeps.loops import LEAST_COHERENT, LEAST_PATH, Loop, coherent_loops, ellipses, enclosed_loops
from sketch2shape.sweeps.outlines import Circle, Frame, Outline, ellipse_through, in_one_frame
from sketch2shape.sweeps.pieces import cut_ring, rounded
from sketch2shape.sweeps.pyramids import pyramids
from sketch2shape.sweeps.retracing import retraced
from sketch2shape.sweeps.round_pairs import round_pairs
from sketch2shape.sweeps.rungs import joints, rung_ends, wire_shifts
from sketch2shape.sweeps.sweep import Redrawn, Sweep, Way, redraw, seen_vertices, turning_points
from sketch2shape.sweeps.ways import (
    centres,
    directions,
    distinct_centres,
    distinct_directions,
    settled,
    settled_wire,
    shifts,
    ways_along,
    ways_towards,
)

__all__ = [
    "LEAST_COHERENT",
    "LEAST_PATH",
    "Cells",
    "Circle",
    "Frame",
    "Loop",
    "Outline",
    "Redrawn",
    "Sweep",
    "Way",
    "centres",
    "coherent_loops",
    "cut_ring",
    "directions",
    "distinct_centres",
    "distinct_directions",
    "ellipse_through",
    "ellipses",
    "enclosed_loops",
    "eroded_outline",
    "in_one_frame",
    "joined",
    "joints",
    "pyramids",
    "redraw",
    "retraced",
    "round_pairs",
    "rounded",
    "rung_ends",
    "seen_vertices",
    "settled",
    "settled_wire",
    "shifts",
    "turning_points",
    "ways_along",
    "ways_towards",
    "wire_shifts",
]
