"""Bridging: strokes that stop short of the corner they mean are drawn on to it."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import Bools
from sketch2shape.strokes.junctions import Corners, join_ends
from sketch2shape.strokes.skeleton import Skeleton
from sketch2shape.strokes.tracing import Strokes, trace_skeleton

GAPS, WIDEST = 4.0, 0.04
"""Pens by which strokes may stop short of their corner, which people leave on purpose, and fraction of the drawing's
size up to which these may be wider, ..."""
WIDER = 1.5
"""... in steps of this factor, as long as too many ends meet nothing."""
LEAST_LOOSE = 6
"""Loose ends of the skeleton below which strokes meet: one that meets no other has two."""
LEAST_FREE = 0.3
"""Fraction of all stroke ends that stop short of any other from which on a drawing has gaps at its corners."""


def bridged(skeleton: Skeleton, solid: Bools, tolerance: float) -> Bools | None:
    """(h, w) bool, the ink with strokes drawn on to where their lines meet; None if few strokes stop short."""
    if np.count_nonzero(_loose_ends(skeleton)) < LEAST_LOOSE:
        return None
    strokes = trace_skeleton(skeleton, tolerance, solid)
    if not len(strokes.ends):
        return None
    pen = skeleton.pen_width
    wide = join_ends(strokes, GAPS * pen)
    if _short(skeleton, strokes, wide).mean() < LEAST_FREE:
        return None
    gap, most = GAPS * pen, WIDEST * float(np.hypot(*np.ptp(skeleton.points, axis=0)))
    while _unmet(wide) > LEAST_FREE and (gap := WIDER * gap) <= most:
        wide = join_ends(strokes, gap)
    drawn = solid.astype(np.uint8)
    thickness = max(1, round(pen))
    for (k, i), corner in np.ndenumerate(wide.strokes):
        if wide.degree[corner] >= 2:
            ends = np.rint([strokes.ends[k, i], wide.points[corner]]).astype(int)
            cv2.line(drawn, ends[0].tolist(), ends[1].tolist(), 1, thickness)
    return drawn.astype(bool)


def _unmet(corners: Corners) -> float:
    """Fraction of the ends of strokes that meet no other stroke."""
    own = corners.strokes
    return float((~corners.on[own] & (corners.degree[own] < 2)).mean())


def _short(skeleton: Skeleton, strokes: Strokes, corners: Corners) -> Bools:
    """(k, 2) bool, ends of strokes where ink ends, short of the corner that they mean or of any."""
    pen, ends = skeleton.pen_width, strokes.ends
    out = np.stack([ends[:, 0] - ends[:, 1], ends[:, 1] - ends[:, 0]], axis=1)
    out /= np.linalg.norm(out, axis=2, keepdims=True) + 1e-9
    ahead = ((corners.points[corners.strokes] - ends) * out).sum(axis=2)
    meets = corners.degree[corners.strokes] >= 2
    at = np.argwhere(_loose_ends(skeleton))[:, ::-1]
    near = np.linalg.norm(ends[:, :, None] - at, axis=3).min(axis=2, initial=np.inf) <= pen + strokes.tolerance
    return np.asarray(near & np.where(meets, ahead > pen, ~corners.on[corners.strokes]))


def _loose_ends(skeleton: Skeleton) -> Bools:
    """(h, w) bool, pixels of the skeleton with a single neighbour."""
    around = cv2.boxFilter(skeleton.mask, cv2.CV_8U, (3, 3), normalize=False, borderType=cv2.BORDER_CONSTANT)
    return np.asarray(skeleton.mask & (around == 2), np.bool_)
