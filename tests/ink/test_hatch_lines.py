from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.hatch_lines import MANY, without_hatch_lines

SHAPE = (480, 640)
FRONT = np.array([[120, 180], [340, 200], [350, 420], [110, 400]])
BACK = FRONT + np.array([170, -120])


def outline(pen: int = 3) -> np.ndarray:
    """A box with all its edges."""
    image = np.zeros(SHAPE, np.uint8)
    cv2.polylines(image, [FRONT, BACK], True, 1, pen)
    for a, b in zip(FRONT, BACK, strict=True):
        cv2.line(image, a.tolist(), b.tolist(), 1, pen)
    return image


def hatching(angle: float, spacing: float, pen: int = 2, sway: float = 0.0, seed: int = 1) -> np.ndarray:
    """Lines across the front face."""
    rng = np.random.default_rng(seed)
    face = cv2.fillPoly(np.zeros(SHAPE, np.uint8), [FRONT], 1)
    lines = np.zeros(SHAPE, np.uint8)
    centre = FRONT.mean(axis=0)
    for at in np.arange(-300, 300, spacing):
        turn = np.radians(angle + rng.normal(0, sway))
        way, aside = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
        middle = centre + (at + rng.normal(0, 0.1 * spacing) * (sway > 0)) * aside
        cv2.line(lines, *[np.round(middle + s * 400 * way).astype(int).tolist() for s in (-1, 1)], 1, pen)
    return lines & face


def left(result: np.ndarray, part: np.ndarray) -> float:
    return float(np.count_nonzero(result & (part > 0)) / np.count_nonzero(part))


@pytest.mark.parametrize("angle", [20, 55, 110, 160])
@pytest.mark.parametrize(("spacing", "sway"), [(18.0, 0.0), (30.0, 0.0), (24.0, 0.8)])
def test_wide_hatching_goes_and_the_edges_stay(angle: float, spacing: float, sway: float) -> None:
    box, lines = outline(), hatching(angle, spacing, sway=sway)
    result = without_hatch_lines((box | lines) > 0)
    inner = lines & ~cv2.dilate(box, np.ones((9, 9), np.uint8))
    assert left(result, inner) < 0.35
    assert left(result, box) > 0.97


def test_lines_far_apart_go_if_all_are_at_one_distance() -> None:
    frame = cv2.rectangle(np.zeros(SHAPE, np.uint8), (98, 100), (362, 380), 1, 2)
    lines = np.zeros(SHAPE, np.uint8)
    for k in range(7):
        cv2.line(lines, (130 + 33 * k, 100), (130 + 33 * k, 300), 1, 2)
    result = without_hatch_lines((frame | lines) > 0)
    assert left(result, lines & ~cv2.dilate(frame, np.ones((9, 9), np.uint8))) < 0.35  # the outermost ones may be edges
    assert left(result, frame) > 0.97


def test_lines_leave_no_stubs_at_the_edges_they_ended_on() -> None:
    box = outline()
    result = without_hatch_lines((box | hatching(55, 22)) > 0)
    beside = cv2.dilate(box, np.ones((3, 3), np.uint8)) == 0
    assert np.count_nonzero(result & beside) < 0.01 * np.count_nonzero(box)


@pytest.mark.parametrize(("count", "goes"), [(MANY + 2, True), (MANY - 2, False)])
def test_many_lines_need_not_be_even(monkeypatch: pytest.MonkeyPatch, count: int, goes: bool) -> None:
    monkeypatch.setattr("sketch2shape.ink.hatch_lines._are_even", lambda *_: False)
    lines = np.zeros(SHAPE, np.uint8)
    for k in range(count):
        cv2.line(lines, (125 + 14 * k, 225), (130 + 14 * k, 320), 1, 2)
    remains = left(without_hatch_lines(lines > 0), lines)
    assert remains < 0.25 if goes else remains == 1.0


def test_an_edge_along_which_the_lines_run_stays() -> None:
    box, lines = outline(), np.zeros(SHAPE, np.uint8)
    for k in range(1, 9):
        a, b = FRONT[0] + k * (FRONT[3] - FRONT[0]) / 9, FRONT[1] + k * (FRONT[2] - FRONT[1]) / 9
        cv2.line(lines, np.round(a).astype(int).tolist(), np.round(b).astype(int).tolist(), 1, 2)
    result = without_hatch_lines((box | lines) > 0)
    assert left(result, lines & ~cv2.dilate(box, np.ones((9, 9), np.uint8))) < 0.15
    assert left(result, box) > 0.98


def test_the_last_line_of_a_hatching_that_ends_on_others_may_be_an_edge() -> None:
    frame, lines = np.zeros(SHAPE, np.uint8), np.zeros(SHAPE, np.uint8)
    for x in (100, 400):
        cv2.line(frame, (x, 60), (x, 440), 1, 3)
    edges = cv2.line(cv2.line(np.zeros(SHAPE, np.uint8), (100, 100), (400, 100), 1, 3), (100, 300), (400, 300), 1, 3)
    for y in range(120, 300, 20):
        cv2.line(lines, (100, y), (400, y), 1, 2)
    result = without_hatch_lines((frame | edges | lines) > 0)
    assert left(result, edges) > 0.98
    assert left(result, lines & ~cv2.dilate(frame, np.ones((9, 9), np.uint8))) < 0.05


def test_the_same_however_it_is_turned() -> None:
    mask = (outline() | hatching(55, 22)) > 0
    gone = mask.sum() - without_hatch_lines(mask).sum()
    for turned in (np.rot90(mask), np.fliplr(mask), np.flipud(mask)):
        turned = np.ascontiguousarray(turned)
        assert abs(int(turned.sum() - without_hatch_lines(turned).sum()) - int(gone)) < 0.2 * gone


def test_a_drawing_without_hatching_stays_the_same_array() -> None:
    mask = outline() > 0
    assert without_hatch_lines(mask) is mask
    empty = np.zeros(SHAPE, np.bool_)
    assert without_hatch_lines(empty) is empty


def comb(teeth: int) -> np.ndarray:
    """The wireframe of a comb: many parallel edges at even distances that end at corners."""
    points = [[80, 380], [80, 200]]
    for k in range(teeth):
        x = 80 + 44 * k
        points += [[x, 200], [x + 22, 200], [x + 22, 300], [x + 44, 300]]
    points += [[80 + 44 * teeth, 380]]
    front = np.array(points)
    image = np.zeros(SHAPE, np.uint8)
    cv2.polylines(image, [front, front + np.array([57, -43])], True, 1, 2)
    for x, y in front:
        cv2.line(image, (int(x), int(y)), (int(x) + 57, int(y) - 43), 1, 2)
    return image > 0


def test_edges_at_even_distances_that_end_at_corners_stay() -> None:
    mask = comb(6)
    assert without_hatch_lines(mask) is mask


def test_four_lines_are_no_hatching() -> None:
    lines = np.zeros(SHAPE, np.uint8)
    for x in (160, 190, 220, 250):
        cv2.line(lines, (x, 230), (x, 370), 1, 2)
    mask = (outline() | lines) > 0
    assert (without_hatch_lines(mask) == mask).all()


def test_dashes_are_no_hatching() -> None:
    image = outline()
    for y in (240, 262, 284, 306, 328, 350):
        for x in range(140, 320, 16):
            cv2.line(image, (x, y), (x + 8, y), 1, 2)
    mask = image > 0
    assert (without_hatch_lines(mask) == mask).all()


def test_noise_is_not_followed_piece_by_piece(monkeypatch: pytest.MonkeyPatch) -> None:
    noise = np.random.default_rng(1).random((900, 1200)) < 0.08

    def never(*_: object) -> None:
        pytest.fail("thousands of pieces are traced")

    monkeypatch.setattr("sketch2shape.ink.hatch_lines.lines_of", never)
    assert without_hatch_lines(noise) is noise
