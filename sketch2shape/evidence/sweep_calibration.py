"""Confidence of answers with arcs or a point: a logistic regression on their own witnesses (see `sweep_witness`).

`scripts/fit_sweep_confidence.py` fits the weights on one half of generated drawings and shows the reliability of both.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketch2shape.evidence import sweep_weights
from sketch2shape.model import Floats

FARTHEST = 4.0
"""Spreads from the mean beyond which a witness says no more: no drawing of the fit lay further off."""


class SweepWeights(NamedTuple):
    """A logistic regression: mean, standard deviation and weight of each witness, (w,) each, and the bias."""

    centre: tuple[float, ...] = sweep_weights.CENTRE
    spread: tuple[float, ...] = sweep_weights.SPREAD
    weight: tuple[float, ...] = sweep_weights.WEIGHT
    bias: float = sweep_weights.BIAS


def sweep_terms(witnesses: Floats, weights: SweepWeights) -> Floats:
    """Witnesses (..., w) in standard deviations from their mean."""
    off = (np.nan_to_num(witnesses) - weights.centre) / weights.spread
    return np.asarray(np.clip(off, -FARTHEST, FARTHEST))


def sweep_confidence(witnesses: Floats, weights: SweepWeights | None = None) -> float:
    """Probability 0..1 that an answer with these witnesses (w,) is right."""
    used = weights or SweepWeights()
    told = float(sweep_terms(witnesses, used) @ np.array(used.weight) + used.bias)
    return float(1.0 / (1.0 + np.exp(-told)))
