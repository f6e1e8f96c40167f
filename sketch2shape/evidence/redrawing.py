"""A sweep held against a drawing, in the same nats as all other hypotheses (see `energy`)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence.energy import MISSING, Comparison
from sketch2shape.evidence.view import View
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes import interpolated
from sketch2shape.sweeps import Redrawn, Sweep, redraw

SPACING = 3.0
"""Pixels between the samples of straight sides."""
DASHES_APART = 2.0
"""Pens from the nearest solid line beyond which what is seen has not been drawn, whatever dashes lie there."""


def compare_sweep(sweep: Sweep, view: View, margin: float, solid: NDArray[np.float32] | None = None) -> Comparison:
    """Hold a sweep against a drawing.

    margin : pixels within which a line may lie on the border of sight
    solid  : (h, w) pixels to the nearest ink that is no dash; None where there are no dashes
    """
    drawn = redraw(sweep, SPACING, margin)
    each = drawn.length / view.unit
    hidden = drawn.depth == 2
    off = interpolated(view.skeleton.distance, drawn.points)
    if solid is not None:
        from_solid = interpolated(solid, drawn.points)
        off = np.where(~hidden & (from_solid > DASHES_APART * view.pen), np.maximum(off, from_solid), off)
    every = _nearest(view.points, drawn, np.ones(len(hidden), np.bool_))
    return Comparison(
        view=view,
        lengths=np.bincount(drawn.edge, drawn.length, int(drawn.edge.max()) + 1).astype(float),
        off=off[:, None],
        wanted=np.where(drawn.depth == 0, MISSING * each, 0.0)[:, None],
        hidden=np.where(hidden, each, 0.0)[:, None],
        every=every,
        seen=_nearest(view.points, drawn, ~hidden) if hidden.any() else every,
        misses=((sweep.way.numbers, np.zeros(1)),),
        front=sweep.shape_numbers / 2,
        holes=len(sweep.rings) - 1,
    )


def _nearest(points: Floats, drawn: Redrawn, some: Bools) -> tuple[Floats, Ints]:
    """(k,) distance of each point to the nearest of some of the lines, pixels, and (k,) the edge it belongs to."""
    at = np.flatnonzero(some)
    if not len(at):
        return np.full(len(points), np.inf), np.zeros(len(points), np.intp)
    from scipy.spatial import cKDTree  # the command starts without it

    far, which = cKDTree(drawn.points[at]).query(points)
    own = at[which]
    to, along = points - drawn.points[own], drawn.along[own]
    t = np.clip((to * along).sum(axis=1), -0.5 * drawn.length[own], 0.5 * drawn.length[own])
    rest = to - t[:, None] * along
    return np.minimum(far, np.hypot(rest[:, 0], rest[:, 1])), drawn.edge[own]
