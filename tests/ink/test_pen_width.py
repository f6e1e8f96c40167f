from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.pen_width import pen_width_of, rough_pen_width


def stroke(width: float, angle: float) -> np.ndarray:
    """A stroke of exact width, drawn large and averaged down."""
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    corners = np.array([[-40, -width / 2], [40, -width / 2], [40, width / 2], [-40, width / 2]])
    turned = corners @ np.array([[c, s], [-s, c]]) + 50
    big = np.zeros((800, 800), np.uint8)
    cv2.fillPoly(big, [np.round(turned * 8).astype(np.int32)], 255)
    return cv2.resize(big, (100, 100), interpolation=cv2.INTER_AREA) > 127


@pytest.mark.parametrize("angle", [0, 20, 45, 80])
@pytest.mark.parametrize("width", [2, 5, 9, 15])
def test_width_at_any_angle(width: int, angle: int) -> None:
    assert pen_width_of(stroke(width, angle)) == pytest.approx(width, abs=1.0)
    assert rough_pen_width(stroke(width, angle)) == pytest.approx(width, rel=0.45)


def test_no_ink() -> None:
    assert pen_width_of(np.zeros((5, 5), bool)) == rough_pen_width(np.zeros((5, 5), bool)) == 1.0
