"""Ruled lines: segments and corners of a vector drawing, and which drawings have none."""

import numpy as np
import pytest

from sketch2shape.model import VectorLine
from sketch2shape.strokes.ruled_lines import MOST, ruled_lines


def told(*lines, dashed=(), curved=()):
    return ruled_lines(
        [VectorLine(np.array(p, float), dashed=k in dashed, curved=k in curved) for k, p in enumerate(lines)]
    )


TRIANGLE = [(0, 0), (100, 0)], [(100, 0), (40, 80)], [(40, 80), (0, 0)]


def test_ends_that_meet_are_one_corner():
    found = told(*TRIANGLE)
    assert len(found.corners) == 3
    assert found.joined.sum() == 6
    assert found.ways.tolist() == [2, 2, 2]
    assert not found.is_cut.any()


def test_a_pull_round_a_face_is_cut_at_its_corners():
    found = told([(0, 0), (50, 0), (100, 0), (40, 80), (0, 0)])
    assert len(found.pieces) == 3
    assert len(found.corners) == 3


def test_pieces_of_one_line_that_touch_are_one_segment():
    found = told([(0, 0), (60, 0)], [(100, 0), (60, 0)], *TRIANGLE[1:], dashed=[1])
    assert len(found.pieces) == 4
    assert found.dashed.tolist() == [False, True, False, False]
    assert len(found.ends) == 3
    assert len(found.corners) == 3


def test_a_line_that_ends_on_another_is_cut_there():
    found = told(*TRIANGLE, [(40, 80), (40, 0)])
    cut = found.corners[found.is_cut]
    assert np.allclose(cut, [[40, 0]])
    assert sorted(found.ways.tolist()) == [2, 2, 3, 3]
    assert found.joined.sum() == 2 * 6


@pytest.mark.parametrize(
    "lines",
    [
        [],
        [[(0, 0), (0.2, 0)]],
        [*TRIANGLE, [(100, 0), (150, 50)]],  # ends in the middle of nowhere
        [[(0, 0), (30, 20), (60, 20)], [(0, 0), (100, 0)]],
        [[(x, 0), (x, 50)] for x in range(MOST + 1)],
        [[(0, 0), (100, 0)], [(100, 0.2), (150, 0.25)], [(150, 0.25), (190, 0.5)], [(190, 0.5), (9, 9), (0, 0)]],
    ],
)
def test_other_drawings_are_none(lines):
    assert told(*lines) is None


def test_a_curve_is_none():
    assert told(*TRIANGLE, curved=[1]) is None
