"""The boundary of a solid: faces on surfaces, bounded by loops of directed edges on curves (ISO 10303-42, "B-rep").

Whatever measures, draws or writes a solid reads only this, so a new kind of solid is a new builder. A new kind of curve
or surface joins the union `Curve` or `Surface`: an arc, say, with its centre, normal and radius.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from sketch2shape.errors import PointsError
from sketch2shape.model.arrays import Brief, Floats, Ints
from sketch2shape.model.drawing import ring_edges

Ring: TypeAlias = tuple[int, ...]
"""Vertices in the order of a loop."""


@dataclass(frozen=True)
class Line:
    """The straight curve; an edge's two vertices say where it runs."""


@dataclass(frozen=True, eq=False, repr=False)
class Plane(Brief):
    """The flat surface.

    origin : (3,) float, a point on it, in the solid's unit
    normal : (3,) float of unit length, out of the solid; 0 0 0 where the face on it has no area
    """

    origin: Floats
    normal: Floats


Curve: TypeAlias = Line
Surface: TypeAlias = Plane


@dataclass(frozen=True)
class Edge:
    """A piece of a curve between two vertices.

    start, end : rows of the boundary's vertices
    """

    start: int
    end: int
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
    faces    : the principal faces first, the front face before all others
    """

    vertices: Floats
    edges: tuple[Edge, ...]
    faces: tuple[Face, ...]

    @cached_property
    def edge_ends(self) -> Ints:
        """(number of edges, 2) rows of `vertices`: start and end of each edge."""
        return np.array([(edge.start, edge.end) for edge in self.edges], np.intp).reshape(-1, 2)

    def rings(self, face: Face) -> tuple[Ring, ...]:
        """The vertices of each of the face's loops."""
        return tuple(
            tuple(self.edges[e].start if forward else self.edges[e].end for e, forward in loop) for loop in face.loops
        )

    @property
    def area(self) -> float:
        """Area of all faces, unit squared."""
        return float(np.linalg.norm(self._face_areas(self.vertices), axis=1).sum())

    @property
    def volume(self) -> float:
        """What it holds, unit cubed, by the divergence theorem; negative if it is inside out."""
        v = self.vertices - self.vertices.mean(axis=0)
        first = [self.rings(face)[0][0] for face in self.faces]
        return float((v[first] * self._face_areas(v)).sum()) / 3.0

    def scaled(self, factor: float) -> Boundary:
        """The same boundary in a smaller unit of length, `factor` of which make the present one."""
        faces = tuple(Face(Plane(f.surface.origin * factor, f.surface.normal), f.loops) for f in self.faces)
        return Boundary(self.vertices * factor, self.edges, faces)

    def _face_areas(self, vertices: Floats) -> Floats:
        """(number of faces, 3) the normal of each face, as long as its area."""
        rings = [self.rings(face) for face in self.faces]
        areas = _area_vectors(vertices, [ring for face in rings for ring in face])
        starts = np.cumsum([0, *(len(face) for face in rings[:-1])])
        return np.asarray(np.add.reduceat(areas, starts, axis=0))


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


def two_face_boundary(vertices: Floats, ring_sizes: Sequence[int]) -> Boundary:
    """The boundary of a two-face object: front, back, then a side for each edge of the front face.

    vertices   : (2m, 3) float in the order of `TwoFaceObject.vertices`; the edges keep the order of its `edges`
    ring_sizes : vertices of each ring of one face: the outer ring first, then the holes; m is their sum

    Raises PointsError if a ring has fewer than three vertices.
    """
    if min(ring_sizes) < 3:
        raise PointsError(f"expected rings of at least 3 vertices, got one of {min(ring_sizes)}")
    half, start = sum(ring_sizes), 0
    through = vertices[half:].mean(axis=0) - vertices[:half].mean(axis=0)
    front: list[Ring] = []
    for n in ring_sizes:
        ring = tuple(range(start, start + n))
        outward = float(_area_vectors(vertices, [ring])[0] @ through) < 0
        front.append(ring if outward != bool(front) else ring[::-1])
        start += n
    back = [tuple(i + half for i in ring[::-1]) for ring in front]
    sides = [[(ring[i - 1], ring[i - 1] + half, ring[i] + half, ring[i])] for ring in front for i in range(len(ring))]
    return polyhedron(vertices, [front, back, *sides], ring_edges(list(ring_sizes)))


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
