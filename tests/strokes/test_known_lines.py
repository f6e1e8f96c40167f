"""Paths of known lines: every place once, to a part of a pixel."""

import numpy as np

from sketch2shape.model import VectorLine
from sketch2shape.strokes.known_lines import known_paths

SHAPE = (200, 200)


def paths(*lines):
    return known_paths([VectorLine(np.array(line, float)) for line in lines], SHAPE)


def test_points_lie_a_pixel_apart_along_the_longer_axis():
    (path,) = paths([[10, 10], [110.4, 60.2]])
    assert len(path) == 101
    assert np.allclose(np.diff(path[:, 0]), 1.004)
    assert path[[0, -1]].tolist() == [[10, 10], [110.4, 60.2]]


def test_an_edge_drawn_twice_counts_once():
    again = paths([[10, 10], [110, 10]], [[110, 10], [10, 10]])
    assert len(again) == 1
    half = paths([[10, 10], [110, 10]], [[60, 10], [160, 10]])
    assert 148 < sum(map(len, half)) < 153


def test_crossings_leave_both_lines_whole():
    across = paths([[10, 50], [110, 50]], [[60, 10], [60, 110]], [[20, 20], [100, 90]])
    assert len(across) == 3


def test_two_faces_that_share_an_edge():
    left = [[20, 20], [100, 20], [100, 100], [20, 100], [20, 20]]
    right = [[100, 20], [180, 20], [180, 100], [100, 100], [100, 20]]
    assert abs(sum(map(len, paths(left, right))) - 7 * 80) < 12


def test_a_dot_is_a_path_of_two_points():
    (dot,) = paths([[50, 50], [50.2, 50.1]])
    assert len(dot) == 2
    (single,) = paths([[50, 50]])
    assert len(single) == 2
