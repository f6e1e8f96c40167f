import numpy as np
import pytest

from sketch2shape.lifting import choose_front
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [200, 100], [200, 160], [100, 160.0]])


@pytest.mark.parametrize("d", [[50, -40], [-50, -40], [60, 0]])
def test_wireframe_is_seen_from_above(d):
    obj = TwoFaceObject(FACE, FACE + d)
    assert choose_front(obj) is obj
    assert np.array_equal(choose_front(obj.swapped()).f1, FACE)


def test_upright_wireframe_shows_its_top():
    top = np.array([[100, 100], [180, 140], [100, 180], [20, 140.0]])
    for lean in (0, 4):
        obj = TwoFaceObject(top, top + [lean, 120])
        assert choose_front(obj) is obj
        assert np.array_equal(choose_front(obj.swapped()).f1, top)


def test_hidden_lines_have_already_told():
    obj = TwoFaceObject(FACE, FACE + [50, 40], lines="dashed")
    assert choose_front(obj) is obj


def test_smaller_cap_is_farther():
    obj = TwoFaceObject(FACE, 0.7 * FACE + [120, 90])
    assert choose_front(obj) is obj
    assert np.array_equal(choose_front(obj.swapped()).f1, FACE)
