"""What a drawing of a sweep shows, and what it hides."""

from dataclasses import replace

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, PYRAMID, TUBE, ellipse

from sketch2shape.sweeps import Sweep, Way, redraw, seen_vertices


def parts(sweep):
    """Share of the sampled length that is seen, on the border, hidden."""
    made = redraw(sweep, 2.0, 3.0)
    return np.bincount(made.depth, made.length, 3) / made.length.sum()


def test_the_far_half_of_a_cylinders_bottom_is_hidden():
    made = redraw(CYLINDER, 2.0, 3.0)
    bottom = (made.depth == 2) & (made.points[:, 1] > 200)
    assert (made.points[bottom, 1] < 270).all()
    rim = np.abs(made.points[:, 0] - 240) < 60
    far = rim & (np.abs(made.points[:, 1] - 240) < 8)
    near = rim & (made.points[:, 1] > 300)
    assert (made.depth[far] == 2).all()
    assert (made.depth[near] == 0).all()


def test_silhouettes_touch_both_rims():
    (a, b) = redraw(CYLINDER, 2.0, 3.0).silhouettes
    xs = sorted([a[0, 0], b[0, 0]])
    assert xs == pytest.approx([150, 330], abs=4)
    assert (a[1] - a[0]).tolist() == pytest.approx([0, 150])


def test_a_tubes_inner_side_is_hidden_but_for_its_rim():
    assert parts(TUBE)[2] > 1.5 * parts(CYLINDER)[2]


def test_a_deep_hole_shows_nothing_of_its_far_rim_and_a_shallow_one_does():
    def seen(depth):
        made = redraw(Sweep((ellipse(), ellipse(radius=60.0)), Way(np.array([0.0, depth]))), 2.0, 2.0)
        at = made.points - [240, 120 + depth]
        rim = np.abs((at[:, 0] / 60) ** 2 + (at[:, 1] / 24) ** 2 - 1) < 0.05
        return (made.depth[rim] == 0).mean()

    assert seen(150.0) == 0
    assert seen(12.0) > 0.3


def test_the_back_of_a_cones_base_is_hidden_from_above_and_seen_from_below():
    made = redraw(CONE, 2.0, 3.0)
    back = (made.points[:, 1] < 262) & (made.points[:, 1] > 240) & (np.abs(made.points[:, 0] - 240) < 55)
    rim = np.abs(((made.points - [240, 280]) / [90, 36]) ** 2 @ [1, 1] - 1) < 0.02
    assert (made.depth[back & rim] == 2).all()
    below = Sweep(CONE.rings, CONE.way, is_near=True)
    assert (redraw(below, 2.0, 3.0).depth[: len(CONE.rings[0].line)] == 0).all()


def test_numbers_of_sweeps():
    assert CYLINDER.shape_numbers == 3 + 1
    assert PYRAMID.shape_numbers == 8
    assert [CYLINDER.way.numbers, CONE.way.numbers, Way(np.zeros(2), np.zeros(2), 0.5).numbers] == [2, 2, 3]


def test_reversing_twice_changes_nothing():
    again = ARCH.reversed().reversed()
    assert again.rings[0].line == pytest.approx(ARCH.rings[0].line)
    assert again.way.shift.tolist() == ARCH.way.shift.tolist()


def test_vertices_of_the_back_that_the_front_hides():
    seen = seen_vertices(ARCH, 3.0)
    # the arch goes up and to the right: its left corners lie behind it
    assert seen.tolist() == [False, True, True, False]


def test_a_shift_in_perspective_grows_from_its_origin_and_returns():
    way = Way(np.array([40.0, -30]), slope=np.array([0.0, 1e-3]), origin=np.array([200.0, 200]))
    points = np.array([[200.0, 200], [200, 300]])
    assert way.of(points) == pytest.approx(np.array([[40.0, -30], [44, -33]]))
    there = points + way.of(points)
    assert there + way.back().of(there) == pytest.approx(points, abs=1.0)
    assert way.moved(np.array([7.0, 5])).of(points + [7, 5]) == pytest.approx(way.of(points))
    assert way.numbers == 4


def test_lines_at_smooth_joints_are_drawn_where_that_is_the_manner():
    plain, told = (redraw(replace(ARCH, tangents=drawn), 3.0, 3.0) for drawn in (False, True))
    assert told.length.sum() - plain.length.sum() == pytest.approx(2 * np.hypot(*ARCH.way.shift), rel=1e-6)


def test_a_way_with_a_centre_may_be_seen_in_perspective():
    way = Way(np.zeros(2), np.array([240.0, -600]), 0.8, np.array([0.0, 1e-3]), np.array([240.0, 120]))
    near, far = way.of(np.array([[240.0, 120], [240.0, 220]]))
    assert near == pytest.approx([0.0, -0.2 * 720])
    # a quarter of the rest, and a tenth more of that
    assert far == pytest.approx([0.0, -820 * 0.275 / 1.275])
    assert way.numbers == 5
    assert way.moved(np.array([7.0, 5])).of(np.array([[247.0, 125]]))[0] == pytest.approx(near)
    # what would come from behind the eye
    assert np.isfinite(way.of(np.array([[240.0, -5000]]))).all()


def test_a_shift_in_perspective_returns_exactly():
    way = Way(np.array([40.0, -30]), slope=np.array([2e-3, 1e-3]), origin=np.array([200.0, 200]))
    points = np.array([[200.0, 200], [200, 300], [90, 20]])
    there = points + way.of(points)
    assert there + way.back().of(there) == pytest.approx(points)


def test_the_image_in_perspective_of_a_circle_is_the_ellipse_of_its_points():
    way = Way(np.zeros(2), np.array([240.0, -600]), 0.8, np.array([3e-4, 1e-3]), np.array([240.0, 120]))
    swept = Sweep((ellipse(),), way)
    there = swept.rings[0].line + way.of(swept.rings[0].line)
    image = swept.image(swept.rings[0])
    assert np.hypot(*(image.line[:, None] - there).transpose(2, 0, 1)).min(axis=1).max() < 3.0
    x, y = image.frame.flat(there - image.middle).T
    assert np.hypot(x, y) == pytest.approx(np.full(len(there), image.circle.radius), rel=1e-4)
    assert image.frame.ratio != pytest.approx(0.4, abs=0.02)
