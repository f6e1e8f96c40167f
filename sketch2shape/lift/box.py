"""Boxes: any of the three pairs of opposite sides can pass for f1 and f2.

A prism over a four-sided face whose sides may be parallel in space has three pairs of opposite faces, and each is a
valid f1 and f2. In an oblique drawing only one pair has its true shape, in a one-point drawing only one faces the
viewer, and in a two-point drawing one pair has its meeting point at infinity: so the lifting tries all three.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.lift.homology import relate_faces
from sketch2shape.lift.projection import Drawing
from sketch2shape.lift.regularity import between, log_odds
from sketch2shape.model import Floats, Ints

#: sides of a parallelogram may differ by this part of their length
_PARALLEL = 0.02

#: log odds by which other sides must look truer than f1 to be taken as the true ones
_SIDEWAYS = 1.0

#: the vertices, numbered f1 then f2, of the other two pairs
_PAIRS = (
    np.array([0, 1, 5, 4, 3, 2, 6, 7]),
    np.array([1, 2, 6, 5, 0, 3, 7, 4]),
)


def other_pairs(drawing: Drawing) -> list[tuple[Drawing, Ints]]:
    """The drawing with each of the other two pairs of opposite sides as f1 and f2, and its vertices in the old numbers.

    Empty unless the face has four sides, no hole and no inferred vertex that counts.
    """
    if drawing.sizes != [4]:
        return []
    points = np.concatenate([drawing.first, drawing.second])
    seen = np.concatenate([np.ones(4, bool), drawing.known])
    found = []
    for order in _PAIRS:
        first, second = points[order[:4]], points[order[4:]]
        known = seen[order[:4]] & seen[order[4:]]
        pair = replace(drawing, first=first, second=second, relation=relate_faces(first, second, known), known=known)
        found.append((pair, order))
    return found


def true_pair(drawing: Drawing) -> tuple[Drawing, Ints | None]:
    """The pair of sides that an oblique drawing would show in true shape, and its numbers; None for the pair as given.

    Of a box's three directions of edges, the two drawn at right angles, best level and upright, span the true face.
    Only an object whose face is a parallelogram has other pairs.
    """
    first, noise = drawing.first, drawing.noise
    if drawing.sizes != [4]:
        return drawing, None
    a, b = first[1] - first[0], first[3] - first[0]
    skew = np.hypot(*(first[0] - first[1] + first[2] - first[3]))
    if skew > max(4.0 * noise, _PARALLEL * (np.hypot(*a) + np.hypot(*b))):
        return drawing, None
    a, b, d = a + 0.5 * (first[2] - first[3] - a), b + 0.5 * (first[2] - first[1] - b), drawing.relation.d
    own, *sides = (_square_odds(u, v, noise) for u, v in ((a, b), (a, d), (b, d)))
    best = int(np.argmax(sides))
    if sides[best] < max(own + _SIDEWAYS, 0.0):
        return drawing, None
    return other_pairs(drawing)[best]


def _square_odds(u: Floats, v: Floats, noise: float) -> float:
    """Log odds that two drawn edges span a face in true shape: at right angles, level or upright."""
    angle = np.arctan2([u[1], v[1]], [u[0], v[0]])
    spread = np.hypot(noise / np.hypot([u[0], v[0]], [u[1], v[1]]), np.deg2rad(0.3))
    square = log_odds(between(angle[:1], angle[1:]) - np.pi / 2, np.hypot(*spread)[None], 0.8, np.pi / 2)
    off = np.minimum(between(angle, np.zeros(2)), between(angle, np.full(2, np.pi / 2)))
    level = log_odds(off, np.hypot(spread, np.deg2rad(1.0)), 0.6, np.pi / 4)
    return float(square[0] + level.sum())


def receding(pair: Drawing, d: Floats) -> tuple[Drawing, bool]:
    """The pair with the face in front that is nearer, d being the connecting vector of the old pair; was it swapped?

    If f1 is known to be the visible cap the box recedes against d, as a face is only seen from outside; else it is
    seen from above, so what recedes rises.
    """
    back = pair.relation.d
    along = float(back @ d)
    if pair.hidden and abs(along) > 0.05 * np.hypot(*back) * np.hypot(*d):
        away = along < 0
    else:
        away = back[1] < 0 if abs(back[1]) > 1e-9 else back[0] > 0
    if away:
        return pair, False
    swapped = relate_faces(pair.second, pair.first, pair.known)
    return replace(pair, first=pair.second, second=pair.first, relation=swapped), True
