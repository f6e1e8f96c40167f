"""From ink to straight strokes and the corners where they meet."""

from __future__ import annotations

from sketch2shape.strokes.bridging import bridged
from sketch2shape.strokes.corner_detectors import DETECTORS, detector_named, near, propose, reach_of
from sketch2shape.strokes.junctions import Corners, crossed, crossings, join_ends
from sketch2shape.strokes.labelled_corners import DetectedCorners, detect_corners
from sketch2shape.strokes.ruled_lines import MEET, RuledLines, ruled_lines
from sketch2shape.strokes.skeleton import Skeleton, are_covered, interpolated, thin
from sketch2shape.strokes.stage import ink_of, trace_strokes
from sketch2shape.strokes.tracing import Strokes, trace_skeleton

__all__ = [
    "DETECTORS",
    "MEET",
    "Corners",
    "DetectedCorners",
    "RuledLines",
    "Skeleton",
    "Strokes",
    "are_covered",
    "bridged",
    "crossed",
    "crossings",
    "detect_corners",
    "detector_named",
    "ink_of",
    "interpolated",
    "join_ends",
    "near",
    "propose",
    "reach_of",
    "ruled_lines",
    "thin",
    "trace_skeleton",
    "trace_strokes",
]
