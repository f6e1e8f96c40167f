"""How much of any ink an object would explain by chance."""

import numpy as np
import pytest
from sketches import DEPTH, SQUARE

from sketch2shape.evidence import coverage, is_crowded, near_line
from sketch2shape.evidence.coverage import CROWDED
from sketch2shape.hypotheses import Rings

SIDES = SQUARE, np.roll(SQUARE, -1, axis=0) - SQUARE
BOX = Rings((SQUARE,), (SQUARE + DEPTH,))


@pytest.mark.parametrize("noise", [2.0, 5.0, 9.0])
def test_the_sides_of_a_square_reach_a_frame_of_it(noise):
    inner = 1.0 - 2.0 * near_line(noise) / 150.0
    assert coverage(*SIDES, noise) == pytest.approx(1.0 - max(inner, 0.0) ** 2, abs=0.08)


def test_lines_that_reach_everything_explain_anything():
    assert not is_crowded(*BOX.segments, 0.5)
    assert coverage(*BOX.segments, 100.0) == 1.0
    flat = Rings((SQUARE * [1.0, 0.05],), (SQUARE * [1.0, 0.05] + [20.0, 3.0],))
    assert is_crowded(*flat.segments, 2.0)


@pytest.mark.parametrize("scale", [0.5, 3.0])
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_it_depends_on_neither_size_nor_direction(scale, turn):
    c, s = np.cos(turn), np.sin(turn)
    start, span = (scale * both @ np.array([[c, s], [-s, c]]) for both in BOX.segments)
    assert coverage(start, span, 3.0 * scale) == pytest.approx(coverage(*BOX.segments, 3.0), abs=0.06)


def test_lines_without_an_inside_reach_all_of_it():
    along = np.array([[0.0, 0.0], [100.0, 0.0]]), np.array([[100.0, 0.0], [100.0, 0.0]])
    assert coverage(*along, 0.5) == 1.0 > CROWDED
