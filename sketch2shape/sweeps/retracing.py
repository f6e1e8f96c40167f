"""Retracing: a closed line of a wireframe put on the ink of both faces.

Where other lines meet or cross it, a closed line that is followed over pixels has notches. Both faces tell where it
runs: along its normals, at the place where there is ink here and, moved, on the back face.
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from sketch2shape.model import Floats
from sketch2shape.strokes import Skeleton, interpolated
from sketch2shape.sweeps.sweep import Way

SMOOTHED = 13
"""Pixels of a line over which it is averaged for its normals: more than a notch is wide."""
FARTHEST, STEP = 6.0, 0.5
"""Pixels along a normal up to which ink is looked for, and from one look to the next."""
ON_INK = 1.5
"""Pixels to the ink of both faces up to which a place is on the line."""
PULL = 0.15
"""How far from ink counts as much as a pixel away from the line as followed, pixels."""
STEADY = 9
"""Pixels of a line over which the median of the places is taken: strays are shorter."""


def retraced(line: Floats, way: Way, skeleton: Skeleton) -> Floats:
    """(k, 2) a closed line, points about a pixel apart, moved to the ink of both faces.

    Where there is none within reach it runs as its neighbours do. A line with too little ink stays as it is.
    """
    base = _averaged(line, SMOOTHED)
    span = np.roll(base, -1, axis=0) - np.roll(base, 1, axis=0)
    normal = np.stack([-span[:, 1], span[:, 0]], axis=1) / (np.hypot(*span.T)[:, None] + 1e-9)
    steps = np.arange(-FARTHEST, FARTHEST + STEP, STEP)
    places = (base[:, None] + steps[:, None] * normal[:, None]).reshape(-1, 2)
    moved = places + way.of(places)
    off = np.maximum(interpolated(skeleton.distance, places), interpolated(skeleton.distance, moved))
    off = off.reshape(len(base), len(steps))
    best = (off + PULL * np.abs(steps)).argmin(axis=1)
    own = np.arange(len(base))
    at = np.flatnonzero(off[own, best] <= ON_INK)
    if len(at) < len(base) // 2:
        return line
    to = np.interp(own, at, steps[best[at]], period=len(base))
    return np.asarray(base + _median(to, STEADY)[:, None] * normal)


def _averaged(line: Floats, width: int) -> Floats:
    return np.asarray(_windows(line, width).mean(axis=-1))


def _median(values: Floats, width: int) -> Floats:
    return np.asarray(np.median(_windows(values, width), axis=-1))


def _windows(values: Floats, width: int) -> Floats:
    """(k, ..., width) the values around each of a closed line's."""
    half = width // 2
    return sliding_window_view(np.concatenate([values[-half:], values, values[:half]]), width, axis=0)
