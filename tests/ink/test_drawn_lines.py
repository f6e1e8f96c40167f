"""The ink of a vector drawing: the same whatever the order, the unit or the place of its lines."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON
from solid_lines import prism_lines

from sketch2shape.ink import find_ink, split_groups
from sketch2shape.ink.drawn_lines import BY_HAND, DASH, GAP, RULED, ink_of_lines, strokes_of
from sketch2shape.model import VectorDrawing, VectorLine
from sketch2shape.reading.sheet import picture_of


def ink(lines):
    return ink_of_lines(VectorDrawing(tuple(lines), (800, 600)))


def test_the_mask_has_the_working_size_whatever_the_unit():
    lines = prism_lines(HEXAGON, HEXAGON + DEPTH)
    small, large = (ink([line.mapped(np.array([7.0, -9.0]), s) for line in lines]) for s in (0.05, 20.0))
    assert np.array_equal(small.mask, large.mask)
    y, x = np.nonzero(small.mask)
    assert abs(np.hypot(np.ptp(x), np.ptp(y)) - RULED) < 8


def test_working_pixels_and_own_coordinates_go_both_ways():
    lines = prism_lines(HEXAGON, HEXAGON + DEPTH)
    found = ink(lines)
    own = np.concatenate([found.to_picture(line.points) for line in found.lines])
    given = np.concatenate([line.points for line in lines])
    assert np.allclose(np.unique(own.round(6), axis=0), np.unique(given.round(6), axis=0))
    assert np.allclose(found.to_working(found.to_picture(given)), given)


def test_order_and_direction_do_not_matter():
    lines = prism_lines(HEXAGON, HEXAGON + DEPTH)
    other = ink([VectorLine(line.points[::-1], line.dashed) for line in reversed(lines)])
    assert all(np.array_equal(a.points, b.points) for a, b in zip(ink(lines).lines, other.lines, strict=True))


def test_dashes_reach_both_ends_and_leave_gaps():
    line = VectorLine(np.array([[0.0, 0], [60, 0], [60, 61]]), dashed=True)
    dashes = strokes_of(line)
    assert dashes[0][0].tolist() == [0, 0]
    assert np.allclose(dashes[-1][-1], [60, 61])
    assert len(dashes) == round((121 + GAP) / (DASH + GAP))
    drawn = sum(float(np.linalg.norm(np.diff(d, axis=0), axis=1).sum()) for d in dashes)
    assert 0.5 < drawn / 121 < 0.7
    assert strokes_of(VectorLine(line.points)) == [line.points]


def test_a_short_dashed_line_is_one_dash():
    assert len(strokes_of(VectorLine(np.array([[0.0, 0], [3, 0]]), dashed=True))) == 1


def test_two_objects_are_two_groups_with_lines_of_their_own_and_dashes_are_not_solid():
    one = prism_lines(HEXAGON, HEXAGON + DEPTH, "dashed")
    other = [line.mapped(np.array([-700.0, 0.0]), 1.0) for line in one]
    groups = split_groups(find_ink(picture_of([*one, *other])))
    assert len(groups) == 2
    for group in groups:
        assert len(group.ink.lines) == len(one)
        assert sum(line.dashed for line in group.ink.lines) == sum(line.dashed for line in one)
        for line in group.ink.lines:
            x, y = np.rint(line.points.mean(axis=0)).astype(int)
            assert group.solid[y, x] == (not line.dashed)


def test_no_lines_are_no_ink():
    assert not ink([]).mask.any()
    assert split_groups(ink([])) == []


def test_lines_of_a_hand_get_a_smaller_working_size():
    def wavy(line):
        t = np.linspace(0, 1, 60)[:, None]
        a, b = line.points
        side = np.array([a[1] - b[1], b[0] - a[0]]) / np.linalg.norm(b - a)
        return VectorLine(a + t * (b - a) + np.sin(20 * t) * side)

    lines = prism_lines(HEXAGON, HEXAGON + DEPTH)
    assert ink([wavy(line) for line in lines]).scale / ink(lines).scale == pytest.approx(BY_HAND / RULED, abs=0.02)
    in_pieces = [VectorLine(np.linspace(*line.points, 40)) for line in lines]
    assert ink(in_pieces).scale == ink(lines).scale


def test_dashes_and_curves_of_a_program_do_not_make_a_hand():
    lines = prism_lines(HEXAGON, HEXAGON + DEPTH)
    turn = np.linspace(0, 6, 50)
    curve = VectorLine(200 + 70 * np.c_[np.cos(turn), np.sin(turn)], curved=True)
    dashes = [VectorLine(np.array([[x, 200], [x + 4, 201], [x + 8, 200.0]])) for x in range(130, 300, 15)]
    assert ink([*lines, curve, *dashes]).scale == ink(lines).scale
