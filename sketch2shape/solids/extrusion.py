"""A solid as an outline that is drawn out along a straight axis: a prism, a frustum, a pyramid.

This is how a person makes it, in a program or a CAD system: an outline, holes in it, a length, and how much smaller
the far end is than the near one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.geometry import signed_area
from sketch2shape.model import Boundary, Brief, Circle, Face, Floats, Plane, Solid
from sketch2shape.solids.front import FlatRing, laid_ring

#: two points, or an axis and a direction, agree if they differ by less than this part of the solid's size
_SAME = 1e-6

Sides = tuple[str, str]

#: what the sizes of a solid along its own axes are called, and what lies at the low and the high end of each
_SIZES: tuple[tuple[str, Sides], ...] = (
    ("width", ("left", "right")),
    ("height", ("bottom", "top")),
    ("depth", ("front", "back")),
)


@dataclass(frozen=True, eq=False, repr=False)
class Extrusion(Brief):
    """An outline with holes, drawn out along the axis across its plane.

    outlines : in the plane of the near end: the outer one, turning anticlockwise, then the holes, turning clockwise;
               the lower left corner of the outer one is 0 0
    extents  : (2,) size of the outer outline
    length   : of the axis, in the solid's unit
    scale    : size of the far end over that of the near one: 1 for a prism, 0 where it comes to a point, never more
    foot     : (2,) where the axis leaves the outline's plane: the point from which the far end is scaled
    origin   : (3,) the lower left corner in space
    axes     : (3, 3) unit rows: along the outline's two axes, and along the axis; right-handed
    names    : what the sizes along these axes are: "width", "height" and "depth" of the upright solid
    sides    : what lies at the low and the high end of the outline's axes, as "left" and "right"
    """

    outlines: tuple[FlatRing, ...]
    extents: Floats
    length: float
    scale: float
    foot: Floats
    origin: Floats
    axes: Floats
    names: tuple[str, str, str]
    sides: tuple[Sides, Sides]


def extrusion_of(solid: Solid) -> Extrusion | None:
    """The solid as an extrusion, or None if it is none, or one whose axis leans without a point it leads to."""
    boundary, front = solid.boundary, solid.faces[0]
    ends = _ends(boundary)
    if ends is None or not isinstance(front.surface, Plane):
        return None
    near, far = ends
    size = float(np.linalg.norm(np.ptp(boundary.extremes(np.eye(3)), axis=0)))
    normal = -front.surface.normal
    length = float((far - near).mean(axis=0) @ normal)
    if length <= _SAME * size or np.ptp(near @ normal) > _SAME * size or np.ptp(far @ normal) > _SAME * size:
        return None
    scale = _scale(near, far)
    moved = far - length * normal - scale * near
    if np.ptp(moved, axis=0).max() > _SAME * size:
        return None
    lean = moved.mean(axis=0)
    if abs(scale - 1.0) <= _SAME:
        return _placed(solid, length, 1.0, near[0]) if np.linalg.norm(lean) <= _SAME * size else None
    return _placed(solid, length, scale if scale > _SAME else 0.0, lean / (1.0 - scale))


def _ends(boundary: Boundary) -> tuple[Floats, Floats] | None:
    """(k, 3) points of the front face, and those of the face or the point across that belong to them."""
    front = boundary.faces[0]
    own = {i for ring in boundary.rings(front) for i in ring}
    across: dict[int, int] = {}
    for a, b in boundary.edge_ends.tolist():
        for i, j in ((a, b), (b, a)):
            if i in own and j not in own:
                if i in across:
                    return None
                across[i] = j
    sides = sum(len(loop) for loop in front.loops)
    pointed = len(boundary.faces) == sides + 1
    others = set(across.values())
    if len(across) != len(own) or (not pointed and (len(others) != len(own) or len(boundary.faces) != sides + 2)):
        return None
    if pointed and (len(own) + 1 != len(boundary.vertices) or not others <= {len(boundary.vertices) - 1}):
        return None
    near = [boundary.vertices[i] for i in across]
    far = [boundary.vertices[i] for i in across.values()]
    circles = _circles(boundary, front)
    if circles:
        normal = circles[0].normal
        beyond = [] if pointed else _circles(boundary, boundary.faces[1])
        near += [mark for circle in circles for mark in _marks(circle, normal)]
        far += (
            [boundary.vertices[-1]] * 3 if pointed else [mark for circle in beyond for mark in _marks(circle, normal)]
        )
    if len(far) != len(near):
        return None
    return np.array(near), np.array(far)


def _circles(boundary: Boundary, face: Face) -> list[Circle]:
    """The whole circles among the loops of a face."""
    edges = [boundary.edges[loop[0].edge] for loop in face.loops]
    return [edge.curve for edge in edges if edge.start is None and isinstance(edge.curve, Circle)]


def _marks(circle: Circle, normal: Floats) -> list[Floats]:
    """Centre and two points of a circle, the same for all circles in planes across the normal."""
    side = np.cross(normal, np.eye(3)[int(np.abs(normal).argmin())])
    side = circle.radius * side / np.linalg.norm(side)
    return [circle.center, circle.center + side, circle.center + np.cross(normal, side)]


def _scale(near: Floats, far: Floats) -> float:
    """How much larger the far points are than the near ones, by least squares."""
    from_middle = near - near.mean(axis=0)
    return float((from_middle * (far - far.mean(axis=0))).sum() / (from_middle * from_middle).sum())


def _placed(solid: Solid, length: float, scale: float, foot: Floats) -> Extrusion:
    """The extrusion, with the larger end as the near one; of a prism the one whose outline is seen as from before."""
    end, axis = solid.faces[0], -_normal(solid.faces[0])
    right, up, kinds = _looking(solid, axis)
    backward = float(np.cross(right, up) @ axis) < 0
    if scale > 1.0 or (scale == 1.0 and backward):
        end, axis, scale, backward = solid.faces[1], -axis, 1.0 / scale, not backward
    sides = [_SIZES[k][1] for k in kinds[:2]]
    if backward:
        right, sides[0] = -right, sides[0][::-1]
    axes = np.array([right, up, axis])
    rings = [laid_ring(solid, loop, axes[:2]) for loop in end.loops]
    traced = _far_points(rings[0])
    corner = traced.min(axis=0)
    level = float(_point_on(solid, end) @ axis)
    return Extrusion(
        tuple(_turning(ring.moved(-corner), 1 if k == 0 else -1) for k, ring in enumerate(rings)),
        np.ptp(traced, axis=0),
        length,
        scale,
        axes[:2] @ foot - corner,
        np.array([*corner, level]) @ axes,
        axes,
        (_SIZES[kinds[0]][0], _SIZES[kinds[1]][0], _SIZES[kinds[2]][0]),
        (sides[0], sides[1]),
    )


def _normal(face: Face) -> Floats:
    return face.surface.normal if isinstance(face.surface, Plane) else np.zeros(3)


def _point_on(solid: Solid, face: Face) -> Floats:
    return face.surface.origin if isinstance(face.surface, Plane) else solid.vertices[0]


def _far_points(ring: FlatRing) -> Floats:
    """Points of a ring with the same bounds as the ring."""
    if ring.circle is not None:
        return np.array(
            [ring.circle[0] + ring.circle[1] * side for side in np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])]
        )
    found = [ring.points]
    for start, bulge in enumerate(ring.bulges.tolist()):
        if bulge:
            found.append(ring.arc(start).farthest())
    return np.concatenate(found)


def _looking(solid: Solid, axis: Floats) -> tuple[Floats, Floats, tuple[int, int, int]]:
    """Right and up of the outline, and which of `_SIZES` those along them and along the axis are."""
    own = np.eye(3) if solid.axes is None else solid.axes
    along = int(np.abs(own @ axis).argmax())
    across, up = (k for k in (0, 2, 1) if k != along)
    if abs(abs(own[along] @ axis) - 1.0) <= _SAME:
        return own[across], own[up], (across, up, along)
    ends = solid.boundary.edge_ends[
        [number for number, _ in solid.faces[0].loops[0] if solid.edges[number].start is not None]
    ]
    edges = np.diff(solid.vertices[ends], axis=1)[:, 0] if len(ends) else own[[across]]
    longest = edges[int(np.linalg.norm(edges, axis=1).argmax())]
    longest = longest - (longest @ axis) * axis
    right = longest / np.linalg.norm(longest)
    right = right * (np.sign(right @ own[across]) or 1.0)
    aside = np.cross(axis, right)
    return right, aside * (np.sign(aside @ own[up]) or 1.0), (across, up, along)


def _turning(ring: FlatRing, way: int) -> FlatRing:
    """The ring turning anticlockwise (1) or clockwise (-1), from its lowest vertex on, the leftmost of those."""
    if ring.circle is not None:
        return ring
    points, bulges = ring.points, ring.bulges
    if signed_area(ring.outline()) * way < 0:
        points, bulges = points[::-1], -np.roll(bulges[::-1], -1)
    size = float(np.ptp(points, axis=0).max()) or 1.0
    rounded = np.round(points / size, 6)
    first = -int(np.lexsort((rounded[:, 0], rounded[:, 1]))[0])
    return FlatRing(np.roll(points, first, axis=0), np.roll(bulges, first))
