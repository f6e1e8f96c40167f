"""How deep inside closed lines places lie."""

import numpy as np
import pytest

from sketch2shape.sweeps.insides import MOST_SIDE, Inside

SQUARE = np.array([[10.0, 10], [50, 10], [50, 50], [10, 50]])
HOLE = np.array([[24.0, 24], [36, 24], [36, 36], [24, 36]])


@pytest.mark.parametrize(("point", "deep"), [((20, 30), 10.0), ((30, 45), 5.0), ((5, 30), 0.0), ((300, -8), 0.0)])
def test_depth_is_the_distance_to_the_border(point, deep):
    assert Inside.of([SQUARE]).at(np.array(point, float)) == pytest.approx(deep, abs=1.5)


def test_holes_are_outside():
    inside = Inside.of([SQUARE, HOLE])
    assert inside.holds(np.array([[17.0, 30], [30, 30], [43, 30]]), 2.0).tolist() == [True, False, True]


def test_the_margin_is_kept():
    inside = Inside.of([SQUARE])
    assert inside.holds(np.array([[20.0, 30]]), 5.0)
    assert not inside.holds(np.array([[20.0, 30]]), 12.0)


def test_a_shape_larger_than_any_drawing_takes_no_more_memory():
    huge = np.array([[0.0, 0], [3e5, 0], [3e5, 3e5], [0, 3e5]])
    inside = Inside.of([huge])
    assert max(inside.depth.shape) == MOST_SIDE
    assert inside.holds(np.array([[50.0, 60.0], [-50.0, 60.0], [2e5, 2e5]]), 3.0).tolist() == [True, False, False]
