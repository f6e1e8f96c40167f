from __future__ import annotations

import warnings

import cv2
import numpy as np
import pytest

from sketch2shape.ink.find import find_ink
from sketch2shape.ink.noise import noise_of, paper_marks
from sketch2shape.model.picture import Picture

HEXAGON = np.array([[150, 100], [330, 90], [420, 200], [340, 300], [170, 310], [90, 210]])


def squared(spacing: int) -> np.ndarray:
    image = np.full((400, 560), 250, np.uint8)
    image[::spacing], image[:, ::spacing] = 205, 205
    return image


def ruled() -> np.ndarray:
    image = np.full((400, 560), 250, np.uint8)
    image[10::26] = 190
    return image


def dotted() -> np.ndarray:
    image = np.full((400, 560), 250, np.uint8)
    for row, y in enumerate(range(8, 400, 16)):
        for x in range(8 + 9 * (row % 2), 560, 18):
            cv2.circle(image, (x, y), 1, 170, -1)
    return image


@pytest.mark.parametrize("paper", [squared(20), squared(33), ruled(), dotted()])
def test_printed_marks_are_no_ink(paper: np.ndarray) -> None:
    image = paper.copy()
    cv2.polylines(image, [HEXAGON], True, 40, 3)
    drawn = cv2.polylines(np.zeros_like(image), [HEXAGON], True, 1, 3) > 0
    mask = find_ink(Picture(np.dstack([image] * 3))).mask
    assert mask[drawn].mean() > 0.98
    assert not (mask & ~(cv2.dilate(drawn.astype(np.uint8), np.ones((5, 5))) > 0)).any()


def pencilled(paper: np.ndarray, pencil: int, noise: np.ndarray) -> tuple[float, float]:
    """Of a hexagon drawn on paper, how much is found as ink, and how much else, as parts of it."""
    drawn = cv2.polylines(np.zeros(paper.shape, np.uint8), [HEXAGON], True, 1, 2) > 0
    image = np.where(drawn, pencil, paper) + noise
    mask = find_ink(Picture(np.dstack([np.clip(image, 0, 255).astype(np.uint8)] * 3))).mask
    around = cv2.dilate(drawn.astype(np.uint8), np.ones((5, 5))) > 0
    return float(mask[drawn].mean()), float((mask & ~around).sum() / drawn.sum())


@pytest.mark.parametrize("spacing", [11, 24])
def test_squares_nearly_as_strong_as_the_pencil_are_no_ink(spacing: int) -> None:
    image = np.full((400, 560), 235.0)
    image[::spacing], image[:, ::spacing] = 150, 150
    inked, stray = pencilled(image, 105, np.random.default_rng(2).normal(0, 2, image.shape))
    assert inked > 0.97
    assert stray < 0.01


def test_a_hairline_hardly_stronger_than_the_squares_is_found_whole() -> None:
    rng = np.random.default_rng(2)
    image = np.full((400, 560), 235.0)
    image[::20], image[:, ::20] = 160, 160
    drawn = np.zeros(image.shape, np.uint8)
    cv2.polylines(drawn, [HEXAGON], True, 255, 1, cv2.LINE_AA)
    image = cv2.GaussianBlur(np.minimum(image, 235 - 0.46 * drawn), (0, 0), 0.6) + rng.normal(0, 2, image.shape)
    mask = find_ink(Picture(np.dstack([np.clip(image, 0, 255).astype(np.uint8)] * 3))).mask
    gap = cv2.distanceTransform((~mask).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5)
    assert np.mean(gap[drawn > 128] < 3) > 0.97


def test_dots_as_dark_as_the_pencil_do_not_take_it_away() -> None:
    image = np.full((400, 560), 250, np.uint8)
    for y in range(8, 400, 16):
        for x in range(8, 560, 18):
            cv2.circle(image, (x, y), 1, 120, -1)
    drawn = cv2.polylines(np.zeros(image.shape, np.uint8), [HEXAGON], True, 1, 2) > 0
    image[drawn] = 115
    assert find_ink(Picture(np.dstack([image] * 3))).mask[drawn].mean() > 0.97


def test_empty_squared_paper_has_no_ink() -> None:
    assert not find_ink(Picture(np.dstack([squared(24)] * 3))).mask.any()


def test_a_few_specks_are_no_paper_marks() -> None:
    contrast = np.zeros((400, 400), np.uint8)
    rng = np.random.default_rng(3)
    contrast[rng.integers(0, 400, 150), rng.integers(0, 400, 150)] = 200
    assert paper_marks(contrast) == 0.0


def test_strokes_everywhere_are_no_paper_marks() -> None:
    contrast = np.zeros((400, 400), np.uint8)
    contrast[:, 5::20] = contrast[5::20] = 220
    assert paper_marks(contrast) == 0.0


@pytest.mark.parametrize("sigma", [4.0, 10.0])
def test_noise_is_measured(sigma: float) -> None:
    noise = np.random.default_rng(1).normal(100, sigma, (300, 300))
    assert noise_of(np.clip(noise, 0, 255).astype(np.uint8)) == pytest.approx(sigma, rel=0.15)


def test_noise_of_a_clean_picture_is_nothing() -> None:
    image = np.zeros((200, 200), np.uint8)
    cv2.line(image, (10, 10), (180, 150), 255, 3)
    assert noise_of(image) == 0.0


def test_faint_pencil_on_noisy_grey_paper_is_found() -> None:
    image = np.full((400, 560), 225.0)
    inked, stray = pencilled(image, 150, np.random.default_rng(5).normal(0, 8, image.shape))
    assert inked > 0.9
    assert stray < 0.02


def test_black_edges_of_a_scan_and_window_bars_are_no_ink() -> None:
    image = np.full((400, 560), 240, np.uint8)
    cv2.polylines(image, [HEXAGON], True, 50, 3)
    drawn = image < 100
    image[:, :18] = 20
    image[:12] = 30
    image[-16:] = 60
    mask = find_ink(Picture(np.dstack([image] * 3))).mask
    assert np.array_equal(mask[16:-20, 22:], drawn[16:-20, 22:])
    assert not mask[:12].any()
    assert not mask[:, :18].any()


@pytest.mark.parametrize("pen", [3, 16])
def test_a_drawing_along_the_frame_stays(pen: int) -> None:
    image = np.full((300, 300), 255, np.uint8)
    image[:pen], image[-pen:], image[:, :pen], image[:, -pen:], image[100 : 100 + pen] = 0, 0, 0, 0, 0
    assert np.array_equal(find_ink(Picture(np.dstack([image] * 3))).mask, image == 0)


def test_noise_is_measured_in_a_strip_of_few_rows():
    strip = np.random.default_rng(1).integers(0, 256, (3, 900), np.uint8)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert noise_of(strip, np.ones(strip.shape, bool)) > 20
