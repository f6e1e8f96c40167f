"""Which parts of a solid's edges its own faces hide in the drawing it was read from.

Each edge is cut where another edge crosses it in the drawing; a piece is hidden if, at its middle, some face lies in
front of it. Depths need no camera: in a parallel drawing depth is an affine function of the picture over each plane
face, in perspective its inverse is.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketch2shape.geometry import cross, inside, line_crossings
from sketch2shape.model import Bools, Floats, Ints, Ring, Solid

#: a face must lie this part of the object's depth in front of a point to hide it
_IN_FRONT = 1e-6

#: edges whose cross product is less than this part of the longer one's squared length are parallel
_PARALLEL = 1e-12

#: nearer to the end of an edge than this part of its length, and it is the end
_AT_END = 1e-6


class Run(NamedTuple):
    """A piece of an edge as it is drawn.

    start, stop : where it begins and ends, 0..1 along the edge
    visible     : is no face in front of it?
    """

    start: float
    stop: float
    visible: bool


def edge_runs(solid: Solid, points: Floats) -> list[list[Run]]:
    """For each edge of a solid without arcs the pieces it falls into where it passes in or out of sight, start to end.

    points : (k, 2) where each of `solid.vertices` lies in the drawing
    """
    near = nearness(points, solid.vertices, solid.projection.family)
    faces = _FaceImages(points, near, [solid.rings(face) for face in solid.faces])
    runs: list[list[Run]] = []
    for number in range(len(solid.edges)):
        cuts = _cuts(points, solid.edge_ends, number)
        seen = ~faces.hide(solid.edge_ends[number], 0.5 * (cuts[1:] + cuts[:-1]))
        starts = np.flatnonzero(np.append(True, seen[1:] != seen[:-1]))
        stops = np.append(starts[1:], len(seen))
        runs.append([Run(float(cuts[a]), float(cuts[b]), bool(seen[a])) for a, b in zip(starts, stops, strict=True)])
    return runs


class _FaceImages:
    """The faces in the drawing: their rings, and nearness over each as an affine function of the picture."""

    def __init__(self, points: Floats, near: Floats, faces: list[tuple[Ring, ...]]) -> None:
        self.points, self.near = points, near
        self.slack = _IN_FRONT * float(np.ptp(near))
        self.rings = [[points[list(ring)] for ring in rings] for rings in faces]
        self.members = np.zeros((len(faces), len(points)), bool)
        self.slopes, self.offsets = np.zeros((len(faces), 2)), np.zeros(len(faces))
        self.low, self.high = np.zeros((len(faces), 2)), np.zeros((len(faces), 2))
        for k, rings in enumerate(faces):
            every = [i for ring in rings for i in ring]
            middle = points[every].mean(axis=0)
            rows = np.c_[points[every] - middle, np.ones(len(every))]
            fit, *_ = np.linalg.lstsq(rows, near[every], rcond=1e-6)
            self.members[k, every] = True
            self.low[k], self.high[k] = points[every].min(axis=0), points[every].max(axis=0)
            self.slopes[k], self.offsets[k] = fit[:2], fit[2] - fit[:2] @ middle

    def hide(self, edge: Ints, t: Floats) -> Bools:
        """Is the edge's point at each of these parameters covered by a face in front of it?"""
        a, b = edge
        at = self.points[a] + t[:, None] * (self.points[b] - self.points[a])
        own = self.near[a] + t * (self.near[b] - self.near[a])
        front = at @ self.slopes.T + self.offsets > (own + self.slack)[:, None]
        front &= ~(self.members[:, a] & self.members[:, b])
        for axis in (0, 1):  # whatever lies outside a face's box it cannot hide
            front &= (self.low[:, axis] <= at[:, axis, None]) & (at[:, axis, None] <= self.high[:, axis])
        hidden = np.zeros(len(t), bool)
        for k in np.flatnonzero(front.any(axis=0)):
            behind = np.flatnonzero(front[:, k] & ~hidden)
            hidden[behind] = np.logical_xor.reduce([inside(at[behind], ring) for ring in self.rings[k]])
        return hidden


def nearness(points: Floats, vertices: Floats, family: str) -> Floats:
    """(k,) a number that grows towards the viewer and is affine in the picture over any plane.

    points   : (k, 2) where the vertices (k, 3) lie in the drawing
    family   : of the projection
    """
    v = vertices - vertices.mean(axis=0)
    v = v / (np.abs(v).max() or 1.0)
    if family == "perspective" and len(v) >= 6:
        depth = _perspective_depth(points, v)
        if depth is not None:
            near: Floats = 1.0 / depth / np.abs(1.0 / depth).max()
            return near
    map_to_picture, *_ = np.linalg.lstsq(np.c_[v, np.ones(len(v))], points, rcond=None)
    away = np.cross(map_to_picture[:3, 0], map_to_picture[:3, 1])
    along: Floats = -(v @ away) / (np.linalg.norm(away) or 1.0)
    return along


def _perspective_depth(points: Floats, v: Floats) -> Floats | None:
    """(k,) depth before the camera that sees the vertices so, by direct linear transformation; None if none does."""
    middle, size = points.mean(axis=0), float(np.abs(points - points.mean(axis=0)).max()) or 1.0
    xy = (points - middle) / size
    rows = np.c_[v, np.ones(len(v))]
    nothing = np.zeros_like(rows)
    system = np.concatenate([np.c_[rows, nothing, -xy[:, :1] * rows], np.c_[nothing, rows, -xy[:, 1:] * rows]])
    camera = np.linalg.svd(system)[2][-1].reshape(3, 4)
    depth: Floats = rows @ camera[2] * np.sign(np.linalg.det(camera[:, :3]) or 1.0)
    return depth if depth.min() > 1e-6 * np.abs(depth).max() else None


def _cuts(points: Floats, edges: Ints, number: int) -> Floats:
    """Sorted parameters 0..1 at which other edges cross or touch this one."""
    a, b = edges[number]
    p, r = points[a], points[b] - points[a]
    q, s = points[edges[:, 0]], points[edges[:, 1]] - points[edges[:, 0]]
    length2 = max(float(r @ r), 1e-12)
    flat = np.abs(cross(r, s)) < _PARALLEL * length2
    t, u = line_crossings(p, r, q, s)
    crossing = t[~flat & _within(t) & (u > -_AT_END) & (u < 1 + _AT_END)]
    to = np.concatenate([q, q + s]) - p
    along = to @ r / length2
    ends = along[np.tile(flat, 2) & _within(along) & (np.abs(cross(r, to)) < _AT_END * length2)]
    cuts: Floats = np.unique(np.concatenate([[0.0, 1.0], crossing, ends]).round(9))
    return cuts


def _within(t: Floats) -> Bools:
    """Which parameters lie on an edge, off its ends."""
    return np.asarray((t > _AT_END) & (t < 1 - _AT_END))
