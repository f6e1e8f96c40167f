"""How objects are usually shown: from somewhat above, upright on the paper, standing on a face or on an edge of it."""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.lifting.regularity import uneven_odds
from sketch2shape.model import Bools, Floats

#: slants at which a face is seen, radians: never quite from the front nor quite from its edge
SEEN_SLANTS: Floats = np.deg2rad(np.linspace(6.0, 84.0, 79))

#: how often an object stands on its face, and how far off its plumb edges are drawn besides the noise, radians
STANDING, _PLUMB = 0.3, math.radians(1.0)

#: a unit vector less far aside than this is drawn upright
_UPRIGHT = 0.1

#: usual elevation of the viewer above the ground, and its spread, degrees
_ELEVATION, _ELEVATION_SPREAD = 33.0, 14.0


def view_prior(slants: Floats, toward: Floats) -> Floats:
    """Log of how usual each slant of a face is whose connecting edges are drawn along the unit vector `toward`.

    Objects are shown from where their faces can be seen, rarely head-on, rarely edge-on; and, if d is not upright, from
    somewhat above or below: the vertical is not much foreshortened.
    """
    cosine = np.cos(slants)
    prior: Floats = uneven_odds(np.maximum(1.0 / cosine, 1.0 / np.sin(slants)))
    if is_upright(toward):
        elevation = 90.0 - np.rad2deg(slants)
    else:
        plumb = np.sqrt((toward[1] / cosine) ** 2 + toward[0] ** 2)
        elevation = np.rad2deg(np.arccos(np.minimum(1.0 / plumb, 1.0)))
    return prior - 0.5 * ((elevation - _ELEVATION) / _ELEVATION_SPREAD) ** 2


def usual_view(toward: Floats) -> float:
    """Log of the mean of the prior over all slants seen, which makes it a density against a uniform one."""
    return float(np.log(np.exp(view_prior(SEEN_SLANTS, toward)).mean()))


def is_upright(toward: Floats) -> bool:
    """Is the connecting vector, of length one, drawn vertical?"""
    return bool(abs(toward[0]) < _UPRIGHT)


def plumb_turn(toward: Floats) -> float:
    """The turn that makes the connecting vector plumb, radians."""
    off = math.atan2(toward[1], toward[0]) - 0.5 * math.pi
    return (0.5 * math.pi - off) % math.pi - 0.5 * math.pi


def plumb_density(off: float, wobble: float) -> float:
    """Density of what is drawn this far from plumb, radians, if it is meant to be; wobble: its standard deviation."""
    width = math.hypot(wobble, _PLUMB)
    return math.exp(-0.5 * (off / width) ** 2) / (width * math.sqrt(2.0 * math.pi))


def standing_odds(toward: Floats, wobble: float) -> float:
    """Log odds of the direction of the connecting edges: objects often stand on their face, these edges plumb."""
    return math.log(1.0 - STANDING + STANDING * math.pi * plumb_density(plumb_turn(toward), wobble))


def rests_on(ways: Floats, outer: Floats) -> Bools:
    """(k,) could the object stand on an edge of these (k, 2) directions: is one of them at the bottom of the ring?"""
    if not len(outer) or not len(ways):
        return np.zeros(len(ways), bool)
    down = np.where(ways[:, :1] > 0, 1.0, -1.0) * np.stack([-ways[:, 1], ways[:, 0]], axis=1)
    depth = outer @ down.T
    close = depth > depth.max(axis=0) - 0.02 * np.ptp(depth, axis=0)
    both = close & np.concatenate([close[-1:], close[:-1]])
    return np.asarray(both.any(axis=0))
