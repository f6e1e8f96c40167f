"""Pyramids that stand in an oblique drawing, as textbooks have them: the height plumb, an edge of the base level.

The plane that is drawn in its true shape is then the upright one through that edge; the base recedes. It is a
rectangle as wide as its level edge is drawn, and as deep as the receding one over the drawing's ratio. The point mostly
stands over the middle of the base; in exercises of geometry also over a corner, or over the middle of an edge.
"""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.lifting.parallel import along_a_vector
from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats

#: how far an edge drawn level, or a height drawn plumb, may be off at most, radians; less where the height does not
#: stand on the middle of the base, and the log odds against that
_OFF, _ASIDE, _RARE = math.radians(6.0), math.radians(2.5), -1.0

#: least slope of a receding edge, and of the plumb against it: between, it is drawn aslant, radians
_ASLANT = math.radians(10.0)

#: how likely a pyramid over four sides that stands has an edge drawn level because it is drawn so
_DRAWN_SO = 0.3

#: how well a hand keeps a line level, radians
_SLOPPY = math.radians(0.7)


def standing_odds(face: Floats, d: Floats, noise: float) -> tuple[float, int] | None:
    """Log odds of a pyramid over a parallelogram (4, 2) being drawn so, and which edge (0 or 1) is the level one.

    d : (2,) from the middle of the base to the point

    None if it cannot be: no edge is level, no height is plumb, or the base does not recede aslant.
    """
    foot = _foot(face, face.mean(axis=0) + d)
    if foot is None:
        return None
    edges = face[1] - face[0], face[2] - face[1]
    rise = [math.atan2(abs(float(e[1])), abs(float(e[0]))) for e in edges]
    level = int(np.argmin(rise))
    if rise[level] > _OFF or not _ASLANT < rise[1 - level] < 0.5 * math.pi - _ASLANT:
        return None
    width = math.hypot(_SLOPPY, noise / max(float(np.hypot(*edges[level])), 1e-9))
    density = math.exp(-0.5 * (rise[level] / width) ** 2) / (width * math.sqrt(2.0 * math.pi))
    return math.log(1e-6 + _DRAWN_SO * 0.5 * math.pi * density) + (_RARE if foot.any() else 0.0), level


def _foot(face: Floats, apex: Floats) -> Floats | None:
    """(4,) weights of the vertices that give what the point stands over; all 0 for the middle, None for nothing."""
    corners = np.eye(4)
    aside = np.concatenate([corners, 0.5 * (corners + np.roll(corners, 1, axis=0))])
    if _lean(apex - face.mean(axis=0)) <= _OFF:
        return np.zeros(4)
    leans = [_lean(apex - weights @ face) for weights in aside]
    best = int(np.argmin(leans))
    return np.asarray(aside[best]) if leans[best] <= _ASIDE else None


def _lean(height: Floats) -> float:
    """How far a height (2,) is drawn from the plumb, radians."""
    return math.atan2(abs(float(height[0])), abs(float(height[1])))


def standing_shape(face: Floats, d: Floats, level: int, ratio: float, *, free: bool) -> Shape:
    """The pyramid drawn so; free: is the ratio of drawn to true receding lengths only assumed?"""
    edges = face[1] - face[0], face[2] - face[1]
    back = edges[1 - level]
    away = back * (-1.0 if back[1] > 0 else 1.0) / float(np.hypot(*back))
    to_drawing = np.array([[1.0, 0.0], ratio * away])
    inverse = np.linalg.inv(to_drawing)
    middle = face.mean(axis=0)
    flat = (face - middle) @ inverse
    # with its sides exactly square: level is along the first axis, receding along the second
    half = 0.5 * np.array([abs(edges[level] @ inverse)[0], abs(back @ inverse)[1]])
    flat = np.sign(flat) * half
    foot = _foot(face, middle + d)
    weights = np.zeros(4) if foot is None else foot
    rise = float(d[1]) - float((weights @ (face - middle))[1])
    pose = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0 if rise < 0 else 1.0, 0.0]])
    evidence = {"depth_ratio": ratio, "receding_deg": round(math.degrees(math.atan2(-away[1], away[0])), 2)}
    return Shape(
        "oblique",
        flat,
        pose,
        np.array([*middle, 0.0]),
        abs(rise),
        along_a_vector(ratio * away),
        inverse,
        [4],
        free=free,
        free_axis=1,
        tip=weights @ flat,
        evidence=evidence,
    )
