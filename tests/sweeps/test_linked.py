"""Pieces of a line that gaps have parted are put together, and others are not."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.sweeps.linked import linked

SIZE, PEN = 400.0, 2.0


def arc(begin, end, radius=100.0, at=(150.0, 150.0)):
    angle = np.linspace(begin, end, max(int(radius * abs(end - begin)), 5))
    return np.rint(np.stack([np.cos(angle), np.sin(angle)], axis=1) * radius + at).astype(np.int32)


def straight(a, b):
    n = int(np.hypot(*np.subtract(b, a)))
    return np.rint(np.linspace(a, b, n)).astype(np.int32)


@given(st.permutations(range(6)), st.lists(st.booleans(), min_size=6, max_size=6))
def test_a_dashed_arc_is_one_line_in_whatever_order_and_way_its_dashes_come(order, turned):
    dashes = [arc(0.4 * k, 0.4 * k + 0.35) for k in range(6)]
    (line,) = linked([dashes[k][::-1] if turned[k] else dashes[k] for k in order], SIZE, PEN)
    angle = np.arctan2(line[:, 1] - 150, line[:, 0] - 150)
    assert len(line) == sum(map(len, dashes))
    assert (np.diff(angle) > -0.02).all() or (np.diff(angle) < 0.02).all()


def test_a_dashed_circle_is_one_line():
    step = 2 * np.pi / 16
    (line,) = linked([arc(step * k, step * k + 0.34) for k in range(16)], SIZE, PEN)
    assert np.hypot(*np.diff(line, axis=0).T).max() < 8


@pytest.mark.parametrize(
    "other",
    [
        straight([110, 10], [110, 60]),  # turns off at the end
        straight([120, 10], [200, 10]),  # too far behind a gap
        straight([104, 16], [180, 16]),  # beside it
        straight([104, 10], [105, 10]),  # too short to head anywhere
    ],
)
def test_what_does_not_go_on_is_another_line(other):
    assert linked([straight([10, 10], [100, 10]), other], SIZE, PEN) == []


def test_of_two_that_go_on_the_nearer_does():
    near, far = straight([103, 10], [160, 10]), straight([106, 11], [160, 11])
    (line,) = linked([straight([10, 10], [100, 10]), far, near], SIZE, PEN)
    assert line[-1].tolist() == [160, 10]
