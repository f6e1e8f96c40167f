"""Overlaps: edges of a hypothesis that are drawn along each other, where one line of ink would do for both."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Bools, Floats

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
    p = (a[:, None] + PLACES * span[:, None]).reshape(-1, 2)
    u = span / length[:, None]
    to = p[:, None] - a
    along, across = (to * u).sum(axis=2), np.abs(to[..., 0] * u[:, 1] - to[..., 1] * u[:, 0])
    found = ((across <= reach) & (along >= 0) & (along <= length)).reshape(len(a), -1, len(a))
    found &= (np.abs(u[:, None, 0] * u[:, 1] - u[:, None, 1] * u[:, 0]) < ONE_WAY)[:, None]
    found[np.arange(len(a)), :, np.arange(len(a))] = False
    return np.asarray(found)


def coincidences(a: Floats, span: Floats, length: Floats, seen: Floats, reach: float) -> int:
    """How many edges that are seen lie along a longer one that is: each is an accident of the view.

    seen : (e,) float, fraction of each edge that is
    """
    shown = seen > HALF
    laid = (beside(a, span, length, reach).mean(axis=1) > HALF) & shown & shown[:, None]
    # of two as long as each other, one counts
    rank = np.argsort(np.argsort(length, kind="stable"))
    return int((laid & (rank[:, None] < rank)).any(axis=1).sum())
