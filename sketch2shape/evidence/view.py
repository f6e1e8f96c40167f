"""What all hypotheses of one drawing are compared with, and what ink costs that none of them explains."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence.sheet import MOST_POINTS
from sketch2shape.ink import Group
from sketch2shape.model import Floats, Ints
from sketch2shape.strokes import Skeleton

MOST_KNOWN = 1000
"""The same of lines that are known, which no thinning has roughened."""
UNIT = 0.01
"""Fraction of the drawing's size in which lengths are told, if the pen is not wider."""
LEAST_NOISE, PEN_NOISE = 0.4, 0.05
"""Noise of a ruled line, pixels, and what a thick pen adds, as a fraction of its width."""
MOST_NOISE = 0.015
"""Noise of the worst hand, as a fraction of the drawing's size."""
NOISE_STEP = 1.5
"""Factor between the noises that are tried."""
FOREIGN = 2.5
"""Nats for a unit of foreign ink in a scribble, ..."""
STROKE, STROKE_UNIT = 16.0, 0.25
"""... and for a whole foreign stroke (four coordinates) and each unit of it, where that is less."""
SPECK, DASH = 0.2, 0.6
"""How much the ink of small pieces counts, letters, and where they are straight, dashes."""
STRAIGHT = 0.95
"""Chord of a path over its length from which on it is straight."""


@dataclass(frozen=True, eq=False)
class View:
    """What all hypotheses of one drawing are compared with.

    skeleton : of the ink
    points   : (k, 2) float, pixels of its paths, thinned out
    path     : (k,) int, the path of each
    length   : (k,) float, pixels of ink that each stands for; ink of small pieces counts for little
    pen      : stroke width, pixels
    size     : diagonal of the ink, pixels
    """

    skeleton: Skeleton
    points: Floats
    path: Ints
    length: Floats
    pen: float
    size: float

    @property
    def unit(self) -> float:
        """Pixels in which lengths are told."""
        return max(self.pen, UNIT * self.size)

    @cached_property
    def noises(self) -> Floats:
        """Standard deviations of a hand that are tried, pixels."""
        least = LEAST_NOISE + PEN_NOISE * self.pen
        most = max(MOST_NOISE * self.size, NOISE_STEP * least)
        return np.asarray(least * NOISE_STEP ** np.arange(1 + int(np.log(most / least) / np.log(NOISE_STEP))))

    @cached_property
    def all_foreign(self) -> float:
        """Nats if no ink is explained."""
        return float(foreign_price(np.bincount(self.path, self.length, minlength=1) / self.unit).sum())


def foreign_price(units: Any) -> Any:
    """Nats for foreign ink on paths of so many units each."""
    return np.minimum(FOREIGN * units, (STROKE + STROKE_UNIT * units) * (np.asarray(units) > 0))


def observe(group: Group, skeleton: Skeleton) -> View:
    """The view of a group of ink."""
    paths = [p for p in skeleton.paths if len(p)] or [np.zeros((0, 2), np.int32)]
    pixels, owner = np.concatenate(paths), np.repeat(np.arange(len(paths)), [len(p) for p in paths])
    step = max(1, -(-len(pixels) // (MOST_KNOWN if skeleton.is_known else MOST_POINTS)))
    points, owner = pixels[::step], owner[::step]
    x, y = np.rint(points).astype(np.intp).T
    small = ~group.solid[y, x]
    length = np.full(len(points), float(step))
    if small.any():
        length[small] *= np.where(np.array([_is_straight(p) for p in paths])[owner[small]], DASH, SPECK)
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0))) if len(skeleton.points) else 1.0
    return View(skeleton, points.astype(float), owner, length, skeleton.pen_width, size)


def _is_straight(path: NDArray[Any]) -> bool:
    """Whether a path of pixels is."""
    if len(path) < 2:
        return False
    steps = np.diff(path, axis=0)
    return bool(np.hypot(*(path[-1] - path[0])) > STRAIGHT * np.hypot(steps[:, 0], steps[:, 1]).sum())
