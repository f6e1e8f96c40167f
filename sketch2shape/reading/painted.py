"""What a drawing program paints, shape over shape, as the lines that are left to see.

A filled shape hides what was painted before it. Shapes that are filled and have no stroke are left out where they are
small (letters, arrow heads, dots), are lines where they are long and thin (the outline of a pen's stroke), and faces
otherwise: their borders are lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

import numpy as np
import shapely

from sketch2shape.model import Floats, VectorLine
from sketch2shape.reading.sheet import checked_points

Colour = tuple[int, int, int]
WHITE: Colour = (255, 255, 255)
SEEN = 8
"""Difference of a colour, of 255, from which on it is seen on the ground."""
SMALL = 0.06
"""Size of a filled shape, as a part of the drawing's, up to which it is a letter, an arrow head or a dot."""
THIN, LONG = 0.025, 8.0
"""Width of a filled shape, as a part of the drawing's size, up to which it is a line if it is so many times longer."""
DASH, FULL = 3.0, 0.6
"""Length of a dash in its widths, and the part of that box that it fills; the head of an arrow fills half."""
COVERS = 0.9
"""Part of the drawing's box that the ground fills at least."""
INSET = 0.002
"""Part of the drawing's size by which a shape hides less than it fills: lines along its border are seen."""
MOST_COVERS = 500
"""Filled shapes up to which what they hide is worked out; a picture shaded with more is none of lines."""
MOST_TANGLED, TANGLED = 4_000, 8.0
"""Squares of the lengths of filled rings, in their own diagonals, added up over rings that are so many diagonals long:
they cross themselves about as often, and what they fill takes as long. The outline of a letter has six."""
MOST_PAIRS, MOST_CUT = 500_000, 300_000
"""Pairs of a filled shape and a line before it, and points of those that overlap, up to which it is worked out what is
hidden: both take a part of a second."""
MOST_GROUNDS = 10
"""Shapes over each other, each on the whole of the one before: a page, its border, its paper."""
UNEVEN = 3.0
"""Width of a pen's stroke at its widest, in mean widths, up to which its two sides have a line between them."""


class OutlinedStrokesError(Exception):
    """The lines are there as outlines of one tangle: only its picture tells where they run."""


@dataclass(frozen=True, eq=False)
class Shape:
    """One shape as painted.

    parts  : its straight and its curved lines, in order
    rings  : (n, 2) each, its subpaths, as a filling closes them
    stroke : colour of the line along it, None for none
    dashed : whether that is dashed or dotted
    fill   : colour of its opaque filling, None for none
    """

    parts: tuple[VectorLine, ...]
    rings: tuple[Floats, ...] = ()
    stroke: Colour | None = None
    dashed: bool = False
    fill: Colour | None = None


def visible_lines(shapes: Sequence[Shape]) -> list[VectorLine]:
    """The lines that can be seen. Raises OutlinedStrokesError, UnreadableError, LimitError."""
    points = checked_points([part.points for shape in shapes for part in shape.parts if len(part.points)])
    if not len(points):
        return []
    size = float(np.hypot(*np.ptp(points, axis=0)))
    ground, shapes = _without_ground(shapes)
    filled = [shape for shape in shapes if shape.fill is not None]
    if len(filled) > MOST_COVERS or _tangle(filled) > MOST_TANGLED:
        raise OutlinedStrokesError
    left = _Left()
    for shape in shapes:
        region = _region(shape) if shape.fill is not None else None
        if region is not None and not region.is_empty:
            left.cover(region.buffer(-INSET * size))
        left.add(_own_lines(shape, region, ground, size))
    return left.lines


def _tangle(shapes: Sequence[Shape]) -> float:
    """See `MOST_TANGLED`."""
    wound = [
        float(np.hypot(*np.diff(ring, axis=0).T).sum()) / max(float(np.hypot(*np.ptp(ring, axis=0))), 1e-12)
        for shape in shapes
        for ring in shape.rings
    ]
    return sum(long**2 for long in wound if long > TANGLED)


def _own_lines(shape: Shape, region: Any, ground: Colour, size: float) -> list[VectorLine]:
    if shape.stroke is not None:
        if not _differ(shape.stroke, ground):
            return []
        return [replace(part, dashed=shape.dashed) for part in shape.parts if len(part.points)]
    if region is None or region.is_empty or shape.fill is None or not _differ(shape.fill, ground):
        return []
    low_x, low_y, high_x, high_y = region.bounds
    width = 2.0 * region.area / max(region.length, 1e-12)
    if float(np.hypot(high_x - low_x, high_y - low_y)) <= SMALL * size:
        middle = middle_line(shape.rings[0], width) if _is_dash(region) and len(shape.rings) == 1 else None
        return [] if middle is None else [VectorLine(middle)]
    if width > THIN * size or region.length < 2 * LONG * width:
        return [VectorLine(np.concatenate([ring, ring[:1]])) for ring in shape.rings]
    middle = middle_line(shape.rings[0], width) if len(shape.rings) == 1 else None
    if middle is None:
        raise OutlinedStrokesError
    return [VectorLine(middle)]


def _is_dash(region: Any) -> bool:
    """Whether a small region fills most of a box that is much longer than wide."""
    box = shapely.minimum_rotated_rectangle(region)
    if box.area <= 0:
        return False
    corners = shapely.get_coordinates(box)
    sides = np.sort(np.hypot(*np.diff(corners[:3], axis=0).T))
    return bool(sides[1] >= DASH * sides[0] and region.area >= FULL * box.area)


def middle_line(outline: Floats, width: float) -> Floats | None:
    """(k, 2) the line between the two sides of the outline of a stroke; None for that of a tangle."""
    ring = outline[:-1] if np.array_equal(outline[0], outline[-1]) else outline
    i, j = _tips(ring)
    one, other = ring[i : j + 1], np.concatenate([ring[j:], ring[: i + 1]])[::-1]
    count = max(8, len(ring))
    one, other = _evenly(one, count), _evenly(other, count)
    across = np.hypot(*(one - other).T)
    return None if float(across.max()) > UNEVEN * width else np.asarray((one + other) / 2)


def _tips(ring: Floats) -> tuple[int, int]:
    """The two points that are farthest apart."""
    hull = np.flatnonzero(_on_hull(ring))
    apart = np.hypot(*(ring[hull, None] - ring[None, hull]).transpose(2, 0, 1))
    a, b = np.unravel_index(int(apart.argmax()), apart.shape)
    first, last = sorted((int(hull[a]), int(hull[b])))
    return first, last


def _on_hull(ring: Floats) -> Any:
    """(n,) which points are the outermost in one of some directions."""
    angles = np.arange(64) * np.pi / 32
    extreme = (ring @ np.stack([np.cos(angles), np.sin(angles)])).argmax(axis=0)
    out = np.zeros(len(ring), np.bool_)
    out[extreme] = True
    return out


def _evenly(points: Floats, count: int) -> Floats:
    """A polyline as so many points at equal distances along it."""
    steps = np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
    at = np.linspace(0.0, steps[-1], count)
    return np.stack([np.interp(at, steps, points[:, 0]), np.interp(at, steps, points[:, 1])], axis=1)


def _without_ground(shapes: Sequence[Shape]) -> tuple[Colour, list[Shape]]:
    """The colour all else is painted on, white if no shape fills the whole; and the other shapes."""
    rest = list(shapes)
    ground = WHITE
    boxes = [_box(shape) for shape in rest]
    for _ in range(MOST_GROUNDS):
        whole = _joined(boxes)
        first, fill = boxes[0], rest[0].fill
        if fill is None or first is None or whole is None or len(rest[0].rings) != 1 or len(rest) == 1:
            break
        inner = _joined(boxes[1:])
        if _area(first) < COVERS * _area(whole) or inner is None or not _within(inner, first):
            break
        ground = fill
        rest, boxes = rest[1:], boxes[1:]
    return ground, rest


Box = tuple[float, float, float, float]


def _box(shape: Shape) -> Box | None:
    points = [part.points for part in shape.parts if len(part.points)]
    if not points:
        return None
    every = np.concatenate(points)
    low, high = every.min(axis=0).tolist(), every.max(axis=0).tolist()
    return low[0], low[1], high[0], high[1]


def _joined(boxes: Sequence[Box | None]) -> Box | None:
    known = [box for box in boxes if box is not None]
    if not known:
        return None
    columns = list(zip(*known, strict=True))
    return min(columns[0]), min(columns[1]), max(columns[2]), max(columns[3])


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])


def _within(inner: Box, outer: Box) -> bool:
    """Whether a box lies well inside another: the border of a face is as large as what it shows, but touches it."""
    return inner[0] > outer[0] and inner[1] > outer[1] and inner[2] < outer[2] and inner[3] < outer[3]


def _region(shape: Shape) -> Any:
    """What a shape fills, by the rule of even and odd."""
    some = [shapely.make_valid(shapely.Polygon(r)) for r in shape.rings if len(np.unique(r, axis=0)) >= 3]
    while len(some) > 1:  # in pairs: one after the other would take the square of the time
        some = [a.symmetric_difference(b) for a, b in zip_longest(some[::2], some[1::2], fillvalue=shapely.Polygon())]
    return some[0] if some else shapely.Polygon()


class _Left:
    """What is left to see of the lines painted so far."""

    def __init__(self) -> None:
        self.lines: list[VectorLine] = []
        self._drawn: list[Any] = []
        self._pairs = self._cut = 0

    def add(self, lines: Sequence[VectorLine]) -> None:
        """Paint lines over all others."""
        self.lines += lines
        self._drawn += map(_geometry, lines)

    def cover(self, cover: Any) -> None:
        """Hide what lies under a region. Raises OutlinedStrokesError where that would take long."""
        self._pairs += len(self.lines)
        if self._pairs > MOST_PAIRS:
            raise OutlinedStrokesError
        if cover.is_empty or not self.lines:
            return
        shapely.prepare(cover)
        met = shapely.intersects(cover, np.array(self._drawn, object))
        if not met.any():
            return
        around = int(shapely.get_num_coordinates(cover))
        self._cut += sum(around + len(line.points) for line, cut in zip(self.lines, met.tolist(), strict=True) if cut)
        if self._cut > MOST_CUT:
            raise OutlinedStrokesError
        painted, self.lines, self._drawn = zip(self.lines, self._drawn, met.tolist(), strict=True), [], []
        for line, drawn, is_met in painted:
            self.add([line] if not is_met else _pieces_of(line, drawn.difference(cover)))


def _geometry(line: VectorLine) -> Any:
    return shapely.LineString(line.points) if len(line.points) > 1 else shapely.Point(line.points[0])


def _pieces_of(line: VectorLine, left: Any) -> list[VectorLine]:
    """The line where only this is left of it."""
    pieces = getattr(left, "geoms", [left])
    return [replace(line, points=shapely.get_coordinates(p)) for p in pieces if not p.is_empty]


def _differ(one: Colour, other: Colour) -> bool:
    return max(abs(a - b) for a, b in zip(one, other, strict=True)) >= SEEN
