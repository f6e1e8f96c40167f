import pytest

from sketch2shape.ink.kernels import square


@pytest.mark.parametrize(("size", "side"), [(0.0, 1), (1.9, 1), (2.0, 3), (3.9, 3), (4.0, 5)])
def test_a_square_has_a_centre(size, side):
    assert square(size).shape == (side, side)
    assert square(size).all()
