"""A face of lines and arcs in its own plane: its unknowns, where its edges point, and how far it is from the drawing.

Unknowns are the vertices, the bulge angle of each arc between two vertices (the angle it turns through, signed), and
centre and radius of each whole circle.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sketch2shape.lifting.bent import Bent, BentArc
from sketch2shape.lifting.shape import FlatArc, Shape
from sketch2shape.model import Floats

#: an arc turns through less than a full circle, and more than nothing, radians
_LEAST_TURN, _MOST_TURN = 0.02, 2.0 * np.pi - 0.05


@dataclass(frozen=True)
class Edge:
    """One edge of a ring with vertices.

    first, last : vertices that it joins
    arc         : number of its bulge angle, None for a straight edge
    """

    first: int
    last: int
    arc: int | None


@dataclass(frozen=True)
class Profile:
    """What the unknowns of a face are, and where it was drawn.

    bent   : how its points belong together
    sizes  : vertices of each ring
    points : (m, 2) the face as it follows from the drawing: vertices, then points on arcs
    map    : (2, 2) flat -> drawing, row vectors
    """

    bent: Bent
    sizes: list[int]
    points: Floats
    to_drawing: Floats

    @cached_property
    def open(self) -> list[BentArc]:
        """Arcs between two vertices."""
        return [arc for arc in self.bent.arcs if arc.start is not None]

    @cached_property
    def whole(self) -> list[BentArc]:
        """Whole circles."""
        return [arc for arc in self.bent.arcs if arc.start is None]

    @cached_property
    def rings(self) -> list[list[Edge]]:
        """The edges of each ring that has vertices, in order."""
        arcs = {(arc.ring, arc.start): k for k, arc in enumerate(self.open)}
        found: list[list[Edge]] = []
        start = 0
        for ring, n in enumerate(self.sizes):
            if n:
                steps = range(n)
                found.append([Edge(start + k, start + (k + 1) % n, arcs.get((ring, k))) for k in steps])
            start += n
        return found

    @property
    def edges(self) -> list[Edge]:
        """All of them."""
        return [edge for ring in self.rings for edge in ring]

    def vertices(self, x: Floats) -> Floats:
        """(k, 2) of unknowns x."""
        return x[: 2 * self.bent.vertices].reshape(-1, 2)

    def turns(self, x: Floats) -> Floats:
        """(a,) signed angle of each arc, radians: positive from the plane's first axis to the second."""
        start = 2 * self.bent.vertices
        return x[start : start + len(self.open)]

    def circles(self, x: Floats) -> Floats:
        """(c, 3) centre and radius of each whole circle."""
        return x[2 * self.bent.vertices + len(self.open) :].reshape(-1, 3)

    def radius(self, x: Floats, edge: Edge) -> float:
        """Of a curved edge."""
        chord = self.vertices(x)[edge.last] - self.vertices(x)[edge.first]
        half = 0.5 * float(self.turns(x)[edge.arc or 0])
        return float(np.hypot(*chord) / (2.0 * abs(np.sin(half))))

    def center(self, x: Floats, edge: Edge) -> Floats:
        """(2,) of a curved edge's circle."""
        p, q = self.vertices(x)[[edge.first, edge.last]]
        chord, half = q - p, 0.5 * float(self.turns(x)[edge.arc or 0])
        return np.asarray(0.5 * (p + q) + np.array([-chord[1], chord[0]]) / (2.0 * np.tan(half)))

    def heading(self, x: Floats, edge: Edge, *, at_end: bool) -> float:
        """Direction in which an edge leaves its first vertex, or arrives at its last, radians."""
        chord = self.vertices(x)[edge.last] - self.vertices(x)[edge.first]
        half = 0.0 if edge.arc is None else 0.5 * float(self.turns(x)[edge.arc])
        return float(np.arctan2(chord[1], chord[0])) + (half if at_end else -half)

    def start(self) -> Floats:
        """The unknowns as the drawing has them."""
        turns = [_turn(self.points[arc.rows]) for arc in self.open]
        circles = [_circle(self.points[arc.rows]) for arc in self.whole]
        return np.concatenate([self.points[: self.bent.vertices].ravel(), turns, *circles])

    def placed(self, x: Floats) -> Floats:
        """(m, 2) the points of the face of unknowns x, each the one that belongs to a drawn point."""
        points = self.points.copy()
        points[: self.bent.vertices] = self.vertices(x)
        curved = [edge for edge in self.edges if edge.arc is not None]
        for edge in curved:
            rows = self.open[edge.arc or 0].rows
            points[rows[1:-1]] = _onto(self.points[rows[1:-1]], self.center(x, edge), self.radius(x, edge))
        for arc, (u, v, r) in zip(self.whole, self.circles(x), strict=True):
            points[arc.rows] = _onto(self.points[arc.rows], np.array([u, v]), float(r))
        return points

    def moved(self, x: Floats) -> Floats:
        """(2 m,) how far each point is from where it was drawn, pixels of the drawing."""
        return np.asarray(((self.placed(x) - self.points) @ self.to_drawing).ravel())

    def shape(self, x: Floats, shape: Shape) -> Shape:
        """The shape with this face."""
        arcs: list[FlatArc] = []
        for edge in self.edges:
            if edge.arc is not None:
                arc = self.open[edge.arc]
                turn = float(np.sign(self.turns(x)[edge.arc]))
                arcs.append(FlatArc(arc.ring, arc.start, self.center(x, edge), self.radius(x, edge), turn))
        for arc, (u, v, r) in zip(self.whole, self.circles(x), strict=True):
            arcs.append(FlatArc(arc.ring, None, np.array([u, v]), float(r), 1.0))
        return replace(shape, flat=self.placed(x), arcs=tuple(arcs))


def profile_of(shape: Shape, bent: Bent) -> Profile:
    """The face of a shape with arcs."""
    return Profile(bent, shape.sizes, shape.flat, shape.to_drawing)


def _onto(points: Floats, center: Floats, radius: float) -> Floats:
    """Points (k, 2) moved onto a circle."""
    away = points - center
    return np.asarray(center + away * (radius / np.maximum(np.hypot(*away.T), 1e-12))[:, None])


def _turn(points: Floats) -> float:
    """Signed angle of the arc from the first point to the last that runs nearest to those between, radians."""
    p, q = points[0], points[-1]
    chord, inner = q - p, points[1:-1] - p
    size = float(np.hypot(*chord)) or 1.0
    along, aside = inner @ chord / size, (inner[:, 1] * chord[0] - inner[:, 0] * chord[1]) / size
    # a point of an arc sees its chord under half of what is left of the full turn
    seen = np.arctan2(-size * aside, along**2 + aside**2 - size * along)
    weight = np.abs(aside) + 1e-9 * size
    angle = 2.0 * np.arctan2(float(weight @ np.sin(seen)), float(weight @ np.cos(seen)))
    bulge = float(np.sign((weight * aside).sum()) or 1.0)
    turn = 2.0 * np.pi - abs(angle)
    return -bulge * float(np.clip(turn, _LEAST_TURN, _MOST_TURN))


def _circle(points: Floats) -> Floats:
    """(3,) centre and radius of the circle nearest to points, algebraically."""
    middle = points.mean(axis=0)
    x, y = (points - middle).T
    (a, b, c), *_ = np.linalg.lstsq(np.c_[2 * x, 2 * y, np.ones_like(x)], x**2 + y**2, rcond=None)
    return np.array([middle[0] + a, middle[1] + b, np.sqrt(max(c + a**2 + b**2, 1e-12))])


def neighbours(rings: list[list[Edge]]) -> list[tuple[Edge, Edge]]:
    """Edges that follow each other in a ring."""
    return [(ring[k - 1], ring[k]) for ring in rings for k in range(len(ring))]
