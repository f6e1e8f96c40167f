"""Confidence: a logistic regression that clips what it has never seen."""

import numpy as np
import pytest

from sketch2shape.evidence import WITNESSES, confidence
from sketch2shape.evidence.calibration import FARTHEST, WHOLE, Weights, standardised, terms

W = len(WITNESSES)
PLAIN = Weights((1.0,) * W, (2.0,) * W, (1.5,) + (0.0,) * (W - 1) + (-1.0,), 0.5)


def odds(witnesses):
    p = confidence(witnesses, PLAIN)
    return np.log(p / (1 - p))


def test_the_mean_gives_the_bias_alone():
    assert odds(np.ones(W)) == pytest.approx(0.5)


def test_a_witness_moves_the_odds_by_its_weight_for_each_spread():
    two = np.ones(W)
    two[-1] += 4.0
    assert odds(two) == pytest.approx(0.5 - 2.0)


def test_where_all_is_explained_nothing_else_counts():
    whole = np.ones(W)
    for name, (none, _) in WHOLE.items():
        whole[WITNESSES.index(name)] = none
    assert odds(whole) == pytest.approx(0.5 + 1.5)
    far = whole.copy()
    far[-1] += 100.0
    assert odds(far) == odds(whole)


@pytest.mark.parametrize("name", WHOLE)
def test_each_witness_against_it_ends_that(name):
    seen = np.zeros(W)
    at = WITNESSES.index(name)
    none, much = WHOLE[name]
    seen[at] = none
    assert terms(seen, PLAIN)[0] == 1
    seen[at] = (none + much) / 2
    assert 0 < terms(seen, PLAIN)[0] < 1
    seen[at] = much
    assert terms(seen, PLAIN)[0] == 0


def test_what_lies_far_off_says_no_more_than_the_farthest_that_was_fitted():
    far, farther = np.ones(W), np.ones(W)
    far[-1], farther[-1] = 1 + 2 * FARTHEST, 1e9
    assert odds(far) == odds(farther)
    assert standardised(np.full(W, -1e9), PLAIN).min() == -FARTHEST


def test_what_cannot_be_told_is_a_number_all_the_same():
    assert 0.0 < confidence(np.full(W, np.nan), PLAIN) < 1.0


def test_the_fitted_weights_cover_every_witness_and_more_foreign_ink_is_never_surer():
    fitted = Weights()
    assert len(fitted.centre) == len(fitted.spread) == len(fitted.weight) - 1 == W
    low = np.array(fitted.centre)
    high = low.copy()
    for name in ("unexplained", "attached", "loose"):
        high[WITNESSES.index(name)] += 0.3
    assert confidence(high) < confidence(low)
