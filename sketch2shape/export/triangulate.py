"""Caps of a solid: triangles over a polygon with holes that use every vertex of every ring."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sketch2shape.model import Floats, Ints

#: shifts tried, as a part of the face's size, where vertices on a straight edge defeat the ear cutter
_SHIFTS = (0.0, 1e-9, 1e-7, 1e-5, 1e-3)


def triangulate(points: Floats, sizes: list[int]) -> Ints:
    """(k, 3) indices of triangles that fill a polygon with holes, k = m + 2 * holes - 2.

    points : (m, 2) float, the outer ring, then each hole; any orientation
    sizes  : vertices of each ring, the outer ring first

    Triangles turn the way the outer ring does, and every ring edge belongs to exactly one of them, also where a
    vertex lies on a straight edge: an ear cutter drops such a vertex, so the points are then moved apart by a hair
    for the cut alone. A ring that crosses itself has no true triangulation; it gets a fan, which is at least closed.
    """
    rings: list[Ints] = []
    start = 0
    for n in sizes:
        ring = np.arange(start, start + n)
        rings.append(ring if (signed_area(points[ring]) > 0) != bool(rings) else ring[::-1])
        start += n
    flip = signed_area(points[: sizes[0]]) <= 0
    borders = {(int(a), int(b)) for ring in rings for a, b in zip(ring, np.roll(ring, -1), strict=True)}
    for shift in _SHIFTS:
        triangles = _ears(_bulged(points, rings, shift), sizes)
        if _fills(triangles, borders, len(points), len(sizes)):
            break
    else:
        triangles = _fan(rings)
    return triangles[:, ::-1] if flip else triangles


def signed_area(ring: Floats) -> float:
    """Shoelace area of an (n, 2) ring: positive if it turns from the first axis to the second."""
    x, y = (ring - ring[0]).T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def _bulged(points: Floats, rings: list[Ints], shift: float) -> Floats:
    """Points moved outward by a part of the size, most in the middle of a straight run, so that none is collinear."""
    moved = points.copy()
    for ring in rings if shift else []:
        p = points[ring]
        chord = np.roll(p, -1, axis=0) - np.roll(p, 1, axis=0)
        length = np.hypot(*chord.T)
        normal = np.c_[chord[:, 1], -chord[:, 0]] / np.where(length > 0, length, 1.0)[:, None]
        middle = p.mean(axis=0)
        along = np.linalg.norm(p - middle, axis=1)
        size = float(along.max()) or 1.0
        moved[ring] = p + normal * (shift * size * (2.0 - (along / size) ** 2))[:, None]
    return moved


def _ears(points: Floats, sizes: list[int]) -> Ints:
    """Triangles of the ear cutter, turned from the first axis to the second."""
    import mapbox_earcut

    ends = np.cumsum(sizes).astype(np.uint32)
    triangles = mapbox_earcut.triangulate_float64(points, ends).reshape(-1, 3).astype(np.intp)
    a, b, c = points[triangles].transpose(1, 0, 2)
    u, v = b - a, c - a
    return np.where((u[:, 0] * v[:, 1] < u[:, 1] * v[:, 0])[:, None], triangles[:, ::-1], triangles)


def _fills(triangles: Ints, borders: set[tuple[int, int]], m: int, rings: int) -> bool:
    """Is every ring edge used once, in the ring's direction, and every other edge twice, once each way?"""
    if len(triangles) != m + 2 * rings - 4:
        return False
    edges = [(int(t[i]), int(t[(i + 1) % 3])) for t in triangles for i in range(3)]
    used = set(edges)
    return len(used) == len(edges) and {e for e in edges if e[::-1] not in used} == borders


def _fan(rings: list[Ints]) -> Ints:
    """Triangles from the outer ring's first vertex around all rings, joined by bridges."""
    walk = list(rings[0])
    for hole in rings[1:]:
        walk = [*walk, walk[0], hole[0], *hole[1:], hole[0]]
    triangles = [(walk[0], b, c) for b, c in pairwise(walk[1:])]
    return np.array([t for t in triangles if len(set(t)) == 3], np.intp).reshape(-1, 3)
