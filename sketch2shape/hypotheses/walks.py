"""Walks: the faces of a wireframe followed edge by edge, each connecting edge with a freedom of its own.

A careless hand draws lateral edges that obey no plane map common to all (`wireframe.ladders` asks for one). Neighbours
are alike nonetheless: a walk steps from one lateral edge to the next where ink joins both their ends. Walks from all
edges grow together, a beam of the best: the ink they explain less the price of their vertices and of what neighbours
differ by. One that comes back to where it began closes two faces.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.hypotheses.hypothesis import Rings, stack, which_plausible
from sketch2shape.hypotheses.wireframe import CornerGraph
from sketch2shape.model import Bools, Floats, Ints

MOST_RUNGS = 400
"""Edges of a graph, each way, that are walked; where there are more, only the longest."""
WIDEST = 16
"""Steps from one edge that are tried, the best."""
KEPT = 16
"""Walks that go on from one first edge."""
FARTHEST = 20
"""Vertices of a face."""
ALIKE = 0.45
"""Most that neighbouring lateral edges differ, as a fraction of the longer one."""
ALONG = 0.17
"""Sine of the angle up to which two edges from one corner may be one: ten degrees."""
INK = 1.0
"""Nats for ink as long as a hundredth of the drawing's size: what it costs as foreign ink, on the whole."""
VERTEX = 12.0
"""Nats for a vertex of the front, which brings one of the back with it."""
MOST = 60
"""Pairs of faces that are given."""


class _Steps(NamedTuple):
    """What a walk may do.

    rungs : (m, 2) int, a corner of the front and the one behind it
    near  : (m, w) int, the rungs that each may be followed by, the best first
    gain  : (m, w) float, nats saved by each of these steps; -inf where there is none
    """

    rungs: Ints
    near: Ints
    gain: Floats


class _Walks(NamedTuple):
    """Walks of one length.

    path  : (k, n) int, rungs
    taken : (k, c) bool, corners that have served
    saved : (k,) float, nats
    """

    path: Ints
    taken: Bools
    saved: Floats


def walked(graph: CornerGraph, size: float, least: float) -> Iterator[Rings]:
    """Pairs of faces, those that explain the most ink at the least price first.

    size  : diagonal of the drawing, pixels
    least : pixels, length of the shortest edge
    """
    steps = _steps(graph, size)
    found: dict[frozenset[frozenset[int]], tuple[float, Ints]] = {}
    for saved, path in _closed(steps, graph):
        key = frozenset(map(frozenset, steps.rungs[path].tolist()))
        if key not in found or found[key][0] < saved:
            found[key] = (saved, path)
    ranked = sorted(found.values(), key=lambda f: -f[0])[: 10 * MOST]
    pairs = [graph.points[steps.rungs[path]] for _, path in ranked]
    rings = [Rings((pair[:, 0],), (pair[:, 1],)) for pair in pairs]
    yield from islice((r for r, ok in zip(rings, _plausible(rings, least), strict=True) if ok), MOST)


def _plausible(rings: list[Rings], least: float) -> list[bool]:
    ok = np.zeros(len(rings), bool)
    for sizes in {r.sizes for r in rings}:
        alike = [k for k, r in enumerate(rings) if r.sizes == sizes]
        ok[alike] = which_plausible(stack([rings[k] for k in alike]), least)
    return ok.tolist()


def _steps(graph: CornerGraph, size: float) -> _Steps:
    rungs = np.argwhere(graph.inked)
    way = graph.points[rungs[:, 1]] - graph.points[rungs[:, 0]]
    length = np.hypot(way[:, 0], way[:, 1])
    if len(rungs) > MOST_RUNGS:
        some = np.sort(np.argsort(-length, kind="stable")[:MOST_RUNGS])
        rungs, way, length = rungs[some], way[some], length[some]
    a, b = rungs[:, 0], rungs[:, 1]
    linked = graph.inked[np.ix_(a, a)] & graph.inked[np.ix_(b, b)]
    r, s = np.nonzero(linked & (a[:, None] != b) & (b[:, None] != a))
    off = np.hypot(*(way[r] - way[s]).T)
    front, back = graph.points[a[s]] - graph.points[a[r]], graph.points[b[s]] - graph.points[b[r]]
    # ink counts once: no edge of a face runs along the connecting edge it meets
    ok = off <= ALIKE * np.maximum(length[r], length[s])
    for edge, rung in ((front, way[r]), (back, -way[r]), (-front, way[s]), (-back, -way[s])):
        ok &= ~_along(edge, rung, graph.tolerance)
    explained = np.hypot(*front.T) + np.hypot(*back.T) + length[s]
    saved = 100.0 * INK * explained / size - VERTEX - np.minimum(0.5 * (off / graph.tolerance) ** 2, VERTEX)
    r, s, saved = r[ok], s[ok], saved[ok]
    order = np.lexsort((-saved, r))
    r, s, saved = r[order], s[order], saved[order]
    rank = np.arange(len(r)) - np.searchsorted(r, r)
    some = rank < WIDEST
    near, gain = np.zeros((len(rungs), WIDEST), np.intp), np.full((len(rungs), WIDEST), -np.inf)
    near[r[some], rank[some]], gain[r[some], rank[some]] = s[some], saved[some]
    return _Steps(rungs, near, gain)


def _along(u: Floats, v: Floats, near: float) -> Bools:
    """Whether of two vectors (k, 2) from one point the shorter lies along the longer, at most this many pixels off."""
    a, b = np.hypot(*u.T), np.hypot(*v.T)
    off = np.abs(cross(u, v)) / (np.maximum(a, b) + 1e-9)
    return np.asarray(((u * v).sum(axis=1) > 0) & (off < np.minimum(near, ALONG * np.minimum(a, b))))


def _closed(steps: _Steps, graph: CornerGraph) -> Iterator[tuple[float, Ints]]:
    """Walks that come back to their first rung, and what they save."""
    rungs, near, gain = steps
    ends = np.zeros((len(rungs), len(graph.points)), bool)
    ends[np.arange(len(rungs))[:, None], rungs] = True
    first = np.flatnonzero((rungs[:, 0] < rungs[:, 1]) & (np.isfinite(gain).sum(axis=1) >= 2))
    walks = _Walks(first[:, None], ends[first], np.zeros(len(first)))
    for n in range(1, FARTHEST):
        walks = _grown(walks, steps, graph, ends)
        if not len(walks.path):
            return
        if n >= 2:
            first, last = walks.path[:, 0], walks.path[:, -1]
            k, w = np.nonzero((near[last] == first[:, None]) & np.isfinite(gain[last]))
            yield from zip((walks.saved[k] + gain[last[k], w]).tolist(), walks.path[k], strict=True)


def _grown(walks: _Walks, steps: _Steps, graph: CornerGraph, ends: Bools) -> _Walks:
    """One step on: the best few from each first rung, of those that meet no corner twice and do not turn back."""
    rungs, points = steps.rungs, graph.points
    path, taken, saved = walks
    last = path[:, -1]
    k, w = np.nonzero(np.isfinite(steps.gain[last]))
    r = steps.near[last[k], w]
    ok = ~(taken[k, rungs[r, 0]] | taken[k, rungs[r, 1]])
    if path.shape[1] > 1:
        for face in (0, 1):
            here = points[rungs[last[k], face]]
            ok &= ~_along(points[rungs[path[k, -2], face]] - here, points[rungs[r, face]] - here, graph.tolerance)
    k, w, r = k[ok], w[ok], r[ok]
    saved = saved[k] + steps.gain[last[k], w]
    order = np.lexsort((-saved, path[k, 0]))
    start = path[k[order], 0]
    kept = order[np.arange(len(order)) - np.searchsorted(start, start) < KEPT]
    k, r = k[kept], r[kept]
    return _Walks(np.column_stack([path[k], r]), taken[k] | ends[r], saved[kept])
