"""Corners from strokes that are known exactly."""

import numpy as np
import pytest

from sketch2shape.strokes.junctions import crossed, join_ends
from sketch2shape.strokes.tracing import Strokes


def corners_of(*segments, pen=2.0, tolerance=1.5):
    ends = np.array(segments, float).reshape(-1, 2, 2)
    return join_ends(Strokes(ends, np.ones(len(ends)), tolerance), pen)


def at(corners, point, within=1e-6):
    gap = np.linalg.norm(corners.points - point, axis=1)
    return int(gap.argmin()) if gap.min() <= within else None


def test_two_strokes_that_stop_short_of_each_other_meet_on_both_lines():
    corners = corners_of([[0, 0], [97, 0]], [[100, 3], [100, 90]])
    k = at(corners, [100, 0], 1e-3)
    assert k is not None
    assert corners.degree[k] == 2
    assert sorted(corners.degree) == [1, 1, 2]
    assert not corners.on.any()


def test_a_crossing_is_no_corner():
    corners = corners_of([[0, 50], [100, 50]], [[50, 0], [50, 100]])
    assert at(corners, [50, 50], 10) is None
    assert corners.degree.tolist() == [1] * 4


def test_an_end_on_a_stroke_is_one_end_that_lies_on_it():
    corners = corners_of([[0, 50], [100, 50]], [[50, 52], [50, 100]])
    k = at(corners, [50, 52], 3)
    assert corners.degree[k] == 1
    assert corners.on.tolist().count(True) == 1
    assert corners.on[k]


def test_three_strokes_meet_once_and_know_it():
    corners = corners_of([[100, 102], [100, 200]], [[98, 100], [0, 100]], [[101.5, 98.5], [170, 30]])
    k = at(corners, [100, 100], 0.1)
    assert corners.degree[k] == 3
    assert corners.strokes.shape == (3, 2)
    assert (corners.strokes == k).sum() == 3


def test_strokes_that_end_side_by_side_but_point_past_each_other_do_not_meet():
    corners = corners_of([[0, 0], [100, 0]], [[104, 14], [200, 14]])
    assert corners.degree.tolist() == [1] * 4


def test_the_two_ends_of_one_short_stroke_stay_two_corners():
    corners = corners_of([[0, 0], [100, 0]], [[100, 0], [106, 8]], [[106, 8], [106, 100]])
    first, second = corners.strokes[1]
    assert first != second


def test_nearly_parallel_strokes_meet_between_their_ends_and_not_far_away():
    corners = corners_of([[0, 0], [100, 0]], [[103, 0.2], [200, 3]])
    k = int(np.argmax(corners.degree))
    assert corners.degree[k] == 2
    assert corners.points[k] == pytest.approx([101.5, 0], abs=3)


def test_no_strokes_have_no_corners():
    corners = corners_of()
    assert corners.points.shape == (0, 2)
    assert corners.strokes.shape == (0, 2)


def test_strokes_cross_only_where_both_run_on():
    ends = np.array([[[0, 50], [100, 50]], [[50, 0], [50, 100]], [[80, 46], [80, 100]], [[0, 53], [100, 53]]], float)
    points = crossed(Strokes(ends, np.ones(4), 1.0), 3.0)
    assert np.allclose(sorted(map(tuple, points)), [(50, 50), (50, 53), (80, 53)])
