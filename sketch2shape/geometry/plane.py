"""Points, segments and rings in the plane."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Bools, Floats


def cross(a: Floats, b: Floats) -> Floats:
    """z of the cross product of vectors (..., 2): positive if b is counter-clockwise of a (y up)."""
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])


def size_of(points: Floats) -> float:
    """Diagonal of the bounding box of points (n, 2)."""
    return float(np.hypot(*np.ptp(points, axis=0)))


def signed_area(ring: Floats) -> float:
    """Area of a ring (n, 2): positive if counter-clockwise (y up)."""
    centred = ring - ring[0]
    return 0.5 * float(cross(centred, np.roll(centred, -1, axis=0)).sum())


def distances(points: Floats) -> Floats:
    """(n, n) distances between points (n, 2)."""
    gap = points[:, None] - points[None]
    return np.asarray(np.hypot(gap[..., 0], gap[..., 1]))


def are_simple(polygons: Floats) -> Bools:
    """(...) bool: no two edges of a polygon cross; polygons (..., n, 2)."""
    after = np.r_[1 : polygons.shape[-2], 0]
    x, y = polygons[..., 0], polygons[..., 1]
    dx, dy = x[..., after] - x, y[..., after] - y
    # on which side of the line through edge i (second to last axis) vertex j (last axis) lies
    side = dx[..., None] * (y[..., None, :] - y[..., None]) - dy[..., None] * (x[..., None, :] - x[..., None])
    apart = side * side[..., after] < -1e-9
    return np.asarray(~(apart & np.swapaxes(apart, -1, -2)).any(axis=(-2, -1)))


def inside(points: Floats, ring: Floats) -> Bools:
    """Which points (m, 2) lie inside a ring (n, 2), by counting crossings of a ray to the right."""
    x, y = points[:, None, 0], points[:, None, 1]
    a, b = ring, np.roll(ring, -1, axis=0)
    spans = (a[:, 1] > y) != (b[:, 1] > y)
    rise = np.where(a[:, 1] == b[:, 1], 1.0, b[:, 1] - a[:, 1])
    at = a[:, 0] + (y - a[:, 1]) / rise * (b[:, 0] - a[:, 0])
    return np.asarray((spans & (x < at)).sum(axis=1) % 2 == 1)


def segment_distance(p: Floats, a: Floats, b: Floats) -> Floats:
    """Distance of points p (..., 2) from segments a-b, broadcasting."""
    ab, ap = b - a, p - a
    length2 = (ab * ab).sum(axis=-1)
    t = np.clip((ap * ab).sum(axis=-1) / np.where(length2 > 0, length2, 1.0), 0.0, 1.0)
    off = ap - t[..., None] * ab
    return np.asarray(np.hypot(off[..., 0], off[..., 1]))


def line_crossings(a: Floats, along: Floats, b: Floats, across: Floats) -> tuple[Floats, Floats]:
    """Where lines a + s along and b + t across meet: s and t, broadcasting; not finite where they are parallel."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        gap, turn = b - a, cross(along, across)
        return cross(gap, across) / turn, cross(gap, along) / turn


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
