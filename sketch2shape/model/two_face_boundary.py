"""The boundary of a two-face object: front face, back face or apex, and a side for each edge of the front face."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sketch2shape.errors import PointsError
from sketch2shape.model.arrays import Floats
from sketch2shape.model.boundary import (
    Boundary,
    Cone,
    Cylinder,
    DirectedEdge,
    Edge,
    Face,
    Loop,
    Plane,
    Surface,
)
from sketch2shape.model.curves import Circle, Curve, Line
from sketch2shape.model.drawing import Side, ring_edges

#: radii that differ by less than this part are those of a cylinder
_ALIKE = 1e-9


#: a plane that is not known yet
_NOWHERE = Plane(np.zeros(3), np.zeros(3))


class ArcPlace(NamedTuple):
    """Which edge of a two-face object is curved.

    face  : the face it borders
    ring  : number of the ring, the outer one 0
    start : vertex of the ring that it starts at; None for a ring that is a whole circle
    """

    face: Side
    ring: int
    start: int | None


def two_face_boundary(
    vertices: Floats,
    ring_sizes: Sequence[int],
    circles: Mapping[ArcPlace, Circle] | None = None,
    *,
    pointed: bool = False,
) -> Boundary:
    """The boundary of a two-face object: front, back unless it is a point, then a side for each edge of the front face.

    vertices   : (2m, 3) float in the order of `TwoFaceObject.vertices`, (m + 1, 3) with a point; the edges keep the
                 order of its `edges`, then come the whole circles ring by ring, front before back
    ring_sizes : vertices of each ring of one face: the outer ring first, then the holes; m is their sum
    circles    : what the curved edges lie on, each turning from start to end; both faces have one for the same edge
    pointed    : is the last vertex the point that all sides meet in?

    Raises PointsError if a ring has too few vertices: one without a circle needs three, one with an arc two.
    """
    circles = circles or {}
    for number, n in enumerate(ring_sizes):
        arcs = sum(place.face == "f1" and place.ring == number for place in circles)
        if n < (3 if not arcs else 0 if n == 0 else 2):
            raise PointsError(f"expected rings of at least 3 vertices, got one of {n}")
    return _Builder(vertices, tuple(ring_sizes), circles, pointed).boundary()


@dataclass(frozen=True)
class _Ring:
    """One ring of both faces, by numbers of edges.

    front, back : edges of the front and the back face, each from its vertex to the next; no back at a point
    joins       : connecting edges, from front to back
    """

    front: range
    back: range
    joins: range


class _Builder:
    """Puts a boundary together; arguments as of `two_face_boundary`."""

    def __init__(
        self, vertices: Floats, sizes: tuple[int, ...], circles: Mapping[ArcPlace, Circle], pointed: bool
    ) -> None:
        self.vertices, self.circles, self.pointed = vertices, circles, pointed
        self.rings: list[_Ring] = []
        ends = ring_edges(list(sizes), pointed=pointed).tolist()
        self.edges = [Edge(a, b, Line()) for a, b in ends]
        at = 0
        for n in sizes:
            m = 0 if pointed else n
            self.rings.append(_Ring(range(at, at + n), range(at + n, at + n + m), range(at + n + m, at + 2 * n + m)))
            at += 2 * n + m
        for number, n in enumerate(sizes):
            if n == 0:
                self.rings[number] = self._whole(number)
            else:
                self._bend(number)

    def _whole(self, number: int) -> _Ring:
        """A ring that is one circle; its edges are the last so far."""
        faces: list[Side] = ["f1"] if self.pointed else ["f1", "f2"]
        at = len(self.edges)
        self.edges += [Edge(None, None, self.circles[ArcPlace(face, number, None)]) for face in faces]
        return _Ring(range(at, at + 1), range(at + 1, at + len(faces)), range(0))

    def _bend(self, number: int) -> None:
        """Put a ring's arcs in the place of lines."""
        ring = self.rings[number]
        sides: list[tuple[Side, range]] = [("f1", ring.front), ("f2", ring.back)]
        for side, edges in sides:
            for start, e in enumerate(edges):
                circle = self.circles.get(ArcPlace(side, number, start))
                if circle is not None:
                    self.edges[e] = Edge(self.edges[e].start, self.edges[e].end, circle)

    def boundary(self) -> Boundary:
        """The whole of it."""
        whole = Boundary(self.vertices, tuple(self.edges), ())
        through = self._through()
        along = whole.area_vectors([_flat((_forward(ring.front),)) for ring in self.rings]) @ through
        outward = [bool((way < 0) != bool(number)) for number, way in enumerate(along.tolist())]
        made = self._turned(whole, outward)
        # faces that hardly face each other do not tell which side is out
        return made if made.volume >= 0 else self._turned(whole, [not ahead for ahead in outward])

    def _turned(self, whole: Boundary, outward: list[bool]) -> Boundary:
        """The boundary whose front rings are walked as they are, or backwards."""
        front = tuple(_walk(r.front, ahead) for r, ahead in zip(self.rings, outward, strict=True))
        back = () if self.pointed else tuple(_walk(r.back, not a) for r, a in zip(self.rings, outward, strict=True))
        ends = [loops for loops in (front, back) if loops]
        steps = [
            (ring, step) for ring, loop in zip(self.rings, front, strict=True) for step in (*loop[-1:], *loop[:-1])
        ]
        sides = [self._side_loops(ring, step.edge - ring.front.start, step.forward) for ring, step in steps]
        planes = self._planes(whole, [*ends, *sides])
        normal = planes[0].normal
        bent = [self._surface(ring, step, normal) for ring, step in steps]
        surfaces = [*planes[: len(ends)], *(own or plane for own, plane in zip(bent, planes[len(ends) :], strict=True))]
        return Boundary(self.vertices, whole.edges, tuple(map(Face, surfaces, [*ends, *sides])))

    def _through(self) -> Floats:
        """(3,) from the front to the back."""
        half = len(self.vertices) - 1 if self.pointed else len(self.vertices) // 2
        front, back = (
            [*points, *(c.center for place, c in self.circles.items() if place.face == face and place.start is None)]
            for face, points in (("f1", self.vertices[:half]), ("f2", self.vertices[half:]))
        )
        return np.asarray(np.mean(back, axis=0) - np.mean(front, axis=0))

    def _planes(self, whole: Boundary, faces: list[tuple[Loop, ...]]) -> list[Plane]:
        """The planes of faces with these loops, if they are flat."""
        areas = whole.area_vectors([_flat(loops[:1]) for loops in faces])
        sizes = np.linalg.norm(areas, axis=1)
        normals = areas / np.where(sizes > 0, sizes, 1.0)[:, None]
        planes = []
        for loops, normal in zip(faces, normals, strict=True):
            number, ahead = loops[0][0]
            edge = self.edges[number]
            first = edge.start if ahead else edge.end
            planes.append(Plane(self.vertices[first] if first is not None else _center(edge.curve), normal))
        return planes

    def _surface(self, ring: _Ring, step: DirectedEdge, normal: Floats) -> Surface | None:
        """What the side at an edge of the front face, walked as there, lies on; None for its plane.

        normal : out of the front face
        """
        curve = self.edges[step.edge].curve
        if isinstance(curve, Line):
            return None
        convex = (float(curve.normal @ normal) > 0) == step.forward
        return self._bent(curve, ring, step.edge - ring.front.start, convex)

    def _bent(self, circle: Circle, ring: _Ring, place: int, convex: bool) -> Surface:
        """The cylinder or cone at a curved edge."""
        if self.pointed:
            return Cone(self.vertices[-1], circle, convex)
        far = self.edges[ring.back[place]].curve
        if not isinstance(far, Circle) or abs(far.radius - circle.radius) <= _ALIKE * circle.radius:
            return Cylinder(circle, convex)
        return Cone(circle.center + (far.center - circle.center) / (1.0 - far.radius / circle.radius), circle, convex)

    def _side_loops(self, ring: _Ring, place: int, ahead: bool) -> tuple[Loop, ...]:
        front = DirectedEdge(ring.front[place], not ahead)
        far = () if self.pointed else (DirectedEdge(ring.back[place], ahead),)
        if not ring.joins:
            return ((front,), far) if far else ((front,),)
        after = (place + 1) % len(ring.front)
        a, b = (place, after) if ahead else (after, place)
        return ((DirectedEdge(ring.joins[a], True), *far, DirectedEdge(ring.joins[b], False), front),)


def _flat(loops: tuple[Loop, ...]) -> Face:
    """A face of which only the loops count."""
    return Face(_NOWHERE, loops)


def _forward(edges: range) -> Loop:
    return tuple(DirectedEdge(e, True) for e in edges)


def _walk(edges: range, ahead: bool) -> Loop:
    """A ring walked from its first vertex on, or from its last one back."""
    if ahead:
        return _forward(edges)
    return tuple(DirectedEdge(e, False) for e in (*reversed(edges[:-1]), edges[-1]))


def _center(curve: Curve) -> Floats:
    return curve.center if isinstance(curve, Circle) else np.zeros(3)
