"""The paper net of a solid: its faces laid flat and joined where they fold, in few pieces without overlaps.

Faces are seen from outside, so that folds of a convex solid go away from the viewer. Each face lies in one piece.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from sketch2shape.model import Boundary, Brief, Floats, Plane
from sketch2shape.solids.contours import smooth_edges
from sketch2shape.solids.development import FlatEdge, FlatFace, developed

#: faces that share less than this part of the smaller one's area only touch
_TOUCH = 1e-6

#: points of faces laid side by side are told apart by this part of their extent
_GRID = 1e-9

Fits = Callable[[shapely.Geometry], bool]
"""Whether a piece of this outline has room on the paper."""


@dataclass(frozen=True, eq=False, repr=False)
class Fold(Brief):
    """A straight edge over which two faces of a piece are joined.

    points : (2, 2) its ends
    edge   : number of the solid's edge
    faces  : numbers of the two faces
    smooth : do they join without a crease, as a flat side and a rounded one?
    back   : is it folded toward the viewer, as at an inner corner?
    """

    points: Floats
    edge: int
    faces: tuple[int, int]
    smooth: bool
    back: bool


@dataclass(frozen=True)
class Piece:
    """Faces that hang together, in their place on the paper."""

    faces: tuple[FlatFace, ...]
    folds: tuple[Fold, ...]

    @property
    def outline(self) -> shapely.Geometry:
        """What they cover."""
        return covered([polygon(face) for face in self.faces])


def covered(shapes: Sequence[shapely.Geometry]) -> shapely.Geometry:
    """What shapes cover together.

    On a fine grid: edges that differ by rounding alone are one there, while without it GEOS may lose shapes.
    """
    points = shapely.get_coordinates(shapes)
    if not len(points):
        return shapely.Polygon()
    size = float(np.ptp(points, axis=0).max())
    return shapely.union_all(shapes, grid_size=_GRID * size)


def polygon(face: FlatFace) -> shapely.Geometry:
    """A face as a polygon with holes; one that crosses itself as what it covers."""
    whole = shapely.Polygon(face.ring(), [face.ring(k) for k in range(1, len(face.loops))])
    return whole if whole.is_valid else shapely.buffer(whole, 0.0)


def unfolded(boundary: Boundary, fits: Fits = lambda _: True) -> list[Piece]:
    """The pieces of the net.

    fits : whether a piece has room on the paper; a single face is a piece whether it fits or not

    Two orders are tried: sides in a row with the ends hanging on, and sides around an end. The one of fewer pieces,
    then of less paper, is taken.
    """
    unfolding = _Unfolding(boundary, fits)
    ways = [unfolding.pieces(order) for order in (_in_a_row, _around)]
    return min(ways, key=lambda pieces: (len(pieces), round(sum(_paper(piece) for piece in pieces), 6)))


def _paper(piece: Piece) -> float:
    """Area of the smallest rectangle around a piece."""
    return float(shapely.minimum_rotated_rectangle(piece.outline).area)


Order = Callable[[int, int, int], tuple[int, ...]]
"""How late two faces are joined, given how many faces are ends and the two numbers."""


def _in_a_row(ends: int, a: int, b: int) -> tuple[int, ...]:
    """Sides to sides first."""
    return (int(a < ends or b < ends),)


def _around(ends: int, a: int, b: int) -> tuple[int, ...]:
    """Everything to the front face first, then to the face laid last."""
    return (int(0 not in (a, b)), int(a < ends or b < ends))


class _Unfolding:
    """The faces of a solid and where they may be joined."""

    def __init__(self, boundary: Boundary, fits: Fits) -> None:
        self.boundary, self.fits = boundary, fits
        self.faces = developed(boundary)
        self.areas = [polygon(face).area for face in self.faces]
        self.smooth = set(smooth_edges(boundary))
        # principal faces: those across the sides, which come first
        normals = [f.surface.normal for f in boundary.faces[:2] if isinstance(f.surface, Plane)]
        self.ends = 2 if len(normals) == 2 and abs(float(normals[0] @ normals[1])) > 0.999 else 1
        size = float(np.ptp(boundary.extremes(np.eye(3)), axis=0).max())
        self.joins: dict[int, list[tuple[int, int]]] = defaultdict(list)
        at: dict[int, list[int]] = defaultdict(list)
        for face in self.faces:
            for edge in face.loops[0]:
                if edge.is_straight and edge.edge is not None and edge.length > _GRID * size:
                    at[edge.edge].append(face.number)
        for number, pair in at.items():
            if len(pair) == 2:
                self.joins[pair[0]].append((pair[1], number))
                self.joins[pair[1]].append((pair[0], number))

    def pieces(self, order: Order) -> list[Piece]:
        """The faces joined in an order, each new piece from the largest face that is left."""
        left = set(range(len(self.faces)))
        found: list[Piece] = []
        start = 0 if order is _around else min(self.ends, len(self.faces) - 1)
        while left:
            root = start if start in left else max(left, key=lambda k: (self.areas[k], -k))
            piece = self._grown(root, left, order)
            left -= {face.number for face in piece.faces}
            found.append(piece)
        return found

    def _grown(self, root: int, left: set[int], order: Order) -> Piece:
        placed = {root: self.faces[root]}
        folds: list[Fold] = []
        cover: shapely.Geometry = polygon(self.faces[root])
        tried: set[tuple[int, int]] = set()
        while True:
            choice = self._next(placed, left, order, tried)
            if choice is None:
                return Piece(tuple(placed.values()), tuple(folds))
            a, b, number = choice
            tried.add((b, number))
            face, fold = self._hinged(placed[a], b, number)
            shape = polygon(face)
            if shapely.intersection(cover, shape).area > _TOUCH * min(shape.area, self.areas[a]):
                continue
            grown = covered([cover, shape])
            if self.fits(grown):
                placed[b], cover = face, grown
                folds.append(fold)

    def _next(
        self,
        placed: dict[int, FlatFace],
        left: set[int],
        order: Order,
        tried: set[tuple[int, int]],
    ) -> tuple[int, int, int] | None:
        """The join to try next: the face there is, the new one, the edge."""
        options = [
            (number not in self.smooth, *order(self.ends, a, b), -round(self._length(b, number), 9), a, b, number)
            for a in placed
            for b, number in self.joins[a]
            if b in left and b not in placed and (b, number) not in tried
        ]
        if not options:
            return None
        *_, a, b, number = min(options)
        return int(a), int(b), int(number)

    def _length(self, face: int, number: int) -> float:
        return next(edge.length for edge in self.faces[face].loops[0] if edge.edge == number)

    def _hinged(self, beside: FlatFace, number: int, edge: int) -> tuple[FlatFace, Fold]:
        """A face laid against another one along an edge."""
        face = self.faces[number]
        own = next(e.points for e in face.loops[0] if e.edge == edge)
        there = next(e.points for e in beside.loops[0] if e.edge == edge)
        p, q = (complex(*point) for point in own)
        b, a = (complex(*point) for point in there)
        turn = (b - a) / (q - p)
        turn = turn / abs(turn)
        pair = (beside.number, number)
        fold = Fold(there, edge, pair, edge in self.smooth, self._is_inner(edge, pair))
        return face.moved(turn, (a + b) / 2 - turn * (p + q) / 2), fold

    def _is_inner(self, edge: int, pair: tuple[int, int]) -> bool:
        """Whether the solid's faces make an inner corner at an edge."""
        for one, other in (pair, pair[::-1]):
            surface = self.boundary.faces[one].surface
            if isinstance(surface, Plane):
                ring = {i for ring in self.boundary.rings(self.boundary.faces[other]) for i in ring}
                start = self.boundary.vertices[self.boundary.edge_ends[edge][0]]
                return bool((self.boundary.vertices[sorted(ring)].mean(axis=0) - start) @ surface.normal > 0)
        return False


def open_edges(pieces: list[Piece]) -> Iterator[tuple[int, FlatFace, FlatEdge]]:
    """The edges that are cut: number of the piece, face, edge."""
    for number, piece in enumerate(pieces):
        folded = {(fold.edge, face) for fold in piece.folds for face in fold.faces}
        for face in piece.faces:
            for edge in (edge for loop in face.loops for edge in loop):
                if edge.edge is None or (edge.edge, face.number) not in folded:
                    yield number, face, edge
