"""What could be the two faces: hypotheses, and the sources that propose them."""

from __future__ import annotations

from sketch2shape.hypotheses.hypothesis import (
    Frame,
    Rings,
    Stack,
    coincide,
    frame,
    has_edges,
    plausible,
    split,
    stack,
    which_plausible,
)
from sketch2shape.hypotheses.opaque import caps
from sketch2shape.hypotheses.regions import Region, enclosed_regions, without_edge
from sketch2shape.hypotheses.ruled import ruled_caps, ruled_graph
from sketch2shape.hypotheses.unions import united
from sketch2shape.hypotheses.walks import walked
from sketch2shape.hypotheses.wireframe import CornerGraph

__all__ = [
    "CornerGraph",
    "Frame",
    "Region",
    "Rings",
    "Stack",
    "caps",
    "coincide",
    "enclosed_regions",
    "frame",
    "has_edges",
    "plausible",
    "ruled_caps",
    "ruled_graph",
    "split",
    "stack",
    "united",
    "walked",
    "which_plausible",
    "without_edge",
]
