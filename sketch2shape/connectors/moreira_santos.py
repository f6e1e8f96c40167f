"""Moreira and Santos's k nearest neighbours concave hull.

A. Moreira and M. Y. Santos, "Concave hull: a k-nearest neighbours approach for the computation of the region occupied
by a set of points", GRAPP 2007.
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.graham import convex_hull
from sketch2shape.connectors.polygon import blocked
from sketch2shape.errors import UsageError
from sketch2shape.geometry import distances, inside, segment_distance, size_of
from sketch2shape.model import Floats, Ints


def moreira_santos(points: Floats, *, k: int = 3) -> Walk:
    """Walk to the right-most turn among the k nearest points; with a larger k after a failure. O(n h k) for each k.

    Strategy: start at the lowest point. Of the k nearest unused points the one is next that turns most to the right
    (y up, as seen from the edge just walked) and whose segment meets no edge walked before. From the fifth step
    (sooner for four points or fewer) the start may be chosen again, which closes the ring. A dead end, or a point
    left outside, restarts with k + 1.

    k : neighbours to look at first, >= 3
    The convex hull is given, and said so, if no k succeeds. Raises UsageError for k < 3.
    """
    if k < 3:
        raise UsageError(f"expected k >= 3, got {k!r}")
    neighbours = np.argsort(distances(points), axis=1, kind="stable")[:, 1:]
    for tried in range(min(k, len(points) - 1), len(points)):
        ring = _ring(points, neighbours, tried)
        if ring is not None and _encloses(points, ring):
            left_out = len(points) - len(ring)
            violated = (f"{left_out} points are inside the ring",) if left_out else ()
            return Walk(ring, violated=violated, parameters={"k": tried})
    return Walk(
        convex_hull(points), violated=("no k gives a ring around all points: convex hull",), parameters={"k": k}
    )


def _ring(points: Floats, neighbours: Ints, k: int) -> Ints | None:
    start = int(np.lexsort((points[:, 0], points[:, 1]))[0])
    ring, used, back = [start], {start}, np.pi
    while True:
        if len(ring) == min(4, len(points) - 1):
            used.discard(start)
        nearest = [int(i) for i in neighbours[ring[-1]] if i not in used][:k]
        chosen = _first_free(points, ring, _by_right_turn(points, ring[-1], nearest, back), start)
        if chosen is None:
            return None
        if chosen == start:
            return np.array(ring, dtype=np.intp)
        back = float(np.arctan2(*(points[ring[-1]] - points[chosen])[::-1]))
        ring.append(chosen)
        used.add(chosen)
        if len(used) == len(points) and start in used and len(ring) < 3:
            return None


def _by_right_turn(points: Floats, current: int, candidates: list[int], back: float) -> list[int]:
    """Candidates by the angle swept counter-clockwise from the edge just walked: the sharpest right turn first."""
    if not candidates:
        return []
    vectors = points[candidates] - points[current]
    swept = np.mod(np.arctan2(vectors[:, 1], vectors[:, 0]) - back, 2 * np.pi)
    swept[swept < 1e-12] = 2 * np.pi
    return [candidates[i] for i in np.argsort(swept, kind="stable")]


def _first_free(points: Floats, ring: list[int], candidates: list[int], start: int) -> int | None:
    walked = np.array([ring[:-1], ring[1:]], dtype=np.intp).T
    for candidate in candidates:
        if candidate == start and len(ring) < 3:
            continue
        if not blocked(points, ring[-1], candidate, walked):
            return candidate
    return None


def _encloses(points: Floats, ring: Ints) -> bool:
    """Whether every point is inside the ring or on it."""
    rest = np.setdiff1d(np.arange(len(points)), ring)
    if len(rest) == 0:
        return True
    corners = points[ring]
    outside = points[rest[~inside(points[rest], corners)]]
    gap = segment_distance(outside[:, None], corners[None], np.roll(corners, -1, axis=0)[None])
    return bool((gap.min(axis=1, initial=np.inf) <= 1e-9 * size_of(points)).all())
