"""Verification: what is hidden, what is explained, and how hidden lines are drawn."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, hidden_edges, line, outline, prism, sheet_of, shrunk

from sketch2shape.verify import Rings, hidden_samples, judge, plausible

BOX = Rings((SQUARE,), (SQUARE + DEPTH,))


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


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_the_true_object_explains_its_drawing_and_tells_its_hidden_lines(lines):
    evidence = judge(BOX, sheet_of(prism(SQUARE, SQUARE + DEPTH, lines)))
    assert evidence.lines == lines
    assert evidence.score > 0.97
    assert evidence.weakest > 0.9
    assert evidence.drawn.tolist() == [True, True, True, lines != "removed"]


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_wrong_depth_or_a_missing_part_explains_less(lines):
    sheet = sheet_of(prism(SQUARE, SQUARE + DEPTH, lines))
    right = judge(BOX, sheet).score
    assert judge(Rings((SQUARE,), (SQUARE + 0.8 * DEPTH,)), sheet).score < right - 0.1
    assert judge(Rings((SQUARE[:3],), (SQUARE[:3] + DEPTH,)), sheet).score < right - 0.1
    assert judge(Rings((SQUARE + 8,), (SQUARE + 8 + DEPTH,)), sheet).score < right - 0.3


def test_ink_that_is_left_over_counts_against_an_answer():
    picture = prism(SQUARE, SQUARE + DEPTH)
    clean = judge(BOX, sheet_of(picture))
    line(line(picture, [40, 40], [440, 380]), [40, 380], [440, 340])
    evidence = judge(BOX, sheet_of(picture))
    assert evidence.support == pytest.approx(clean.support, abs=0.02)
    assert evidence.explained < 0.8
    assert evidence.score < clean.score - 0.1


def test_one_edge_without_ink_is_enough_to_doubt():
    full = prism(SQUARE, SQUARE + DEPTH)
    gap = full.copy()
    gap[136:145, 140:200] = 255
    gap[136:145, 220:262] = 255
    assert judge(BOX, sheet_of(full)).weakest > 0.9
    assert judge(BOX, sheet_of(gap)).weakest < 0.5


def test_a_flat_face_with_everything_else_hidden_is_no_object():
    inside = shrunk(SQUARE, 0.5, SQUARE.mean(axis=0))
    assert judge(Rings((SQUARE,), (inside,)), sheet_of(outline(SQUARE))).score < 0.5


def test_what_cannot_be_the_faces_of_an_object():
    assert plausible(BOX, 3.0)
    crossed = SQUARE[[0, 2, 1, 3]]
    assert not plausible(Rings((crossed,), (crossed + DEPTH,)), 3.0)
    assert not plausible(Rings((SQUARE,), (shrunk(SQUARE, 0.05, SQUARE[0]),)), 3.0)  # a pyramid
    assert not plausible(Rings((SQUARE,), (SQUARE + 1.0,)), 3.0)  # no depth
    assert not plausible(Rings((SQUARE,), (SQUARE * [-1, 1] + [500, 0],)), 3.0)  # turned over
    assert not plausible(Rings((SQUARE,), (np.full((4, 2), np.inf),)), 3.0)
