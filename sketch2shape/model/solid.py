"""The three-dimensional object, and how it was projected."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from sketch2shape.model.arrays import Floats, Ints
from sketch2shape.model.drawing import ring_edges


@dataclass(frozen=True)
class Projection:
    """How the object was projected onto the paper.

    family   : "oblique", "axonometric" or "perspective"
    evidence : why, and the numbers found (angles in degrees, focal length in pixels, ...), ready for JSON
    """

    family: Literal["oblique", "axonometric", "perspective"]
    evidence: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Solid:
    """The three-dimensional object.

    vertices   : (2m, 3) float, same order as `TwoFaceObject.vertices`, in `unit`
    ring_sizes : vertices of each ring of one face: the outer ring first, then the holes; m is their sum
    projection : how it was projected, with evidence
    unit       : name of the unit of length
    warnings   : defaults that had to be assumed, in words
    axes       : (3, 3) rows: the object's own width, height and depth directions (unit vectors), None for x, y, z
    """

    vertices: Floats
    ring_sizes: tuple[int, ...]
    projection: Projection
    unit: str = "px"
    warnings: tuple[str, ...] = ()
    axes: Floats | None = None

    @property
    def edges(self) -> Ints:
        """(3m, 2) indices into `vertices`; order as in `TwoFaceObject.edges`."""
        return ring_edges(list(self.ring_sizes))

    @property
    def faces(self) -> tuple[tuple[tuple[int, ...], ...], ...]:
        """The m + 2 flat faces: front, back, then the sides; each the indices of its rings, the outer ring first.

        Outer rings turn anticlockwise seen from outside (the right-hand rule's normal points out), holes the other way.
        """
        return solid_faces(self.vertices, self.ring_sizes)

    @property
    def area(self) -> float:
        """Surface area, `unit` squared."""
        return float(sum(np.linalg.norm(_area_vector(self.vertices, face)) for face in self.faces))

    @property
    def volume(self) -> float:
        """Volume, `unit` cubed, by the divergence theorem."""
        v = self.vertices - self.vertices.mean(axis=0)
        return float(sum(v[face[0][0]] @ _area_vector(v, face) for face in self.faces)) / 3.0

    @property
    def dimensions(self) -> tuple[float, float, float]:
        """Width, height and depth along the object's own axes, in `unit`."""
        along = self.vertices if self.axes is None else self.vertices @ self.axes.T
        width, height, depth = (float(e) for e in np.ptp(along, axis=0))
        return width, height, depth


def solid_faces(vertices: Floats, ring_sizes: tuple[int, ...]) -> tuple[tuple[tuple[int, ...], ...], ...]:
    """Faces of a solid with these (2m, 3) vertices; see `Solid.faces`."""
    half, start = sum(ring_sizes), 0
    through = vertices[half:].mean(axis=0) - vertices[:half].mean(axis=0)
    front: list[tuple[int, ...]] = []
    for n in ring_sizes:
        ring = tuple(range(start, start + n))
        outward = float(_area_vector(vertices, (ring,)) @ through) < 0
        front.append(ring if outward != bool(front) else ring[::-1])
        start += n
    back = tuple(tuple(i + half for i in ring[::-1]) for ring in front)
    sides = (((ring[i - 1], ring[i - 1] + half, ring[i] + half, ring[i]),) for ring in front for i in range(len(ring)))
    return (tuple(front), back, *sides)


def _area_vector(vertices: Floats, rings: tuple[tuple[int, ...], ...]) -> Floats:
    """(3,) normal of a flat face, as long as its area."""
    total = np.zeros(3)
    for ring in rings:
        p = vertices[list(ring)] - vertices[ring[0]]
        total += 0.5 * np.cross(p, np.roll(p, -1, axis=0)).sum(axis=0)
    return total
