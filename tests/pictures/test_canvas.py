import cv2
import numpy as np
import pytest

from sketch2shape.pictures import canvas as canvas_module
from sketch2shape.pictures.canvas import Canvas, encode_png, fit, shorten, text_width


def dark(pixels: np.ndarray) -> np.ndarray:
    return pixels.sum(axis=2) < 300


def test_a_line_lies_where_it_was_drawn_and_nowhere_else() -> None:
    canvas = Canvas(40, 30)
    canvas.line(np.array([5.0, 10.0]), np.array([34.0, 10.0]), width=1)
    rows, columns = np.nonzero(dark(canvas.finish()))
    assert set(rows) == {10}
    assert columns.min() in (5, 6)
    assert columns.max() in (33, 34)


def test_dashes_begin_and_end_on_ink_and_leave_gaps() -> None:
    canvas = Canvas(60, 9)
    canvas.line(np.array([4.0, 4.0]), np.array([55.0, 4.0]), width=2, dash=(6, 5))
    row = dark(canvas.finish())[4]
    assert row[5]
    assert row[54]
    assert 3 <= np.count_nonzero(np.diff(row[5:55].astype(int))) // 2 <= 6


def test_a_view_moves_and_scales_points() -> None:
    canvas = Canvas(50, 50).view(2.0, (10, 20))
    assert canvas.place(np.array([3.0, 4.0])).tolist() == [16, 28]
    canvas.dot(np.array([3.0, 4.0]), 2, rim=None)
    rows, columns = np.nonzero(dark(canvas.finish()))
    assert rows.mean() == pytest.approx(28, abs=0.5)
    assert columns.mean() == pytest.approx(16, abs=0.5)


def test_a_half_transparent_fill_lies_between_the_two_colours() -> None:
    canvas = Canvas(20, 20)
    square = np.array([[5.0, 5.0], [15.0, 5.0], [15.0, 15.0], [5.0, 15.0]])
    canvas.fill([square], (0, 0, 0), alpha=0.5)
    assert canvas.finish()[10, 10].tolist() == pytest.approx([127, 127, 127], abs=2)


def test_a_ring_inside_a_ring_is_a_hole() -> None:
    outer = np.array([[2.0, 2.0], [27.0, 2.0], [27.0, 27.0], [2.0, 27.0]])
    canvas = Canvas(30, 30)
    canvas.fill([outer, (outer - 14.5) / 3 + 14.5], (0, 0, 0))
    filled = dark(canvas.finish())
    assert filled[5, 15]
    assert not filled[15, 15]


def test_points_far_outside_do_no_harm() -> None:
    canvas = Canvas(10, 10)
    canvas.line(np.array([-1e12, 5.0]), np.array([1e12, 5.0]), dash=(3, 3))
    assert canvas.finish().shape == (10, 10, 3)


@pytest.mark.parametrize(("h", "w", "expected"), [(100, 50, (80, 40)), (10, 40, (20, 80)), (1, 5000, (1, 80))])
def test_fit_keeps_the_aspect_ratio(h: int, w: int, expected: tuple[int, int]) -> None:
    assert fit(np.zeros((h, w, 3), np.uint8), 80, 80)[0].shape[:2] == expected


def test_words_are_cut_to_the_width() -> None:
    text = "folder/another folder/drawing.png"
    cut = shorten(text, 14, 120, "end")
    assert cut.endswith("drawing.png")
    assert text_width(cut, 14) <= 120
    assert shorten("short", 14, 120) == "short"


def test_equal_pictures_are_equal_files() -> None:
    pixels = np.random.default_rng(1).integers(0, 255, (30, 40, 3), dtype=np.uint8)
    assert encode_png(pixels) == encode_png(pixels.copy())
    assert encode_png(pixels).startswith(b"\x89PNG")


def test_large_pictures_take_no_more_than_their_own_pixels() -> None:
    large, small = Canvas(2400, 1800), Canvas(240, 180)
    assert large._big.size == 2400 * 1800 * 3
    assert small._big.size > 240 * 180 * 3
    for canvas in (large, small):
        canvas.line(np.array([10.0, 50.0]), np.array([200.0, 50.0]), width=3)
        canvas.paste(np.full((20, 30, 3), 7, np.uint8), 100, 100)
        done = canvas.finish()
        assert 3 <= dark(done)[40:60, 100].sum() <= 5
        assert (done[100:120, 100:130] == 7).all()


def test_png_is_packed_for_speed_and_loses_nothing() -> None:
    # the highest levels take 10 to 40 times as long on photos, for a fifth of the size
    assert canvas_module._COMPRESSION <= 5
    pixels = np.random.default_rng(0).integers(0, 255, (40, 60, 3), np.uint8)
    assert (cv2.imdecode(np.frombuffer(encode_png(pixels), np.uint8), cv2.IMREAD_COLOR)[..., ::-1] == pixels).all()
