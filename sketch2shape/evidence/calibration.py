"""Confidence: how often an answer with such witnesses is right.

A logistic regression of right and wrong answers on the witnesses. `scripts/fit_confidence.py` fits the weights on one
half of the drawings, draws the reliability of both, and writes them to `evidence/weights.py`. The weight of `chords` is
of a later fit than the others, which made fewer right answers sure.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketch2shape.evidence.weights import BIAS, CENTRE, SPREAD, WEIGHT
from sketch2shape.evidence.witness import WITNESSES
from sketch2shape.model import Floats

REFUSE_BELOW = 0.19
"""Confidence below which an answer is none; when it was chosen, none of sixteen between 0.14 and this was right."""
EVEN_ODDS = 0.5
"""Confidence below which an answer is likelier wrong than right."""
FARTHEST = 4.0
"""Spreads from the mean beyond which a witness says no more: no drawing of the fit lay further off."""
WHOLE = {
    "unexplained": (0.02, 0.1),
    "closed": (0.01, 0.03),
    "weakest": (0.4, 0.9),
    "bend": (0.03, 0.07),
    "flat": (0.0, 1.0),
    "doubled": (0.05, 0.3),
}
"""Witnesses against an answer that explains all ink: values up to which nothing speaks against it, and from which much
does. Where nothing does, however thick the pen or careless the hand, such answers are right."""


class Weights(NamedTuple):
    """A logistic regression: mean and standard deviation of each witness, (w,) each, weight of each term, and the bias.

    The terms are those of `terms`, or the witnesses as they are.
    """

    centre: tuple[float, ...] = CENTRE
    spread: tuple[float, ...] = SPREAD
    weight: tuple[float, ...] = WEIGHT
    bias: float = BIAS


def standardised(witnesses: Floats, weights: Weights) -> Floats:
    """Witnesses (..., w) in standard deviations from their mean."""
    off = (np.nan_to_num(witnesses) - weights.centre) / weights.spread
    return np.asarray(np.clip(off, -FARTHEST, FARTHEST))


def terms(witnesses: Floats, weights: Weights) -> Floats:
    """(..., w + 1) what is weighed: how far an answer explains all; witnesses (..., w), less so the more it does."""
    whole = np.ones(witnesses.shape[:-1])
    for name, (none, much) in WHOLE.items():
        whole = whole * np.clip((much - witnesses[..., WITNESSES.index(name)]) / (much - none), 0.0, 1.0)
    whole = whole[..., None]
    return np.concatenate([whole, standardised(witnesses, weights) * (1.0 - whole)], axis=-1)


def confidence(witnesses: Floats, weights: Weights | None = None) -> float:
    """Probability 0..1 that an answer with these witnesses (w,) is right."""
    used = weights or Weights()
    return probability(terms(np.nan_to_num(witnesses), used), used)


def probability(weighed: Floats, weights: Weights) -> float:
    """The logistic of terms (k,) under their weights."""
    return float(1.0 / (1.0 + np.exp(-(weighed @ np.array(weights.weight) + weights.bias))))
