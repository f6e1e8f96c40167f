from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.hatching import without_hatching

FACE = np.array([[100, 80], [320, 80], [320, 280], [100, 280]])
DIAGONAL = float(np.hypot(380, 480))


def outline(thickness: int = 2) -> np.ndarray:
    image = cv2.polylines(np.zeros((380, 480), np.uint8), [FACE], True, 1, thickness)
    for corner in FACE[1:]:
        cv2.line(image, tuple(corner.tolist()), (int(corner[0]) + 70, int(corner[1]) + 50), 1, thickness)
    return image


def hatched(spacing: float, angle: float) -> np.ndarray:
    image = np.zeros((380, 480), np.uint8)
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    for k in np.arange(-400, 400, spacing):
        middle = np.array([210, 180]) + k * np.array([-s, c])
        a, b = middle - 500 * np.array([c, s]), middle + 500 * np.array([c, s])
        cv2.line(image, tuple(np.round(a).astype(int).tolist()), tuple(np.round(b).astype(int).tolist()), 1, 1)
    inside = cv2.fillPoly(np.zeros_like(image), [FACE], 1)
    return (image & inside) | outline()


@pytest.mark.parametrize(("spacing", "angle"), [(7.0, 45.0), (8.5, -30.0), (6.0, 70.0)])
def test_a_hatched_face_keeps_its_outline(spacing: float, angle: float) -> None:
    drawn = hatched(spacing, angle) > 0
    kept = without_hatching(drawn, DIAGONAL)
    assert kept[outline() > 0].mean() > 0.98
    assert kept[110:250, 130:290].mean() < 0.01


def test_a_line_across_the_hatching_stays() -> None:
    drawn = hatched(7.0, 45.0)
    cv2.line(drawn, (210, 80), (210, 280), 1, 2)
    kept = without_hatching(drawn > 0, DIAGONAL)
    assert kept[100:260, 210].mean() > 0.95


@pytest.mark.parametrize(("first", "second"), [(45.0, -45.0), (20.0, 110.0), (0.0, 60.0)])
def test_lines_that_cross_each_other_all_over_a_face_go(first: float, second: float) -> None:
    drawn = (hatched(8.0, first) | hatched(7.0, second)) > 0
    kept = without_hatching(drawn, DIAGONAL)
    assert kept[outline() > 0].mean() > 0.98
    assert kept[110:250, 130:290].mean() < 0.01


def test_a_narrow_face_is_hatched_too() -> None:
    narrow = np.zeros((380, 480), np.uint8)
    cv2.fillPoly(narrow, [np.array([[100, 80], [125, 80], [125, 280], [100, 280]])], 1)
    drawn = ((hatched(6.0, 5.0) & narrow) | outline()) > 0
    cv2.line(drawn.view(np.uint8), (125, 80), (125, 280), 1, 2)
    kept = without_hatching(drawn, DIAGONAL)
    assert kept[outline() > 0].mean() > 0.98
    assert kept[110:250, 108:118].mean() < 0.01


def test_nothing_hatched_nothing_changed() -> None:
    drawn = outline() > 0
    assert without_hatching(drawn, DIAGONAL) is drawn


def test_a_comb_of_few_or_wider_lines_is_no_hatching() -> None:
    image = outline()
    image[80:280, 120:320:22] = 1
    assert np.array_equal(without_hatching(image > 0, DIAGONAL), image > 0)
    image = outline()
    image[80:280, 120:160:7] = 1
    assert np.array_equal(without_hatching(image > 0, DIAGONAL), image > 0)


def test_text_is_no_hatching() -> None:
    image = np.zeros((300, 600), np.uint8)
    for y in range(30, 290, 16):
        cv2.putText(image, "the quick brown fox jumps over it", (10, y), cv2.FONT_HERSHEY_SIMPLEX, 0.5, 1, 1)
    assert np.array_equal(without_hatching(image > 0, DIAGONAL), image > 0)
