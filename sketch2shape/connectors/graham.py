"""Graham's scan: the convex hull by one angular sort.

R. L. Graham, "An efficient algorithm for determining the convex hull of a finite planar set", Inf. Process. Lett. 1
(1972).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.model import Floats, Ints


def convex_hull(points: Floats) -> Ints:
    """(h,) hull corners, counter-clockwise with y up, from the lowest point; points on hull edges are left out."""
    x, y = points[:, 0], points[:, 1]
    anchor = int(np.lexsort((x, y))[0])
    dx, dy = x - x[anchor], y - y[anchor]
    by_angle = np.lexsort((np.hypot(dx, dy), np.arctan2(dy, dx)))
    xs, ys = x.tolist(), y.tolist()
    stack: list[int] = [anchor]
    for i in by_angle.tolist():
        if i == anchor:
            continue
        while len(stack) > 1:
            a, b = stack[-2], stack[-1]
            if (xs[b] - xs[a]) * (ys[i] - ys[a]) - (ys[b] - ys[a]) * (xs[i] - xs[a]) > 0:
                break
            stack.pop()
        stack.append(i)
    return np.array(stack, dtype=np.intp)


def graham(points: Floats) -> Walk:
    """The convex hull; points inside are left out. O(n log n)."""
    return Walk(convex_hull(points))
