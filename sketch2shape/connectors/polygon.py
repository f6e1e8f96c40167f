"""Polygons as the connectors share them: edges that block each other, simple rings, orders."""

from __future__ import annotations

import numpy as np

from sketch2shape.geometry import cross, segments_meet
from sketch2shape.model import Floats, Ints

#: a point nearer to a line than this part of the points' size lies on it
ON_LINE = 1e-9
#: above this many vertices a ring is tested for crossings with an index (GEOS) rather than pair by pair
PAIRWISE = 600


def blocked(points: Floats, a: int, b: int, edges: Ints) -> bool:
    """Whether the segment a-b meets one of the edges (m, 2) anywhere but in an end it shares with it."""
    if len(edges) == 0:
        return False
    shared = (edges == a) | (edges == b)
    free = ~shared.any(axis=1)
    p, q = points[a], points[b]
    if free.any() and bool(segments_meet(p, q, points[edges[free, 0]], points[edges[free, 1]]).any()):
        return True
    return any(_overlap(points, a, b, int(i), int(j)) for i, j in edges[~free])


def _overlap(points: Floats, a: int, b: int, i: int, j: int) -> bool:
    """Whether edges with a common end lie on each other."""
    if {a, b} == {i, j}:
        return True
    common, other = (a, b) if a in (i, j) else (b, a)
    u, v = points[other] - points[common], points[j if i == common else i] - points[common]
    return float(cross(u, v)) == 0.0 and float(u @ v) > 0.0


def ring_is_simple(ring: Floats) -> bool:
    """Whether a ring (n, 2) neither crosses nor touches itself."""
    n = len(ring)
    if n < 3:
        return False
    if n > PAIRWISE:
        import shapely

        return bool(shapely.is_valid(shapely.polygons(ring)))
    after = np.roll(ring, -1, axis=0)
    i, j = np.triu_indices(n, 1)
    apart = (j - i > 1) & ~((i == 0) & (j == n - 1))
    i, j = i[apart], j[apart]
    if bool(segments_meet(ring[i], after[i], ring[j], after[j]).any()):
        return False
    u, v = ring - after, np.roll(after, -1, axis=0) - after
    return not bool(((cross(u, v) == 0.0) & ((u * v).sum(axis=1) > 0)).any())


def ring_edges_of(order: Ints) -> Ints:
    """(n, 2) consecutive pairs of a closed order."""
    return np.column_stack((order, np.roll(order, -1)))


def circumradii(points: Floats, triangles: Ints) -> Floats:
    """(m,) circumradius of each triangle (m, 3)."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    sides = np.hypot(*(b - a).T) * np.hypot(*(c - b).T) * np.hypot(*(a - c).T)
    twice = np.abs(cross(b - a, c - a))
    return np.asarray(sides / np.maximum(2 * twice, np.finfo(float).tiny))


def canonical(order: Ints) -> tuple[int, ...]:
    """The cyclic order as a tuple that starts at its smallest index and runs towards the smaller neighbour."""
    values = [int(i) for i in order]
    if not values:
        return ()
    start = values.index(min(values))
    forward = values[start:] + values[:start]
    backward = [forward[0], *forward[:0:-1]]
    return tuple(min(forward, backward))
