"""Rivals: how sure an answer is beside others that tell the drawing nearly as briefly.

What speaks for and against an answer by itself says how likely it is. Another object that costs hardly more nats, or
none at all, makes it less so. A logistic regression again: on the log odds of the answer alone and on how close the
rival comes. `scripts/fit_confidence.py` fits it, and writes the weights to `evidence/rival_weights.py`.
"""

from __future__ import annotations

import numpy as np

from sketch2shape.evidence.calibration import Weights, probability, standardised
from sketch2shape.evidence.rival_weights import BIAS, CENTRE, SPREAD, WEIGHT
from sketch2shape.model import Floats

NEAR = 0.2
"""Price of the next best above the best, over that of all ink, at which a rival says a third as much."""
MOST_ODDS = 9.0
"""Log odds of an answer alone beyond which they say no more."""
AGAINST_RIVALS = Weights(CENTRE, SPREAD, WEIGHT, BIAS)


def rivalry(gap: float, everything: float) -> float:
    """How close a rival comes: 0 for none, 1 for one that costs as little.

    gap        : nats to the next best hypothesis that is another object, or to none
    everything : nats for all ink if no object explains it
    """
    return float(np.exp(-max(gap, 0.0) / (NEAR * everything + 1e-9)))


def beside(alone: float, rival: float) -> Floats:
    """(2,) what is weighed: log odds of an answer with this confidence 0..1, and how close its rival comes."""
    odds = np.log(max(alone, 1e-9) / max(1.0 - alone, 1e-9))
    return np.array([np.clip(odds, -MOST_ODDS, MOST_ODDS), rival])


def against_rivals(alone: float, rival: float) -> float:
    """Probability 0..1 that an answer is right which has this confidence by itself, and a rival so close, 0..1 both."""
    return probability(standardised(beside(alone, rival), AGAINST_RIVALS), AGAINST_RIVALS)
