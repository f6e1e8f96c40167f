"""Confidence of answers with arcs or a point: a logistic regression on their own witnesses (see `sweep_witness`).

`scripts/fit_sweep_confidence.py` fits the weights on one half of generated drawings and shows the reliability of both.
The weight of `chords` is of a later fit than the others, which refused cones and pyramids drawn by hand.
"""

from __future__ import annotations

from sketch2shape.evidence import sweep_weights
from sketch2shape.evidence.calibration import Weights, probability, standardised
from sketch2shape.model import Floats

SWEEP_WEIGHTS = Weights(sweep_weights.CENTRE, sweep_weights.SPREAD, sweep_weights.WEIGHT, sweep_weights.BIAS)
"""As fitted; every witness is weighed as it is."""


def sweep_confidence(witnesses: Floats, weights: Weights | None = None) -> float:
    """Probability 0..1 that an answer with these witnesses (w,) is right."""
    used = weights or SWEEP_WEIGHTS
    return probability(standardised(witnesses, used), used)
