"""Bridging: strokes that stop short of the corner they mean are drawn on to it."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import Bools
from sketch2shape.strokes.junctions import join_ends
from sketch2shape.strokes.skeleton import Skeleton
from sketch2shape.strokes.tracing import trace_skeleton

GAPS = 4.0
"""Pens by which strokes may stop short of their corner: what people leave on purpose."""
LEAST_LOOSE = 6
"""Loose ends of the skeleton below which strokes meet: one that meets no other has two."""
LEAST_FREE = 0.3
"""Fraction of all stroke ends that meet no other from which on a drawing has gaps at its corners."""


def bridged(skeleton: Skeleton, solid: Bools, tolerance: float) -> Bools | None:
    """(h, w) bool, the ink with strokes drawn on to where their lines meet; None if few strokes stop short."""
    if _loose_ends(skeleton) < LEAST_LOOSE:
        return None
    strokes = trace_skeleton(skeleton, tolerance, solid)
    if not len(strokes.ends):
        return None
    pen = skeleton.pen_width
    tight = join_ends(strokes, pen)
    free = (tight.degree[tight.strokes] < 2) & ~tight.on[tight.strokes]
    if free.mean() < LEAST_FREE:
        return None
    wide = join_ends(strokes, GAPS * pen)
    drawn = solid.astype(np.uint8)
    thickness = max(1, round(pen))
    for (k, i), corner in np.ndenumerate(wide.strokes):
        if wide.degree[corner] >= 2:
            ends = np.rint([strokes.ends[k, i], wide.points[corner]]).astype(int)
            cv2.line(drawn, ends[0].tolist(), ends[1].tolist(), 1, thickness)
    return drawn.astype(bool)


def _loose_ends(skeleton: Skeleton) -> int:
    """Pixels of the skeleton with a single neighbour."""
    around = cv2.boxFilter(skeleton.mask, cv2.CV_8U, (3, 3), normalize=False, borderType=cv2.BORDER_CONSTANT)
    return int(np.count_nonzero(skeleton.mask & (around == 2)))
