"""A solid's lines as they are drawn: edges straight and curved, and the outlines of curved sides, seen and hidden."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from sketch2shape.model import Bools, DrawnArc, Floats, Ints, Projection, Solid, TwoFaceObject
from sketch2shape.solids.contours import contour_candidates, smooth_edges
from sketch2shape.solids.hidden import edge_runs, nearness
from sketch2shape.solids.tessellation import Tessellation, tessellated

#: places along a straight line of a round solid at which it is asked whether a face hides it
_PLACES = 128

#: a facet must lie this part of the solid's depth in front of a point to hide it
_IN_FRONT = 1e-5

#: facets whose image has less than this part of the drawing's size squared are seen from their edge
_EDGE_ON = 1e-9


@dataclass(frozen=True)
class DrawnLine:
    """A piece of a line of the drawing.

    points  : (k, 2) pixels along it: both ends of a straight one, more of a curved one
    visible : is no face in front of it?
    edge    : row of `Solid.edges` it belongs to; None for the outline of a curved side
    """

    points: Floats
    visible: bool
    edge: int | None

    @property
    def start(self) -> Floats:
        """(2,) where it begins."""
        return np.asarray(self.points[0])

    @property
    def end(self) -> Floats:
        """(2,) where it ends."""
        return np.asarray(self.points[-1])


def drawn_lines(obj: TwoFaceObject, solid: Solid) -> list[DrawnLine]:
    """The lines of an object, cut where they pass in or out of sight, in the order of the solid's edges.

    Outlines of curved sides come last. Smooth joints, as of a line and an arc, have no line.
    """
    if not solid.boundary.is_round:
        return _straight_lines(solid, obj.vertices)
    if solid.camera is None:  # nothing tells what hides what
        arcs = [DrawnLine(arc.path, True, None) for arc in obj.arcs]
        return [*arcs, *(DrawnLine(obj.vertices[list(e)], True, k) for k, e in enumerate(obj.edges))]
    return _round_lines(solid, solid.camera, obj.vertices, _arcs_at(obj))


def lines_seen(solid: Solid, camera: Floats) -> list[DrawnLine]:
    """The lines of a solid as a camera (3, 4) sees it, as `drawn_lines` gives those of its drawing."""
    converges = bool(np.abs(camera[2, :3]).max() > 0)
    seen = replace(solid, projection=Projection("perspective" if converges else "axonometric"))
    points = _seen(camera, solid.vertices)
    if solid.boundary.is_round:
        return _round_lines(seen, camera, points, {})
    return _straight_lines(seen, points)


def _straight_lines(solid: Solid, points: Floats) -> list[DrawnLine]:
    """Straight edges between vertices at these points (k, 2)."""
    lines: list[DrawnLine] = []
    for number, runs in enumerate(edge_runs(solid, points)):
        a, b = points[solid.edge_ends[number]]
        lines += [DrawnLine(np.array([a + t * (b - a), a + u * (b - a)]), visible, number) for t, u, visible in runs]
    return lines


def _round_lines(solid: Solid, camera: Floats, vertices: Floats, arcs_at: dict[int, DrawnArc]) -> list[DrawnLine]:
    """Edges and outlines of a round solid before a camera.

    vertices : (k, 2) where the solid's vertices are drawn
    arcs_at  : arcs as drawn, by the numbers of the solid's edges
    """
    form = tessellated(solid.boundary)
    view = _View(form, solid, _seen(camera, form.vertices))
    smooth = smooth_edges(solid.boundary)
    lines: list[DrawnLine] = []
    for number, edge in enumerate(solid.edges):
        if number in smooth:
            continue
        path = form.paths[number]
        if len(path) > 2:
            shown = _snapped(view.points[path], arcs_at.get(number), whole=edge.start is None)
            lines += [DrawnLine(shown[a : b + 1], seen, number) for a, b, seen in _cut(view.seen_along(path))]
        else:
            lines += [DrawnLine(p, seen, number) for p, seen in view.straight(path, vertices[path])]
    for i, j, *beside in contour_candidates(form, smooth).tolist():
        if view.faces[beside[0]] != view.faces[beside[1]]:
            path = np.array([i, j])
            lines += [DrawnLine(p, seen, None) for p, seen in view.straight(path, view.points[path])]
    return lines


def _seen(camera: Floats, vertices: Floats) -> Floats:
    """(k, 2) pixels at which a camera (3, 4) sees vertices (k, 3)."""
    rows = np.c_[vertices, np.ones(len(vertices))] @ camera.T
    return np.asarray(rows[:, :2] / rows[:, 2:])


class _View:
    """The facets of a solid in its drawing."""

    def __init__(self, form: Tessellation, solid: Solid, points: Floats) -> None:
        self.points = points
        self.near = nearness(points, form.vertices, solid.projection.family)
        triangles = form.triangles
        a, b, c = points[triangles].swapaxes(0, 1)
        area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        #: (t,) does the triangle face the viewer? y is down, so that outward ones then turn the other way
        self.faces: Bools = area * self._handed(form, triangles) > 0
        kept = np.abs(area) > _EDGE_ON * float(np.ptp(points, axis=0).max()) ** 2
        self.corners, self.area = (a[kept], b[kept], c[kept]), area[kept]
        self.heights = self.near[triangles[kept]]

    def _handed(self, form: Tessellation, triangles: Ints) -> float:
        """1 or -1: the sense in which triangles that face the viewer turn in the picture."""
        a, b, c = form.vertices[triangles].swapaxes(0, 1)
        p, q, r = self.points[triangles].swapaxes(0, 1)
        out = np.cross(b - a, c - a)
        rows = np.c_[form.vertices - form.vertices.mean(axis=0), np.ones(len(form.vertices))]
        slope = np.linalg.lstsq(rows, self.near, rcond=None)[0][:3]
        area = (q[:, 0] - p[:, 0]) * (r[:, 1] - p[:, 1]) - (q[:, 1] - p[:, 1]) * (r[:, 0] - p[:, 0])
        return 1.0 if float((out @ slope) @ area) > 0 else -1.0

    def hidden(self, at: Floats, near: Floats) -> Bools:
        """(k,) is there a facet in front of these points (k, 2) of this nearness (k,)?"""
        a, b, c = self.corners
        x, y = at[:, None, 0], at[:, None, 1]
        u = ((x - a[:, 0]) * (c - a)[:, 1] - (y - a[:, 1]) * (c - a)[:, 0]) / self.area
        v = ((b - a)[:, 0] * (y - a[:, 1]) - (b - a)[:, 1] * (x - a[:, 0])) / self.area
        first, second, third = self.heights.T
        here = first + u * (second - first) + v * (third - first)
        slack = _IN_FRONT * float(np.ptp(self.near))
        inside = (u >= 0) & (v >= 0) & (u + v <= 1)
        return np.asarray((inside & (here > near[:, None] + slack)).any(axis=1))

    def seen_along(self, path: Ints) -> Bools:
        """(k - 1,) is the middle of each chord of a path in view?"""
        at, near = self.points[path], self.near[path]
        return ~self.hidden(0.5 * (at[:-1] + at[1:]), 0.5 * (near[:-1] + near[1:]))

    def straight(self, path: Ints, shown: Floats) -> list[tuple[Floats, bool]]:
        """The pieces of a straight line between two vertices, drawn between two points (2, 2); is each of them seen?"""
        t = (np.arange(_PLACES)[:, None] + 0.5) / _PLACES
        (p, q), (m, n) = self.points[path], self.near[path]
        seen = ~self.hidden(p + t * (q - p), m + t[:, 0] * (n - m))
        (a, b) = shown
        step = (b - a) / _PLACES
        return [(np.array([a + s * step, a + e * step]), k) for s, e, k in _cut(seen)]


def _cut(seen: Bools) -> list[tuple[int, int, bool]]:
    """Runs of equal values: where each begins and ends, and the value."""
    cuts = [0, *(np.flatnonzero(np.diff(seen)) + 1).tolist(), len(seen)]
    return [(a, b, bool(seen[a])) for a, b in pairwise(cuts)]


def _arcs_at(obj: TwoFaceObject) -> dict[int, DrawnArc]:
    """The drawn arcs by the numbers of the solid's edges."""
    pointed = obj.is_pointed
    at, found, open_edges = 0, {}, len(obj.edges)
    whole = open_edges
    for ring, pair in enumerate(obj.rings):
        n = len(pair.f1)
        mine = [arc for arc in obj.arcs if (0 if arc.hole is None else arc.hole + 1) == ring]
        for arc in mine:
            if arc.start is None:
                found[whole + (arc.face == "f2")] = arc
            else:
                found[at + arc.start + (n if arc.face == "f2" else 0)] = arc
        whole += 0 if n else 1 if pointed else 2
        at += (2 if pointed else 3) * n
    return found


def _snapped(points: Floats, arc: DrawnArc | None, *, whole: bool) -> Floats:
    """Points (k, 2) along an arc of the solid, moved onto the arc as it was drawn."""
    if arc is None:
        return points
    if not whole:
        t = np.linspace(0.0, len(arc.points) - 1.0, len(points))
        index = np.arange(len(arc.points))
        return np.stack([np.interp(t, index, arc.points[:, 0]), np.interp(t, index, arc.points[:, 1])], axis=1)
    turn = np.radians(arc.ellipse.angle)
    axes = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    away = (points - points[:-1].mean(axis=0)) @ axes.T
    reach = np.hypot(*(away / arc.ellipse.axes).T)
    return np.asarray(arc.ellipse.center + (away / np.maximum(reach, 1e-9)[:, None]) @ axes)
