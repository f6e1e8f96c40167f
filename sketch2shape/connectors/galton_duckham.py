"""Galton and Duckham's swinging arm.

A. Galton and M. Duckham, "What is the region occupied by a set of points?", GIScience 2006.
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.errors import UsageError
from sketch2shape.geometry import distances, inside
from sketch2shape.model import Bools, Floats, Ints

#: how many arm lengths are tried when none is given
TRIES = 48


def galton_duckham(points: Floats, *, r: float | None = None) -> Walk:
    """Swing an arm of length r clockwise (y up) about the current point until it meets the next. O(n h).

    Strategy: start at the leftmost point with the arm to the left. The next point is the first within r that the arm
    sweeps over; then the arm swings on from the direction of the point just left. The ring is closed when an
    edge repeats. Points outside the ring start another one, so a short arm gives several polygons; a vertex can be
    passed more than once.

    r : arm length, units of the points; None takes the shortest that gives one ring around all points without passing a
        vertex twice (tried at up to 48 lengths between the longest edge of the spanning tree and the diameter)
    `order` is the first ring, each vertex once; `rings` are all closed walks. Raises UsageError for r <= 0.
    """
    gaps = distances(points)
    if r is None:
        r, rings = _shortest_arm(points, gaps)
    elif r > 0:
        rings = _all_rings(points, gaps, r)
    else:
        raise UsageError(f"expected r > 0, got {r!r}")
    first = rings[0]
    order = np.array(list(dict.fromkeys(first.tolist())), dtype=np.intp)
    violated = []
    if len(order) < len(first):
        violated.append("a vertex is passed more than once")
    if len(rings) > 1:
        violated.append(f"the arm is too short for one polygon: {len(rings)} polygons")
    return Walk(order, violated=tuple(violated), rings=tuple(rings), parameters={"r": r})


def _shortest_arm(points: Floats, gaps: Floats) -> tuple[float, list[Ints]]:
    lengths = np.unique(gaps[gaps >= _longest_tree_edge(gaps)])
    chosen = lengths[np.unique(np.linspace(0, len(lengths) - 1, TRIES).astype(int))]
    for r in chosen.tolist():
        rings = _all_rings(points, gaps, r)
        if len(rings) == 1 and len(set(rings[0].tolist())) == len(rings[0]) >= 3:
            return r, rings
    longest = float(lengths[-1])
    return longest, _all_rings(points, gaps, longest)


def _longest_tree_edge(gaps: Floats) -> float:
    """Longest edge of the minimum spanning tree (Prim)."""
    reach, longest = gaps[0].copy(), 0.0
    outside = np.ones(len(gaps), dtype=bool)
    outside[0] = False
    while outside.any():
        candidates = np.flatnonzero(outside)
        i = int(candidates[np.argmin(reach[candidates])])
        longest = max(longest, float(reach[i]))
        outside[i] = False
        reach = np.minimum(reach, gaps[i])
    return longest


def _all_rings(points: Floats, gaps: Floats, r: float) -> list[Ints]:
    rings: list[Ints] = []
    free = np.ones(len(points), dtype=bool)
    while free.any():
        candidates = np.flatnonzero(free)
        start = int(candidates[np.lexsort((points[candidates, 1], points[candidates, 0]))[0]])
        ring = _swing(points, gaps, r, start, free)
        rings.append(ring)
        free[ring] = False
        if len(ring) > 2:
            free[candidates[inside(points[candidates], points[ring])]] = False
    return rings


def _swing(points: Floats, gaps: Floats, r: float, start: int, free: Bools) -> Ints:
    ring, arm, current = [start], np.pi, start
    seen: set[tuple[int, int]] = set()
    while True:
        near = np.flatnonzero(free & (gaps[current] <= r))
        near = near[near != current]
        if len(near) == 0:
            return np.array(ring, dtype=np.intp)
        vectors = points[near] - points[current]
        angles = np.arctan2(vectors[:, 1], vectors[:, 0])
        swept = np.mod(arm - angles, 2 * np.pi)
        swept[swept < 1e-12] = 2 * np.pi  # straight back only when there is nothing else
        if current == start and not seen:
            swept[swept >= 2 * np.pi] = 0.0
        at = np.lexsort((gaps[current][near], swept))[0]
        following = int(near[at])
        if (current, following) in seen:
            return np.array(ring[:-1] if len(ring) > 1 else ring, dtype=np.intp)
        seen.add((current, following))
        ring.append(following)
        arm = float(np.arctan2(*(points[current] - points[following])[::-1]))
        current = following
