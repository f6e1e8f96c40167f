"""Strokes on rough paper."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.find import find_ink
from sketch2shape.ink.grain import with_weak_places, without_burrs
from sketch2shape.model.picture import Ink, Picture
from sketch2shape.strokes.skeleton import thin

HEXAGON = np.array([[150, 60], [330, 90], [400, 220], [300, 330], [140, 300], [80, 170]])


def grained(thickness: int, strongest: float, coarse: float, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Pencil on white paper, RGB, paler where the paper is low, and where it was drawn."""
    rng = np.random.default_rng(seed)
    line = np.zeros((400, 500), np.uint8)
    cv2.polylines(line, [HEXAGON], True, 255, thickness, cv2.LINE_AA)
    height = cv2.GaussianBlur(rng.normal(0, 1, line.shape), (0, 0), coarse)
    ink = np.clip(line / 255 * (strongest + 0.12 * height / height.std()), 0.0, 1.0)
    image = 240 * (1 - ink) + rng.normal(0, 1.5, line.shape)
    return np.dstack([np.clip(image, 0, 255).astype(np.uint8)] * 3), line > 0


def pieces(mask: np.ndarray) -> int:
    return int(cv2.connectedComponents(mask.astype(np.uint8), connectivity=8)[0]) - 1


@pytest.mark.parametrize("seed", range(4))
def test_a_hairline_over_grain_stays_in_one_piece(seed: int) -> None:
    image, drawn = grained(1, 0.45, 0.8, seed)
    mask = find_ink(Picture(image)).mask
    assert pieces(mask) <= 2
    assert not (mask & ~(cv2.dilate(drawn.astype(np.uint8), np.ones((5, 5))) > 0)).any()


@pytest.mark.parametrize("gap", [3, 4, 6])
def test_dots_and_dashes_of_a_hairline_stay_apart(gap: int) -> None:
    contrast = np.zeros((60, 400), np.uint8)
    for x in range(20, 380, 4 + gap):
        contrast[30, x : x + 4] = 200
    contrast = cv2.GaussianBlur(contrast, (3, 3), 0)
    drawn = contrast > 70
    assert pieces(with_weak_places(drawn, contrast, 8.0)) == pieces(drawn)


def test_dots_of_the_paper_keep_their_shape() -> None:
    contrast = np.zeros((100, 100), np.uint8)
    for y in range(10, 100, 16):
        for x in range(10, 100, 16):
            cv2.circle(contrast, (x, y), 1, 140, -1, cv2.LINE_AA)
    drawn = contrast > 60
    assert np.array_equal(with_weak_places(drawn, contrast, 8.0), drawn)


def ragged() -> np.ndarray:
    """Thick strokes of chalk."""
    rng = np.random.default_rng(8)
    mask = cv2.polylines(np.zeros((400, 500), np.uint8), [HEXAGON], True, 1, 5)
    rim = (mask == 0) & (cv2.dilate(mask, np.ones((3, 3), np.uint8)) > 0)
    return (mask > 0) | (rim & (rng.random(mask.shape) < 0.4))


def branches(mask: np.ndarray) -> int:
    return len(thin(Ink(mask, mask * np.uint8(255), 5.0)).paths)


def test_chalk_has_few_branches_without_burrs() -> None:
    before, after = branches(ragged()), branches(without_burrs(ragged(), 5.0))
    assert before > 50
    assert after < 12


def test_a_fine_line_beside_ragged_strokes_stays() -> None:
    mask = ragged()
    mask[60:330, 250] = True
    kept = without_burrs(mask, 5.0)
    assert kept[90:300, 250].all()
    assert pieces(kept) == 1


def test_smooth_strokes_are_left_as_they_are() -> None:
    mask = cv2.polylines(np.zeros((400, 500), np.uint8), [HEXAGON], True, 1, 5) > 0
    assert without_burrs(mask, 5.0) is mask
