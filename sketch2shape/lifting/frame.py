"""The object's own axes, and turning it upright into them."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from sketch2shape.model import Floats

#: edges this close to each other, or to a right angle, run along the same axes, radians
_ALIGNED = np.deg2rad(3.0)

#: part of the edges' squared length that must run along the axes
_SHARE = 0.3

#: directions with this part of the best one's squared length are as good: a right triangle's legs and its longest side
_TIE = 0.9


def own_axes(edges: Floats, through: Floats) -> Floats:
    """(3, 3) unit rows: width and height in the face, and the normal from the front to the back face.

    Width and height follow the face's edges: the pair of perpendicular directions along which most length lies, width
    being the one seen more level. Right-handed like the viewer's axes (right, down, away).

    edges   : (e, 3) straight edges of the front face
    through : (3,) from the front face to the back face
    """
    normal = _unit(through, np.array([0.0, 0.0, 1.0]))
    aside = np.array([0.0, 0.0, -np.sign(normal[0]) or 1.0])  # level too, for a face that looks to the side
    level = _unit(np.array([1.0, 0.0, 0.0]) - normal[0] * normal, aside)
    across = _cross(normal, level)
    lean = _lean(edges @ np.array([level, across]).T) if len(edges) else 0.0
    width = math.cos(lean) * level + math.sin(lean) * across
    return np.array([width, _cross(normal, width), normal])


def _lean(edges: Floats) -> float:
    """Angle of the direction, between -45 and 45 degrees, that most of the edges (m, 2) run along or across, radians.

    Squared lengths count, as a long edge says more than many short ones; of directions that are as good the most level;
    0 if no direction has its share.
    """
    x, y = edges.T
    weight, angle = x * x + y * y, np.arctan2(y, x)
    off = (angle[:, None] - angle + np.pi / 4) % (np.pi / 2) - np.pi / 4
    near = np.abs(off) < _ALIGNED
    support = near @ weight
    if support.max() <= _SHARE * float(weight.sum()):
        return 0.0
    good = support >= _TIE * support.max()
    own = (weight[:, None] * near)[:, good]
    means = angle[good] + (own * off[:, good]).sum(axis=0) / own.sum(axis=0)
    leans = (means + np.pi / 4) % (np.pi / 2) - np.pi / 4
    return float(leans[np.abs(leans).argmin()])


def standing(axes: Floats) -> Floats:
    """(3, 3) unit rows: right, up and away of an object with these own axes, set upright; in the viewer's axes.

    The own axis that is seen most nearly vertical is upright, the one seen most nearly along the line of sight leads
    away.
    """
    down = axes[np.abs(axes[:, 1]).argmax()]
    down = down * np.sign(down[1])
    away = max((a for a in axes if abs(a @ down) < 0.5), key=lambda a: abs(a[2]))
    away = away * (np.sign(away[2]) or 1.0)
    return np.array([_cross(down, away), -down, away])


def frame(looks: Floats, up: Literal["z", "y", "camera"]) -> Floats:
    """(3, 3) unit rows: the axes of the frame asked for; looks as from `standing`."""
    right, high, away = looks
    if up == "camera":
        return np.eye(3)
    return np.array([right, away, high] if up == "z" else [right, high, -away])


def _cross(a: Floats, b: Floats) -> Floats:
    """np.cross of two vectors, without what it spends on arrays of them."""
    (x, y, z), (u, v, w) = a.tolist(), b.tolist()
    return np.array([y * w - z * v, z * u - x * w, x * v - y * u])


def _unit(vector: Floats, default: Floats) -> Floats:
    size = math.hypot(*vector.tolist())
    return vector / size if size > 1e-12 else default
