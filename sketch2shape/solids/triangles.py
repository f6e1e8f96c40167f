"""Triangles that fill a flat face, over exactly its vertices."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from sketch2shape.geometry import cross, signed_area
from sketch2shape.model import Floats, Ints, Ring

#: decimals kept of a face's points, in units of its size: more than that is noise, and faces alike get triangles alike
_DECIMALS = 9

#: how far a face's rings are moved out for the cut alone, in units of its size: 0, then a hair if they touch each other
_SHIFTS = (0.0, 1e-6, -1e-6)


def flat_triangles(vertices: Floats, rings: Sequence[Ring], normal: Floats) -> Ints:
    """(k, 3) triangles of a flat face, rows of the vertices, turned about the normal as its outer ring is.

    They are found in the order of the vertices' numbers, so that the rings' starts have no say: faces that are alike
    and lie alike, as the bases of a prism are, have the same triangles.
    """
    ordered = [in_order(ring) for ring in rings]
    turned_back = ordered[0][1] != rings[0][(rings[0].index(ordered[0][0]) + 1) % len(rings[0])]
    triangles = _flat(vertices, ordered, -normal if turned_back else normal)
    return triangles[:, ::-1] if turned_back else triangles


def in_order(ring: Ring) -> Ring:
    """The ring from its vertex of the lowest number on, towards the lower of that one's neighbours."""
    start = ring.index(min(ring))
    forward = ring[start:] + ring[:start]
    return min(forward, (forward[0], *forward[:0:-1]))


def _flat(vertices: Floats, rings: Sequence[Ring], normal: Floats) -> Ints:
    """Triangles of a flat face, turned about the normal as its outer ring is."""
    outer = rings[0]
    if len(rings) == 1 and len(outer) <= 4:
        few = np.array([(outer[0], b, c) for b, c in pairwise(outer[1:])], np.intp)
        a, b, c = vertices[few].swapaxes(0, 1)
        if len(few) == 1 or bool((np.cross(b - a, c - a) @ normal > 0).all()):
            return few
    along = vertices[outer[1]] - vertices[outer[0]]
    members = [i for ring in rings for i in ring]
    flat = (vertices[members] - vertices[outer[0]]) @ np.array([along, np.cross(normal, along)]).T
    flat = (flat / (np.abs(flat).max() or 1.0)).round(_DECIMALS)
    return np.array(members, np.intp)[triangulate(flat, [len(ring) for ring in rings])]


def triangulate(points: Floats, sizes: Sequence[int]) -> Ints:
    """(k, 3) indices of triangles that fill a polygon with holes, k = m + 2 * holes - 2.

    points : (m, 2) float, the outer ring, then each hole; any orientation
    sizes  : vertices of each ring, the outer ring first

    Triangles turn the way the outer ring does, and every ring edge belongs to exactly one of them, also where a vertex
    lies on a straight edge. The triangulation is the constrained Delaunay one (GEOS). It has none for rings that touch,
    so these are then moved apart by a hair for the cut alone. A ring that crosses itself has no true triangulation; it
    gets a fan, which is at least closed.
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
        triangles = _delaunay(_moved_out(points, rings, shift), sizes)
        if _fills(triangles, borders, len(points), len(sizes)):
            break
    else:
        triangles = _fan(rings)
    return triangles[:, ::-1] if flip else triangles


def _moved_out(points: Floats, rings: list[Ints], shift: float) -> Floats:
    """Points moved away from the polygon's inside by a part of its size."""
    moved = points.copy()
    for ring in rings if shift else []:
        chord = np.roll(points[ring], -1, axis=0) - np.roll(points[ring], 1, axis=0)
        length = np.hypot(*chord.T)
        normal = np.c_[chord[:, 1], -chord[:, 0]] / np.where(length > 0, length, 1.0)[:, None]
        moved[ring] += shift * float(np.ptp(points, axis=0).max()) * normal
    return moved


def _delaunay(points: Floats, sizes: Sequence[int]) -> Ints:
    """The constrained Delaunay triangles, turned from the first axis to the second; none if GEOS finds none."""
    import shapely

    outer, *holes = np.split(points, np.cumsum(sizes)[:-1])
    none = np.zeros((0, 3), np.intp)
    try:
        found = shapely.constrained_delaunay_triangles(shapely.Polygon(outer, holes))
    except shapely.errors.GEOSException:
        return none
    corners = shapely.get_coordinates(found).reshape(-1, 4, 2)[:, :3]
    number = {point: i for i, point in enumerate(map(tuple, points.tolist()))}
    try:
        triangles = np.array([[number[x, y] for x, y in c] for c in corners.tolist()], np.intp).reshape(-1, 3)
    except KeyError:  # a point that is no vertex
        return none
    a, b, c = points[triangles].swapaxes(0, 1)
    return np.where((cross(b - a, c - a) < 0)[:, None], triangles[:, ::-1], triangles)


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
