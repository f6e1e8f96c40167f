"""Overlaps: edges of a hypothesis that are drawn along each other, where one line of ink would do for both."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Bools, Floats, Ints

ONE_WAY = 0.1
"""Radians between edges of one direction."""
PLACES = ((np.arange(24) + 0.5) / 24)[:, None]
"""Where on an edge it is looked at."""
HALF = 0.5
"""Fraction of an edge from which on it lies along another, or is seen."""


def beside(a: Floats, span: Floats, length: Floats, reach: float) -> Bools:
    """(e, n, e) bool, which of n places of each edge lie along each other edge, at most reach pixels off.

    a, span, length : (e, 2), (e, 2) and (e,) float, where each edge begins, the way to its end, and how far that is
    """
    u = span / length[:, None]
    found = np.zeros((len(a), len(PLACES), len(a)), np.bool_)
    one, other = _near_pairs(a, span, u, length, reach)
    if len(one):
        to = a[one, None] + PLACES * span[one, None] - a[other, None]
        way = u[other, None]
        along = (to * way).sum(axis=2)
        across = np.abs(to[..., 0] * way[..., 1] - to[..., 1] * way[..., 0])
        found[one, :, other] = (across <= reach) & (along >= 0) & (along <= length[other, None])
    return found


def _near_pairs(a: Floats, span: Floats, u: Floats, length: Floats, reach: float) -> tuple[Ints, Ints]:
    """Pairs of edges of one direction u that may lie along each other, as far as the ends of the first tell."""
    (x, y), (ux, uy) = a.T, u.T
    dx, dy, sx, sy = x[:, None] - x, y[:, None] - y, span[:, :1], span[:, 1:]
    aside, along = dx * uy - dy * ux, dx * ux + dy * uy
    far_aside, far_along = aside + (sx * uy - sy * ux), along + (sx * ux + sy * uy)
    near = np.abs(ux[:, None] * uy - uy[:, None] * ux) < ONE_WAY
    near &= (np.maximum(aside, far_aside) >= -reach) & (np.minimum(aside, far_aside) <= reach)
    near &= (np.maximum(along, far_along) >= 0) & (np.minimum(along, far_along) <= length)
    np.fill_diagonal(near, False)
    one, other = np.nonzero(near)
    return one, other


def coincidences(a: Floats, span: Floats, length: Floats, seen: Floats, reach: float) -> int:
    """How many edges that are seen lie along a longer one that is: each is an accident of the view.

    seen : (e,) float, fraction of each edge that is
    """
    shown = seen > HALF
    along = beside(a, span, length, reach)
    if not along.any():
        return 0
    laid = (along.mean(axis=1) > HALF) & shown & shown[:, None]
    # of two as long as each other, one counts
    rank = np.argsort(np.argsort(length, kind="stable"))
    return int((laid & (rank[:, None] < rank)).any(axis=1).sum())
