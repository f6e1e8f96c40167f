from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.find import find_ink
from sketch2shape.model.picture import Picture


def drawing(ground: int = 255, ink: int = 0, width: int = 2, size: tuple[int, int] = (320, 400)) -> np.ndarray:
    """A box outline with a diagonal, RGB."""
    image = np.full((*size, 3), ground, np.uint8)
    cv2.rectangle(image, (80, 60), (300, 240), (ink,) * 3, width)
    cv2.line(image, (80, 60), (300, 240), (ink,) * 3, width)
    return image


@pytest.mark.parametrize(("ground", "ink"), [(255, 0), (255, 200), (30, 255), (30, 120), (200, 90)])
def test_every_polarity_and_contrast_gives_the_same_ink(ground: int, ink: int) -> None:
    found = find_ink(Picture(drawing(ground, ink)))
    assert np.array_equal(found.mask, drawing(255, 0)[..., 0] < 128)


@pytest.mark.parametrize("width", [1, 3, 5, 9])
def test_pen_width_is_the_drawn_width(width: int) -> None:
    image = np.full((320, 400, 3), 255, np.uint8)
    image[60 : 60 + width, 50:300] = image[50:250, 120 : 120 + width] = 0
    assert find_ink(Picture(image)).pen_width == pytest.approx(width, abs=0.8)


def test_blank_paper_has_no_ink() -> None:
    found = find_ink(Picture(np.full((200, 300, 3), 250, np.uint8)))
    assert not found.mask.any()
    assert found.pen_width >= 1.0
