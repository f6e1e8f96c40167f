"""Rings of lines and arcs as they are seen."""

import numpy as np
import pytest
from round_sketches import FACING, UPRIGHT, arch, ellipse, half_disc

from sketch2shape.sweeps.outlines import Frame, ellipse_through, in_one_frame, polygon


def test_a_half_circle_bulges_by_one():
    line = half_disc().line
    arc = line[:24]
    assert np.hypot(*(arc - [210, 240]).T) == pytest.approx(90)
    assert arc[:, 1].min() == pytest.approx(150, abs=1e-6)


def test_a_whole_ellipse_keeps_the_ratio_of_its_frame():
    wide, high = np.ptp(ellipse().line, axis=0)
    assert high / wide == pytest.approx(0.4, abs=1e-3)
    ((edge, (centre, axes, angle)),) = ellipse().ellipses()
    assert (edge, axes, angle) == (0, pytest.approx((90, 36)), pytest.approx(0))
    assert centre == pytest.approx([240, 120])


def test_numbers_of_rings():
    # two a vertex, one for the arc, and each smooth joint takes one back
    assert arch().numbers == 8 + 1 - 2
    assert half_disc().numbers == 4 + 1
    assert ellipse().numbers == 3
    assert polygon(np.eye(3)[:, :2]).numbers == 6


@pytest.mark.parametrize("ring", [arch(), half_disc(UPRIGHT), ellipse()], ids=["arch", "half", "ellipse"])
def test_moving_a_ring_moves_its_line(ring):
    by, centre = np.array([13.0, -7.0]), np.array([50.0, 60.0])
    assert ring.shifted(by).line == pytest.approx(ring.line + by)
    assert ring.moved(centre, 0.5).line == pytest.approx(centre + 0.5 * (ring.line - centre))


def test_a_ring_turns_at_its_corners_and_not_at_smooth_joints():
    assert arch().turns == pytest.approx([0, 0, np.pi / 2, np.pi / 2], abs=0.08)
    assert FACING.flat(FACING.seen(np.array([[3.0, 4.0]]))) == pytest.approx(np.array([[3.0, 4.0]]))


def test_circles_of_one_face_are_told_in_one_frame():
    flatter = Frame(UPRIGHT.along, 0.3)
    large, small = in_one_frame((ellipse(radius=90.0), ellipse(y=130.0, radius=20.0, frame=flatter)))
    assert small.frame == large.frame == UPRIGHT
    assert small.middle == pytest.approx([240, 130])
    assert np.ptp(small.line[:, 0]) == pytest.approx(40, rel=1e-3)


def test_a_ring_is_carried_vertex_by_vertex():
    ring = arch()
    moved = ring.carried(lambda p: 0.1 * p)
    assert moved.vertices == pytest.approx(1.1 * ring.vertices)
    assert moved.bulges == pytest.approx(ring.bulges)


def test_an_arc_is_carried_by_its_top_too():
    ring = arch()
    # the half circle on top is drawn out upwards
    moved = ring.carried(lambda p: np.stack([0.0 * p[:, 0], 0.5 * (p[:, 1] - 180)], axis=1))
    assert moved.vertices[:2] == pytest.approx(ring.vertices[:2])
    assert np.abs(moved.bulges) == pytest.approx([1.5, 0, 0, 0], rel=1e-2)
    assert moved.line[:, 1].min() == pytest.approx(90, abs=0.5)


def test_the_ellipse_through_points_has_their_axes():
    leaning = Frame(np.array([0.6, 0.8]), 0.5)
    told = ellipse_through(ellipse(radius=80.0, frame=leaning).line)
    assert abs(float(told.frame.along @ leaning.along)) == pytest.approx(1.0, abs=1e-4)
    assert told.frame.ratio == pytest.approx(0.5, abs=1e-3)
    assert told.middle == pytest.approx([240, 120], abs=0.1)
    assert told.circle.radius == pytest.approx(80, abs=0.1)
