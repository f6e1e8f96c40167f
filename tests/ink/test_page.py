from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.find import find_ink
from sketch2shape.ink.page import page_homography
from sketch2shape.model.picture import Picture


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


def on_table(image: np.ndarray, table: tuple[int, int, int]) -> np.ndarray:
    wide = np.full((image.shape[0] + 160, image.shape[1] + 200, 3), table, np.uint8)
    wide[80:-80, 100:-100] = image
    return shot(wide)


def shot(image: np.ndarray) -> np.ndarray:
    noise = np.random.default_rng(6).normal(0, 2, image.shape[:2])
    return np.clip(cv2.GaussianBlur(image, (3, 3), 0) + noise[..., None], 0, 255).astype(np.uint8)


def drawing() -> tuple[np.ndarray, np.ndarray]:
    drawn = cv2.polylines(
        np.zeros((360, 480), np.uint8), [np.array([[90, 60], [390, 80], [350, 300], [70, 280]])], 1, 1, 3
    )
    return np.where(drawn[..., None] > 0, np.uint8((50, 50, 55)), np.uint8((225, 225, 225))), drawn > 0


def misses_and_extra(image: np.ndarray, drawn: np.ndarray) -> tuple[float, float]:
    """Part of the drawing that was not found, and ink beside it as a part of it."""
    mask = find_ink(Picture(image)).mask
    near = cv2.dilate(drawn.astype(np.uint8), np.ones((7, 7), np.uint8)) > 0
    return 1.0 - float(mask[drawn].mean()), float((mask & ~near).sum() / drawn.sum())


def test_a_shadow_into_which_strokes_run_belongs_to_the_page() -> None:
    image, drawn = drawing()
    shadow = cv2.fillPoly(np.zeros(drawn.shape), [np.array([[480, 0], [480, 180], [360, 100], [300, 0]])], 1.0)
    lit = 1.0 - 0.55 * cv2.GaussianBlur(shadow, (0, 0), 2.0)
    missed, extra = misses_and_extra(shot((image * lit[..., None]).astype(np.uint8)), drawn)
    assert missed < 0.03
    assert extra < 0.05


def test_a_table_as_bright_as_a_shadow_on_the_page_is_told_by_its_colour() -> None:
    image, drawn = drawing()
    lit = np.interp(np.arange(480), [200, 480], [1.0, 0.55])
    missed, extra = misses_and_extra(on_table((image * lit[:, None]).astype(np.uint8), (165, 125, 85)), framed(drawn))
    assert missed < 0.03
    assert extra < 0.05


def framed(drawn: np.ndarray) -> np.ndarray:
    return np.pad(drawn, ((80, 80), (100, 100)))


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
