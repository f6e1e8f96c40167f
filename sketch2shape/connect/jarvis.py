"""Jarvis's march: the convex hull by gift wrapping.

R. A. Jarvis, "On the identification of the convex hull of a finite set of points in the plane", Inf. Process. Lett. 2
(1973).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connect.connection import Walk
from sketch2shape.connect.geometry import cross
from sketch2shape.model import Floats


def jarvis(points: Floats) -> Walk:
    """The convex hull, counter-clockwise with y up; points inside are left out. O(n h) for h hull corners."""
    start = int(np.lexsort((points[:, 0], points[:, 1]))[0])
    order = [start]
    while len(order) <= len(points):
        following = _wrap(points, order[-1])
        if following == start:
            break
        order.append(following)
    return Walk(np.array(order, dtype=np.intp))


def _wrap(points: Floats, current: int) -> int:
    """The point with all others to the left of the line to it; the farthest of several on that line."""
    arms = points - points[current]
    reach = np.hypot(arms[:, 0], arms[:, 1])
    best = int(np.argmax(reach))
    while True:
        turn = cross(arms[best], arms)
        ahead = turn < 0
        if ahead.any():  # the one farthest round to the right
            units = arms[ahead] / reach[ahead, None]
            best = int(np.flatnonzero(ahead)[np.argmin(cross(arms[best], units))])
            continue
        on_line = (turn == 0) & ((arms * arms[best]).sum(axis=1) > 0)
        return int(np.flatnonzero(on_line)[np.argmax(reach[on_line])])
