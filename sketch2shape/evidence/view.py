"""What all hypotheses of one drawing are compared with, and what ink costs that none of them explains."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence.sheet import MOST_POINTS
from sketch2shape.ink import Group
from sketch2shape.model import Bools, Floats, Ints
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
ALONG = 0.96
"""Cosine of the angle up to which a path goes on as another."""
AHEAD = 4.0
"""Pens from its end over which a path has a direction."""
MEETING, BLUR = 1.5, 1.5
"""Pens, and pixels more, between the ends of paths that meet."""
MOSTLY = 0.5
"""Part of a path that is foreign from which on all of it is a foreign stroke."""
MOST_LINKED = 300
"""Paths beyond which none is held to go on as another: a page of text, a scribble."""
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
    slack    : (k,) float, pixels by which a line may run beside each, within a blot
    pen      : stroke width, pixels
    size     : diagonal of the ink, pixels
    cut      : see `Sheet`
    """

    skeleton: Skeleton
    points: Floats
    path: Ints
    length: Floats
    slack: Floats
    pen: float
    size: float
    cut: Floats | None = None

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
    def units(self) -> Floats:
        """(p,) units of ink of each path."""
        return np.asarray(np.bincount(self.path, self.length, len(_paths(self.skeleton))) / self.unit)

    @property
    def follows(self) -> Ints:
        """(p, 2) int, the path as which each goes on straight at each end, or -1."""
        return self._ends[0]

    @property
    def ends_freely(self) -> Bools:
        """(p, 2) bool, whether no other path meets it at each end."""
        return self._ends[1]

    @cached_property
    def _ends(self) -> tuple[Ints, Bools]:
        return _followed(_paths(self.skeleton), self.pen)

    @cached_property
    def all_foreign(self) -> float:
        """Nats if no ink is explained."""
        return self.foreign(self.units)

    def foreign(self, left: Floats) -> float:
        """Nats for foreign ink; left: (p,) float, units of each path that are foreign."""
        foreign = left > MOSTLY * self.units
        # a stroke that crosses others is told once, and one that runs on past an edge's end starts there
        told = (self.follows >= 0) & foreign[:, None] & (foreign[self.follows] | self.ends_freely[:, ::-1])
        return float(foreign_price(left, STROKE * (1.0 - told.mean(axis=1))).sum())


def foreign_price(units: Any, stroke: Any = STROKE) -> Any:
    """Nats for foreign ink on paths of so many units each, and so many nats for the stroke."""
    return np.minimum(FOREIGN * units, (stroke + STROKE_UNIT * units) * (np.asarray(units) > 0))


def _paths(skeleton: Skeleton) -> list[NDArray[Any]]:
    return [p for p in skeleton.paths if len(p)]


def _followed(paths: list[NDArray[Any]], pen: float) -> tuple[Ints, Bools]:
    """See `View.follows` and `View.ends_freely`."""
    none = np.full((len(paths), 2), -1)
    if not 0 < len(paths) <= MOST_LINKED:
        return none, np.zeros(none.shape, np.bool_)
    near = round(AHEAD * pen) + 1
    points, last = np.concatenate(paths).astype(float), np.cumsum([len(p) for p in paths]) - 1
    first = np.append(0, last[:-1] + 1)
    ends = np.stack([points[first], points[last]], axis=1)
    inner = np.stack([points[np.minimum(first + near, last)], points[np.maximum(last - near, first)]], axis=1)
    out = (ends - inner).reshape(-1, 2)
    out /= np.hypot(*out.T)[:, None] + 1e-9
    at = ends.reshape(-1, 2)
    apart = np.abs(at[:, None] - at).max(axis=2)
    meet = apart <= MEETING * pen + BLUR
    turned = np.where(meet, out @ out.T, 1.0)
    own = np.arange(len(at))
    turned[own, own] = turned[own, own ^ 1] = 1.0
    best = turned.argmin(axis=1)
    mutual = (best[best] == own) & (turned[own, best] < -ALONG)
    follows = np.where(mutual, best // 2, none.ravel()).reshape(-1, 2)
    return np.asarray(follows), np.asarray((meet.sum(axis=1) == 1).reshape(-1, 2))


def observe(group: Group, skeleton: Skeleton) -> View:
    """The view of a group of ink."""
    paths = _paths(skeleton) or [np.zeros((0, 2), np.int32)]
    pixels, owner = np.concatenate(paths), np.repeat(np.arange(len(paths)), [len(p) for p in paths])
    step = max(1, -(-len(pixels) // (MOST_KNOWN if skeleton.is_known else MOST_POINTS)))
    points, owner = pixels[::step], owner[::step]
    x, y = np.rint(points).astype(np.intp).T
    small = ~group.solid[y, x]
    length = np.full(len(points), float(step))
    if small.any():
        length[small] *= np.where(np.array([_is_straight(p) for p in paths])[owner[small]], DASH, SPECK)
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0))) if len(skeleton.points) else 1.0
    slack = skeleton.slack(points)
    return View(skeleton, points.astype(float), owner, length, slack, skeleton.pen_width, size, group.cut)


def _is_straight(path: NDArray[Any]) -> bool:
    """Whether a path of pixels is."""
    if len(path) < 2:
        return False
    steps = np.diff(path, axis=0)
    return bool(np.hypot(*(path[-1] - path[0])) > STRAIGHT * np.hypot(steps[:, 0], steps[:, 1]).sum())
