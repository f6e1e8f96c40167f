"""Found: a verified hypothesis, what it costs, and which of several is the best.

All are priced under the noise of one hand: who draws one line with a trembling hand draws all with it.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from sketch2shape.evidence import Comparison, Energy, Evidence, Sheet
from sketch2shape.hypotheses import Rings, coincide
from sketch2shape.model import Floats
from sketch2shape.search.exact import Verified

TIE = 3.0
"""Nats that are no reason to prefer a later hypothesis."""
COMPARABLE = 0.1
"""Difference of scores up to which answers tell the noise of the hand that drew."""
MAIN = 0.5
"""Part of the ink from which on an answer that is drawn whole tells the noise of the hand, whatever else is drawn."""


@dataclass(frozen=True)
class Found(Verified):
    """A verified hypothesis that others are weighed against.

    sheet     : what it was compared with, as strictly as its lines allow
    compared  : held against the drawing
    energy    : what it and the drawing under it cost
    witnesses : what speaks for and against it by itself
    is_none   : whether it is no object, however sure that makes it
    alone     : 0..1, how sure that alone makes it
    rival     : 0..1, how close another comes
    """

    sheet: Sheet = field(kw_only=True)
    compared: Comparison | None = None
    energy: Energy | None = None
    witnesses: Floats | None = None
    is_none: bool = False
    alone: float = 0.0
    rival: float = 0.0


def total(found: Found) -> float:
    """What it costs, nats; infinity before it is priced."""
    return found.energy.total if found.energy else np.inf


def priced(found: list[Found]) -> list[Found]:
    """Those held against the drawing, with what each costs under the noise of one hand; some are found."""
    hand = hand_of(found)
    return [replace(f, energy=f.compared.energy(hand)) for f in found if f.compared is not None]


def hand_of(found: list[Found]) -> float:
    """Noise of the hand that drew, pixels: the least under which an answer as good as any, or one all drawn, holds.

    Raises ValueError if nothing is found.
    """
    top = max(f.evidence.score for f in found)
    return min(f.noise for f in found if f.evidence.score >= top - COMPARABLE or _is_all_drawn(f.evidence))


def _is_all_drawn(evidence: Evidence) -> bool:
    """Whether all that should have been drawn has, and it is a good part of the drawing."""
    return evidence.is_all_drawn and evidence.explained > MAIN


def best_of(found: list[Found]) -> Found | None:
    """The hypothesis of least energy, all under the noise of one hand; None if nothing is found."""
    if not found:
        return None
    best, *others = priced(found)
    for other in others:
        # of those that cost alike, the one that is drawn better by far, or else that was thought of first
        is_better = other.evidence.score > best.evidence.score + COMPARABLE
        if total(other) < total(best) + (TIE if is_better else -TIE):
            best = other
    return best


def is_same(a: Found | None, b: Found | None) -> bool:
    """Whether both are the same object, to within the reach of a line."""
    return a is not None and b is not None and alike(a.rings, b.rings, 0.5 * (a.sheet.reach + b.sheet.reach))


def alike(a: Rings, b: Rings, near: float) -> bool:
    """Whether refinement will make the same of both: the same outlines, at most near pixels apart."""
    if a.sizes != b.sizes:
        return False
    return coincide(a.front[0], b.front[0], near) and coincide(a.back[0], b.back[0], near)
