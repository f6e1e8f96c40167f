"""The fit of a confidence: known optima, weights within their bounds, a module that reads back, a table that counts."""

import numpy as np
import pytest

from evaluation.logistic import AGAINST, FOR, FREE, RIDGE, Answer, fitted, module_text, promise
from sketch2shape.evidence.calibration import Weights, probability, standardised


def answers(rows, half="even"):
    return [Answer(np.array(seen, float), right, half) for *seen, right in rows]


MIXED = answers([(0, True), (0, True), (0, False), (2, True), (2, False), (2, False)])


def test_where_a_witness_is_always_the_same_the_bias_is_the_odds():
    weights = fitted(answers([(3, True)] * 3 + [(3, False)]), standardised, [FREE])
    assert weights.centre == (3.0,)
    assert weights.weight == (0.0,)
    assert weights.spread[0] > 0
    assert weights.bias == pytest.approx(np.log(3), abs=2e-3)


def test_the_weight_is_where_the_answers_and_the_penalty_balance():
    weights = fitted(MIXED, standardised, [FREE])
    assert (weights.centre, weights.spread) == ((1.0,), (1.0,))
    assert weights.bias == pytest.approx(0.0, abs=1e-3)
    # slope of the loss: 3 answers on each side, a third of each contradict the weight
    w = weights.weight[0]
    assert w < 0
    assert 6 * (1 / (1 + np.exp(-w)) - 1 / 3) + RIDGE * w == pytest.approx(0.0, abs=2e-3)


@pytest.mark.parametrize(("bounds", "sign"), [(FREE, -1), (AGAINST, -1), (FOR, 0)])
def test_a_weight_stays_within_its_bounds(bounds, sign):
    assert np.sign(fitted(MIXED, standardised, [bounds]).weight[0]) == sign


def test_what_cannot_be_told_counts_as_zero():
    untold = [a._replace(witnesses=np.where(a.witnesses == 0, np.nan, a.witnesses)) for a in MIXED]
    assert fitted(untold, standardised, [FREE]) == fitted(MIXED, standardised, [FREE])


def test_terms_may_be_more_than_witnesses():
    def doubled(x, weights):
        z = standardised(x, weights)
        return np.concatenate([z, z], axis=-1)

    weights = fitted(MIXED, doubled, [FREE, FOR])
    assert len(weights.centre) == 1
    assert weights.weight[0] < 0
    assert weights.weight[1] == 0


def test_one_weight_is_fitted_beside_those_that_are_held():
    both = [a._replace(witnesses=np.append(a.witnesses, a.right)) for a in MIXED]
    held = Weights((0.5, 0.25), (2.0, 0.5), (-0.3, 0.0), 0.4)
    weights = fitted(both, standardised, [(-0.3, -0.3), FREE], bias=(0.4, 0.4), scale=held)
    assert (weights.centre, weights.spread) == (held.centre, held.spread)
    assert (weights.weight[0], weights.bias) == (-0.3, 0.4)
    assert weights.weight[1] > 0.5


def test_of_nothing_there_is_no_fit():
    with pytest.raises(ValueError, match="no answer"):
        fitted([], standardised, [FREE])


def test_the_module_reads_back_as_it_was_fitted():
    weights = Weights((0.5, 2.0), (1.0, 0.25), (3.0, -0.1234, 0.0), -1.5)
    text = module_text("Weights of a test.", weights, ["ink", "gap"], ["whole", "ink", "gap"])
    told: dict = {}
    exec(text, told)
    assert told["__doc__"] == "Weights of a test."
    assert Weights(told["CENTRE"], told["SPREAD"], told["WEIGHT"], told["BIAS"]) == weights
    assert "    -0.1234,  # ink\n" in text


def test_a_module_whose_names_do_not_fit_is_not_written():
    with pytest.raises(ValueError, match="zip"):
        module_text("", Weights((0.0,), (1.0,), (1.0,), 0.0), ["ink"], ["whole", "ink"])


def test_the_promise_counts_the_sure_and_the_right_of_each_half():
    weights = Weights((0.0,), (1.0,), (3.0,), 0.0)  # sure from a witness of 0.74 on
    even = answers([(1, True), (2, True), (2, False), (0, True), (-1, False)])
    rows = promise({"all": even + answers([(1, True)], "odd")}, lambda seen: probability(seen, weights)).splitlines()
    assert rows[2:] == [
        "| all | even | 5 | 60.0 | 3 | 66.7 | 66.7 |",
        "| all | odd | 1 | 100.0 | 1 | 100.0 | 100.0 |",
    ]
