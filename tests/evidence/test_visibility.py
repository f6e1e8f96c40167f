"""Visibility: which edges lie behind the object."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, hidden_edges

from sketch2shape.evidence.visibility import hidden_samples
from sketch2shape.hypotheses.hypothesis import Rings


def surely_hidden(rings):
    """(3m,) part of each edge that is hidden for sure, a few pixels at the outline left open."""
    sure, perhaps = hidden_samples(rings, 3.0)
    assert (perhaps | ~sure).all()
    return sure.mean(axis=1)


@pytest.mark.parametrize("d", [(90, -60), (-80, -50), (70, 60), (-60, 90)])
@pytest.mark.parametrize("f1", [SQUARE, HEXAGON], ids=["box", "hexagon"])
def test_hidden_edges_of_convex_prisms_are_those_of_the_sides_that_look_away(f1, d):
    f2 = f1 + np.array(d, float)
    hidden = surely_hidden(Rings((f1,), (f2,)))
    expected = hidden_edges(f1, f2)
    assert (hidden[expected] > 0.5).all()
    assert (hidden[~expected] < 0.2).all()


def test_a_back_edge_of_an_l_is_hidden_where_the_l_covers_it():
    #  0-----1        seen from the right and above: the step's inner corner 3 hides the back only in part
    #  |  3--2
    #  5--4
    hidden = surely_hidden(Rings((L_SHAPE,), (L_SHAPE + DEPTH,)))
    front, back, joining = hidden[:6], hidden[6:12], hidden[12:]
    assert (front == 0).all()
    assert back[0] == 0  # above the object
    assert back[1] == 0  # to its right
    assert back[4] > 0.6  # the bottom, behind the stem, comes out beside it
    assert back[4] < 1.0
    assert back[5] > 0.8  # the left side, but for its top
    assert joining[0] == joining[1] == joining[2] == joining[4] == 0
    assert joining[5] > 0.6


def test_seen_through_a_hole_the_back_is_not_hidden():
    hole = SQUARE.mean(axis=0) + 0.6 * (SQUARE - SQUARE.mean(axis=0))
    d = np.array([20.0, -15])
    hidden = surely_hidden(Rings((SQUARE, hole), (SQUARE + d, hole + d)))
    through = hidden[12 + 4 : 12 + 8]  # the hole's back edges: right and top behind the face, left and bottom in sight
    assert through[3] < 0.3
    assert through[2] < 0.3
    assert through[0] > 0.7
    assert through[1] > 0.7


def test_an_edge_that_runs_behind_no_more_than_a_tip_may_be_hidden_from_there_on():
    #   |\ the spike at 2 covers a few pixels of the edge from the vertex 0
    f1 = np.array([[100.0, 200], [150, 260], [160, 160], [240, 330], [100, 330]])
    sure, perhaps = hidden_samples(Rings((f1,), (f1 + [200.0, -100],)), 3.0)
    rung = 2 * len(f1)
    assert not perhaps[rung, :8].any()
    assert perhaps[rung, 14:].all()
    assert not sure[rung].any()
