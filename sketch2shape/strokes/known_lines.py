"""Paths of a vector drawing: its lines are one point wide already, so nothing has to be thinned."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink import drawn, strokes_of
from sketch2shape.model import Bools, Floats, VectorLine

BESIDE = 3
"""Working pixels of the pen under which a line counts as drawn over again: edges that two faces share."""
REPEATED = 12
"""Pixels from which on a line along others is drawn again; less is a crossing, at 15 degrees or more."""


def known_paths(lines: Iterable[VectorLine], shape: tuple[int, int]) -> list[Floats]:
    """(k, 2) each: what was drawn as points a pixel apart, each place once, on a sheet of this shape (h, w)."""
    return _each_once([_sampled(pull) for line in lines for pull in strokes_of(line)], shape)


def _sampled(points: Floats) -> Floats:
    """(k, 2) a polyline as points one pixel apart along the longer axis, like those of a thinned line."""
    way = np.abs(np.diff(points, axis=0)).max(axis=1)
    steps = np.append(0.0, np.cumsum(way))
    at = np.linspace(0.0, steps[-1], max(2, round(float(steps[-1])) + 1))
    return np.stack([np.interp(at, steps, points[:, 0]), np.interp(at, steps, points[:, 1])], axis=1)


def _each_once(paths: list[Floats], shape: tuple[int, int]) -> list[Floats]:
    """The paths without what lies along a longer one."""
    seen = np.zeros(shape, np.bool_)
    kept: list[Floats] = []
    for path in sorted(paths, key=len, reverse=True):
        x, y = np.rint(path).astype(np.intp).T
        new = [path[run] for run in _runs(~_long_runs(seen[y, x], REPEATED))]
        kept += new
        seen |= drawn(new, shape, BESIDE)
    return kept


def _long_runs(marked: Bools, least: int) -> Bools:
    """(k,) which of the marked are in a run of so many at least."""
    out = np.zeros(len(marked), np.bool_)
    for run in _runs(marked):
        if len(run) >= least:
            out[run] = True
    return out


def _runs(marked: Bools) -> list[NDArray[np.intp]]:
    """Indices of each run of two or more that are marked."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], marked.view(np.int8), [0]]))).reshape(-1, 2)
    return [np.arange(a, b) for a, b in edges if b - a > 1]
