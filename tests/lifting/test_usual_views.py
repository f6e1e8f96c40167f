import math

import numpy as np
import pytest

from sketch2shape.lifting import lift
from sketch2shape.lifting.usual_views import SEEN_SLANTS, plumb_turn, rests_on, standing_odds, usual_view, view_prior
from sketch2shape.model.drawing import TwoFaceObject


def way(degrees):
    return np.array([math.cos(math.radians(degrees)), math.sin(math.radians(degrees))])


@pytest.mark.parametrize(("drawn", "turn"), [(90, 0), (87, 3), (94, -4), (-90, 0), (-86, -4)])
def test_the_turn_that_makes_an_edge_plumb(drawn, turn):
    assert math.degrees(plumb_turn(way(drawn))) == pytest.approx(turn, abs=1e-9)


def test_edges_that_are_plumb_stand_and_others_do_not():
    assert standing_odds(way(90), 0.01) > 2.0 > 0.0 > standing_odds(way(60), 0.01)


@pytest.mark.parametrize("toward", [way(90), way(30), way(0)])
def test_views_from_somewhat_above_are_the_usual_ones(toward):
    prior = view_prior(SEEN_SLANTS, toward) - usual_view(toward)
    assert np.exp(prior).mean() == pytest.approx(1.0)
    assert prior.max() > prior[0] + 3.0
    assert prior.max() > prior[-1] + 3.0


def test_what_an_object_may_stand_on():
    outer = np.array([[0, 0], [100, 0], [100, 60], [0, 60.0]])
    assert rests_on(np.array([[1.0, 0.0]]), outer).all()
    assert not rests_on(np.array([[1.0, 0.0]]), outer + [[0, 0], [0, 0], [0, 0], [0, -50.0]]).any()


@pytest.mark.parametrize("aside", [-3.0, -1.5, 0.0, 1.5, 3.0])
def test_a_low_box_drawn_a_little_askew_stands(aside):
    """Of 4 x 3 x 0.5, seen from 30 degrees aside and 25 above, its short edges some degrees off plumb."""
    a, e = np.radians([30.0, 25.0])
    x, y, z = np.array([[0, 0, 0.5], [4, 0, 0.5], [4, 3, 0.5], [0, 3, 0.5]]).T * 70.0
    right, away = x * np.cos(a) - y * np.sin(a), x * np.sin(a) + y * np.cos(a)
    top = np.stack([right, -away * np.sin(e) - z * np.cos(e)], axis=1)
    solid = lift(TwoFaceObject(top, top + [aside, 35.0 * np.cos(e)], lines="removed", noise=1.7))
    width, height, depth = sorted(solid.dimensions, reverse=True)
    assert width / height == pytest.approx(4 / 3, rel=0.12)
    assert height / depth == pytest.approx(6, rel=0.12)
