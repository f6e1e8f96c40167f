"""What follows from a solid's boundary alone: its surface as triangles, its hidden lines, its true face."""

from __future__ import annotations

from sketch2shape.solids.contours import contour_candidates, smooth_edges
from sketch2shape.solids.drawn import DrawnLine, drawn_lines, lines_seen
from sketch2shape.solids.extrusion import Extrusion, extrusion_of
from sketch2shape.solids.front import FlatRing, front_outline
from sketch2shape.solids.hidden import Run, edge_runs
from sketch2shape.solids.names import is_pointed, shape_name
from sketch2shape.solids.tessellation import Tessellation, tessellated

__all__ = [
    "DrawnLine",
    "Extrusion",
    "FlatRing",
    "Run",
    "Tessellation",
    "contour_candidates",
    "drawn_lines",
    "edge_runs",
    "extrusion_of",
    "front_outline",
    "is_pointed",
    "lines_seen",
    "shape_name",
    "smooth_edges",
    "tessellated",
]
