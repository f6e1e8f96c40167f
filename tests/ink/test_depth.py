"""Depth: the distance to what is no ink."""

import numpy as np
import pytest

from sketch2shape.ink import depth_of


def test_the_middle_of_a_stroke_is_the_deepest_and_beyond_the_border_is_no_ink():
    mask = np.zeros((40, 60), bool)
    mask[10:21] = True
    assert depth_of(mask)[15, 30] == pytest.approx(6.0, abs=0.2)
    assert depth_of(mask)[30].max() == 0
    assert depth_of(mask[10:21])[5, 30] == pytest.approx(6.0, abs=0.2)
