"""The ec-shape of Methirumangalath and others.

S. Methirumangalath, A. D. Parakkat, R. Muthuganapathy, "A unified approach towards reconstruction of a planar point
set", Computers & Graphics 51 (2015).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.chi_shape import left_out
from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.delaunay import Border, eat, triangulate
from sketch2shape.errors import UsageError
from sketch2shape.model import Floats


def ec_shape(points: Floats, *, v: float = 1.0) -> Walk:
    """As chi-shape, but circles decide which border triangle goes instead of a length. O(n log n).

    Strategy: longest border edge ab first, with apex c not on the border. Its triangle goes if c is within v|ab|/2 of
    ab's midpoint. It also goes if, for one of its inner edges pq with the neighbour's apex f and D = v|ab|, either
    |pq| >= D and f is within vD/2 of pq's midpoint, or |pq| < D and f is in a circle of radius vD/2 through p and q.

    v : size of the circles, > 0; larger digs more
    Raises UsageError for v <= 0.
    """
    if not v > 0:
        raise UsageError(f"expected v > 0, got {v!r}")
    border = Border(points, triangulate(points))

    def may_go(a: int, b: int, c: int) -> bool:
        edge = border.length(a, b)
        if _gap(points[c], (points[a] + points[b]) / 2) <= v * edge / 2:
            return True
        return any(_neighbour_in_circle(border, p, q, apex, v, edge) for p, q, apex in ((a, c, b), (b, c, a)))

    eat(border, may_go, lambda *_: False)
    order = border.ring()
    return Walk(order, violated=left_out(points, order), parameters={"v": v})


def _gap(p: Floats, q: Floats) -> float:
    return float(np.hypot(*(p - q)))


def _neighbour_in_circle(border: Border, p: int, q: int, apex: int, v: float, edge: float) -> bool:
    f = border.beyond(p, q, apex)
    if f is None:
        return False
    a, b, far = border.points[p], border.points[q], border.points[f]
    middle, inner, diameter = (a + b) / 2, border.length(p, q), v * edge
    radius = v * diameter / 2
    if inner >= diameter:
        return _gap(far, middle) <= radius
    if radius < inner / 2:
        return False  # no circle of that radius passes through both
    normal = np.array([a[1] - b[1], b[0] - a[0]]) / inner * float(np.sqrt(radius**2 - inner**2 / 4))
    return min(_gap(far, middle + normal), _gap(far, middle - normal)) <= radius
