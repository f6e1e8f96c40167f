from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink import find_ink
from sketch2shape.model import Picture
from sketch2shape.page import page_homography


def photo(quad: list[list[float]], light: float = 0.0) -> np.ndarray:
    """A square drawn on a tilted light page on a brown table; `light` darkens the page from left to right."""
    image = np.full((360, 480, 3), (110, 90, 70), np.uint8)
    corners = np.array(quad, np.float32)
    cv2.fillConvexPoly(image, corners.astype(np.int32), (210, 210, 205))
    square = np.array([[[0.3, 0.3], [0.7, 0.3], [0.7, 0.7], [0.3, 0.7]]], np.float32)
    unit = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)
    drawn = cv2.perspectiveTransform(square, cv2.getPerspectiveTransform(unit, corners))
    cv2.polylines(image, [drawn.astype(np.int32)], True, (40, 40, 45), 3)
    image = image * np.linspace(1, 1 - light, 480)[None, :, None]
    return cv2.GaussianBlur(image.astype(np.uint8), (5, 5), 1)


QUAD = [[60.0, 40.0], [420.0, 60.0], [440.0, 330.0], [40.0, 310.0]]


@pytest.mark.parametrize("light", [0.0, 0.5])
def test_table_and_page_border_are_no_ink(light: float) -> None:
    found = find_ink(Picture(photo(QUAD, light)))
    ys, xs = np.nonzero(found.mask)
    assert 140 < xs.min() < 170
    assert 310 < xs.max() < 340
    assert 115 < ys.min() < 145
    assert 225 < ys.max() < 260


def test_a_page_seen_whole_is_rectified() -> None:
    page = find_ink(Picture(photo(QUAD))).page
    assert page is not None
    seen = cv2.perspectiveTransform(np.array([QUAD], np.float64), page)[0]
    sides = np.roll(seen, -1, axis=0) - seen
    assert np.abs(np.array([sides[0, 1], sides[1, 0], sides[2, 1], sides[3, 0]])).max() < 6.0


def test_a_page_that_fills_the_picture_has_no_homography() -> None:
    image = np.full((300, 400, 3), 230, np.uint8)
    cv2.rectangle(image, (100, 80), (300, 220), (0, 0, 0), 2)
    assert find_ink(Picture(image)).page is None


def test_aspect_ratio_survives_the_tilt() -> None:
    """A 3:2 sheet seen by a pinhole camera comes back as 3:2."""
    tilt, focal = np.radians(35.0), 700.0
    sheet = np.array([[-1.5, -1.0, 0.0], [1.5, -1.0, 0.0], [1.5, 1.0, 0.0], [-1.5, 1.0, 0.0]])
    turn = np.array([[np.cos(0.4), 0, np.sin(0.4)], [0, 1, 0], [-np.sin(0.4), 0, np.cos(0.4)]]) @ np.array(
        [[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]]
    )
    seen = sheet @ turn.T + [0, 0, 5.0]
    corners = focal * seen[:, :2] / seen[:, 2:] + [320, 240]
    flat = cv2.perspectiveTransform(corners[None], page_homography(corners, np.array([320.0, 240.0])))[0]
    width, height = np.linalg.norm(flat[1] - flat[0]), np.linalg.norm(flat[3] - flat[0])
    assert width / height == pytest.approx(1.5, rel=0.02)
