"""One drawing at several tolerances."""

from itertools import pairwise

import numpy as np
import pytest
from sketches import DEPTH, SQUARE, ink_of, line, paper, prism

from sketch2shape.ink.groups import split_groups
from sketch2shape.model.drawing import ring_edges
from sketch2shape.search.tolerances import (
    COVERED,
    ROUGHLY,
    Round,
    Traced,
    corner_graph,
    is_wireframe,
    rounds_for,
    vertex_candidates,
)
from sketch2shape.strokes.skeleton import thin


def traced(picture, tolerance=1.5):
    (group,) = split_groups(ink_of(picture))
    return group, Traced(group, thin(group.ink), tolerance)


def test_tolerance_only_grows_from_round_to_round():
    for size, pen in ((100.0, 2.0), (500.0, 3.0), (2000.0, 12.0)):
        rounds = rounds_for(size, pen)
        assert all(b.trace >= a.trace and b.reach >= a.reach for a, b in pairwise(rounds))


def test_a_box_has_its_corners_and_ink_between_those_that_an_edge_joins():
    group, ruled = traced(prism(SQUARE, SQUARE + DEPTH))
    points = vertex_candidates(ruled.strokes, ruled.corners, Round(1.5, 2.0), group.ink.pen_width)
    graph = corner_graph(ruled.skeleton, points, 2.0)
    truth = np.r_[SQUARE, SQUARE + DEPTH] - group.offset
    gap = np.linalg.norm(graph.points[:, None] - truth[None], axis=2)
    assert gap.min(axis=0).max() < 2.5
    joined = graph.inked[np.ix_(gap.argmin(axis=0), gap.argmin(axis=0))]
    assert {frozenset(e) for e in np.argwhere(joined).tolist()} == {frozenset(e) for e in ring_edges([4]).tolist()}


def test_a_wireframe_is_told_from_a_scribble_by_where_three_strokes_meet():
    assert is_wireframe(traced(prism(SQUARE, SQUARE + DEPTH))[1].corners)
    picture, rng = paper(), np.random.default_rng(3)
    for a, b in pairwise(rng.uniform(60, 420, (12, 2))):
        line(picture, a, b)
    assert not is_wireframe(traced(picture)[1].corners)


def test_ruled_lines_hardly_wobble_and_wavy_ones_do():
    _, ruled = traced(prism(SQUARE, SQUARE + DEPTH))
    assert ruled.wobble < 0.5
    picture = paper()
    x = np.arange(60, 420, 4.0)
    wave = np.c_[x, 200 + 2.2 * np.sin(x / 9)]
    for a, b in pairwise(wave):
        line(picture, a, b)
    _, wavy = traced(picture, 4.0)
    assert wavy.wobble == pytest.approx(2.2 / np.sqrt(2), rel=0.3)


def test_without_small_pieces_there_are_no_ends_of_dashes():
    assert len(traced(prism(SQUARE, SQUARE + DEPTH))[1].dash_ends) == 0
    assert len(traced(prism(SQUARE, SQUARE + DEPTH, "dashed"))[1].dash_ends) > 0


@pytest.mark.parametrize(
    ("part", "covered", "roughly"), [(0.97, True, True), (0.82, False, True), (0.65, False, False)]
)
def test_an_edge_is_one_if_most_of_it_is_inked_and_a_careless_one_if_much_is(part, covered, roughly):
    a, b = np.array([60.0, 200]), np.array([400.0, 200])
    group, ruled = traced(line(paper(), a, a + part * (b - a)))
    points = np.array([a, b]) - group.offset
    for least, inked in ((COVERED, covered), (ROUGHLY, roughly)):
        assert corner_graph(ruled.skeleton, points, 2.0, least).inked.tolist() == [[False, inked], [inked, False]]


def test_corners_nearer_than_two_pens_have_no_edge_between_them():
    group, ruled = traced(line(paper(), [60, 200], [400, 200], width=8))
    pen = ruled.skeleton.pen_width
    for pens, inked in ((1.8, False), (2.2, True)):
        points = np.array([[100.0, 200], [100.0 + pens * pen, 200]]) - group.offset
        assert corner_graph(ruled.skeleton, points, 2.0).inked[0, 1] == inked


@pytest.mark.parametrize("width", [2, 8])
def test_corners_are_as_loose_as_pen_and_reach(width):
    group, ruled = traced(line(paper(), [60, 200], [400, 200], width=width))
    points = np.array([[60.0, 200], [400.0, 200]]) - group.offset
    narrow, wide = (corner_graph(ruled.skeleton, points, reach).tolerance for reach in (2.0, 6.0))
    assert narrow == pytest.approx(0.75 * ruled.skeleton.pen_width + 4.5)
    assert wide - narrow == pytest.approx(6.0)
