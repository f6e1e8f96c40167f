"""Confidence: a logistic regression that clips what it has never seen."""

import numpy as np
import pytest

from sketch2shape.evidence import WITNESSES, confidence
from sketch2shape.evidence.calibration import FARTHEST, Weights, standardised

W = len(WITNESSES)
PLAIN = Weights((1.0,) * W, (2.0,) * W, (0.0,) * (W - 1) + (-1.0,), 0.5)


def test_the_mean_gives_the_bias_alone():
    assert confidence(np.ones(W), PLAIN) == pytest.approx(1 / (1 + np.exp(-0.5)))


def test_a_witness_moves_the_odds_by_its_weight_for_each_spread():
    two = np.ones(W)
    two[-1] += 4.0
    assert confidence(two, PLAIN) == pytest.approx(1 / (1 + np.exp(-0.5 + 2.0)))


def test_what_lies_far_off_says_no_more_than_the_farthest_that_was_fitted():
    far, farther = np.ones(W), np.ones(W)
    far[-1], farther[-1] = 1 + 2 * FARTHEST, 1e9
    assert confidence(far, PLAIN) == confidence(farther, PLAIN)
    assert standardised(np.full(W, -1e9), PLAIN).min() == -FARTHEST


def test_what_cannot_be_told_is_a_number_all_the_same():
    assert 0.0 < confidence(np.full(W, np.nan), PLAIN) < 1.0


def test_the_fitted_weights_cover_every_witness_and_more_foreign_ink_is_never_surer():
    fitted = Weights()
    assert len(fitted.centre) == len(fitted.spread) == len(fitted.weight) == W
    low = np.array(fitted.centre)
    high = low.copy()
    high[WITNESSES.index("unexplained")] += 0.3
    assert confidence(high) < confidence(low)
