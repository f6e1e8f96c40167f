"""From ink to straight strokes and the corners where they meet."""

from __future__ import annotations

from sketch2shape.strokes.corner_detectors import DETECTORS, check_detector, near, propose, reach_of
from sketch2shape.strokes.junctions import Corners, crossed, crossings, join_ends
from sketch2shape.strokes.labelled_corners import detect_corners
from sketch2shape.strokes.skeleton import Skeleton, are_covered, thin
from sketch2shape.strokes.stage import ink_of, trace_strokes
from sketch2shape.strokes.tracing import Strokes, trace_skeleton

__all__ = [
    "DETECTORS",
    "Corners",
    "Skeleton",
    "Strokes",
    "are_covered",
    "check_detector",
    "crossed",
    "crossings",
    "detect_corners",
    "ink_of",
    "join_ends",
    "near",
    "propose",
    "reach_of",
    "thin",
    "trace_skeleton",
    "trace_strokes",
]
