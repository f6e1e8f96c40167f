"""Which parts of an object's edges its own faces hide.

Each edge is cut where another edge crosses it in the drawing; a piece is hidden if, at its middle, some face lies in
front of it. Depths need no camera: in a parallel drawing depth is an affine function of the picture over each plane
face, in perspective its inverse is.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Floats, Solid, TwoFaceObject

#: a face must lie this part of the object's depth in front of a point to hide it
_IN_FRONT = 1e-6


@dataclass(frozen=True)
class Line:
    """A piece of an edge in the drawing.

    start, end : (2,) pixels
    visible    : is no face in front of it?
    edge       : row of `TwoFaceObject.edges` it belongs to
    """

    start: Floats
    end: Floats
    visible: bool
    edge: int


def drawing_lines(obj: TwoFaceObject, solid: Solid) -> list[Line]:
    """The object's edges as drawn lines, cut where they pass in or out of sight, in the order of `obj.edges`."""
    points, edges = obj.vertices, obj.edges
    near = _nearness(points, solid)
    faces = [_FaceImage(points, near, solid.rings(face)) for face in solid.faces]
    lines: list[Line] = []
    for number, (a, b) in enumerate(edges.tolist()):
        cuts = _cuts(points, edges, number)
        middles = 0.5 * (cuts[1:] + cuts[:-1])
        shown = [_seen(points, near, (a, b), float(t), faces) for t in middles]
        start = 0
        for k in range(1, len(shown) + 1):
            if k == len(shown) or shown[k] != shown[start]:
                p, q = (points[a] + cuts[i] * (points[b] - points[a]) for i in (start, k))
                lines.append(Line(p, q, shown[start], number))
                start = k
    return lines


class _FaceImage:
    """A face in the drawing: its rings, and nearness as an affine function of the picture."""

    def __init__(self, points: Floats, near: Floats, rings: tuple[tuple[int, ...], ...]) -> None:
        self.members = frozenset(i for ring in rings for i in ring)
        self.rings = [points[list(ring)] for ring in rings]
        every = [i for ring in rings for i in ring]
        middle = points[every].mean(axis=0)
        rows = np.c_[points[every] - middle, np.ones(len(every))]
        fit, *_ = np.linalg.lstsq(rows, near[every], rcond=1e-6)
        self.slope, self.offset = fit[:2], fit[2] - fit[:2] @ middle

    def holds(self, p: Floats) -> bool:
        """Does the face's image contain the point (even-odd over all rings)?"""
        inside = False
        for ring in self.rings:
            a, b = ring, np.roll(ring, -1, axis=0)
            span = (a[:, 1] > p[1]) != (b[:, 1] > p[1])
            rise = np.where(span, b[:, 1] - a[:, 1], 1.0)
            x = a[:, 0] + (p[1] - a[:, 1]) / rise * (b[:, 0] - a[:, 0])
            inside ^= bool((span & (x > p[0])).sum() % 2)
        return inside


def _nearness(points: Floats, solid: Solid) -> Floats:
    """(2m,) a number that grows towards the viewer and is affine in the picture over any plane."""
    v = solid.vertices - solid.vertices.mean(axis=0)
    v = v / (np.abs(v).max() or 1.0)
    if solid.projection.family == "perspective" and len(v) >= 6:
        depth = _perspective_depth(points, v)
        if depth is not None:
            near: Floats = 1.0 / depth / np.abs(1.0 / depth).max()
            return near
    map_to_picture, *_ = np.linalg.lstsq(np.c_[v, np.ones(len(v))], points, rcond=None)
    away = np.cross(map_to_picture[:3, 0], map_to_picture[:3, 1])
    along: Floats = -(v @ away) / (np.linalg.norm(away) or 1.0)
    return along


def _perspective_depth(points: Floats, v: Floats) -> Floats | None:
    """(2m,) depth before the camera that sees the vertices so, by direct linear transformation; None if none does."""
    middle, size = points.mean(axis=0), float(np.abs(points - points.mean(axis=0)).max()) or 1.0
    xy = (points - middle) / size
    rows = np.c_[v, np.ones(len(v))]
    nothing = np.zeros_like(rows)
    system = np.concatenate([np.c_[rows, nothing, -xy[:, :1] * rows], np.c_[nothing, rows, -xy[:, 1:] * rows]])
    camera = np.linalg.svd(system)[2][-1].reshape(3, 4)
    depth: Floats = rows @ camera[2] * np.sign(np.linalg.det(camera[:, :3]) or 1.0)
    return depth if depth.min() > 1e-6 * np.abs(depth).max() else None


def _cuts(points: Floats, edges: np.ndarray[tuple[int, int], np.dtype[np.intp]], number: int) -> Floats:
    """Sorted parameters 0..1 at which other edges cross or touch this one."""
    a, b = edges[number]
    p, r = points[a], points[b] - points[a]
    q, s = points[edges[:, 0]], points[edges[:, 1]] - points[edges[:, 0]]
    cross = r[0] * s[:, 1] - r[1] * s[:, 0]
    flat = np.abs(cross) < 1e-12 * max(float(r @ r), 1e-12)
    safe = np.where(flat, 1.0, cross)
    gap = q - p
    t = (gap[:, 0] * s[:, 1] - gap[:, 1] * s[:, 0]) / safe
    u = (gap[:, 0] * r[1] - gap[:, 1] * r[0]) / safe
    crossing = t[~flat & (t > 1e-6) & (t < 1 - 1e-6) & (u > -1e-6) & (u < 1 + 1e-6)]
    along = (np.concatenate([q, q + s]) - p) @ r / max(float(r @ r), 1e-12)
    ends = along[np.tile(flat, 2) & (along > 1e-6) & (along < 1 - 1e-6)]
    cuts: Floats = np.unique(np.concatenate([[0.0, 1.0], crossing, ends]).round(9))
    return cuts


def _seen(points: Floats, near: Floats, edge: tuple[int, int], t: float, faces: list[_FaceImage]) -> bool:
    """Is the point at parameter t of an edge in front of every face that covers it?"""
    a, b = edge
    p = points[a] + t * (points[b] - points[a])
    own = near[a] + t * (near[b] - near[a])
    limit = own + _IN_FRONT * float(np.ptp(near))
    covering = (f for f in faces if not (a in f.members and b in f.members))
    return not any(f.slope @ p + f.offset > limit and f.holds(p) for f in covering)
