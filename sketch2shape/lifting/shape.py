"""A solid before it is measured: its true face, where that lies, and how far it reaches."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np

from sketch2shape.lifting.bent import Bent
from sketch2shape.lifting.face import edge_vectors
from sketch2shape.model import ArcPlace, Boundary, Circle, Floats, Ints, Side, arc_between, two_face_boundary


@dataclass(frozen=True)
class FlatArc:
    """A curved edge of a true face.

    ring, start : as of `ArcPlace`
    center      : (2,) in the face's plane
    radius      : of its circle
    turn        : 1 if it turns from the plane's first axis to the second, -1 the other way
    """

    ring: int
    start: int | None
    center: Floats
    radius: float
    turn: float


@dataclass(frozen=True)
class Shape:
    """A prism, or a frustum, with parallel faces.

    family    : how it was projected
    flat      : (m, 2) true face in its own plane, all rings, about as large as drawn, pixels; then points on its arcs
    pose      : (3, 3) rows: the plane's two axes and its normal, away from the viewer, in the viewer's axes
    origin    : (3,) where the plane's (0, 0) lies
    depth     : distance between the faces along the normal, negative if f2 is the nearer one
    taper     : size of the back face over that of the front face; the axis goes through the mean of the outer vertices
    camera    : (3, 4) from `vertices` to homogeneous pixels of the drawing
    map       : (2, 2) the linear part of drawing -> flat, row vectors
    sizes     : vertices of each ring
    free      : was the depth a mere default?
    free_axis : row of the pose that the depth runs along
    noise     : standard deviation of a vertex of the face, pixels of the drawing
    evidence  : numbers for the report
    warnings  : what had to be assumed
    order     : (2m,) number of each vertex in the object, None if they are in its order (see `box`)
    bent      : how the points of `flat` belong together where some edges are arcs
    arcs      : what its curved edges are in the true face, once they are made exact
    pointed   : does it come to a point? That lies over the middle of the face
    tip       : (2,) how far off the middle the point stands, in the face's plane; None for over it
    """

    family: Literal["oblique", "axonometric", "perspective"]
    flat: Floats
    pose: Floats
    origin: Floats
    depth: float
    camera: Floats
    map: Floats
    sizes: list[int]
    taper: float = 1.0
    free: bool = False
    free_axis: int = 2
    noise: float = 0.0
    evidence: dict[str, Any] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    order: Ints | None = None
    bent: Bent | None = None
    arcs: tuple[FlatArc, ...] = ()
    pointed: bool = False
    tip: Floats | None = None

    @cached_property
    def to_drawing(self) -> Floats:
        """(2, 2) the linear part of flat -> drawing, row vectors."""
        (a, b), (c, d) = self.map.tolist()
        inverse: Floats = np.array([[d, -b], [-c, a]]) / (a * d - b * c)
        return inverse

    @property
    def middle(self) -> Floats:
        """(2,) the point of the true face that the axis goes through."""
        bent = self.bent
        return np.asarray(self.flat[: self.sizes[0]].mean(axis=0) if bent is None else bent.middle @ self.flat)

    @property
    def lengths(self) -> Floats:
        """(k,) how long the face's edges are, and how large its arcs."""
        if self.bent is not None:
            return self.bent.lengths(self.flat)
        return np.asarray(np.linalg.norm(edge_vectors(self.flat, self.sizes), axis=1))

    @property
    def drawn_lengths(self) -> Floats:
        """(k,) the same as drawn, pixels."""
        if self.bent is not None:
            return self.bent.lengths(self.flat @ self.to_drawing)
        return np.asarray(np.hypot(*(edge_vectors(self.flat, self.sizes) @ self.to_drawing).T))

    @property
    def vertices(self) -> Floats:
        """(2m, 3) in the object's order: front face, then back face; (m + 1, 3) if it comes to a point."""
        flat, middle = self.flat[: sum(self.sizes)], self.middle
        point = middle if self.tip is None else middle + self.tip
        back = point[None] if self.pointed else middle + self.taper * (flat - middle)
        plane, normal = self.pose[:2], self.pose[2]
        own = np.concatenate([flat @ plane, back @ plane + self.depth * normal]) + self.origin
        if self.order is None:
            return own
        vertices = np.empty_like(own)
        vertices[self.order] = own
        return vertices

    @property
    def edges(self) -> Floats:
        """(e, 3) the straight edges of the front face, in the viewer's axes."""
        flat = self.flat
        if self.bent is None:
            return edge_vectors(flat, self.sizes) @ self.pose[:2]
        ends = self.bent.ends
        return np.asarray((flat[ends[:, 1]] - flat[ends[:, 0]]) @ self.pose[:2])

    @property
    def boundary(self) -> Boundary:
        """The solid, in the viewer's axes."""
        return self.placed_boundary(self.vertices, np.eye(3))

    def placed_boundary(self, vertices: Floats, turn: Floats, shift: Floats | None = None) -> Boundary:
        """The solid with its vertices moved to these, its arcs by the linear map `turn` (3, 3) and the shift (3,).

        The map must not make ellipses of circles.
        """
        if not self.arcs and not self.pointed:
            return two_face_boundary(vertices, self.sizes)
        circles = {place: _moved(circle, turn, shift) for place, circle in self.circles.items()}
        return two_face_boundary(vertices, self.sizes, circles, pointed=self.pointed)

    @property
    def circles(self) -> dict[ArcPlace, Circle]:
        """What the curved edges of both faces lie on, in the viewer's axes."""
        across, middle = np.cross(self.pose[0], self.pose[1]), self.middle
        faces: list[tuple[Side, float, float]] = [("f1", 1.0, 0.0)]
        if not self.pointed:
            faces.append(("f2", self.taper, self.depth))
        found: dict[ArcPlace, Circle] = {}
        for side, scale, away in faces:
            for arc in self.arcs:
                at = (middle + scale * (arc.center - middle)) @ self.pose[:2] + away * self.pose[2] + self.origin
                found[ArcPlace(side, arc.ring, arc.start)] = Circle(at, arc.turn * across, scale * arc.radius)
        return found


def _moved(circle: Circle, turn: Floats, shift: Floats | None) -> Circle:
    """A circle as a linear map, and then a shift, leave it."""
    first = arc_between(circle, None, None).first
    one, other = turn @ first, turn @ np.cross(circle.normal, first)
    size = float(np.linalg.norm(one))
    normal = np.cross(one, other)
    center = turn @ circle.center + (0.0 if shift is None else shift)
    return Circle(center, normal / np.linalg.norm(normal), circle.radius * size)
