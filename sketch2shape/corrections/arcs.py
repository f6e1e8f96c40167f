"""Curved edges in a corrections file, in the report's words: which edge is an arc, and points along it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, cast

import numpy as np

from sketch2shape.errors import UsageError
from sketch2shape.model import DrawnArc, Ellipse, FacePair, Floats, Side

_ADVICE = 'arcs as a report has them: "face", "hole", "from", "to" and "points"'
_MOST_ARCS, _FEWEST_POINTS = 2000, 3

#: points along an arc that is given by fewer, and round a whole ellipse
_POINTS = 17


def arcs_from(
    data: Any, rings: Sequence[FacePair], points_from: Callable[[Any, str], Floats], where: str
) -> tuple[DrawnArc, ...]:
    """The arcs of an object; those of the back face that are not given are the front face's moved.

    data        : the JSON list
    rings       : the object's rings, the outer pair first
    points_from : reads points (n, 2), told what they are for its messages

    Raises UsageError for arcs of edges that are none.
    """
    if not isinstance(data, list | tuple) or len(data) > _MOST_ARCS:
        raise UsageError(f"{where}: arcs must be a list", remedy=_ADVICE)
    given = [_arc(entry, rings, points_from, f"{where}, arc {k + 1}") for k, entry in enumerate(data)]
    places = {(arc.face, arc.hole, arc.start) for arc in given}
    if len(places) < len(given):
        raise UsageError(f"{where}: an edge has two arcs", remedy=_ADVICE)
    pointed = len(rings[0].f2) == 1
    missing = [arc for arc in given if arc.face == "f1" and ("f2", arc.hole, arc.start) not in places]
    moved = [] if pointed else [_moved(arc, _ring(rings, arc.hole), where) for arc in missing]
    return (*given, *moved)


def needs_vertices(rings: Sequence[FacePair], arcs: Sequence[DrawnArc]) -> list[str]:
    """What is wrong with rings of few vertices, in words: one of two needs an arc, one of none a whole ellipse."""
    wrong: list[str] = []
    for number, pair in enumerate(rings):
        own = [arc for arc in arcs if arc.face == "f1" and (0 if arc.hole is None else arc.hole + 1) == number]
        n = len(pair.f1)
        if not (n >= 3 or (n == 2 and own) or (n == 0 and own and own[0].start is None)):
            wrong.append(f"a ring has {n} vertices and {len(own)} arcs")
    return wrong


def _arc(data: Any, rings: Sequence[FacePair], points_from: Callable[[Any, str], Floats], where: str) -> DrawnArc:
    if not isinstance(data, Mapping):
        raise UsageError(f"{where} must be a JSON object", remedy=_ADVICE)
    face, hole, start, end = (data.get(key) for key in ("face", "hole", "from", "to"))
    if face not in ("f1", "f2") or not (hole is None or (type(hole) is int and 0 <= hole < len(rings) - 1)):
        raise UsageError(f"{where} is of no ring", remedy=_ADVICE)
    pair = _ring(rings, hole)
    ring = pair.f1 if face == "f1" else pair.f2
    n = len(ring)
    points = points_from(data.get("points", []), f"{where}, points")
    if len(points) < _FEWEST_POINTS:
        raise UsageError(f"{where} has {len(points)} points; an arc needs {_FEWEST_POINTS}", remedy=_ADVICE)
    if start is None and end is None and n == 0:
        ellipse = _told(data.get("ellipse")) or _fitted(points, where)
        return DrawnArc(cast(Side, face), hole, None, None, ellipse, _round(ellipse))
    if type(start) is not int or not 0 <= start < n or end != (start + 1) % n:
        raise UsageError(f"{where}: no edge runs from vertex {start} to {end}", remedy=_ADVICE)
    points = _between(points, ring[start], ring[(start + 1) % n])
    return DrawnArc(cast(Side, face), hole, start, (start + 1) % n, _fitted(points, where), points)


def _ring(rings: Sequence[FacePair], hole: int | None) -> FacePair:
    return rings[0 if hole is None else hole + 1]


def _told(data: Any) -> Ellipse | None:
    """The ellipse of an entry, None if it has none that makes sense."""
    try:
        center, (a, b), angle = data["center"], data["axes"], float(data["angle"])
        numbers = [float(center[0]), float(center[1]), float(a), float(b), angle]
    except (TypeError, ValueError, KeyError, IndexError):
        return None
    if not all(map(math.isfinite, numbers)) or min(numbers[2:4]) <= 0.0:
        return None
    x, y, a, b, angle = numbers
    return Ellipse(np.array([x, y]), (max(a, b), min(a, b)), (angle if a >= b else angle + 90.0) % 180.0)


def _fitted(points: Floats, where: str) -> Ellipse:
    """The ellipse through points; of few, or of a nearly straight arc, a circle."""
    import cv2

    if len(points) >= 5:
        (x, y), (wide, high), angle = cv2.fitEllipseDirect(points.astype(np.float32))
        a, b = 0.5 * max(wide, high), 0.5 * min(wide, high)
        if math.isfinite(x + y + a + b) and b > 0.0:
            return Ellipse(np.array([x, y]), (a, b), float(angle if wide >= high else angle + 90.0) % 180.0)
    middle = points.mean(axis=0)
    u, v = (points - middle).T
    (p, q, r), *_ = np.linalg.lstsq(np.c_[2 * u, 2 * v, np.ones_like(u)], u**2 + v**2, rcond=None)
    radius = math.sqrt(max(float(r + p * p + q * q), 0.0))
    if not 0.0 < radius < 1e7:
        raise UsageError(f"{where}: its points lie on no arc", remedy=_ADVICE)
    return Ellipse(middle + [p, q], (radius, radius), 0.0)


def _round(ellipse: Ellipse) -> Floats:
    """(k, 2) points round an ellipse."""
    turn, lean = np.linspace(0.0, 2.0 * np.pi, 4 * _POINTS, endpoint=False), math.radians(ellipse.angle)
    axes = np.array([[math.cos(lean), math.sin(lean)], [-math.sin(lean), math.cos(lean)]])
    a, b = ellipse.axes
    return np.asarray(ellipse.center + np.c_[a * np.cos(turn), b * np.sin(turn)] @ axes)


def _between(points: Floats, start: Floats, end: Floats) -> Floats:
    """Points along an arc, turned and scaled so that they run from one vertex to the other, wherever these now are."""
    before, after = points[-1] - points[0], end - start
    size = float(before @ before)
    if size <= 0.0:
        return points
    along = float(before @ after) / size
    aside = float(before[0] * after[1] - before[1] * after[0]) / size
    moved = (points - points[0]) @ np.array([[along, aside], [-aside, along]]) + start
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(moved, axis=0).T))])
    places = np.linspace(0.0, at[-1], max(_POINTS, len(points)))
    x, y = (np.interp(places, at, c) for c in moved.T) if len(points) < _POINTS else moved.T
    return np.stack([x, y], axis=1)


def _moved(arc: DrawnArc, pair: FacePair, where: str) -> DrawnArc:
    """The arc of the back face that belongs to one of the front face."""
    if arc.start is None or arc.end is None:
        raise UsageError(f"{where}: the back face lacks its whole ellipse", remedy='one arc for "f1" and one for "f2"')
    points = _between(arc.points, pair.f2[arc.start], pair.f2[arc.end])
    return DrawnArc("f2", arc.hole, arc.start, arc.end, _fitted(points, where), points)
