"""How near the base of a pyramid is to a regular polygon in each guess at its true shape.

Pyramids that people draw mostly stand on a square or another regular polygon. A triangle has too few edges for what
`regularity` counts, and a square's equal sides count little there, so a base's being regular as a whole is evidence.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Floats

#: how likely the base of a pyramid is regular
_REGULAR = 0.6

#: how far the vertices of any base are from those of the nearest regular one, as a part of the base's size
_SPREAD = 0.2


@dataclass(frozen=True)
class Base:
    """A base as drawn, by components along and across the connecting vector.

    along, across : (n,) of its vertices, pixels
    noise         : standard deviation of a vertex, pixels
    """

    along: Floats
    across: Floats
    noise: float


def base_of(ring: Floats, toward: Floats, noise: float) -> Base:
    """The base with these vertices (n, 2); toward: (2,) unit vector of d."""
    return Base(ring @ toward, ring @ np.array([-toward[1], toward[0]]), noise)


def with_regular_base(odds: Floats, base: Base, stretches: Floats, swung: tuple[Floats, Floats]) -> Floats:
    """(g,) log odds of each guess, these where the base is any, and more where it is regular.

    stretches : (g, 1) stretch along the direction of d of each guess
    swung     : (g, 1) cosine and sine of the turn of that direction
    """
    c, s = swung
    u, v = base.along - base.along.mean(), base.across - base.across.mean()
    x, y = stretches * (c * u + s * v), c * v - s * u
    n = len(u)
    turns = np.exp(2j * np.pi * np.arange(n) / n)
    shape = x + 1j * y
    sizes = np.stack([shape @ turns.conj(), shape @ turns], axis=1) / n
    ways = np.abs(sizes).argmax(axis=1)
    best = sizes[np.arange(len(sizes)), ways][:, None] * np.where(ways[:, None] == 0, turns, turns.conj())
    off = shape - best
    square = ((off.real / stretches) ** 2 + off.imag**2).sum(axis=1) / base.noise**2
    free = 2 * n - 4
    wide = max(_SPREAD * float(np.hypot(np.ptp(u), np.ptp(v))) / base.noise, 1.0)
    regular = math.log(_REGULAR) + free * math.log(wide) - 0.5 * square
    return np.asarray(np.logaddexp(math.log(1.0 - _REGULAR) + odds, regular))
