"""Corners: the points where strokes end, meet or turn.

A vertex of the object is where stroke ENDS meet, at the least-squares intersection of their lines; an X, where two
strokes run straight on, is a crossing and no vertex; a T is one end on another stroke's interior.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

import numpy as np

from sketch2shape.geometry import cross, line_crossings
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes.tracing import Strokes

#: least sine of the angle between strokes whose crossing says anything; 6 degrees
LEAST_SINE = 0.1


@dataclass(frozen=True)
class Corners:
    """Corners, the surest first.

    points : (k, 2) float, pixels
    degree : (k,) int, how many stroke ends meet there
    on     : (k,) bool, whether it also lies on the interior of another stroke (T)
    strokes: (m, 2) int, the corner at each end of each stroke
    """

    points: Floats
    degree: Ints
    on: Bools
    strokes: Ints


def join_ends(strokes: Strokes, pen: float) -> Corners:
    """Corners where the ends of strokes meet.

    pen : pen width, pixels
    """
    ends = strokes.ends.reshape(-1, 2)
    if not len(ends):
        none = np.zeros(0, np.intp)
        return Corners(np.zeros((0, 2)), none, np.zeros(0, bool), np.zeros((0, 2), np.intp))
    span = strokes.ends[:, 1] - strokes.ends[:, 0]
    lengths = np.hypot(span[:, 0], span[:, 1]) + 1e-9
    direction = np.repeat(span / lengths[:, None], 2, axis=0)
    bunches = _bunches(ends, direction, np.repeat(lengths, 2), strokes.tolerance, pen)
    label = np.zeros(len(ends), np.intp)
    for k, bunch in enumerate(bunches):
        label[bunch.members] = k
    points = np.array([bunch.meeting_point for bunch in bunches])
    degree = np.array([len(bunch.members) for bunch in bunches], np.intp)
    on = _on_interior(points, strokes, strokes.tolerance + pen)
    return Corners(points, degree, on, label.reshape(-1, 2))


def crossed(strokes: Strokes, reach: float) -> Floats:
    """Points where two strokes run across each other, both for more than twice the reach on, (k, 2) float, pixels."""
    i, j, s, t = slanted_pairs(strokes)
    length = strokes.lengths
    inner_s, inner_t = np.minimum(s, 1 - s) * length[i], np.minimum(t, 1 - t) * length[j]
    ok = (inner_s > 2 * reach) & (inner_t > 2 * reach)
    a, b = strokes.ends[i[ok]].swapaxes(0, 1)
    return np.asarray(a + s[ok, None] * (b - a))


def slanted_pairs(strokes: Strokes) -> tuple[Ints, Ints, Floats, Floats]:
    """Pairs of strokes that are far from parallel: numbers of both, and where their lines cross, 0..1 along each."""
    a, span = strokes.ends[:, 0], strokes.ends[:, 1] - strokes.ends[:, 0]
    i, j = np.triu_indices(len(a), 1)
    slanted = np.abs(cross(span[i], span[j])) > LEAST_SINE * strokes.lengths[i] * strokes.lengths[j]
    i, j = i[slanted], j[slanted]
    s, t = line_crossings(a[i], span[i], a[j], span[j])
    return i, j, s, t


def crossings(strokes: Strokes, reach: float, least: int = 3) -> Floats:
    """Points where at least `least` strokes run across each other, (k, 2) float, pixels.

    Where two cross there is usually no vertex; where three do, vertices coincide (the isometric cube's centre).
    """
    points = crossed(strokes, reach)
    kept: list[tuple[float, float]] = []
    for x, y in points[_strokes_across(points, strokes, reach, 2 * reach).sum(axis=1) >= least].tolist():
        if all(hypot(x - u, y - v) >= 2 * reach for u, v in kept):
            kept.append((x, y))
    return np.array(kept).reshape(-1, 2)


@dataclass
class _Bunch:
    """Ends that meet, and the sums that give the point: over the lines a x + b y = c through each, (a, b) of length 1.

    members : the ends; two to a stroke, one after the other
    """

    members: list[int]
    aa: float
    bb: float
    ab: float
    ac: float
    bc: float
    x: float
    y: float

    def with_(self, other: _Bunch) -> _Bunch:
        return _Bunch(
            self.members + other.members,
            self.aa + other.aa,
            self.bb + other.bb,
            self.ab + other.ab,
            self.ac + other.ac,
            self.bc + other.bc,
            self.x + other.x,
            self.y + other.y,
        )

    @property
    def meeting_point(self) -> tuple[float, float]:
        """Least-squares intersection of the lines, held to the ends where they are nearly parallel."""
        k, aa, bb, ab, ac, bc = len(self.members), self.aa, self.bb, self.ab, self.ac, self.bc
        if aa * bb - ab * ab <= 0.02 * k * k / 4:
            # a pull towards the ends tames parallel lines
            weight = 0.02
            aa, bb, ac, bc = aa + weight * k, bb + weight * k, ac + weight * self.x, bc + weight * self.y
        det = aa * bb - ab * ab
        return (bb * ac - ab * bc) / det, (aa * bc - ab * ac) / det


def _bunches(ends: Floats, direction: Floats, lengths: Floats, tolerance: float, pen: float) -> list[_Bunch]:
    """The ends of each corner: the closest join first, as long as their lines still meet there."""
    base = 4 + 1.2 * pen + 2 * tolerance
    i, j, reach = _close_ends(ends, direction, lengths, base, pen)
    (x, y), (u, v) = ends.T, direction.T
    c = u * y - v * x
    sums = np.stack([v * v, u * u, -u * v, -v * c, u * c, x, y], axis=1).tolist()
    rows = np.concatenate([ends, direction], axis=1).tolist()
    bunch_of = [_Bunch([k], *row) for k, row in enumerate(sums)]
    for p, q, far in zip(i.tolist(), j.tolist(), reach.tolist(), strict=True):
        a, b = bunch_of[p], bunch_of[q]
        if a is b or not {k // 2 for k in a.members}.isdisjoint(k // 2 for k in b.members):
            continue
        both = a.with_(b)
        if _is_met(both.meeting_point, [rows[k] for k in both.members], far, 0.5 * base):
            for k in both.members:
                bunch_of[k] = both
    return sorted({id(bunch): bunch for bunch in bunch_of}.values(), key=lambda bunch: bunch.members[0])


def _close_ends(ends: Floats, direction: Floats, lengths: Floats, base: float, pen: float) -> tuple[Ints, Ints, Floats]:
    """Pairs of ends of different strokes, the closest first, and how far each may lie from the point where they meet.

    Lines that meet at a small angle may do so further away.
    """
    (x, y), (u, v) = ends.T, direction.T
    dx, dy = x[:, None] - x, y[:, None] - y
    squares = dx * dx + dy * dy
    i, j = np.nonzero(squares <= (base + 7 * pen) ** 2)
    apart = i // 2 < j // 2
    i, j = i[apart], j[apart]
    gap = np.sqrt(squares[i, j])
    reach = base + 0.7 * pen / np.maximum(np.abs(u[i] * v[j] - v[i] * u[j]), 0.1)
    reach = np.minimum(reach, 0.5 * np.minimum(lengths[i], lengths[j]) + base)
    close = np.flatnonzero(gap <= reach)
    order = close[np.argsort(gap[close], kind="stable")]
    return i[order], j[order], reach[order]


def _is_met(point: tuple[float, float], ends: list[list[float]], reach: float, slack: float) -> bool:
    """Whether strokes, given by x, y and direction at their ends, meet in a point near all of these."""
    for x, y, u, v in ends:
        dx, dy = point[0] - x, point[1] - y
        if abs(dx * v - dy * u) > slack or hypot(dx, dy) > reach:
            return False
    return True


def _on_interior(points: Floats, strokes: Strokes, reach: float) -> Bools:
    """Whether each corner lies on the interior of a stroke."""
    return np.asarray(_strokes_across(points, strokes, reach, 2.5 * reach).any(axis=1))


def _strokes_across(points: Floats, strokes: Strokes, reach: float, inside: float) -> Bools:
    """(k, m) which of m strokes each point lies on, at most `reach` off and more than `inside` away from their ends."""
    (x, y), (dx, dy) = strokes.ends[:, 0].T, (strokes.ends[:, 1] - strokes.ends[:, 0]).T
    length = strokes.lengths + 1e-9
    u, v = dx / length, dy / length
    qx, qy = points[:, :1] - x, points[:, 1:] - y
    along = qx * u + qy * v
    across = np.abs(qx * v - qy * u)
    return np.asarray((along > inside) & (along < length - inside) & (across <= reach))
