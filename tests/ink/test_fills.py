from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.ink.find import find_ink
from sketch2shape.model.picture import Picture

SQUARE = np.array([[60, 120], [180, 120], [180, 240], [60, 240]])
TOP = np.array([[60, 120], [110, 70], [230, 70], [180, 120]])
SIDE = np.array([[180, 120], [230, 70], [230, 190], [180, 240]])


def box(fills: tuple[int, int, int], outline: int | None) -> np.ndarray:
    """A box with faces of three greys and maybe an outline, RGB."""
    image = np.full((300, 300), 255, np.uint8)
    for face, gray in zip((SQUARE, TOP, SIDE), fills, strict=True):
        cv2.fillPoly(image, [face], gray)
    if outline is not None:
        cv2.polylines(image, [SQUARE, TOP, SIDE], True, outline, 2)
    return np.dstack([image] * 3)


def covered(mask: np.ndarray, a: tuple[int, int], b: tuple[int, int]) -> float:
    """Share of the middle of segment a-b with ink within 3 pixels."""
    t = np.linspace(0.1, 0.9, 60)[:, None]
    points = np.round(np.array(a) + t * (np.array(b) - np.array(a))).astype(int)
    near = cv2.dilate(mask.astype(np.uint8), np.ones((7, 7), np.uint8))
    return float(near[points[:, 1], points[:, 0]].mean())


EDGES = [((60, 120), (180, 120)), ((180, 120), (180, 240)), ((180, 120), (230, 70)), ((60, 240), (180, 240))]


def test_outlined_fills_keep_outlines_only() -> None:
    mask = find_ink(Picture(box((200, 230, 150), outline=0))).mask
    assert all(covered(mask, a, b) > 0.95 for a, b in EDGES)
    assert not mask[150:210, 90:150].any()


def test_fills_without_outline_give_their_borders() -> None:
    mask = find_ink(Picture(box((150, 210, 80), outline=None))).mask
    assert all(covered(mask, a, b) > 0.9 for a, b in EDGES)
    assert not mask[150:210, 90:150].any()


def test_a_stain_is_no_ink_and_what_is_drawn_on_it_is() -> None:
    rng = np.random.default_rng(7)
    drawn = cv2.polylines(np.zeros((400, 560), np.uint8), [2 * SQUARE - 60, 2 * TOP - 60], True, 1, 2) > 0
    image = 235.0 + cv2.GaussianBlur(rng.normal(0, 4, drawn.shape), (0, 0), 1.0)
    stain = cv2.circle(np.zeros(drawn.shape), (150, 120), 85, 1.0, -1)
    image -= 26 * cv2.GaussianBlur(stain, (0, 0), 2.0)
    image[drawn] -= 170
    mask = find_ink(Picture(np.dstack([np.clip(image, 0, 255).astype(np.uint8)] * 3))).mask
    assert mask[drawn].mean() > 0.98
    assert (mask & ~(cv2.dilate(drawn.astype(np.uint8), np.ones((5, 5))) > 0)).sum() < 0.01 * drawn.sum()


def test_thick_strokes_are_no_fill() -> None:
    image = np.full((180, 180), 255, np.uint8)
    cv2.polylines(image, [np.array([[30, 60], [110, 60], [110, 150], [30, 150]])], True, 0, 19)
    cv2.polylines(image, [np.array([[30, 60], [70, 25], [150, 25], [150, 110], [110, 150]])], False, 0, 19)
    cv2.line(image, (110, 60), (150, 25), 0, 19)
    found = find_ink(Picture(np.dstack([image] * 3)))
    drawn = cv2.resize(image, found.mask.shape[::-1]) < 128
    assert np.mean(found.mask == drawn) > 0.99
