from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.ink.find import find_ink
from sketch2shape.ink.tones import read_tones, with_borders
from sketch2shape.model import Picture

SIZE = (480, 640)
FRONT = np.array([[150, 200], [350, 200], [350, 400], [150, 400]])
TOP = np.array([[150, 200], [230, 120], [430, 120], [350, 200]])
SIDE = np.array([[350, 200], [430, 120], [430, 320], [350, 400]])
EDGES = [((150, 200), (350, 200)), ((350, 200), (350, 400)), ((350, 200), (430, 120)), ((150, 400), (350, 400))]
Colour = tuple[int, int, int]
RED: tuple[Colour, Colour, Colour] = ((190, 60, 60), (220, 90, 90), (140, 40, 40))


def box(
    fills: tuple[Colour, Colour, Colour],
    *,
    paper: Colour = (255, 255, 255),
    outline: Colour | None = None,
    pen: int = 3,
) -> np.ndarray:
    """A box with three filled faces, RGB, drawn at four times the size so that its borders are smooth."""
    image = np.full((4 * SIZE[0], 4 * SIZE[1], 3), paper, np.uint8)
    for face, colour in zip((FRONT, TOP, SIDE), fills, strict=True):
        cv2.fillPoly(image, [4 * face], colour)
    if outline is not None:
        cv2.polylines(image, [4 * FRONT, 4 * TOP, 4 * SIDE], True, outline, 12)
    return cv2.resize(image, SIZE[::-1], interpolation=cv2.INTER_AREA)


def gray(*levels: int) -> tuple[Colour, Colour, Colour]:
    a, b, c = levels
    return (a, a, a), (b, b, b), (c, c, c)


def covered(mask: np.ndarray, a: tuple[int, int], b: tuple[int, int]) -> float:
    """Share of segment a-b with ink within 3 pixels."""
    t = np.linspace(0.0, 1.0, 100)[:, None]
    points = np.round(np.array(a) + t * (np.array(b) - np.array(a))).astype(int)
    near = cv2.dilate(mask.astype(np.uint8), np.ones((7, 7), np.uint8))
    return float(near[points[:, 1], points[:, 0]].mean())


def shows_the_box(image: np.ndarray) -> bool:
    """All edges have ink, and the insides of the faces have none."""
    mask = find_ink(Picture(image)).mask
    inside = np.zeros(mask.shape, np.uint8)
    for face in (FRONT, TOP, SIDE):
        cv2.fillPoly(inside, [face], 1)
        cv2.polylines(inside, [face], True, 0, 17)
    return all(covered(mask, a, b) == 1.0 for a, b in EDGES) and not mask[inside > 0].any()


@pytest.mark.parametrize(
    ("fills", "paper"),
    [
        (RED, (255, 255, 255)),
        (gray(110, 140, 90), (255, 255, 255)),
        (gray(240, 225, 210), (255, 255, 255)),  # pale
        (gray(100, 108, 92), (255, 255, 255)),  # of little contrast to each other
        (RED, (20, 30, 40)),  # on a dark ground
        (gray(30, 60, 90), (60, 60, 60)),  # darker, as dark and lighter than the ground
    ],
)
def test_faces_without_outlines_give_their_borders(fills: tuple[Colour, Colour, Colour], paper: Colour) -> None:
    image = box(fills, paper=paper)
    if paper == (60, 60, 60):
        tones = read_tones(image)
        assert tones is not None
        assert covered(tones.borders, *EDGES[0]) == 1.0
    else:
        assert shows_the_box(image)


@pytest.mark.parametrize("outline", [(0, 0, 0), (190, 60, 60), (250, 250, 120), (90, 20, 20)])
def test_an_outline_of_any_tone_is_one_line(outline: Colour) -> None:
    mask = find_ink(Picture(box(RED, outline=outline))).mask
    assert all(covered(mask, a, b) > 0.97 for a, b in EDGES)
    assert np.count_nonzero(np.diff(mask[250].astype(int)) == 1) == 3  # left, middle and right: no double lines


def test_dashes_on_a_fill_are_ink() -> None:
    image = box(RED)
    for x in range(160, 340, 20):
        cv2.line(image, (x, 300), (x + 10, 300), (0, 0, 0), 2)
    mask = find_ink(Picture(image)).mask
    assert np.mean([mask[298:303, x : x + 10].any() for x in range(160, 340, 20)]) > 0.9
    assert not mask[298:303, [175, 195, 215]].any()


def test_faces_that_the_frame_cuts_are_no_page() -> None:
    image = box(gray(184, 205, 160), outline=(0, 0, 0))[110:405, 145:440]
    mask = find_ink(Picture(image)).mask
    scale = mask.shape[1] / image.shape[1]
    for a, b in EDGES[1:3]:
        moved = [tuple(int(scale * v) for v in np.subtract(p, (145, 110))) for p in (a, b)]
        assert covered(mask, *moved) > 0.95


def test_a_graded_fill_is_one_face() -> None:
    image = box(RED).astype(np.float64)
    inside = cv2.fillPoly(np.zeros(SIZE, np.uint8), [FRONT], 1) > 0
    image[inside] -= np.linspace(0, 50, SIZE[1])[None, :, None].repeat(SIZE[0], 0)[inside]
    assert shows_the_box(image.astype(np.uint8))


@pytest.mark.parametrize("quality", [95, 80])
def test_jpeg_leaves_no_ink_beside_the_borders(quality: int) -> None:
    data = cv2.imencode(".jpg", box(RED), [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
    assert shows_the_box(cv2.imdecode(data, cv2.IMREAD_COLOR))


@pytest.mark.parametrize(
    "turned", [np.rot90, np.fliplr, np.flipud, lambda image: 255 - image, lambda image: image[..., ::-1]]
)
def test_the_same_ink_however_it_is_turned_or_coloured(turned: Callable[[np.ndarray], np.ndarray]) -> None:
    image = box(RED)
    as_it_is, changed = (find_ink(Picture(np.ascontiguousarray(i))).mask for i in (image, turned(image)))
    there = turned(as_it_is) if turned in (np.rot90, np.fliplr, np.flipud) else as_it_is
    near = [cv2.dilate(mask.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0 for mask in (there, changed)]
    assert not (there & ~near[1]).any()
    assert not (changed & ~near[0]).any()


@settings(max_examples=15, deadline=None)
@given(st.lists(st.integers(0, 30), min_size=4, max_size=4, unique=True))
def test_any_four_tones_show_the_box(levels: list[int]) -> None:
    paper, *faces = (8 * level for level in levels)
    tones = read_tones(box(gray(*faces), paper=(paper,) * 3))
    assert tones is not None
    assert all(covered(tones.borders, a, b) == 1.0 for a, b in EDGES)


def test_drawings_in_lines_have_no_tones() -> None:
    image = np.full((*SIZE, 3), 255, np.uint8)
    cv2.polylines(image, [FRONT, TOP, SIDE], True, (0, 0, 0), 3)
    assert read_tones(image) is None
    thick = np.full((*SIZE, 3), 255, np.uint8)
    cv2.polylines(thick, [FRONT, TOP, SIDE], True, (0, 0, 0), 31)
    assert read_tones(thick) is None


def test_a_sheet_on_a_table_has_no_tones() -> None:
    image = np.full((*SIZE, 3), (120, 90, 70), np.uint8)
    cv2.fillConvexPoly(image, np.array([[60, 30], [590, 50], [600, 440], [40, 450]]), (235, 235, 230))
    cv2.polylines(image, [FRONT, TOP, SIDE], True, (20, 20, 20), 3)
    assert read_tones(image) is None


def test_noise_and_lamps_have_no_tones() -> None:
    noise = np.random.default_rng(3).normal(0, 3, (*SIZE, 3))
    assert read_tones(np.clip(box(RED) + noise, 0, 255).astype(np.uint8)) is None
    light = np.linspace(0.6, 1.0, SIZE[1])[None, :, None]
    assert read_tones((box(RED) * light).astype(np.uint8)) is None


def test_borders_are_left_out_along_strokes_only() -> None:
    drawn, borders = np.zeros((60, 200), np.bool_), np.zeros((60, 200), np.bool_)
    borders[30, 10:190] = True
    drawn[28:31, 10:100] = True
    drawn[33, 150] = True  # a speck
    result = with_borders(drawn, borders)
    assert result[29:32, 12:188].any(axis=0).all()
    assert (result[:, 20:90] == drawn[:, 20:90]).all()
    assert not result[33, 150]


def test_black_faces_that_fill_most_of_a_picture_are_not_its_paper() -> None:
    part = box(((0, 0, 0),) * 3, outline=(255, 0, 0))[100:420, 130:450]
    assert np.count_nonzero(part.max(axis=2) == 0) > np.count_nonzero(part.min(axis=2) == 255)
    mask = find_ink(Picture(part)).mask
    for (ax, ay), (bx, by) in EDGES:
        assert covered(mask, (ax - 130, ay - 100), (bx - 130, by - 100)) > 0.95
    assert not mask[130:270, 50:190].any()  # the front
