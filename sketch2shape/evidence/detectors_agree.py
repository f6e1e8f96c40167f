"""Whether the classic corner detectors see the vertices of an answer."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats, Ink
from sketch2shape.strokes import DETECTORS, near, propose, reach_of

ENOUGH = 0.8
"""Part of an object's vertices that a detector has to see. Of right answers it sees all, or all but one or two."""


def vouched(ink: Ink, vertices: Floats, detector: str, noise: float) -> float:
    """0..1, how far the detectors' proposals speak for these vertices; 1 if nearly all have been seen.

    vertices : (k, 2) float, working pixels, those that are drawn
    noise    : working pixels by which they may be misplaced
    """
    seen = np.zeros(len(vertices), bool)
    for name in DETECTORS[1:] if detector == "both" else (detector,):
        seen |= near(vertices, propose(ink, name), reach_of(ink, noise))
        if seen.sum() >= ENOUGH * len(seen):
            return 1.0
    return float(seen.mean()) / ENOUGH
