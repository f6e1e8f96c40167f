"""Pen: the width of the strokes."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.ink.depth import depth_of
from sketch2shape.model import Bools

FINE = 2.5
"""Rough width, pixels, below which strokes are hairlines."""


def pen_width_of(mask: Bools) -> float:
    """Typical stroke width, pixels: median over the ridge of the distance transform; 1 without ink."""
    ink = np.asarray(mask, np.bool_).view(np.uint8)
    x, y, w, h = cv2.boundingRect(ink)
    if not w:
        return 1.0
    own = ink[y : y + h, x : x + w].view(np.bool_)
    depth = depth_of(own)
    peak = cv2.dilate(depth, np.ones((3, 3), np.uint8))
    where = np.flatnonzero(own)
    inside = depth.ravel().take(where)
    ridge = inside[inside >= peak.ravel().take(where)]
    return max(1.0, 2.0 * float(np.median(ridge)) - 0.7)


def rough_pen_width(mask: Bools) -> float:
    """Mean stroke width, pixels, within about two fifths: twice the area over the length of the outline; 1 without ink.

    The outline is counted in pixel edges, of which a stroke has 4 / pi per unit of outline in the mean over directions.
    """
    return max(1.0, 2.0 * (4.0 / float(np.pi)) * int(np.count_nonzero(mask)) / max(outline_length(mask), 1))


def outline_length(mask: Bools) -> int:
    """Pixel edges between what is set and what is not."""
    row = mask.shape[1]
    flat = mask.ravel()  # unbroken runs compare several times as fast as rows; less the edges from row to row
    edges = np.count_nonzero(flat[row:] != flat[:-row]) + np.count_nonzero(flat[1:] != flat[:-1])
    return int(edges) - int(np.count_nonzero(mask[1:, 0] != mask[:-1, -1]))
