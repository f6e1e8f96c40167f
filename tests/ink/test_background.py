from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.ink.background import at_working_size, read_ground
from sketch2shape.ink.find import find_ink
from sketch2shape.model.picture import Picture

STAR = np.array([[120, 60], [320, 90], [400, 250], [260, 340], [90, 280]])


def page(ground: tuple[int, int, int], ink: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    """A pentagon with a chord, and where it was drawn."""
    drawn = cv2.polylines(np.zeros((400, 500), np.uint8), [STAR], True, 1, 3)
    drawn = cv2.line(drawn, (120, 60), (260, 340), 1, 3) > 0
    return np.where(drawn[..., None], np.uint8(ink), np.uint8(ground)), drawn


def agrees(image: np.ndarray, drawn: np.ndarray) -> bool:
    mask = find_ink(Picture(image)).mask
    near = cv2.dilate(drawn.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    return bool(mask[drawn].mean() > 0.97 and not (mask & ~near).any())


@pytest.mark.parametrize(
    ("ground", "ink"),
    [
        ((255, 255, 255), (255, 225, 40)),  # yellow pen
        ((248, 238, 205), (70, 90, 200)),  # blue ink on cream
        ((20, 60, 160), (235, 240, 255)),  # blueprint
        ((30, 30, 30), (90, 90, 90)),  # dim line on a dark screen
        ((60, 150, 60), (200, 60, 60)),  # red on green
    ],
)
def test_colours(ground: tuple[int, int, int], ink: tuple[int, int, int]) -> None:
    assert agrees(*page(ground, ink))


def test_thin_dark_lines_in_the_shadow_decide_against_the_grain_of_the_bright_paper() -> None:
    rng = np.random.default_rng(3)
    drawn = cv2.polylines(np.zeros((400, 500), np.uint8), [STAR // 2 + [30, 60]], True, 1, 2) > 0
    lit = np.where(np.arange(500) < 260, 70.0, 225.0)[None, :] * np.linspace(1.0, 0.8, 400)[:, None]
    image = cv2.GaussianBlur(np.where(drawn, 0.45 * lit, lit), (0, 0), 1.2)
    image += cv2.GaussianBlur(rng.normal(0, 9, image.shape), (0, 0), 0.8) * image / 225
    mask = find_ink(Picture(np.dstack([np.clip(image, 0, 255).astype(np.uint8)] * 3))).mask
    assert mask[drawn].mean() > 0.9
    near = cv2.dilate(drawn.astype(np.uint8), np.ones((7, 7), np.uint8)) > 0
    assert (mask & ~near).sum() < 0.3 * drawn.sum()


@pytest.mark.parametrize("lowest", [0.8, 0.5, 0.35])
def test_uneven_light(lowest: float) -> None:
    image, drawn = page((240, 240, 240), (60, 60, 60))
    light = np.linspace(lowest, 1.0, 500)[None, :, None] * np.linspace(1.0, lowest, 400)[:, None, None]
    assert agrees((image * light).astype(np.uint8), drawn)


def grainy(image: np.ndarray) -> np.ndarray:
    noise = np.random.default_rng(4).normal(0, 2, image.shape[:2])
    return np.clip(image + noise[..., None], 0, 255).astype(np.uint8)


def test_a_hard_shadow_from_the_frame_is_no_filled_face() -> None:
    image, drawn = page((235, 235, 235), (60, 60, 60))
    shadow = cv2.fillPoly(np.zeros(image.shape[:2]), [np.array([[500, 0], [500, 330], [230, 150], [300, 0]])], 1.0)
    lit = 1.0 - 0.45 * cv2.GaussianBlur(shadow, (0, 0), 2.0)
    mask = find_ink(Picture(grainy(image * lit[..., None]))).mask
    near = cv2.dilate(drawn.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    assert (mask & ~near).sum() < 0.02 * drawn.sum()


@pytest.mark.parametrize("table", [50, 130])
def test_a_page_on_an_even_table_is_no_filled_face(table: int) -> None:
    image, drawn = page((235, 235, 235), (60, 60, 60))
    wide = np.full((600, 760, 3), table, np.uint8)
    wide[90:490, 130:630] = image
    mask = find_ink(Picture(grainy(wide))).mask[90:490, 130:630]
    assert mask[drawn].mean() > 0.97
    near = cv2.dilate(drawn.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    assert not (mask & ~near).any()


def test_the_edge_of_a_shadow_is_no_ink() -> None:
    image, drawn = page((235, 235, 235), (50, 50, 50))
    y, x = np.mgrid[:400, :500]
    lit = 0.4 + 0.6 / (1.0 + np.exp(-(0.8 * x + 0.5 * y - 300) / 3.0))
    assert agrees((image * lit[..., None]).astype(np.uint8), drawn)


def test_hairline_of_a_large_scan_survives() -> None:
    image = np.full((3000, 4000, 3), 255, np.uint8)
    image[1500, 500:3500] = 200
    found = find_ink(Picture(image))
    assert max(found.mask.shape) <= 1100
    assert found.mask.any(axis=0)[round(520 * found.scale) : round(3480 * found.scale)].all()


def test_small_pictures_are_enlarged() -> None:
    pixels, scale = at_working_size(np.zeros((100, 120, 3), np.uint8))
    assert scale == 3.0
    assert pixels.shape == (300, 360, 3)


@pytest.mark.parametrize("size", [(5001, 1703), (4000, 3000), (2300, 2301)])
def test_what_lies_where_in_a_large_picture(size: tuple[int, int]) -> None:
    w, h = size
    gray = np.full((h, w), 255, np.uint8)
    x, y = 3 * w // 4, 2 * h // 3
    gray[y - 8 : y + 9, x - 8 : x + 9] = 0
    small, scale = at_working_size(gray)
    assert abs(max(small.shape) - 1100) <= 1
    ys, xs = np.nonzero(small < 128)
    assert (xs.mean() + 0.5) / scale - 0.5 == pytest.approx(x, abs=0.5 / scale)
    assert (ys.mean() + 0.5) / scale - 0.5 == pytest.approx(y, abs=0.5 / scale)


def test_ink_of_a_reduced_copy_is_told_in_pixels_of_the_whole() -> None:
    image = np.full((750, 1000, 3), 255, np.uint8)
    cv2.rectangle(image, (200, 150), (700, 600), (0, 0, 0), 3)
    whole = find_ink(Picture(image))
    found = find_ink(Picture(image, full_size=(4000, 3000)))
    assert np.array_equal(found.mask, whole.mask)
    assert found.scale == pytest.approx(whole.scale / 4)


@pytest.mark.parametrize("shape", [(1, 1), (1, 300), (7, 3), (40, 2000)])
@pytest.mark.parametrize("level", [0, 128, 255])
def test_odd_shapes_have_no_ink_and_no_error(shape: tuple[int, int], level: int) -> None:
    found = find_ink(Picture(np.full((*shape, 3), level, np.uint8)))
    assert not found.mask.any()


def test_noise_alone_has_hardly_any_ink() -> None:
    noise = np.random.default_rng(2).integers(0, 256, (300, 400, 3)).astype(np.uint8)
    assert find_ink(Picture(noise)).mask.mean() < 0.03


def test_pixels_are_not_changed() -> None:
    image, _ = page((240, 240, 240), (60, 60, 60))
    before = image.copy()
    read_ground(image)
    find_ink(Picture(image))
    assert np.array_equal(image, before)
