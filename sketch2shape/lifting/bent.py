"""Faces with arcs made ready for lifting: points along the arcs beside the vertices, and which of them belong to what.

Most of what lifting asks of a face it asks of points and of straight edges. An arc adds points along it, the same ones
on both faces; that they lie on a circle in the true face is evidence of its own (`roundness`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.lifting.face_relation import relate_faces
from sketch2shape.model import DrawnArc, Ellipse, Floats, Ints, Side, TwoFaceObject

#: points taken inside an arc, and on a whole ellipse (opposite ones in pairs)
_INNER, _ROUND = 5, 16

#: part of the drawing's size by which the points of arcs miss those of the other face, moved and scaled, where they
#: are drawn in perspective, and the part of that by which the lines between both then miss their meeting point at most
_UNLIKE, _MEETING = 0.004, 0.25


@dataclass(frozen=True)
class BentArc:
    """A curved edge of a face.

    ring  : number of its ring, the outer one 0
    start : vertex of the ring that it starts at; None for a whole circle
    rows  : points of the face along it, in order, with both vertices where it has them
    """

    ring: int
    start: int | None
    rows: Ints


@dataclass(frozen=True)
class Bent:
    """How the points of a face with arcs belong together.

    vertices : how many of its points are vertices; these come first
    ends     : (e, 2) the two vertices of each straight edge
    arcs     : the curved edges
    spans    : (s, 2) points of arcs whose distances say how large these are
    outline  : points round the outer ring, in order
    middle   : (m,) weights that take the centroid of the outer ring from the points, in any affine view
    in_perspective : whether the arcs of the back face are no moved and scaled ones of the front face
    """

    vertices: int
    ends: Ints
    arcs: tuple[BentArc, ...]
    spans: Ints
    outline: Ints
    middle: Floats
    in_perspective: bool = False

    def lengths(self, points: Floats) -> Floats:
        """(e + s,) lengths of the straight edges, then of the spans."""
        pairs = np.concatenate([self.ends, self.spans])
        return np.asarray(np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1))


def bent_faces(obj: TwoFaceObject) -> tuple[Floats, Floats, Bent]:
    """(m, 2) points of the front face and of the back face, pixels, and how they belong together.

    Of an object that comes to a point the second are the points of the front face all at the apex.
    """
    pieces: dict[Side, list[Floats]] = {"f1": [p.f1 for p in obj.rings], "f2": [p.f2 for p in obj.rings]}
    if obj.is_pointed:
        pieces["f2"] = [np.repeat(obj.f2, len(obj.f1), axis=0)]
    count = vertices = sum(len(pair.f1) for pair in obj.rings)
    leans = not obj.is_pointed and _is_in_perspective(obj)
    arcs: list[BentArc] = []
    spans: list[tuple[int, int]] = []
    first = 0
    for ring, pair in enumerate(obj.rings):
        n = len(pair.f1)
        for arc in obj.arcs:
            if arc.face != "f1" or (0 if arc.hole is None else arc.hole + 1) != ring:
                continue
            near = _in_turn(arc) if leans else _points(arc)
            pieces["f1"].append(near)
            pieces["f2"].append(_partner(obj, arc, near, in_turn=leans))
            inner = np.arange(count, count + len(near))
            count += len(near)
            if arc.start is None:
                arcs.append(BentArc(ring, None, inner))
                spans += [(int(inner[k]), int(inner[k + _ROUND // 2])) for k in range(0, _ROUND // 2, 2)]
            else:
                a, b = first + arc.start, first + (arc.start + 1) % n
                rows = np.array([a, *inner, b], np.intp)
                arcs.append(BentArc(ring, arc.start, rows))
                spans += [(a, b), (int(inner[_INNER // 2]), a), (int(inner[_INNER // 2]), b)]
        first += n
    near, far = np.concatenate(pieces["f1"]), np.concatenate(pieces["f2"])
    bent_at = {(arc.ring, arc.start) for arc in arcs}
    ends = [
        (start + k, start + (k + 1) % n)
        for ring, (start, n) in enumerate(_starts(obj))
        for k in range(n)
        if (ring, k) not in bent_at
    ]
    outline = _outline(len(obj.f1), arcs)
    middle = _centroid_weights(near, outline)
    pairs = (np.array(p, np.intp).reshape(-1, 2) for p in (ends, spans))
    return near, far, Bent(vertices, next(pairs), tuple(arcs), next(pairs), outline, middle, leans)


def _starts(obj: TwoFaceObject) -> list[tuple[int, int]]:
    """First vertex of each ring, and how many it has."""
    sizes = [len(pair.f1) for pair in obj.rings]
    return list(zip(np.cumsum([0, *sizes[:-1]]).tolist(), sizes, strict=True))


def _points(arc: DrawnArc) -> Floats:
    """(k, 2) points of an arc that are the same ones in each of its parallel images."""
    if arc.start is None:
        return _supports(arc.ellipse)
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(arc.points, axis=0).T))])
    places = at[-1] * np.arange(1, _INNER + 1) / (_INNER + 1)
    return np.stack([np.interp(places, at, arc.points[:, 0]), np.interp(places, at, arc.points[:, 1])], axis=1)


def _supports(ellipse: Ellipse) -> Floats:
    """(16, 2) points of an ellipse where its tangents have fixed directions: those of its images are theirs."""
    turn = 2.0 * np.pi * np.arange(_ROUND) / _ROUND
    out = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    lean = np.radians(ellipse.angle)
    axes = np.array([[np.cos(lean), np.sin(lean)], [-np.sin(lean), np.cos(lean)]])
    square = axes.T @ np.diag(np.square(ellipse.axes)) @ axes
    reach = out @ square
    return np.asarray(ellipse.center + reach / np.sqrt((reach * out).sum(axis=1, keepdims=True)))


def _in_turn(arc: DrawnArc) -> Floats:
    """(k, 2) as many points of an arc, in the order in which both faces have them."""
    parts = np.arange(_ROUND) / _ROUND if arc.start is None else np.arange(1, _INNER + 1) / (_INNER + 1)
    last = len(arc.points) - (arc.start is not None)
    return np.asarray(arc.points[np.rint(parts * last).astype(np.intp)])


def _is_in_perspective(obj: TwoFaceObject) -> bool:
    """Whether the points of arcs lead to those of the other face by lines that meet, and by no shift and scale."""
    pairs = [(arc, other) for arc in obj.arcs if arc.face == "f1" and (other := _other(obj, arc)) is not None]
    if not pairs or any(len(arc.points) != len(other.points) or not len(arc.points) for arc, other in pairs):
        return False
    rings = [(pair.f1, pair.f2) for pair in obj.rings]
    near, far = (np.concatenate(p) for p in zip(*rings, *((_in_turn(a), _in_turn(b)) for a, b in pairs), strict=True))
    relation = relate_faces(near, far)
    size = float(np.linalg.norm(np.ptp(np.concatenate([near, far]), axis=0)))
    return relation.homothety_rms > _UNLIKE * size and relation.centre_rms < _MEETING * relation.homothety_rms


def _other(obj: TwoFaceObject, arc: DrawnArc) -> DrawnArc | None:
    """The same arc of the back face."""
    place = ("f2", arc.hole, arc.start)
    return next((other for other in obj.arcs if (other.face, other.hole, other.start) == place), None)


def _partner(obj: TwoFaceObject, arc: DrawnArc, near: Floats, *, in_turn: bool) -> Floats:
    """The points of the back face that belong to those (k, 2) of an arc of the front face."""
    if obj.is_pointed:
        return np.repeat(obj.f2, len(near), axis=0)
    other = _other(obj, arc)
    if other is not None:
        return _in_turn(other) if in_turn else _points(other)
    pair = obj.rings[0 if arc.hole is None else arc.hole + 1]
    return near + (pair.f2 - pair.f1).mean(axis=0) if len(pair.f1) else near


def _outline(n: int, arcs: list[BentArc]) -> Ints:
    """Points round the outer ring of n vertices."""
    own = {arc.start: arc.rows for arc in arcs if arc.ring == 0}
    if None in own:
        return own[None]
    rows = [own[k][:-1] if k in own else np.array([k], np.intp) for k in range(n)]
    return np.concatenate(rows)


def _centroid_weights(points: Floats, outline: Ints) -> Floats:
    """(m,) the smallest weights of sum 1 that give the centroid of the outline, and so in every affine image."""
    ring = points[outline]
    after = np.roll(ring, -1, axis=0)
    middle = ring.mean(axis=0)
    (x, y), (u, v) = (ring - middle).T, (after - middle).T
    turns = x * v - u * y
    centroid = middle + np.array([((x + u) * turns).sum(), ((y + v) * turns).sum()]) / (3.0 * (turns.sum() or 1.0))
    rows = np.c_[ring - middle, np.ones(len(ring))].T
    weights = np.zeros(len(points))
    weights[outline] = np.linalg.lstsq(rows, np.append(centroid - middle, 1.0), rcond=None)[0]
    return weights
