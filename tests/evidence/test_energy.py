"""The energy: parts that can be worked out by hand, and what must never make an answer cheaper."""

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, ink_of, line, prism, shrunk

from sketch2shape.evidence.energy import BLUR, CORRELATED, WITHIN, compare, nearest_edges, with_hidden
from sketch2shape.evidence.view import FOREIGN, STROKE, STROKE_UNIT, foreign_price, observe
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.ink import split_groups
from sketch2shape.strokes.skeleton import thin

BOX = Rings((SQUARE,), (SQUARE + DEPTH,))
ALL = np.ones(4, bool)


def view_of(picture):
    (group,) = split_groups(ink_of(picture))
    return observe(group, thin(group.ink)), group.offset


def priced(rings, picture, drawn=None, hand=0.5):
    view, offset = view_of(picture)
    drawn = np.ones(sum(rings.sizes), bool) if drawn is None else drawn
    return compare(rings.shifted(-offset), view, drawn, 4.0).energy(hand)


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_the_true_box_leaves_nothing_unexplained_however_its_hidden_edges_are_drawn(lines):
    energy = priced(BOX, prism(SQUARE, SQUARE + DEPTH, lines))
    assert energy.unexplained < 0.5 * energy.vertex
    assert energy.noise < 1.0
    assert energy.lines in {"wire": ("wire",), "dashed": ("wire", "dashed"), "removed": ("removed",)}[lines]


def test_the_shape_costs_two_digits_a_front_vertex_and_a_plain_map_least():
    wire = prism(SQUARE, SQUARE + DEPTH)
    energy = priced(BOX, wire)
    assert energy.shape == pytest.approx((2 * 4 + 2) * energy.digit, abs=1.0)
    tapered = Rings((SQUARE,), (shrunk(SQUARE, 0.6, np.array([400.0, 60])),))
    other = priced(tapered, prism(SQUARE, tapered.back[0]))
    assert other.shape == pytest.approx((2 * 4 + 3) * other.digit, abs=1.0)


def test_a_careless_back_vertex_costs_no_more_than_its_two_coordinates():
    back = SQUARE + DEPTH
    off = back.copy()
    off[2] += [14.0, 9.0]
    energy = priced(Rings((SQUARE,), (off,)), prism(SQUARE, off))
    assert energy.shape <= (2 * 4 + 5 + 2) * energy.digit + 1.0
    assert energy.unexplained < energy.vertex


def test_an_edge_without_ink_costs_by_its_length_and_a_gap_at_its_end_little():
    full = prism(SQUARE, SQUARE + DEPTH)
    middle, end = full.copy(), full.copy()
    middle[136:145, 180:220] = 255
    end[136:145, 123:131] = 255
    assert priced(BOX, middle).missing > priced(BOX, full).missing + 15
    assert priced(BOX, end).missing < priced(BOX, full).missing + 4


def test_a_vertex_stays_if_its_edges_explain_more_than_it_costs():
    picture = prism(L_SHAPE, L_SHAPE + DEPTH)
    whole = priced(Rings((L_SHAPE,), (L_SHAPE + DEPTH,)), picture)
    hull = L_SHAPE[[0, 1, 2, 4, 5]]
    assert whole.total < priced(Rings((hull,), (hull + DEPTH,)), picture).total - 50


def test_a_needless_vertex_costs_just_itself():
    picture = prism(SQUARE, SQUARE + DEPTH)
    five = np.insert(SQUARE, 1, [195.0, 140.0], axis=0)
    more = priced(Rings((five,), (five + DEPTH,)), picture)
    plain = priced(BOX, picture)
    assert more.total > plain.total + 0.9 * plain.vertex


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 3), st.floats(0, 2 * np.pi), st.floats(9, 40))
def test_a_vertex_moved_off_its_ink_never_saves(k, angle, far):
    picture = prism(SQUARE, SQUARE + DEPTH)
    moved = SQUARE.copy()
    moved[k] += far * np.array([np.cos(angle), np.sin(angle)])
    assert priced(Rings((moved,), (SQUARE + DEPTH,)), picture).total > priced(BOX, picture).total + 10


def test_a_foreign_stroke_costs_the_right_answer_and_the_wrong_one_alike():
    clean = prism(HEXAGON, HEXAGON + [110, -20])
    marked = line(clean.copy(), HEXAGON[0], [470, 380])
    right = Rings((HEXAGON,), (HEXAGON + [110, -20],))
    rise = priced(right, marked).total - priced(right, clean).total
    assert 5 < rise < 2.5 * (STROKE + STROKE_UNIT * 100)


@pytest.mark.parametrize("turn", [None, cv2.ROTATE_90_CLOCKWISE, cv2.ROTATE_180])
def test_turned_or_inverted_drawings_cost_the_same(turn):
    picture = prism(SQUARE, SQUARE + DEPTH)
    plain = priced(BOX, picture)
    if turn is None:
        assert priced(BOX, 255 - picture).total == pytest.approx(plain.total, abs=1.0)
        return
    h, w = picture.shape
    way = {
        cv2.ROTATE_90_CLOCKWISE: lambda p: np.c_[h - 1 - p[:, 1], p[:, 0]],
        cv2.ROTATE_180: lambda p: [w - 1, h - 1] - p,
    }[turn]
    rings = Rings((way(SQUARE),), (way(SQUARE + DEPTH),))
    assert priced(rings, cv2.rotate(picture, turn)).total == pytest.approx(plain.total, abs=3.0)


def test_foreign_paths_cost_by_length_until_a_stroke_tells_them_more_briefly():
    assert foreign_price(np.array([0.0, 2.0])).tolist() == [0.0, 2 * FOREIGN]
    assert foreign_price(np.array([100.0]))[0] == STROKE + 100 * STROKE_UNIT


def test_a_stroke_that_crosses_another_is_told_once():
    picture = prism(SQUARE, SQUARE + DEPTH)
    line(line(picture, SQUARE[0], SQUARE[2]), SQUARE[1], SQUARE[3])
    assert priced(BOX, picture).foreign < 2.2 * (STROKE + STROKE_UNIT * 60)


def test_a_line_that_runs_on_past_the_end_of_an_edge_is_half_told_by_that_edge():
    corner = SQUARE[2]
    on = priced(BOX, line(prism(SQUARE, SQUARE + DEPTH), corner, corner + [0.0, 60])).foreign
    aside = priced(BOX, line(prism(SQUARE, SQUARE + DEPTH), corner, corner + [42.0, 42])).foreign
    assert aside == pytest.approx(STROKE + STROKE_UNIT * 60 / 4, rel=0.15)
    assert aside - on == pytest.approx(0.5 * STROKE, rel=0.15)
    # where it ends at other lines it is no careless end but a part of something
    picture = line(prism(SQUARE, SQUARE + DEPTH), corner, corner + [0.0, 60])
    line(line(picture, corner + [0.0, 60], corner + [60.0, 80]), corner + [0.0, 60], corner + [-60.0, 80])
    assert priced(BOX, picture).foreign > on + 2.4 * STROKE


def test_the_nearest_edge_is_the_nearest_shown_part():
    a, span = np.array([[0.0, 0], [0, 10]]), np.array([[10.0, 0], [10, 0]])
    points = np.array([[2.0, 4], [8, 4], [12, 0]])
    distance, edge = nearest_edges(points, a, span)
    assert distance.tolist() == pytest.approx([4, 4, 2])
    assert edge.tolist() == [0, 0, 0]
    shown = np.array([[True, False], [True, True]])
    distance, edge = nearest_edges(points, a, span, shown)
    assert distance.tolist()[:2] == pytest.approx([4, 6])
    assert edge.tolist() == [0, 1, 1]


def test_more_noise_is_a_reason_only_near_the_noise_of_the_hand():
    view, offset = view_of(prism(SQUARE, SQUARE + DEPTH))
    off = Rings((SQUARE + 4,), (SQUARE + 4 + DEPTH,)).shifted(-offset)
    compared = compare(off, view, ALL, 4.0)
    assert compared.energy(10.0).noise > 1.0
    assert compared.energy(0.1).noise == view.noises[0]


@pytest.mark.parametrize(("pen", "most"), [(2, 2.5), (16, 4.0)])
def test_lines_of_a_thick_pen_may_bend_more(pen, most):
    view, offset = view_of(prism(SQUARE, SQUARE + DEPTH, width=pen))
    hand = 0.9
    off = Rings((SQUARE + 6,), (SQUARE + 6 + DEPTH,)).shifted(-offset)
    assert (view.noises > most * hand).any()
    assert compare(off, view, ALL, 4.0).energy(hand).noise == view.noises[view.noises <= most * hand][-1]


@pytest.mark.parametrize("noise", [1.5, 4.0])
def test_straying_ink_costs_by_the_square_of_its_distance_until_it_is_foreign(noise):
    view, offset = view_of(prism(SQUARE, SQUARE + DEPTH))
    compared = compare(BOX.shifted(-offset), view, ALL, 4.0)

    def at(distance):
        _, edge = compared.every
        return compared._ink((np.full(len(edge), distance), edge), noise)

    (on, nothing), (off, none), (_, foreign) = at(0.0), at(3.0 * noise), at(WITHIN * noise + BLUR + 0.01)
    lengths = view.length.sum() / max(view.pen, CORRELATED * view.size)
    assert off - on == pytest.approx(lengths * 4.5)  # half of three standard deviations squared
    assert (nothing, none) == (0.0, 0.0)
    assert foreign == pytest.approx(view.all_foreign)


def test_hidden_vertices_are_put_where_the_plainest_map_has_them():
    picture = prism(SQUARE, SQUARE + DEPTH, "removed")
    view, _ = view_of(picture)
    off = SQUARE + DEPTH
    off[3] += [25.0, 30]
    seen = np.array([True, True, True, False])
    energy = priced(Rings((SQUARE,), (off,)), picture, seen)
    placed = with_hidden(Rings((SQUARE,), (off,)), seen, energy, view.size)
    assert np.allclose(placed.back[0], SQUARE + DEPTH)
    assert np.array_equal(placed.front[0], SQUARE)
    careless = SQUARE + DEPTH
    careless[0] += [3.0, 2]
    lost = careless.copy()
    lost[3] += 30
    # a careless hand is no reason for a map that turns or shrinks
    assert np.abs(with_hidden(Rings((SQUARE,), (lost,)), seen, energy, view.size).back[0][3] - careless[3]).max() < 2
    tapered = shrunk(SQUARE, 0.6, np.array([400.0, 60]))
    lost = tapered.copy()
    lost[3] += 30
    assert np.allclose(with_hidden(Rings((SQUARE,), (lost,)), seen, energy, view.size).back[0], tapered, atol=1e-6)


def test_what_is_all_drawn_or_tells_too_little_stays_as_it_is():
    energy = priced(BOX, prism(SQUARE, SQUARE + DEPTH))
    off = Rings((SQUARE,), (SQUARE + 1.3 * DEPTH + np.arange(8).reshape(4, 2),))
    for seen in (ALL, np.array([True, False, False, False])):
        assert with_hidden(off, seen, energy, 400.0) is off
