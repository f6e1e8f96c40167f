"""Arcs are round in the true face and nowhere else."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.lifting.evenness import base_of, with_regular_base
from sketch2shape.lifting.roundness import arcs_of, roundness_odds

STRETCHES = 1.0 / np.cos(np.radians(np.linspace(0, 80, 81)))[:, None]
STILL = np.ones_like(STRETCHES), np.zeros_like(STRETCHES)


def foreshortened(points, toward, slant):
    t = np.array([np.cos(toward), np.sin(toward)])
    return points - (1 - np.cos(np.radians(slant))) * np.outer(points @ t, t), t


@given(st.floats(0, 6.28), st.integers(10, 70), st.floats(1.0, 6.28), st.floats(0, 6.28))
def test_the_true_slant_makes_an_arc_round(toward, slant, sweep, start):
    turn = start + np.linspace(0, sweep, 12)
    circle = 100 * np.c_[np.cos(turn), np.sin(turn)]
    seen, t = foreshortened(circle, toward, slant)
    odds = roundness_odds(arcs_of([seen + 300], t, 1.0), STRETCHES, STILL)
    assert odds[slant] == pytest.approx(0.0, abs=1e-6)
    assert (odds <= 1e-6).all()
    if sweep > 3.0:
        assert odds[max(slant - 10, 0)] < -0.1 or slant < 15


def test_short_arcs_say_less_and_more_noise_does():
    told = []
    for sweep, noise in ((6.28, 1.0), (0.8, 1.0), (6.28, 10.0)):
        turn = np.linspace(0, sweep, 12)
        seen, t = foreshortened(100 * np.c_[np.cos(turn), np.sin(turn)], 0.4, 50)
        odds = roundness_odds(arcs_of([seen], t, noise), STRETCHES, STILL)
        told.append(odds[50] - odds[20])
    assert told[0] > 5 * told[1]
    assert told[0] > 3 * told[2]


def test_a_turn_of_the_direction_is_undone():
    turn = np.linspace(0, 6, 16)
    seen, _ = foreshortened(100 * np.c_[np.cos(turn), np.sin(turn)], 0.5, 60)
    astray = np.array([np.cos(0.4), np.sin(0.4)])
    at = np.array([[0.1]])
    arcs = arcs_of([seen], astray, 1.0)
    right = roundness_odds(arcs, STRETCHES[60:61], (np.cos(at), np.sin(at)))
    wrong = roundness_odds(arcs, STRETCHES[60:61], (np.cos(0 * at), np.sin(0 * at)))
    assert right[0] == pytest.approx(0.0, abs=1e-6)
    assert wrong[0] < right[0] - 1.0


@pytest.mark.parametrize("n", [3, 4, 5, 6])
@pytest.mark.parametrize("slant", [25, 55])
def test_a_regular_base_tells_the_slant(n, slant):
    turn = 2 * np.pi * np.arange(n) / n + 0.3
    seen, t = foreshortened(100 * np.c_[np.cos(turn), np.sin(turn)], 1.2, slant)
    for ring in (seen, seen[::-1]):
        odds = with_regular_base(np.zeros(81), base_of(ring, t, 1.0), STRETCHES, STILL)
        assert int(odds.argmax()) == pytest.approx(slant, abs=2)
        assert odds.max() > 2.0
    # any base keeps what it had
    rough = with_regular_base(np.zeros(81), base_of(seen * [3, 1] + seen[::-1], t, 0.1), STRETCHES, STILL)
    assert rough.min() >= np.log(0.4) - 1e-9
