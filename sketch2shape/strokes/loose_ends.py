"""Loose ends: strokes whose last pixels lie among others, drawn on to where their ink ends.

Where two lines meet close to a third, thinning leaves pieces of a pixel or two that no line can be fitted to. The
strokes end before them, so that no corner is found where all three have one.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.strokes.junctions import Corners
from sketch2shape.strokes.skeleton import Skeleton, interpolated
from sketch2shape.strokes.tracing import Strokes

NEAR = 1.0
"""Pixels from the skeleton up to which a line lies on ink."""
MOST_STEPS = 24
"""Pixels by which a stroke is drawn on at most."""
MEETING, PENS = 2.0, 1.0
"""Pixels, and pens more, from another end within which one that is drawn on has met it."""


def without_loose_ends(strokes: Strokes, corners: Corners, skeleton: Skeleton) -> Strokes:
    """The strokes, loose ends drawn straight on along their ink where they meet another end there.

    corners : of these strokes

    A stroke becomes longer by half at most.
    """
    stroke, side = np.nonzero((corners.degree == 1)[corners.strokes])
    if not len(stroke):
        return strokes
    ends, half = strokes.ends.copy(), 0.5 * strokes.lengths[stroke, None]
    way = ends[stroke, side] - ends[stroke, 1 - side]
    way /= 2.0 * half + 1e-9
    steps = np.arange(1.0, MOST_STEPS + 1)
    off = interpolated(skeleton.distance, ends[stroke, side][:, None] + steps[:, None] * way[:, None])
    inked = np.logical_and.accumulate((off <= NEAR) & (steps <= half), axis=1)
    ends[stroke, side] += inked.sum(axis=1)[:, None] * way
    gap = np.linalg.norm(ends[stroke, side][:, None] - ends.reshape(-1, 2), axis=2)
    own = 2 * stroke
    gap[np.arange(len(own)), own] = gap[np.arange(len(own)), own + 1] = np.inf
    met = gap.min(axis=1, initial=np.inf) <= MEETING + PENS * skeleton.pen_width
    ends[stroke[~met], side[~met]] = strokes.ends[stroke[~met], side[~met]]
    return replace(strokes, ends=ends)
