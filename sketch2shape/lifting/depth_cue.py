"""How well the depth of a guess at a prism goes with the edges of its face: cubes, square bars, boxes of two cubes."""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.lifting.regularity import BETWEEN, Candidates, Relations
from sketch2shape.model import Floats

#: how likely the depth was meant to be a simple multiple of an edge, and the range of the logarithm of their ratio if
#: it was not; boxes that people draw mostly have simple proportions, other profiles any depth
_SIMPLE, _RANGE = 0.3, 3.0

#: those multiples, and how often each is meant; a little off besides the noise (of the logarithm)
_TIMES: Floats = np.log([1.0, 2.0, 0.5])
_SHARES: Floats = np.array([0.6, 0.25, 0.15])
_SLOPPY = 0.01

#: a slant less than this tangent is not seen
_FLATTEST = 0.02


def depth_odds(
    relations: Relations, found: Candidates, slants: Floats, length: float, drawn: tuple[float, float]
) -> Floats:
    """(g,) log odds of the depths of guesses, against any depth at all.

    relations, found : what could be regular about the face, and its vectors in each guess
    slants           : (g,) of the face, radians; a right angle where it is not foreshortened
    length           : of the connecting vector as drawn, pixels
    drawn            : standard deviations of a vertex of the face, pixels, and of the connecting vector's direction
    """
    first = len(relations.weight)
    square = np.maximum(found.x[:, first:] ** 2 + found.y[:, first:] ** 2, 1e-24)
    if not square.shape[1]:
        return np.zeros(len(square))
    noise, wobble = drawn
    depth = np.log(length / np.sin(slants))
    # the next guess of a grid is this much less deep
    step = found.step / np.maximum(np.tan(slants), _FLATTEST) ** 2
    own = wobble**2 + (BETWEEN * step) ** 2 + _SLOPPY**2
    variance = 2.0 * (noise * found.stretch[:, None]) ** 2 / square + (BETWEEN * found.step[:, None]) ** 2
    sharp = 1.0 / np.sqrt(variance + own[:, None])
    off = (depth[:, None] - 0.5 * np.log(square)) * sharp
    density = np.zeros_like(off)
    for times, share in zip(_TIMES.tolist(), _SHARES.tolist(), strict=True):
        density += share * np.exp(-0.5 * (off - times * sharp) ** 2)
    mean = (density * sharp).mean(axis=1) / math.sqrt(2.0 * math.pi)
    return np.asarray(np.log(1.0 - _SIMPLE + _SIMPLE * _RANGE * mean))
