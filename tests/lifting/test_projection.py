import numpy as np
import pytest

from sketch2shape.lifting import lift
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [260, 100], [260, 200], [180, 240], [100, 200.0]])


def test_a_tilted_page_is_rectified_first():
    tilt = np.array([[1.0, 0.1, 5.0], [0.05, 1.1, -8.0], [2e-4, 3e-4, 1.0]])

    def seen(points):
        flat = np.c_[points, np.ones(len(points))] @ np.linalg.inv(tilt).T
        return flat[:, :2] / flat[:, 2:]

    back = FACE + [70, -40]
    straight = lift(TwoFaceObject(FACE, back))
    tilted = lift(TwoFaceObject(seen(FACE), seen(back), page=tilt))
    assert tilted.projection.family == "oblique"
    scale = np.linalg.norm(np.ptp(straight.vertices, axis=0)) / np.linalg.norm(np.ptp(tilted.vertices, axis=0))
    assert tilted.volume * scale**3 == pytest.approx(straight.volume, rel=1e-3)
    assert tilted.vertices.shape == (10, 3)


def test_a_page_that_makes_no_sense_is_ignored():
    broken = np.array([[1.0, 0, 0], [0, 1, 0], [0.01, 0, -1.8]])
    plain = TwoFaceObject(FACE, FACE + [70, -40])
    odd = TwoFaceObject(FACE, FACE + [70, -40], page=broken)
    assert lift(odd).vertices == pytest.approx(lift(plain).vertices)
