"""Glue tabs of a paper net: one for each edge that is cut, where there is room."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, replace

import numpy as np
import shapely

from sketch2shape.model import Brief, Floats
from sketch2shape.solids.development import FlatEdge, FlatFace
from sketch2shape.solids.net import Piece, covered, open_edges

#: a tab's sides lean in so far, as a part of its depth: 60 degrees to the edge
_LEAN = 0.577

#: longest part of an edge that the two sides of a tab may take together
_SIDES = 0.7

#: depths that are tried, as parts of the one that is asked for
_DEPTHS = (1.0, 0.6, 0.35)

#: teeth are about so wide, as a part of a tab's depth
_TEETH = 0.9

#: area that a tab may share with what is there before it, as a part of its own: rounding errors; of a tooth, what lies
#: between its straight foot and the rim
_TOUCH = (1e-6, 0.1)

#: part of the teeth that must have room
_ENOUGH = 0.5


@dataclass(frozen=True, eq=False, repr=False)
class Tab(Brief):
    """A tab.

    base    : (k, 2) the edge it hangs on, folded
    outline : (m, 2) the line to cut, from the base and back to it
    face    : number of the face it hangs on
    target  : number of the face it is glued to
    middle  : (2,) where its number has room
    depth   : how far it reaches
    """

    base: Floats
    outline: Floats
    face: int
    target: int
    middle: Floats
    depth: float

    @property
    def shape(self) -> shapely.Geometry:
        """What it covers: a quadrilateral, or a triangle for each tooth."""
        if len(self.base) == 2:
            return shapely.Polygon(self.outline)
        teeth = zip(self.base[:-2:2], self.outline[1::2], self.base[2::2], strict=True)
        return shapely.MultiPolygon([shapely.Polygon(tooth) for tooth in teeth])


@dataclass(frozen=True)
class Joint:
    """Two edges of the paper that are one on the solid.

    tab   : on the first one's side, if there was room; `sides` begins with that one
    sides : number of the piece, face and edge, of both
    """

    sides: tuple[tuple[int, FlatFace, FlatEdge], tuple[int, FlatFace, FlatEdge]]
    tab: Tab | None


def joints(pieces: list[Piece], depth: float) -> list[Joint]:
    """All joints to glue, with their tabs.

    depth : how far tabs reach where there is room
    """
    sides: dict[tuple[int, int], list[tuple[int, FlatFace, FlatEdge]]] = defaultdict(list)
    for number, face, edge in open_edges(pieces):
        sides[(-1, face.number) if edge.edge is None else (0, edge.edge)].append((number, face, edge))
    covers = [piece.outline for piece in pieces]
    found = []
    for key in sorted(sides):
        first, second = sorted(sides[key], key=_reluctance)
        found.append(_joint(covers, first, second, depth))
    return found


def _reluctance(side: tuple[int, FlatFace, FlatEdge]) -> tuple[int, int, int]:
    """Tabs hang on rims of curved sides, as teeth that bend; else on the outside of faces, and on sides before ends."""
    _, face, edge = side
    in_hole = all(edge is not other for other in face.loops[0])
    return (0 if edge.rolled else 1), int(in_hole), -face.number


Side = tuple[int, FlatFace, FlatEdge]


def _joint(covers: list[shapely.Geometry], first: Side, second: Side, depth: float) -> Joint:
    """The joint, with the first tab that has room."""
    for part in _DEPTHS:
        for one, other in ((first, second), (second, first)):
            tab = _with_room(_tab(one, other[1].number, part * depth), covers[one[0]])
            if tab is not None:
                covers[one[0]] = covered([covers[one[0]], tab.shape])
                return Joint((one, other), tab)
    return Joint((first, second), None)


def _with_room(tab: Tab, cover: shapely.Geometry) -> Tab | None:
    """The tab, without teeth that would lie on what is there; None if that leaves too little of it."""
    shapes = shapely.get_parts(tab.shape)
    free = shapely.area(shapely.intersection(shapes, cover)) <= _TOUCH[len(shapes) > 1] * shapely.area(shapes)
    if not free.any() or free.mean() < _ENOUGH:
        return None
    outline = tab.outline.copy()
    for k in np.flatnonzero(~free):
        outline[2 * k + 1] = tab.base[2 * k + 1]
    return replace(tab, outline=outline)


def _tab(side: Side, target: int, depth: float) -> Tab:
    _, face, edge = side
    if edge.rolled or len(edge.points) > 2:
        return _teeth(edge.points, face.number, target, depth)
    a, b = edge.points
    along = b - a
    length = float(np.linalg.norm(along))
    along = along / (length or 1.0)
    depth = min(depth, _SIDES * length / (2 * _LEAN))
    out = depth * np.array([along[1], -along[0]])
    lean = _LEAN * depth * along
    middle = (a + b + out) / 2
    return Tab(edge.points, np.array([a, a + out + lean, b + out - lean, b]), face.number, target, middle, depth)


def _teeth(points: Floats, face: int, target: int, depth: float) -> Tab:
    """Pointed teeth along a rim, which bend with it."""
    lengths = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    count = max(round(lengths[-1] / (_TEETH * depth)), 2)
    at = np.linspace(0.0, lengths[-1], 2 * count + 1)
    x, y = (np.interp(at, lengths, points[:, k]) for k in (0, 1))
    feet = np.c_[x, y]
    along = np.gradient(feet, axis=0)
    out = np.c_[along[:, 1], -along[:, 0]]
    out = out / np.linalg.norm(out, axis=1)[:, None]
    outline = feet + np.where(np.arange(2 * count + 1) % 2 == 1, depth, 0.0)[:, None] * out
    middle = feet[1] + depth / 3 * out[1]
    return Tab(feet, outline, face, target, middle, depth)
