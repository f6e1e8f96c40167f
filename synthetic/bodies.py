"""Bodies of any flat faces, seen: which of their lines are drawn, and which parts of these a viewer sees.

Curved bodies are given by many small faces; their smooth edges are drawn only where they are the outline.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull

from sketch2shape.model import Floats, Ints
from synthetic.projecting import View
from synthetic.visibility import Interval, face_of, seen_parts

Edge = tuple[int, int]
Ring = tuple[int, ...]


@dataclass(frozen=True)
class Body:
    """A closed surface.

    vertices : (k, 3), x right, y down, z away
    faces    : index rings of each face, the outer ring first
    smooth   : edges between two parts of one curved face
    """

    vertices: Floats
    faces: tuple[tuple[Ring, ...], ...]
    smooth: frozenset[Edge] = frozenset()

    def edges(self) -> dict[Edge, list[int]]:
        """Every edge (smaller index first) with the faces that meet in it."""
        found: dict[Edge, list[int]] = {}
        for number, rings in enumerate(self.faces):
            for ring in rings:
                for i, a in enumerate(ring):
                    b = ring[(i + 1) % len(ring)]
                    found.setdefault((min(a, b), max(a, b)), []).append(number)
        return found


@dataclass(frozen=True)
class Line:
    """A part of a drawn line.

    path   : (k, 2) polyline in the picture
    hidden : does the body hide it?
    """

    path: Floats
    hidden: bool


def drawn_lines(body: Body, view: View, *, wire: bool = False) -> list[Line]:
    """The lines of a body as they are drawn, chords of one curve joined.

    wire : nothing is hidden, so that a rim is one line; otherwise seen and hidden parts are apart
    """
    projected = view(body.vertices)
    faces = {k: f for k, rings in enumerate(body.faces) if (f := face_of(projected, [np.array(r) for r in rings]))}
    facing = {k: _faces_viewer(projected, rings[0]) for k, rings in enumerate(body.faces)}
    shown = []
    for edge, beside in body.edges().items():
        if edge not in body.smooth or len({facing[k] for k in beside}) == 2:
            shown.append(edge)
    parts = [(*e, [(0.0, 1.0)]) for e in shown] if wire else seen_parts(projected, list(faces.values()), shown)
    rims, outlines = ([p for p in parts if (p[:2] in body.smooth) == smooth] for smooth in (False, True))
    # An outline touches the rims it ends at: joined with its own kind only.
    return [line for some in (rims, outlines) for hidden in (False, True) for line in _chains(projected, some, hidden)]


def silhouettes(body: Body, view: View) -> list[Edge]:
    """The smooth edges that are the outline in this view: one of their two faces is turned to the viewer."""
    projected = view(body.vertices)
    facing = [_faces_viewer(projected, rings[0]) for rings in body.faces]
    return [e for e, beside in body.edges().items() if e in body.smooth and len({facing[k] for k in beside}) == 2]


def _faces_viewer(projected: Floats, ring: Ring) -> bool:
    """Whether a face turns its outside to the viewer; rings turn one way seen from outside."""
    x, y = projected[list(ring), :2].T
    return bool(x @ np.roll(y, -1) - y @ np.roll(x, -1) > 0)


def _chains(projected: Floats, parts: Iterable[tuple[int, int, list[Interval]]], hidden: bool) -> list[Line]:
    """The seen (or hidden) parts of the edges, those that go on smoothly joined to one line."""
    pieces = []
    for a, b, seen in parts:
        ends = [0.0, *(t for s in seen for t in s), 1.0]
        spans = zip(ends[::2], ends[1::2], strict=True) if hidden else seen
        p, q = projected[a, :2], projected[b, :2]
        pieces += [np.array([p + t0 * (q - p), p + t1 * (q - p)]) for t0, t1 in spans if t1 - t0 > 1e-6]
    return [Line(path, hidden) for path in _joined(pieces)]


SMOOTH = np.cos(np.radians(25))
"""Cosine of the largest turn at which two pieces count as one curve."""


def _joined(pieces: list[Floats]) -> list[Floats]:
    """Pieces joined end to end as long as they go on smoothly."""
    left, done = list(pieces), []
    while left:
        path = left.pop()
        grown = True
        while grown:
            grown = False
            for k, piece in enumerate(left):
                longer = _continued(path, piece)
                if longer is not None:
                    path, grown = longer, True
                    left.pop(k)
                    break
        done.append(path)
    return done


def _continued(path: Floats, piece: Floats) -> Floats | None:
    """The path with the piece at one of its ends if it goes on there smoothly."""
    for one in (path, path[::-1]):
        for other in (piece, piece[::-1]):
            if np.abs(one[-1] - other[0]).max() < 1e-6:
                u, v = one[-1] - one[-2], other[1] - other[0]
                if u @ v > SMOOTH * np.linalg.norm(u) * np.linalg.norm(v):
                    return np.vstack([one, other[1:]])
    return None


def convex(points: Floats) -> Body:
    """The convex hull of points (k, 3), coplanar triangles as one face."""
    hull = ConvexHull(points)
    groups: dict[tuple[float, ...], set[int]] = {}
    for triangle, plane in zip(hull.simplices, hull.equations, strict=True):
        groups.setdefault(tuple(np.round(plane, 6) + 0.0), set()).update(int(i) for i in triangle)
    faces = tuple((_around(points, np.array(sorted(g)), np.array(plane[:3])),) for plane, g in groups.items())
    return Body(points, faces)


def _around(points: Floats, chosen: Ints, normal: Floats) -> Ring:
    """The vertices of a convex face in order; seen from outside they turn one way for all faces."""
    corners = points[chosen] - points[chosen].mean(0)
    right = corners[0] / np.linalg.norm(corners[0])
    up = np.cross(normal, right)
    order = np.argsort(np.arctan2(corners @ up, corners @ right))
    # The viewer looks along +z with y down: seen from outside a ring then turns clockwise on the sheet.
    return tuple(int(i) for i in chosen[order][::-1])


def stacked(slabs: Sequence[tuple[Floats, float]], smooth: Sequence[bool]) -> Body:
    """Slabs one upon another, the lowest first, each with a ring (k, 2) of x, z and a height.

    smooth : whether the side of a slab is one curved face
    """
    points: list[Floats] = []
    faces: list[tuple[Ring, ...]] = []
    soft: set[Edge] = set()
    level, start, below = 0.0, 0, None
    for (ring, height), curved in zip(slabs, smooth, strict=True):
        # Positive area in x, z: seen from above the ring turns against the clock.
        outline, k = (ring if _area(ring) > 0 else ring[::-1]), len(ring)
        points += [np.insert(outline, 1, y, axis=1) for y in (level, level - height)]
        low, high = range(start, start + k), range(start + k, start + 2 * k)
        sides = [(i, (i + 1) % k) for i in range(k)]
        faces += [((high[a], high[b], low[b], low[a]),) for a, b in sides]
        soft |= {(low[i], high[i]) for i in range(k)} if curved else set()
        faces.append(_between(below, tuple(low), points))
        below, level, start = tuple(high), level - height, start + 2 * k
    faces.append((tuple(below or ())[::-1],))
    return Body(np.vstack(points), tuple(faces), frozenset(soft))


def _between(below: Ring | None, above: Ring, points: list[Floats]) -> tuple[Ring, ...]:
    """The flat face where one slab lies on another: the larger ring with the smaller as a hole; alone the underside."""
    if below is None:
        return (above,)
    lower, upper = points[-3][:, ::2], points[-2][:, ::2]
    return (below[::-1], above) if _area(lower) > _area(upper) else (above, below[::-1])


def _area(ring: Floats) -> float:
    x, y = ring.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def cubes(cells: set[tuple[int, int, int]], ruled: bool) -> Body:
    """Unit cubes at (x, y, z), glued; `ruled` keeps the lines between squares of one plane."""
    index: dict[tuple[int, int, int], int] = {}
    faces, planes = [], []
    for x, y, z in sorted(cells):
        for axis in range(3):
            for side in (0, 1):
                step = [0, 0, 0]
                step[axis] = 2 * side - 1
                if (x + step[0], y + step[1], z + step[2]) in cells:
                    continue
                ring = _square((x, y, z), axis, side)
                faces.append((tuple(index.setdefault(c, len(index)) for c in ring),))
                planes.append((axis, side, (x, y, z)[axis]))
    body = Body(np.array(list(index), float), tuple(faces))
    flat = {e for e, beside in body.edges().items() if len({planes[k] for k in beside}) == 1 and len(beside) == 2}
    return body if ruled else Body(body.vertices, body.faces, frozenset(flat))


def _square(cell: tuple[int, int, int], axis: int, side: int) -> list[tuple[int, int, int]]:
    """Corners of one side of a unit cube, turning as `_around` has them."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    corners = []
    for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
        corner = list(cell)
        corner[axis] += side
        corner[u] += du
        corner[v] += dv
        corners.append((corner[0], corner[1], corner[2]))
    return corners[::-1] if side else corners
