"""Park and Oh's concave hull: dig from the edges of the convex hull towards points inside.

J.-S. Park and S.-J. Oh, "A new concave hull algorithm and concaveness measure for n-dimensional datasets", J. Inf.
Sci. Eng. 28 (2012).
"""

from __future__ import annotations

from collections import deque

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.graham import convex_hull
from sketch2shape.connectors.polygon import blocked
from sketch2shape.errors import UsageError
from sketch2shape.geometry import segment_distance
from sketch2shape.model import Floats, Ints

#: digging threshold N when none is given; a lower one digs deeper
THRESHOLD = 1.5


def park_oh(points: Floats, *, N: float = THRESHOLD) -> Walk:
    """Dig into hull edges while they are long against the distance of the point inside. O(n h).

    Strategy: a queue of the ring's edges. For edge ab, p is the free point nearest to it that no neighbouring edge of
    the ring is nearer to. If |ab| / min(|pa|, |pb|) > N and neither ap nor pb meets another edge, ab gives way to ap
    and pb.

    N : the ratio above which an edge is dug, > 0
    Raises UsageError for N <= 0.
    """
    ring, free = dig(points, N)
    violated = (f"{len(free)} points were left out",) if len(free) else ()
    return Walk(ring, violated=violated, parameters={"N": N})


def park_oh_all(points: Floats, *, N: float = THRESHOLD) -> Walk:
    """Park and Oh's hull, "modified" so that no vertex is lost. O(n^2 + n h).

    The paper compares itself with a modified Park-Oh and does not say what was modified. This is a modification of
    our own: each left-over point goes into the edge where it costs the least detour and causes no crossing, cheapest
    point first.

    N : as for park_oh
    """
    ring, free = dig(points, N)
    order, forced = insert_all(points, ring, free)
    violated = (f"{forced} points could only be inserted across another edge",) if forced else ()
    return Walk(order, met=("every point is used",), violated=violated, parameters={"N": N})


def dig(points: Floats, N: float) -> tuple[Ints, Ints]:
    """The dug ring and the points left out."""
    if not N > 0:
        raise UsageError(f"expected N > 0, got {N!r}")
    hull = convex_hull(points)
    after = {int(a): int(b) for a, b in zip(hull, np.roll(hull, -1), strict=True)}
    before = {b: a for a, b in after.items()}
    free = np.ones(len(points), dtype=bool)
    free[hull] = False
    queue = deque(after.items())
    while queue and free.any():
        a, b = queue.popleft()
        p = _candidate(points, np.flatnonzero(free), (before[a], a, b, after[b]))
        if p is None or not _worth_digging(points, a, b, p, N):
            continue
        edges = np.array([e for e in after.items() if e != (a, b)], dtype=np.intp)
        if blocked(points, a, p, edges) or blocked(points, p, b, edges):
            continue
        after[a], after[p], before[p], before[b] = p, b, a, p
        free[p] = False
        queue.extend([(a, p), (p, b)])
    ring = [int(hull[0])]
    while (following := after[ring[-1]]) != ring[0]:
        ring.append(following)
    return np.array(ring, dtype=np.intp), np.flatnonzero(free)


def _candidate(points: Floats, free: Ints, corners: tuple[int, int, int, int]) -> int | None:
    """The free point nearest to edge ab among those that neither neighbouring edge is nearer to."""
    left, a, b, right = points[list(corners)]
    others = points[free]
    own = segment_distance(others, a, b)
    mine = (own <= segment_distance(others, left, a)) & (own <= segment_distance(others, b, right))
    if not mine.any():
        return None
    return int(free[mine][np.argmin(own[mine])])


def _worth_digging(points: Floats, a: int, b: int, p: int, N: float) -> bool:
    edge = float(np.hypot(*(points[b] - points[a])))
    reach = min(float(np.hypot(*(points[p] - points[a]))), float(np.hypot(*(points[p] - points[b]))))
    return edge > N * reach


def insert_all(points: Floats, ring: Ints, free: Ints) -> tuple[Ints, int]:
    """Insert every free point where it lengthens the ring least without a crossing; also how many had to cross."""
    order, rest, forced = [int(i) for i in ring], [int(i) for i in free], 0
    while rest:
        i, at, crosses = _cheapest_insertion(points, order, np.array(rest))
        order.insert(at + 1, i)
        rest.remove(i)
        forced += crosses
    return np.array(order, dtype=np.intp), forced


def _cheapest_insertion(points: Floats, order: list[int], rest: Ints) -> tuple[int, int, bool]:
    """(point, edge to put it in, whether it crosses)."""
    ring = np.array(order)
    edges = np.c_[ring, np.roll(ring, -1)]
    a, b, p = points[edges[:, 0]], points[edges[:, 1]], points[rest][:, None]
    detour = np.hypot(*np.moveaxis(p - a, -1, 0)) + np.hypot(*np.moveaxis(p - b, -1, 0)) - np.hypot(*(b - a).T)
    ranked = np.argsort(detour, axis=None, kind="stable")
    for flat in ranked:
        r, e = divmod(int(flat), len(edges))
        others = np.delete(edges, e, axis=0)
        i = int(rest[r])
        if not blocked(points, int(edges[e, 0]), i, others) and not blocked(points, i, int(edges[e, 1]), others):
            return i, e, False
    r, e = divmod(int(ranked[0]), len(edges))
    return int(rest[r]), e, True
