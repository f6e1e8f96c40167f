"""Boxes: any of the three pairs of opposite sides can pass for f1 and f2.

A prism over a four-sided face whose sides may be parallel in space has three pairs of opposite faces, and each is a
valid f1 and f2. In an oblique drawing only one pair has its true shape, in a one-point drawing only one faces the
viewer, and in a two-point drawing one pair has its meeting point at infinity: so the lifting tries all three.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.lifting.face_relation import relate_faces
from sketch2shape.lifting.projection import CONVERGENCE, Drawing
from sketch2shape.lifting.regularity import between, log_odds
from sketch2shape.model import Floats, Ints

#: sides of a parallelogram may differ by this part of their length
_PARALLEL = 0.02

#: log odds by which other sides must look truer than f1 to be taken as the true ones
_SIDEWAYS = 1.0

#: a relation fits if its residual is within this many standard deviations of the noise
_FITS = 2.0

#: faces whose sizes differ by more than this are not equally far
_SMALLER = 0.05

#: edges drawn steeper than this, degrees, are upright
_PLUMB = 80.0


def simplest_pair(drawing: Drawing) -> tuple[Drawing, Ints | None]:
    """The pair of sides that are parallel in space, by the simplest relation between them; None for the pair as given.

    In a prism over a trapezoid or a wedge, two of the pairs are not parallel; in a frustum over a square only one is.
    """
    # a pair that is a mere guess must fit better than the one given
    slack = [max(_FITS * drawing.noise, part * CONVERGENCE * drawing.diagonal) for part in (1.0, 0.6, 0.6)]
    if drawing.sizes != [4] or drawing.relation.translation_rms <= slack[0]:
        return drawing, None
    pairs = drawing.pairs
    ranks = [_unlikely(pair, limit) for (pair, _), limit in zip(pairs, slack, strict=False)]
    return pairs[ranks.index(min(ranks))]


def _unlikely(drawing: Drawing, limit: float) -> int:
    """Rank of a pair: faces alike, faces similar, connecting lines that meet, none of these; limit in pixels."""
    r = drawing.relation
    if r.translation_rms <= limit:
        return 0
    if r.homothety_rms <= limit and r.scale > 0.0:
        return 1
    return 2 if r.centre_rms <= limit else 3


def is_box_like(drawing: Drawing) -> bool:
    """Is it a prism over a parallelogram, drawn without convergence?"""
    if drawing.sizes != [4]:
        return False
    p = drawing.first
    skew = np.hypot(*(p[0] - p[1] + p[2] - p[3]))
    size = np.hypot(*(p[1] - p[0])) + np.hypot(*(p[3] - p[0]))
    return bool(skew <= max(4.0 * drawing.noise, _PARALLEL * size))


def true_pair(drawing: Drawing) -> int:
    """Which of `Drawing.pairs` an oblique drawing would show in true shape.

    Of the three directions of edges the two drawn at right angles, best level and upright, span the true face; what
    recedes is drawn at 30, 45 or 60 degrees, never level or upright.
    """
    a, b, d = _directions(drawing)
    own, first, second = (_truth_odds(*uvw, drawing.noise) for uvw in ((a, b, d), (a, d, b), (b, d, a)))
    if max(first, second) <= own + _SIDEWAYS:
        return 0
    return 1 if first >= second else 2


def standing_pairs(drawing: Drawing) -> list[int]:
    """Which of `Drawing.pairs` an orthographic view may be about.

    Only matters for a prism that is no box. It rests on the ground, so what joins its faces is upright or level;
    drawn, a level edge is less steep than one that rises, hence the faces joined by the steepest edges are not meant.
    """
    a, b, d = _directions(drawing)
    rise = np.rad2deg([np.arctan2(abs(e[1]), abs(e[0])) for e in (d, a, b)])
    return [0] if rise[0] > _PLUMB or rise[0] < rise.max() else [1, 2]


def lean(face: Floats) -> float:
    """How far the corners of a (4, 2) true parallelogram are from right angles, degrees."""
    a, b = face[1] - face[0], face[3] - face[0]
    return float(np.rad2deg(np.arcsin(min(abs(a @ b) / max(float(np.hypot(*a) * np.hypot(*b)), 1e-12), 1.0))))


def _directions(drawing: Drawing) -> tuple[Floats, Floats, Floats]:
    """The two edges of the face and the connecting vector, pixels."""
    p = 0.5 * (drawing.first + drawing.second)
    return 0.5 * (p[1] - p[0] + p[2] - p[3]), 0.5 * (p[3] - p[0] + p[2] - p[1]), drawing.relation.d


def _truth_odds(u: Floats, v: Floats, back: Floats, noise: float) -> float:
    """Log odds that edges u and v span a face in true shape while the third recedes."""
    angle = np.arctan2([u[1], v[1], back[1]], [u[0], v[0], back[0]])
    spread = np.hypot(noise / np.hypot([u[0], v[0], back[0]], [u[1], v[1], back[1]]), np.deg2rad(0.3))
    square = log_odds(between(angle[:1], angle[1:2]) - np.pi / 2, np.hypot(*spread[:2])[None], 0.8, np.pi / 2)
    rise = between(angle, np.zeros(3))
    off = np.minimum(rise, np.pi / 2 - rise)
    level = log_odds(off[:2], np.hypot(spread[:2], np.deg2rad(1.0)), 0.6, np.pi / 4)
    usual = np.abs(rise[2] - np.deg2rad([30.0, 45.0, 60.0])).min(keepdims=True)
    receding = log_odds(usual, np.hypot(spread[2:], np.deg2rad(0.5)), 0.5, np.pi / 4)
    steep = 3.0 if off[2] < np.deg2rad(2.0) else 0.0
    return float(square[0] + level.sum() + receding[0] - steep)


def receding(pair: Drawing, d: Floats) -> tuple[Drawing, bool]:
    """The pair with the face in front that is nearer, d being the connecting vector of the old pair; was it swapped?

    The smaller one is farther. If they are alike: if f1 is known to be the visible cap the box recedes against d, as
    a face is only seen from outside; else it is seen from above, so what recedes rises.
    """
    back, scale = pair.relation.d, pair.relation.scale
    along = float(back @ d)
    if abs(scale - 1.0) > _SMALLER:
        away = scale < 1.0
    elif pair.hidden and abs(along) > 0.05 * np.hypot(*back) * np.hypot(*d):
        away = along < 0
    else:
        away = back[1] < 0 if abs(back[1]) > 1e-9 else back[0] > 0
    if away:
        return pair, False
    swapped = relate_faces(pair.second, pair.first, pair.known)
    return replace(pair, first=pair.second, second=pair.first, relation=swapped), True
