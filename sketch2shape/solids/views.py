"""A solid seen straight from before, above and the sides: visible and hidden lines, each line once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from sketch2shape.model import Arc, Brief, Floats, Solid
from sketch2shape.solids.contours import smooth_edges
from sketch2shape.solids.drawn import lines_seen

#: lines nearer to each other than this part of the solid's size are one
_SAME = 1e-6

#: axes of a solid that does not tell its own: x to the right, y away, z up
_UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])

#: name of a view -> what lies to its right and above: numbers of right, up, away, and their signs; with the sizes shown
VIEWS: dict[str, tuple[tuple[int, int], tuple[int, int], tuple[str, str]]] = {
    "front": ((0, 1), (1, 1), ("width", "height")),
    "top": ((0, 1), (2, 1), ("width", "depth")),
    "right": ((2, 1), (1, 1), ("depth", "height")),
    "left": ((2, -1), (1, 1), ("depth", "height")),
}


@dataclass(frozen=True, eq=False, repr=False)
class View(Brief):
    """What is seen, in the solid's unit, y up, its lower left corner at 0 0.

    name    : "front", "top", "right" (seen from the right) or "left"
    visible : lines (k, 2)
    hidden  : lines (k, 2)
    size    : (2,) width and height of the view
    sizes   : what these are of the solid: "width", "height", "depth"
    corners : (n, 2) where sharp vertices lie, and centres of circles and half circles that are seen as such, unless
              they lie in its middle
    circles : those circles and arcs: centre (2,), radius, angle turned through, and direction of its middle, radians
    """

    name: str
    visible: tuple[Floats, ...]
    hidden: tuple[Floats, ...]
    size: Floats
    sizes: tuple[str, str]
    corners: Floats
    circles: tuple[tuple[Floats, float, float, float], ...]


def view_of(solid: Solid, name: str) -> View:
    """One view of a solid."""
    own = _UPRIGHT if solid.axes is None else solid.axes
    (across, sign), (up, _), sizes = VIEWS[name]
    plane = np.array([sign * own[across], own[up]])
    flat = solid.boundary.extremes(plane) @ plane.T
    corner, size = flat.min(axis=0), np.ptp(flat, axis=0)
    camera = np.zeros((3, 4))
    camera[:2, :3], camera[2, 3] = plane * [[1.0], [-1.0]], 1.0
    lines = lines_seen(solid, camera)
    grid = _SAME * float(np.ptp(flat, axis=0).max())
    shown = [np.round((line.points * [1.0, -1.0] - corner) / grid) * grid for line in lines]
    visible = _joined([p for p, line in zip(shown, lines, strict=True) if line.visible], grid)
    hidden = _joined([p for p, line in zip(shown, lines, strict=True) if not line.visible], grid)
    hidden = shapely.difference(hidden, shapely.buffer(visible, 3 * grid, cap_style="flat"))
    circles = tuple(_circle(arc, plane, corner) for arc in _facing(solid, plane))
    centers = [c[0][None] for c in circles if c[2] > np.pi - 1e-3 and np.abs(c[0] - size / 2).max() > grid]
    corners = np.concatenate([solid.vertices[_sharp(solid)] @ plane.T - corner, *centers])
    return View(name, _lines(visible, grid), _lines(hidden, grid), size, sizes, corners, circles)


def _sharp(solid: Solid) -> list[int]:
    """The vertices at which no smooth joint ends."""
    smooth = {i for k in smooth_edges(solid.boundary) for i in solid.edge_ends[k].tolist()}
    return [i for i in range(len(solid.vertices)) if i not in smooth]


def _joined(lines: list[Floats], grid: float) -> shapely.Geometry:
    """The lines, each part once; those that are seen as points are left out."""
    kept = [shapely.LineString(line) for line in lines if float(np.ptp(line, axis=0).max()) > 2 * grid]
    # where one line ends in another's middle, rounding may have moved it off that
    ends = shapely.multipoints(shapely.get_coordinates(kept))
    return shapely.union_all(shapely.snap(kept, ends, 2 * grid), grid_size=grid)


def _lines(geometry: shapely.Geometry, grid: float) -> tuple[Floats, ...]:
    """Lines as points: pieces that go straight on are one."""
    if geometry.is_empty:
        return ()
    merged = geometry if geometry.geom_type == "LineString" else shapely.line_merge(geometry)
    parts = shapely.get_parts(shapely.simplify(merged, grid))
    return tuple(shapely.get_coordinates(part) for part in parts if part.length > 10 * grid)


def _facing(solid: Solid, plane: Floats) -> list[Arc]:
    """Arcs that are seen as circles, one of those behind each other."""
    normal = np.cross(*plane)
    found: dict[tuple[float, ...], Arc] = {}
    for edge in solid.edges:
        arc = solid.boundary.arc(edge)
        if arc is not None and abs(float(arc.circle.normal @ normal)) > 1.0 - _SAME:
            middle = plane @ arc.at(np.array([0.5]))[0]
            key = (*np.round(plane @ arc.circle.center, 6), round(arc.circle.radius, 6), *np.round(middle, 6))
            found.setdefault(tuple(map(float, key)), arc)
    return list(found.values())


def _circle(arc: Arc, plane: Floats, corner: Floats) -> tuple[Floats, float, float, float]:
    center = plane @ arc.circle.center
    x, y = plane @ arc.at(np.array([0.5]))[0] - center
    return center - corner, arc.circle.radius, arc.sweep, float(np.arctan2(y, x))
