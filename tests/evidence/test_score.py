"""Verification: what is explained, and how hidden lines are drawn."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, line, outline, prism, sheet_of, shrunk

from sketch2shape.evidence.score import is_dashed, judge, judge_all, judge_stack, most_possible
from sketch2shape.hypotheses.hypothesis import Rings, stack

BOX = Rings((SQUARE,), (SQUARE + DEPTH,))


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


def test_many_are_judged_as_each_alone_whatever_their_sizes():
    sheet = sheet_of(prism(SQUARE, SQUARE + DEPTH, "dashed"))
    some = [BOX, Rings((HEXAGON,), (HEXAGON + DEPTH,)), Rings((SQUARE + 4,), (SQUARE + DEPTH,)), BOX.swapped()]
    for one, evidence in zip(some, judge_all(some, sheet), strict=True):
        alone = judge(one, sheet)
        assert (evidence.score, evidence.lines) == (alone.score, alone.lines)
        assert evidence.drawn.tolist() == alone.drawn.tolist()
    assert judge_all([], sheet) == []


def test_a_hypothesis_partly_outside_the_picture_finds_no_ink_there():
    sheet = sheet_of(prism(L_SHAPE, L_SHAPE + DEPTH))
    away = Rings((SQUARE - 1000,), (SQUARE - 1000 + DEPTH,))
    assert judge_stack(stack([away]), sheet)[0].support == 0


def test_the_first_look_passes_the_drawn_object_and_stops_faces_without_ink():
    sheet = sheet_of(prism(SQUARE, SQUARE + DEPTH, "removed"))
    off = Rings((SQUARE + 15,), (SQUARE + 15 + DEPTH,))
    no_depth = Rings((SQUARE,), (SQUARE - DEPTH,))
    assert (most_possible(stack([BOX, off, no_depth]), sheet) > 0.5).tolist() == [True, False, False]


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_no_score_is_higher_than_the_first_look_allows(lines):
    sheet = sheet_of(prism(L_SHAPE, L_SHAPE + DEPTH, lines))
    rng = np.random.default_rng(1)
    some = [Rings((L_SHAPE + rng.normal(0, k / 3, (6, 2)),), (L_SHAPE + DEPTH,)) for k in range(12)]
    part = L_SHAPE[[0, 1, 2, 3]]
    some = stack([*some, Rings((L_SHAPE,), (L_SHAPE + 0.5 * DEPTH,))]), stack([Rings((part,), (part + DEPTH,))])
    for stacked in some:
        possible = most_possible(stacked, sheet)
        for bound, evidence in zip(possible, judge_stack(stacked, sheet), strict=True):
            assert bound == 0 or evidence.score <= bound + 0.02


@pytest.mark.parametrize(("lines", "dashed"), [("wire", False), ("dashed", True), ("removed", True)])
def test_hidden_edges_with_clearly_less_ink_than_visible_ones_are_dashed(lines, dashed):
    assert is_dashed(BOX, sheet_of(prism(SQUARE, SQUARE + DEPTH, lines), 9.0)) is dashed


def test_nothing_is_dashed_where_nothing_is_hidden():
    flat = Rings((SQUARE,), (shrunk(SQUARE, 0.4, SQUARE.mean(axis=0)),))
    assert not is_dashed(flat, sheet_of(prism(*(r[0] for r in flat))))
