"""Confidence: how often an answer with such witnesses is right.

A logistic regression of right and wrong answers on the witnesses. `scripts/fit_confidence.py` fits the weights on one
half of the drawings, draws the reliability of both, and writes them to `evidence/weights.py`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketch2shape.evidence.weights import BIAS, CENTRE, SPREAD, WEIGHT
from sketch2shape.model import Floats

REFUSE_BELOW = 0.25
"""Confidence below which an answer is no answer: nearly all such answers are wrong, or there is nothing to be found."""
FARTHEST = 4.0
"""Spreads from the mean beyond which a witness says no more: no drawing of the fit lay further off."""


class Weights(NamedTuple):
    """A logistic regression: mean, standard deviation and weight of each witness, (w,) each, and the bias."""

    centre: tuple[float, ...] = CENTRE
    spread: tuple[float, ...] = SPREAD
    weight: tuple[float, ...] = WEIGHT
    bias: float = BIAS


def standardised(witnesses: Floats, weights: Weights) -> Floats:
    """Witnesses (..., w) in standard deviations from their mean."""
    off = (np.nan_to_num(witnesses) - weights.centre) / weights.spread
    return np.asarray(np.clip(off, -FARTHEST, FARTHEST))


def confidence(witnesses: Floats, weights: Weights | None = None) -> float:
    """Probability 0..1 that an answer with these witnesses (w,) is right."""
    used = weights or Weights()
    return float(1.0 / (1.0 + np.exp(-(standardised(witnesses, used) @ np.array(used.weight) + used.bias))))
