"""The boundary of a solid: faces on surfaces, bounded by loops of directed edges on curves (ISO 10303-42, "B-rep").

Whatever measures, draws or writes a solid reads only this, so a new kind of solid is a new builder. Curves are lines
and circles, surfaces are planes, cylinders and cones; a new kind joins the union `Curve` or `Surface`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from sketch2shape.model.arrays import Brief, Floats, Ints
from sketch2shape.model.curves import Arc, Circle, Curve, Line, arc_between

Ring: TypeAlias = tuple[int, ...]
"""Vertices in the order of a loop."""


@dataclass(frozen=True, eq=False, repr=False)
class Plane(Brief):
    """The flat surface.

    origin : (3,) float, a point on it, in the solid's unit
    normal : (3,) float of unit length, out of the solid; 0 0 0 where the face on it has no area
    """

    origin: Floats
    normal: Floats

    def scaled(self, factor: float) -> Plane:
        """As `Boundary.scaled`."""
        return Plane(self.origin * factor, self.normal)


@dataclass(frozen=True, eq=False, repr=False)
class Cylinder(Brief):
    """The surface of all lines across a circle's plane.

    circle : one of its circles
    convex : does the solid lie inside? Not where the surface is that of a hole or a groove
    """

    circle: Circle
    convex: bool

    def scaled(self, factor: float) -> Cylinder:
        """As `Boundary.scaled`."""
        return Cylinder(self.circle.scaled(factor), self.convex)


@dataclass(frozen=True, eq=False, repr=False)
class Cone(Brief):
    """The surface of all lines from a point to a circle; a right cone if the point is over the circle's centre.

    apex   : (3,) float, the point, in the solid's unit
    circle : one of its circles
    convex : does the solid lie inside?
    """

    apex: Floats
    circle: Circle
    convex: bool

    def scaled(self, factor: float) -> Cone:
        """As `Boundary.scaled`."""
        return Cone(self.apex * factor, self.circle.scaled(factor), self.convex)


Surface: TypeAlias = Plane | Cylinder | Cone


@dataclass(frozen=True)
class Edge:
    """A piece of a curve between two vertices, or a whole circle.

    start, end : rows of the boundary's vertices; None, None for a whole circle
    """

    start: int | None
    end: int | None
    curve: Curve


class DirectedEdge(NamedTuple):
    """A walk along an edge.

    edge    : number of the edge
    forward : from its start to its end?
    """

    edge: int
    forward: bool


Loop: TypeAlias = tuple[DirectedEdge, ...]
"""A closed walk of directed edges, each beginning where the one before it ends."""


@dataclass(frozen=True)
class Face:
    """A part of a surface.

    loops : its borders, the outer one first; seen from outside the solid the outer one turns anticlockwise (by the
            right-hand rule its normal points out), holes the other way
    """

    surface: Surface
    loops: tuple[Loop, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Boundary(Brief):
    """The closed surface of a solid. Each edge is walked twice, once each way.

    vertices : (k, 3) float, each on some face
    edges    : those with ends first, then the whole circles
    faces    : the principal faces first, the front face before all others
    """

    vertices: Floats
    edges: tuple[Edge, ...]
    faces: tuple[Face, ...]

    @cached_property
    def edge_ends(self) -> Ints:
        """(number of edges with ends, 2) rows of `vertices`: start and end of each of them."""
        ends = [(edge.start, edge.end) for edge in self.edges if edge.start is not None]
        return np.array(ends, np.intp).reshape(-1, 2)

    def rings(self, face: Face) -> tuple[Ring, ...]:
        """The vertices of each of the face's loops; none for a whole circle."""
        starts = ((self.edges[e].start if forward else self.edges[e].end for e, forward in loop) for loop in face.loops)
        return tuple(tuple(i for i in ring if i is not None) for ring in starts)

    def arc(self, edge: Edge) -> Arc | None:
        """The arc that a curved edge is, from its start to its end."""
        match edge.curve:
            case Line():
                return None
            case circle if edge.start is None or edge.end is None:
                return arc_between(circle, None, None)
            case circle:
                return arc_between(circle, self.vertices[edge.start], self.vertices[edge.end])

    def arcs(self, face: Face) -> Iterator[tuple[Arc, bool]]:
        """The curved edges of a face's loops, and whether they are walked from start to end."""
        for loop in face.loops:
            for number, forward in loop:
                arc = self.arc(self.edges[number])
                if arc is not None:
                    yield arc, forward

    @property
    def is_round(self) -> bool:
        """Whether some edge is curved."""
        return any(not isinstance(edge.curve, Line) for edge in self.edges)

    @property
    def area(self) -> float:
        """Area of all faces, unit squared."""
        return sum(self._area(face) for face in self.faces)

    @property
    def volume(self) -> float:
        """What it holds, unit cubed, by the divergence theorem; negative if it is inside out."""
        middle = self.extremes(np.eye(3)).mean(axis=0)
        flux = 0.0
        for face, through in zip(self.faces, self.area_vectors(self.faces), strict=True):
            match face.surface:
                case Plane(origin):
                    flux += float((origin - middle) @ through)
                case Cylinder(circle, convex):
                    flux += float((circle.center - middle) @ through)
                    flux += (1.0 if convex else -1.0) * circle.radius * self._area(face)
                case Cone(apex):
                    flux += float((apex - middle) @ through)
        return flux / 3.0

    def area_vector(self, face: Face) -> Floats:
        """(3,) the normal of a face, added up over it; as long as its area if it is flat."""
        return np.asarray(self.area_vectors([face])[0])

    def area_vectors(self, faces: Sequence[Face]) -> Floats:
        """(number of faces, 3) `area_vector` of each."""
        rings = [[ring for ring in self.rings(face) if ring] for face in faces]
        total = np.zeros((len(faces), 3))
        of_face = [k for k, own in enumerate(rings) for _ in own]
        np.add.at(total, of_face, _area_vectors(self.vertices, [ring for own in rings for ring in own]))
        if self.is_round:
            for k, face in enumerate(faces):
                for arc, forward in self.arcs(face):
                    total[k] += arc.segment if forward else -arc.segment
        return total

    def extremes(self, directions: Floats) -> Floats:
        """(k, 3) points of the boundary among which are those farthest along and against each direction (n, 3)."""
        found = [self.vertices]
        for edge in self.edges:
            arc = self.arc(edge)
            if arc is not None:
                found += [arc.farthest(direction) for direction in directions]
        return np.concatenate(found)

    def scaled(self, factor: float) -> Boundary:
        """The same boundary in a smaller unit of length, `factor` of which make the present one."""
        edges = tuple(
            edge if isinstance(edge.curve, Line) else replace(edge, curve=edge.curve.scaled(factor))
            for edge in self.edges
        )
        faces = tuple(Face(face.surface.scaled(factor), face.loops) for face in self.faces)
        return Boundary(self.vertices * factor, edges, faces)

    def _area(self, face: Face) -> float:
        """Area of one face: a curved one is what lies between its arcs, laid flat."""
        match face.surface:
            case Plane():
                return float(np.linalg.norm(self.area_vector(face)))
            case Cylinder(circle):
                axis = circle.normal
                strips = (
                    (1.0 if forward == (arc.circle.normal @ axis > 0) else -1.0)
                    * float(arc.circle.center @ axis)
                    * arc.sweep
                    for arc, forward in self.arcs(face)
                )
                return abs(circle.radius * sum(strips))
            case Cone(apex, circle):
                fans = (
                    (1.0 if forward == (arc.circle.normal @ circle.normal > 0) else -1.0) * _fan_area(apex, arc)
                    for arc, forward in self.arcs(face)
                )
                return abs(sum(fans))


def polyhedron(vertices: Floats, faces: Sequence[Sequence[Ring]], edges: Ints | None = None) -> Boundary:
    """The boundary with these flat faces.

    vertices : (k, 3) float
    faces    : the vertices of each face's loops, the outer one first, turning as in `Face`
    edges    : (e, 2) all edges, in the order and the directions to keep; None takes them as the loops walk over them

    Raises ValueError if the faces leave a gap: if an edge is not walked twice, once each way, or is not among `edges`.
    """
    walked = [(a, b) for face in faces for ring in face for a, b in pairwise((*ring, ring[0]))]
    if len(set(walked)) < len(walked) or {(b, a) for a, b in walked} != set(walked):
        raise ValueError("the faces do not close: each edge must be walked twice, once each way")
    given = walked if edges is None else [(int(a), int(b)) for a, b in edges]
    number: dict[tuple[int, int], DirectedEdge] = {}
    kept: list[Edge] = []
    for a, b in given:
        if (a, b) not in number:
            number[a, b], number[b, a] = DirectedEdge(len(kept), True), DirectedEdge(len(kept), False)
            kept.append(Edge(a, b, Line()))
    if set(number) != set(walked):
        raise ValueError("the faces do not walk over the same edges as are given")
    areas = _area_vectors(vertices, [face[0] for face in faces])
    sizes = np.linalg.norm(areas, axis=1)
    normals = areas / np.where(sizes > 0, sizes, 1.0)[:, None]
    stored = tuple(
        Face(
            Plane(vertices[face[0][0]], normal),
            tuple(tuple(number[step] for step in pairwise((*ring, ring[0]))) for ring in face),
        )
        for face, normal in zip(faces, normals, strict=True)
    )
    return Boundary(vertices, tuple(kept), stored)


def _area_vectors(vertices: Floats, rings: Sequence[Ring]) -> Floats:
    """(number of rings, 3) normal of each flat ring, as long as its area."""
    if not rings:
        return np.zeros((0, 3))
    sizes = [len(ring) for ring in rings]
    starts = np.cumsum([0, *sizes[:-1]])
    here = np.array([i for ring in rings for i in ring], np.intp)
    after = np.array([i for ring in rings for i in (*ring[1:], ring[0])], np.intp)
    base = vertices[np.repeat(here[starts], sizes)]
    turns = np.cross(vertices[here] - base, vertices[after] - base)
    return np.asarray(0.5 * np.add.reduceat(turns, starts, axis=0))


#: places and weights of Gauss and Legendre's rule; of 64 it is exact to rounding for the area of any cone met
_PLACES, _WEIGHTS = np.polynomial.legendre.leggauss(64)


def _fan_area(apex: Floats, arc: Arc) -> float:
    """Area of the part of a cone between its apex and an arc."""
    to = arc.at(0.5 * (_PLACES + 1.0)) - apex
    radial = arc.at(0.5 * (_PLACES + 1.0)) - arc.circle.center
    step = 0.5 * arc.sweep * np.cross(arc.circle.normal, radial)
    return 0.5 * float(_WEIGHTS @ np.linalg.norm(np.cross(to, step), axis=1))
