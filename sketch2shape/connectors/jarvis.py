"""Jarvis's march: the convex hull by gift wrapping.

R. A. Jarvis, "On the identification of the convex hull of a finite set of points in the plane", Inf. Process. Lett. 2
(1973).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.model import Floats

#: directions (radians) nearer to each other than this are one: the farther point is the corner
SAME_DIRECTION = 1e-11


def jarvis(points: Floats) -> Walk:
    """The convex hull, counter-clockwise with y up; points inside are left out. O(n h) for h hull corners."""
    start = int(np.lexsort((points[:, 0], points[:, 1]))[0])
    order, heading = [start], 0.0
    while len(order) <= len(points):
        following, heading = _wrap(points, order[-1], heading)
        if following in order:  # the start; or, by rounding, a corner beside it
            break
        order.append(following)
    return Walk(np.array(order, dtype=np.intp))


def _wrap(points: Floats, current: int, heading: float) -> tuple[int, float]:
    """The first point met turning left from the heading (the farthest if several lie there), and its direction."""
    arms = points - points[current]
    reach = np.hypot(arms[:, 0], arms[:, 1])
    direction = np.arctan2(arms[:, 1], arms[:, 0])
    turn = np.mod(direction - heading, 2 * np.pi)
    turn[turn > 2 * np.pi - SAME_DIRECTION] = 0.0  # straight on, but for rounding
    turn[current] = np.inf
    first = np.flatnonzero(turn <= turn.min() + SAME_DIRECTION)
    best = int(first[np.argmax(reach[first])])
    return best, float(direction[best])
