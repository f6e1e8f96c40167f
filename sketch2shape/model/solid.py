"""The three-dimensional object, and how it was projected."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from sketch2shape.model.arrays import Brief, Floats, Ints
from sketch2shape.model.boundary import Boundary, Edge, Face, Ring


@dataclass(frozen=True, eq=False)
class Projection:
    """How the object was projected onto the paper.

    family   : "oblique", "axonometric" or "perspective"
    evidence : why, and the numbers found (angles in degrees, focal length in pixels, ...), ready for JSON
    """

    family: Literal["oblique", "axonometric", "perspective"]
    evidence: dict[str, Any] = field(default_factory=dict, repr=False)


@dataclass(frozen=True, eq=False)
class Alternative:
    """Another solid that the drawing may be of.

    reading     : name of the reading, as "cavalier" or "isometric"
    mirrored    : is the far side taken as the near one?
    projection  : how it is projected, with evidence
    dimensions  : width, height and depth, in the solid's unit
    probability : how likely it is
    """

    reading: str
    mirrored: bool
    projection: Projection
    dimensions: tuple[float, float, float]
    probability: float


@dataclass(frozen=True, eq=False, repr=False)
class Solid(Brief):
    """The three-dimensional object.

    boundary   : its vertices, edges and faces, in `unit`; of a two-face object see `two_face_boundary`
    projection : how it was projected, with evidence
    unit       : name of the unit of length
    warnings   : defaults that had to be assumed, in words
    axes       : (3, 3) unit rows: right, up and away of the object set upright, along which width, height and depth are
                 measured; None for x, y, z
    up         : which axis is upward; "camera" where the axes are those of the viewer (x right, y down, z away)
    camera     : (3, 4) from the vertices to homogeneous pixels of the picture, third row 0 0 0 1 for a parallel view;
                 None if the solid was not read from one
    confidence : 0..1, how sure the proportions are, but for a depth that the drawing leaves free; apart from the
                 confidence of the object
    alternatives : other solids that the drawing may be of, the likeliest first
    """

    boundary: Boundary
    projection: Projection
    unit: str = "px"
    warnings: tuple[str, ...] = ()
    axes: Floats | None = None
    up: Literal["z", "y", "camera"] = "z"
    camera: Floats | None = None
    confidence: float = 1.0
    alternatives: tuple[Alternative, ...] = field(default=(), repr=False)

    @property
    def vertices(self) -> Floats:
        """(k, 3) float, in `unit`; of a two-face object in the order of `TwoFaceObject.vertices`."""
        return self.boundary.vertices

    @property
    def edges(self) -> tuple[Edge, ...]:
        """All edges; of a two-face object in the order of `TwoFaceObject.edges`, then its whole circles."""
        return self.boundary.edges

    @property
    def edge_ends(self) -> Ints:
        """(number of edges with ends, 2) rows of `vertices`: start and end of each of them."""
        return self.boundary.edge_ends

    @property
    def faces(self) -> tuple[Face, ...]:
        """All faces, the principal ones first; of a two-face object front, back, then the sides."""
        return self.boundary.faces

    def rings(self, face: Face) -> tuple[Ring, ...]:
        """The vertices of each loop of one of the faces, the outer loop first; none for a whole circle."""
        return self.boundary.rings(face)

    @property
    def ring_sizes(self) -> tuple[int, ...]:
        """Vertices of each ring of the front face: the outer ring first, then the holes; 0 for a whole circle."""
        return tuple(len(ring) for ring in self.rings(self.faces[0]))

    @property
    def area(self) -> float:
        """Surface area, `unit` squared."""
        return self.boundary.area

    @property
    def volume(self) -> float:
        """Volume, `unit` cubed."""
        return self.boundary.volume

    @property
    def dimensions(self) -> tuple[float, float, float]:
        """Width, height and depth along the object's own axes, in `unit`."""
        axes = np.eye(3) if self.axes is None else self.axes
        along = self.boundary.extremes(axes)
        along = along if self.axes is None else along @ axes.T
        width, height, depth = (float(e) for e in np.ptp(along, axis=0))
        return width, height, depth
