"""Rivals: the closer another object comes, the less sure an answer is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.evidence import against_rivals, rivalry

SURE = st.floats(0.0, 1.0)


def test_a_rival_that_costs_as_little_comes_closest():
    near = [rivalry(gap, 400.0) for gap in (-5.0, 0.0, 20.0, 200.0, np.inf)]
    assert near[0] == near[1] == 1.0
    assert near[1] > near[2] > near[3] > near[4] == 0.0
    assert rivalry(80.0, 400.0) == pytest.approx(np.exp(-1.0))


def test_the_same_gap_says_more_where_there_is_little_ink():
    assert rivalry(20.0, 1000.0) > rivalry(20.0, 100.0)
    assert rivalry(1.0, 0.0) == 0.0


@given(SURE, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_closer_rivals_never_make_an_answer_surer(alone, near, nearer):
    near, nearer = sorted((near, nearer))
    assert 0.0 < against_rivals(alone, nearer) <= against_rivals(alone, near) < 1.0


@given(SURE, SURE, st.floats(0.0, 1.0))
def test_what_is_surer_alone_is_surer_beside_a_rival(one, other, rival):
    one, other = sorted((one, other))
    assert against_rivals(one, rival) <= against_rivals(other, rival)


def test_a_sure_answer_with_a_rival_as_cheap_is_no_longer_sure():
    assert against_rivals(0.96, 0.0) > 0.9
    assert against_rivals(0.96, 1.0) < 0.9
