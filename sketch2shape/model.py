"""The data that flows between the stages: small frozen dataclasses of NumPy arrays.

Units: image coordinates are pixels of the picture as a viewer sees it, x to the right, y down, the centre of the
first pixel at (0, 0). Solid coordinates are right-handed: x right, y down, z away from the viewer.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.intp]
Bools = NDArray[np.bool_]
Gray = NDArray[np.uint8]

Lines = Literal["wire", "dashed", "removed"]
"""How hidden edges are drawn: like all others, dashed (or dotted), or not at all."""


def as_gray(array: NDArray[Any]) -> Gray:
    """The array as uint8, which OpenCV's types do not tell."""
    return np.asarray(array, dtype=np.uint8)


@dataclass(frozen=True)
class Picture:
    """A decoded image.

    pixels    : (h, w, 3) uint8 RGB, EXIF orientation applied, transparency composited
    source    : name for messages and reports
    full_size : (width, height) of the picture if the pixels are a reduced copy of it, else None
    """

    pixels: NDArray[np.uint8]
    source: str = "<array>"
    full_size: tuple[int, int] | None = None

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the picture, in whose pixels everything found in it is told."""
        return self.full_size or (int(self.pixels.shape[1]), int(self.pixels.shape[0]))

    @property
    def reduction(self) -> int:
        """Picture pixels along the side of each of `pixels`."""
        height, width = self.pixels.shape[:2]
        return round(max(self.size) / max(int(height), int(width)))


@dataclass(frozen=True)
class Ink:
    """What was drawn, at working size.

    mask      : (h, w) bool, True where there is ink
    strength  : (h, w) uint8, how dark the ink is against its surroundings, 255 where it is darkest
    pen_width : typical stroke width, working pixels
    scale     : working pixels per picture pixel (<= 1 for large pictures)
    page      : (3, 3) homography from picture pixels to the rectified page if a tilted page is seen whole, else None
    """

    mask: Bools
    strength: Gray
    pen_width: float
    scale: float = 1.0
    page: Floats | None = None


@dataclass(frozen=True)
class FacePair:
    """Two corresponding rings: f1[i] joins f2[i].

    f1 : (n, 2) float, pixels, ring order
    f2 : (n, 2) float, pixels, same order
    """

    f1: Floats
    f2: Floats


@dataclass(frozen=True)
class TwoFaceObject:
    """The object found in a drawing, in the picture's plane.

    f1, f2     : (n, 2) float pixels, front and back face in ring order, f1[i] joins f2[i]
    holes      : through-holes, each a pair of corresponding rings
    confidence : 0..1, calibrated: of answers >= 0.9 at least 99 in 100 are right
    lines      : how hidden edges are drawn
    f2_drawn   : (m,) bool for f2 + holes' f2: False where the vertex was inferred, not seen
    connectors : name of the connector that gave the order of f1 and of f2 ("ink" where the drawing decided)
    noise      : rms distance between model and ink, pixels
    page       : (3, 3) homography that rectifies a page photographed at a tilt, or None
    """

    f1: Floats
    f2: Floats
    holes: tuple[FacePair, ...] = ()
    confidence: float = 1.0
    lines: Lines = "wire"
    f2_drawn: Bools | None = None
    connectors: tuple[str, str] = ("ink", "ink")
    noise: float = 0.0
    page: Floats | None = None

    @property
    def rings(self) -> tuple[FacePair, ...]:
        """The outer pair of rings, then the holes."""
        return (FacePair(self.f1, self.f2), *self.holes)

    @property
    def vertices(self) -> Floats:
        """(2m, 2) float pixels: f1, holes' f1, f2, holes' f2."""
        return np.concatenate([r.f1 for r in self.rings] + [r.f2 for r in self.rings])

    @property
    def edges(self) -> Ints:
        """(3m, 2) indices into `vertices`: front, back and connecting edges of each ring in turn."""
        return ring_edges([len(r.f1) for r in self.rings])

    def swapped(self) -> TwoFaceObject:
        """The same object with f1 and f2 (and those of the holes) exchanged."""
        holes = tuple(FacePair(h.f2, h.f1) for h in self.holes)
        return replace(self, f1=self.f2, f2=self.f1, holes=holes, connectors=self.connectors[::-1])


def ring_edges(sizes: list[int]) -> Ints:
    """(3m, 2) edges of a two-face object with rings of these sizes (sum m); order as in `TwoFaceObject.edges`."""
    half, start, blocks = sum(sizes), 0, []
    for n in sizes:
        a = np.arange(start, start + n)
        b = np.append(a[1:], start)
        blocks += [np.stack([a, b], axis=1), np.stack([a, b], axis=1) + half, np.stack([a, a + half], axis=1)]
        start += n
    return np.concatenate(blocks).astype(np.intp)


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
