"""How round the arcs of a face are in each guess at its true shape.

A guess stretches the drawn face along the connecting vector d. In the true shape the points of an arc lie on a circle;
how far they miss the best one, in pixels of the drawing, is evidence for or against the guess. The circle is fitted
algebraically (Kasa), the distances from it to first order (Sampson).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Floats

#: independent places along an arc: its points are those of a smooth curve, so more of them say no more
_PLACES = 8.0

#: the told noise counts as much as this many residuals, as in `evidence`
_WEIGHT = 4.0

#: least standard deviation of a point on an arc, pixels: what fitting an ellipse to ink leaves
_LEAST = 0.5


@dataclass(frozen=True)
class Arcs:
    """Arcs as drawn, by components along and across the connecting vector.

    along, across : (k,) of the points of each arc, pixels
    noise         : standard deviation of a point, pixels
    """

    along: tuple[Floats, ...]
    across: tuple[Floats, ...]
    noise: float


def arcs_of(points: Sequence[Floats], toward: Floats, noise: float) -> Arcs:
    """The arcs through these points (k, 2) each; toward: (2,) unit vector of d."""
    aside = np.array([-toward[1], toward[0]])
    return Arcs(tuple(p @ toward for p in points), tuple(p @ aside for p in points), max(noise, _LEAST))


def roundness_odds(arcs: Arcs, stretches: Floats, swung: tuple[Floats, Floats]) -> Floats:
    """(g,) log odds of the arcs being those of circles, against points that fit exactly.

    stretches : (g, 1) stretch along the direction of d of each guess
    swung     : (g, 1) cosine and sine of the turn of that direction
    """
    (c, s), total = swung, np.zeros(len(stretches))
    for u, v in zip(arcs.along, arcs.across, strict=True):
        u, v = u - u.mean(), v - v.mean()
        x, y = stretches * (c * u + s * v), c * v - s * u
        off = _off_circle(x, y, stretches)
        places = min(_PLACES, float(len(u)))
        square = (off**2).mean(axis=1) * places
        total -= 0.5 * (_WEIGHT + places) * np.log1p(square / (_WEIGHT * arcs.noise**2))
    return total


def circle_odds(shapes: Floats, drawn: Floats, noise: float) -> Floats:
    """(g,) log odds of an arc being that of a circle in each guess at its true shape, against points that fit exactly.

    shapes : (g, k, 2) its points in each guess
    drawn  : (k, 2) the same as drawn, pixels
    noise  : standard deviation of a point, pixels
    """
    places = min(_PLACES, float(len(drawn)))
    x, y = (shapes - shapes.mean(axis=1, keepdims=True)).transpose(2, 0, 1)
    off = _off_circle(x, y, np.ones((len(shapes), 1)))
    true = np.maximum((x**2 + y**2).mean(axis=1), 1e-18)
    square = (off**2).mean(axis=1) / true * float(((drawn - drawn.mean(axis=0)) ** 2).sum(axis=1).mean()) * places
    return np.asarray(-0.5 * (_WEIGHT + places) * np.log1p(square / (_WEIGHT * max(noise, _LEAST) ** 2)))


def _off_circle(x: Floats, y: Floats, stretch: Floats) -> Floats:
    """(g, k) how far the points are off the best circle of each guess, pixels of the drawing."""
    square = x**2 + y**2
    rows = np.stack([x, y, np.ones_like(x)], axis=2)
    normal = rows.transpose(0, 2, 1) @ rows
    size = square.mean(axis=1)[:, None, None]
    normal = normal + 1e-12 * size * np.eye(3)
    best = np.linalg.solve(normal, (rows * square[..., None]).sum(axis=1)[..., None])[..., 0]
    left = square - (rows @ best[..., None])[..., 0]
    slope = np.hypot(stretch * (2.0 * x - best[:, :1]), 2.0 * y - best[:, 1:2])
    return np.asarray(left / np.maximum(slope, 1e-9))
