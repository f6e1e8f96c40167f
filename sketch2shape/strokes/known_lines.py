"""Paths of a vector drawing: its lines are one point wide already, so nothing has to be thinned."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink import strokes_of
from sketch2shape.model import Bools, Floats, VectorLine

BESIDE = 1
"""Pixels beside a line within which another one lies along it: edges that two faces share are drawn twice."""
REPEATED = 12
"""Pixels from which on a line along others is drawn again; less is a crossing, at 15 degrees or more."""


def known_paths(lines: Iterable[VectorLine], shape: tuple[int, int]) -> list[Floats]:
    """(k, 2) each: what was drawn as points a pixel apart, each place once, on a sheet of this shape (h, w)."""
    return _each_once([_sampled(pull) for line in lines for pull in strokes_of(line)], shape)


def _sampled(points: Floats) -> Floats:
    """(k, 2) a polyline as points one pixel apart along the longer axis, like those of a thinned line."""
    steps = np.zeros(len(points))
    np.cumsum(np.abs(np.diff(points, axis=0)).max(axis=1), out=steps[1:])
    at = np.linspace(0.0, steps[-1], max(2, round(float(steps[-1])) + 1))
    fine = np.empty((len(at), 2))
    fine[:, 0], fine[:, 1] = np.interp(at, steps, points[:, 0]), np.interp(at, steps, points[:, 1])
    return fine


def _each_once(paths: list[Floats], shape: tuple[int, int]) -> list[Floats]:
    """The paths, the longest first, without what lies along a longer one."""
    paths = sorted(paths, key=len, reverse=True)
    if not paths:
        return []
    sizes = [len(path) for path in paths]
    rank = np.repeat(np.arange(1, len(paths) + 1), sizes)
    x, y = np.rint(np.concatenate(paths)).astype(np.intp).T
    width = shape[1] + 2 * BESIDE
    places = (y + BESIDE) * width + x + BESIDE
    first = np.full((shape[0] + 2 * BESIDE) * width, len(paths) + 1, np.intp)
    first[places[::-1]] = rank[::-1]  # of the paths through a pixel, the longest
    beside = range(-BESIDE, BESIDE + 1)
    nearest = np.minimum.reduce([first[places + (dy * width + dx)] for dy in beside for dx in beside])
    again = np.split(nearest < rank, np.cumsum(sizes)[:-1])
    kept: list[Floats] = []
    for path, marked in zip(paths, again, strict=True):
        runs = [run for run in _runs(marked) if len(run) >= REPEATED] if marked.any() else []
        kept += [path[run] for run in _runs(~_joined(runs, len(path)))] if runs else [path]
    return kept


def _joined(runs: list[NDArray[np.intp]], count: int) -> Bools:
    """(count,) bool of the indices in all runs."""
    marked = np.zeros(count, np.bool_)
    marked[np.concatenate(runs)] = True
    return marked


def _runs(marked: Bools) -> list[NDArray[np.intp]]:
    """Indices of each run of two or more that are marked."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], marked.view(np.int8), [0]]))).reshape(-1, 2)
    return [np.arange(a, b) for a, b in edges if b - a > 1]
