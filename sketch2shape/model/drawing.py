"""The two-face object found in a drawing, in the picture's plane."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.errors import PointsError
from sketch2shape.model.arrays import Bools, Brief, Floats, Ints

Lines = Literal["wire", "dashed", "removed"]
"""How hidden edges are drawn: like all others, dashed (or dotted), or not at all."""


Side = Literal["f1", "f2"]
"""One of the two faces."""


@dataclass(frozen=True, eq=False, repr=False)
class Ellipse(Brief):
    """An ellipse in the picture's plane.

    center : (2,) float pixels
    axes   : half axes, pixels, the longer one first
    angle  : of the longer axis, degrees from x towards y, 0..180
    """

    center: Floats
    axes: tuple[float, float]
    angle: float


@dataclass(frozen=True, eq=False, repr=False)
class DrawnArc(Brief):
    """A curved edge of a ring as drawn: a piece of the ellipse that a circular arc is seen as.

    face       : the face whose ring it belongs to
    hole       : number of the hole; None for the outer ring
    start, end : vertices of the ring that it joins, end the one after start; None, None for a whole ellipse, the only
                 edge of a ring without vertices
    ellipse    : what it is a piece of
    points     : (k, 2) float pixels, at least 9, along it from start to end (once round, the first not repeated, where
                 it is whole)
    """

    face: Side
    hole: int | None
    start: int | None
    end: int | None
    ellipse: Ellipse
    points: Floats

    @property
    def path(self) -> Floats:
        """(k, 2) its points; round a whole ellipse back to the first."""
        return self.points if self.start is not None else np.concatenate([self.points, self.points[:1]])


@dataclass(frozen=True, eq=False, repr=False)
class FacePair(Brief):
    """Two corresponding rings: f1[i] joins f2[i].

    f1 : (n, 2) float, pixels, ring order; none for a whole ellipse
    f2 : (n, 2) float, pixels, same order; (1, 2) where the object comes to a point
    """

    f1: Floats
    f2: Floats

    def __post_init__(self) -> None:
        """Take lists and OpenCV's (n, 1, 2) too. Raises PointsError for what is no pair of rings."""
        _settle_rings(self)


@dataclass(frozen=True, eq=False, repr=False)
class TwoFaceObject(Brief):
    """The object found in a drawing, in the picture's plane.

    f1, f2     : (n, 2) float pixels, front and back face in ring order, f1[i] joins f2[i]; f2 is (1, 2) where the
                 object comes to a point (pyramid, cone); a ring that is one whole ellipse has no vertices
    holes      : through-holes, each a pair of corresponding rings
    confidence : 0..1, calibrated: of answers >= 0.9 at least 99 in 100 are right
    lines      : how hidden edges are drawn
    f2_drawn   : (m,) bool for f2 + holes' f2: False where the vertex was inferred, not seen
    connectors : name of the connector that gave the order of f1 and of f2 ("ink" where the drawing decided)
    noise      : rms distance between model and ink, pixels
    page       : (3, 3) homography that rectifies a page photographed at a tilt, or None
    arcs       : the curved edges of all rings of both faces; all other edges are straight
    silhouettes : (s, 2, 2) float pixels, the straight outlines of its curved sides
    front      : the nearer face of a round or pointed object, where hidden lines tell it; of others that is f1
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
    arcs: tuple[DrawnArc, ...] = ()
    silhouettes: Floats = field(default_factory=lambda: np.zeros((0, 2, 2)), repr=False)
    front: Side | None = None

    def __post_init__(self) -> None:
        """Take lists and OpenCV's (n, 1, 2) too, and holes as (f1, f2). Raises PointsError for what is none."""
        _settle_rings(self)
        try:
            holes = tuple(hole if isinstance(hole, FacePair) else FacePair(*hole) for hole in self.holes)
        except TypeError as error:
            raise PointsError("a hole is a pair of rings", remedy="holes=(FacePair(f1, f2), ...)") from error
        object.__setattr__(self, "holes", holes)

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
        """(e, 2) indices into `vertices`: front, back and connecting edges of each ring in turn; 3m without a point."""
        return ring_edges([len(r.f1) for r in self.rings], pointed=self.is_pointed)

    @property
    def is_pointed(self) -> bool:
        """Whether the back face is one point: a pyramid or a cone."""
        return len(self.f2) == 1

    @property
    def is_round(self) -> bool:
        """Whether some edge is curved."""
        return bool(self.arcs)

    def outlines(self, face: Side) -> tuple[Floats, ...]:
        """(k, 2) each ring of a face as drawn, arcs by the points along them; a back face that is a point has none."""
        if face == "f2" and self.is_pointed:
            return ()
        found: list[Floats] = []
        for number, pair in enumerate(self.rings):
            hole = number - 1 if number else None
            own = {arc.start: arc.points for arc in self.arcs if (arc.face, arc.hole) == (face, hole)}
            ring = pair.f1 if face == "f1" else pair.f2
            pieces = (own[k][:-1] if k in own else ring[k : k + 1] for k in range(len(ring)))
            found.append(own[None] if None in own else np.concatenate([ring[:0], *pieces]))
        return tuple(found)

    def swapped(self) -> TwoFaceObject:
        """The same object with f1 and f2 (and those of the holes) exchanged. Raises PointsError if it has a point."""
        if self.is_pointed:
            raise PointsError("the point of a pyramid or a cone cannot be the front face")
        holes = tuple(FacePair(h.f2, h.f1) for h in self.holes)
        arcs = tuple(replace(arc, face="f2" if arc.face == "f1" else "f1") for arc in self.arcs)
        other: dict[Side | None, Side | None] = {"f1": "f2", "f2": "f1", None: None}
        told = replace(self, connectors=self.connectors[::-1], front=other[self.front])
        return replace(told, f1=self.f2, f2=self.f1, holes=holes, arcs=arcs)


def _settle_rings(pair: FacePair | TwoFaceObject) -> None:
    """Make arrays of a pair of corresponding rings. Raises PointsError."""
    f1, f2 = as_ring(pair.f1, "f1"), as_ring(pair.f2, "f2")
    if len(f2) not in (len(f1), 1):
        raise PointsError(f"f1 has {len(f1)} vertices and f2 {len(f2)}", remedy="f1[i] joins f2[i]: as many of each")
    object.__setattr__(pair, "f1", f1)
    object.__setattr__(pair, "f2", f2)


def as_ring(points: ArrayLike, name: str) -> Floats:
    """(n, 2) float of points given in any form; `name` is for the message. Raises PointsError."""
    try:
        ring = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise PointsError(f"{name} must be points (n, 2)") from error
    if ring.ndim == 3 and ring.shape[1] == 1:
        ring = ring[:, 0]
    if ring.shape == (0,):
        ring = ring.reshape(0, 2)
    if ring.ndim != 2 or ring.shape[1] != 2:
        raise PointsError(f"{name} has the shape {ring.shape}, not (n, 2)")
    return ring


def ring_edges(sizes: list[int], *, pointed: bool = False) -> Ints:
    """(e, 2) edges of a two-face object with rings of these sizes (sum m); order as in `TwoFaceObject.edges`.

    pointed : is the back of the one ring a single vertex, m?

    A ring without vertices (a whole ellipse) has no edges here, a ring of two has one each way. Raises PointsError for
    holes beside a point.
    """
    if pointed and len(sizes) > 1:
        raise PointsError("an object that comes to a point has no holes")
    half, start, blocks = sum(sizes), 0, [np.zeros((0, 2), np.intp)]
    for n in sizes:
        a = np.arange(start, start + n)
        b = np.roll(a, -1)
        back = [] if pointed else [np.stack([a, b], axis=1) + half]
        ends = np.full(n, half) if pointed else a + half
        blocks += [np.stack([a, b], axis=1), *back, np.stack([a, ends], axis=1)]
        start += n
    return np.concatenate(blocks).astype(np.intp)
