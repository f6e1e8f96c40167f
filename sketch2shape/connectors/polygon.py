"""Plane geometry the connectors share: turns, crossings, distances, simple rings."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Bools, Floats, Ints

#: a point nearer to a line than this part of the points' size lies on it
ON_LINE = 1e-9
#: above this many vertices a ring is tested for crossings with an index (GEOS) rather than pair by pair
PAIRWISE = 600


def cross(a: Floats, b: Floats) -> Floats:
    """z of the cross product of vectors (..., 2): positive if b is counter-clockwise of a (y up)."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def size_of(points: Floats) -> float:
    """Diagonal of the bounding box."""
    return float(np.hypot(*np.ptp(points, axis=0)))


def signed_area(ring: Floats) -> float:
    """Area of a ring (n, 2): positive if counter-clockwise (y up)."""
    centred = ring - ring[0]
    return 0.5 * float(cross(centred, np.roll(centred, -1, axis=0)).sum())


def distances(points: Floats) -> Floats:
    """(n, n) distances between points."""
    gap = points[:, None] - points[None]
    return np.asarray(np.hypot(gap[..., 0], gap[..., 1]))


def segment_distance(p: Floats, a: Floats, b: Floats) -> Floats:
    """Distance of points p (..., 2) from segments a-b, broadcasting."""
    ab, ap = b - a, p - a
    length2 = (ab * ab).sum(axis=-1)
    t = np.clip((ap * ab).sum(axis=-1) / np.where(length2 > 0, length2, 1.0), 0.0, 1.0)
    off = ap - t[..., None] * ab
    return np.asarray(np.hypot(off[..., 0], off[..., 1]))


def segments_meet(a: Floats, b: Floats, c: Floats, d: Floats, slack: float = 0.0) -> Bools:
    """Whether segments a-b and c-d have a point in common, broadcasting; orientations within `slack` count as zero."""

    def side(p: Floats, q: Floats, r: Floats) -> Floats:
        value = cross(q - p, r - p)
        return np.where(np.abs(value) <= slack, 0.0, np.sign(value))

    def between(p: Floats, q: Floats, r: Floats) -> Bools:
        low, high = np.minimum(p, q), np.maximum(p, q)
        return np.asarray(((low <= r) & (r <= high)).all(axis=-1))

    s1, s2, s3, s4 = side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)
    proper = (s1 * s2 < 0) & (s3 * s4 < 0)
    touch = (s1 == 0) & between(a, b, c) | (s2 == 0) & between(a, b, d)
    touch |= (s3 == 0) & between(c, d, a) | (s4 == 0) & between(c, d, b)
    return np.asarray(proper | touch)


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
