"""Boxes: any of the three pairs of opposite sides can pass for f1 and f2.

A prism over a four-sided face whose sides may be parallel in space has three pairs of opposite faces, and each is a
valid f1 and f2. In an oblique drawing only one pair has its true shape, in a one-point drawing only one faces the
viewer, and in a two-point drawing one pair has its meeting point at infinity: so all three are read (`decision`).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.lifting.face_relation import relate_faces
from sketch2shape.lifting.projection import Drawing
from sketch2shape.lifting.usual_views import SEEN_SLANTS
from sketch2shape.model import Floats

#: faces whose sizes differ by more than this are not equally far
_SMALLER = 0.05

#: a side of a box that is seen from nearer its edge, degrees, does not tell how the box is held
_EDGEWISE = float(np.rad2deg(SEEN_SLANTS[-1]))

#: edges drawn steeper than this, degrees, are upright
_PLUMB = 80.0


def standing_pairs(drawing: Drawing) -> list[int]:
    """Which of `Drawing.pairs` an orthographic view may be about.

    Only matters for a prism that is no box. It rests on the ground, so what joins its faces is upright or level;
    drawn, a level edge is less steep than one that rises, hence the faces joined by the steepest edges are not meant.
    Of a box whose sides are seen from their edge by that, any pair may be meant.
    """
    a, b, d = _directions(drawing)
    joined = ((d, a, b), (b, a, d), (a, b, d))  # each pair: along what its sides are joined, and their own edges
    rise = [_rise(way) for way, _, _ in joined]
    usual = [0] if rise[0] > _PLUMB or rise[0] < max(rise) else [1, 2]
    return [0, 1, 2] if any(_box_slant(*joined[k]) > _EDGEWISE for k in usual) else usual


def _rise(way: Floats) -> float:
    """How steep a (2,) direction is drawn, degrees."""
    return float(np.rad2deg(np.arctan2(abs(way[1]), abs(way[0]))))


def _box_slant(d: Floats, a: Floats, b: Floats) -> float:
    """Slant of a box's side with edges along a and b, joined to the opposite one along d, degrees; 0 if it is none."""
    along, across = float((a @ d) * (b @ d)), float((d[0] * a[1] - d[1] * a[0]) * (d[0] * b[1] - d[1] * b[0]))
    square = -along / across if across else 0.0
    return float(np.rad2deg(np.arccos(np.sqrt(square)))) if 0.0 < square < 1.0 else 0.0


def lean(face: Floats) -> float:
    """How far the corners of a (4, 2) true parallelogram are from right angles, degrees."""
    a, b = face[1] - face[0], face[3] - face[0]
    return float(np.rad2deg(np.arcsin(min(abs(a @ b) / max(float(np.hypot(*a) * np.hypot(*b)), 1e-12), 1.0))))


def _directions(drawing: Drawing) -> tuple[Floats, Floats, Floats]:
    """The two edges of the face and the connecting vector, pixels."""
    p = 0.5 * (drawing.first + drawing.second)
    return 0.5 * (p[1] - p[0] + p[2] - p[3]), 0.5 * (p[3] - p[0] + p[2] - p[1]), drawing.relation.d


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
