"""The front face laid flat reads as the drawing shows it, whichever way the solid is held."""

import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model import TwoFaceObject
from sketch2shape.solids import front_outline

#: an L whose mirror image is another face: foot at the right, y down
L_SHAPE = np.array([[0, 0], [60, 0], [60, 140], [180, 140], [180, 200], [0, 200.0]])
OBLIQUE = TwoFaceObject(L_SHAPE + 100, L_SHAPE + 100 + [50, -50])


@pytest.mark.parametrize("options", [{}, {"up": "y"}, {"up": "camera"}, {"depth_ratio": 1.0}, {"necker": True}])
def test_a_front_seen_from_before_is_laid_as_drawn(options):
    (flat,) = front_outline(lift(OBLIQUE, options=LiftOptions(**options)))
    ring = flat.points
    assert ring - ring[0] == pytest.approx(L_SHAPE, abs=1e-6)


def test_a_face_that_lies_on_top_is_seen_from_above():
    a, e = np.deg2rad([35.0, 40.0])
    x, y = L_SHAPE.T
    right, away = np.cos(a) * x - np.sin(a) * y, np.sin(a) * x + np.cos(a) * y
    top = np.c_[right, away * np.sin(e)] + 300
    (flat,) = front_outline(lift(TwoFaceObject(top, top + [0, 150.0])))
    ring = flat.points
    x, y = ring.T
    area = 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))
    assert area > 0  # turns as it was drawn, not mirrored
    assert np.ptp(ring, axis=0).max() == pytest.approx(200, rel=0.05)
