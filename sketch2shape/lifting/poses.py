"""Guesses at how a face is held in a parallel drawing, many at a time."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sketch2shape.model import Floats


@dataclass(frozen=True)
class Pose:
    """A guess at how the face is held.

    slant, turn : its slant, and by how much d was drawn astray, both radians
    vague       : is it the mean of many that are about as likely?
    """

    slant: float
    turn: float
    vague: bool = False

    def turned(self, d: Floats) -> Floats:
        """The connecting vector d without that error."""
        c, s = np.cos(self.turn), np.sin(self.turn)
        return np.array([c * d[0] - s * d[1], s * d[0] + c * d[1]])


@dataclass(frozen=True)
class Trials:
    """Poses tried: every slant (g,) with every turn (h,), radians, the turn outermost; `sure` (h,) weighs the turns.

    Before all of them come the face as drawn and the `named` (v,) poses that are tried besides. The last turn may be
    one that makes d plumb (`has_plumb`); `spread` is what the weights of the others sum up to.
    """

    slants: Floats
    turns: Floats
    sure: Floats
    spread: float = 1.0
    has_plumb: bool = False
    named: tuple[Pose, ...] = ()

    @property
    def head(self) -> int:
        """How many trials come before those of every slant with every turn."""
        return 1 + len(self.named)

    @cached_property
    def stretches(self) -> Floats:
        """(1 + v + h g, 1) stretch along d."""
        free = np.concatenate([1.0 / np.cos(self.slants)] * len(self.turns))
        return np.concatenate([[1.0], [1.0 / math.cos(pose.slant) for pose in self.named], free])[:, None]

    @cached_property
    def every_slant(self) -> Floats:
        """(1 + v + h g,) slants, radians; a right angle for the face as drawn, which tells no depth."""
        return np.concatenate([[0.5 * np.pi], [p.slant for p in self.named], *[self.slants] * len(self.turns)])

    @cached_property
    def steps(self) -> Floats:
        """(1 + v + h g,) how much further the next slant stretches, of the logarithm."""
        free = np.tan(self.slants) * (abs(float(self.slants[1] - self.slants[0])) if len(self.slants) else 0.0)
        return np.concatenate([np.zeros(self.head), *[free] * len(self.turns)])

    @cached_property
    def swung(self) -> tuple[Floats, Floats]:
        """Cosine and sine of the turn of d, both (1 + v + h g, 1)."""
        named = [pose.turn for pose in self.named]
        swung = np.concatenate([[0.0], named, np.repeat(self.turns, len(self.slants))])[:, None]
        return np.cos(swung), np.sin(swung)
