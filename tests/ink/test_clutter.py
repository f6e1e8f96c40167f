from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.clutter import without_clutter


def frame() -> np.ndarray:
    image = np.zeros((300, 400), np.uint8)
    cv2.rectangle(image, (60, 50), (340, 250), 1, 2)
    return image


def dashes(image: np.ndarray, a: tuple[int, int], b: tuple[int, int], on: float, off: float) -> None:
    length = float(np.hypot(b[0] - a[0], b[1] - a[1]))
    unit = (np.array(b) - np.array(a)) / length
    for s in np.arange(off, length - on, on + off):
        p, q = np.array(a) + s * unit, np.array(a) + (s + on) * unit
        cv2.line(image, tuple(np.round(p).astype(int).tolist()), tuple(np.round(q).astype(int).tolist()), 1, 2)


@pytest.mark.parametrize(("on", "off"), [(8, 6), (12, 10), (2, 6)])
@pytest.mark.parametrize("end", [(300, 90), (200, 240), (330, 220)])
def test_dashed_and_dotted_lines_stay(on: int, off: int, end: tuple[int, int]) -> None:
    image = frame()
    dashes(image, (70, 60), end, on, off)
    drawn = image > 0
    kept = without_clutter(drawn, image * 255)
    lost = cv2.connectedComponents((drawn & ~kept).astype(np.uint8))[0] - 1
    assert lost == 0


def test_a_hidden_corner_of_three_dashes_stays() -> None:
    image = frame()
    for end in ((150, 60), (70, 240), (330, 150)):
        dashes(image, (150, 150), end, 8, 6)
        unit = (np.array(end) - 150.0 * np.ones(2)) / np.hypot(end[0] - 150, end[1] - 150)
        tip = np.round(np.array([150, 150]) + 4 * unit).astype(int)
        cv2.line(image, (150, 150), tuple(tip.tolist()), 1, 2)
    assert without_clutter(image > 0, image * 255)[150, 150]


def test_letters_and_specks_go() -> None:
    image = frame()
    cv2.putText(image, "B", (40, 270), cv2.FONT_HERSHEY_SIMPLEX, 0.5, 1, 1)
    cv2.putText(image, "C", (200, 150), cv2.FONT_HERSHEY_SIMPLEX, 0.5, 1, 1)
    image[20, 30] = image[280, 380] = image[100, 250] = 1
    kept = without_clutter(image > 0, image * 255)
    assert np.array_equal(kept, frame() > 0)


def test_a_corner_cut_off_by_weak_spots_stays_in_grained_pictures() -> None:
    image = np.zeros((300, 400), np.uint8)
    cv2.rectangle(image, (60, 50), (340, 250), 1, 2)
    image[46:54, 318:321] = image[70:73, 336:344] = 0  # cuts the corner off
    assert without_clutter(image > 0, image * 255, noisy=True)[50, 330]
    assert not without_clutter(image > 0, image * 255)[50, 330]


def test_a_small_second_object_stays() -> None:
    image = frame()
    cv2.rectangle(image, (355, 10), (390, 40), 1, 2)
    assert np.array_equal(without_clutter(image > 0, image * 255), image > 0)


def test_input_is_not_changed() -> None:
    mask = frame() > 0
    mask[10, 10] = True
    before = mask.copy()
    without_clutter(mask, frame() * 255)
    assert np.array_equal(mask, before)


def test_a_word_goes_and_a_small_hole_stays() -> None:
    image = frame()
    cv2.putText(image, "front", (10, 285), cv2.FONT_HERSHEY_SIMPLEX, 0.6, 1, 1)
    hole = cv2.polylines(np.zeros_like(image), [np.array([[190, 140], [212, 142], [208, 158], [188, 156]])], True, 1, 2)
    kept = without_clutter((image | hole) > 0, (image | hole) * 255)
    assert np.array_equal(kept, (frame() | hole) > 0)


def test_dots_at_vertices_stay() -> None:
    image = frame()
    for x, y in ((45, 40), (355, 40), (355, 260), (45, 260)):
        cv2.circle(image, (x, y), 6, 1, -1)
    assert np.array_equal(without_clutter(image > 0, image * 255), image > 0)
