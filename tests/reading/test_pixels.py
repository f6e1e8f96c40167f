"""From stored samples to 8-bit RGB."""

from __future__ import annotations

import io

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from sketch2shape.errors import UnreadableError
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.pixels import from_array, from_image, over_ground, scale_integers


def reopened(image, kind, **options):
    out = io.BytesIO()
    image.save(out, kind, **options)
    return Image.open(io.BytesIO(out.getvalue()))


def on_transparency(ink, share=0.02):
    """A drawing of one colour on transparency."""
    rgba = np.zeros((100, 100, 4), np.uint8)
    rgba[: int(100 * share), :] = (*ink, 255)
    return rgba


def test_dark_ink_on_transparency_is_put_on_white():
    pixels = over_ground(on_transparency((0, 0, 0)))
    assert pixels[0, 0].tolist() == [0, 0, 0]
    assert pixels[50, 50].tolist() == [255, 255, 255]


def test_light_ink_on_transparency_is_put_on_black():
    pixels = over_ground(on_transparency((255, 255, 255)))
    assert pixels[0, 0].tolist() == [255, 255, 255]
    assert pixels[50, 50].tolist() == [0, 0, 0]


def test_white_paper_with_transparent_surroundings_stays_on_white():
    rgba = np.zeros((100, 100, 4), np.uint8)
    rgba[30:70, 30:70] = 255
    rgba[50, 35:65, :3] = 0
    assert over_ground(rgba)[0, 0].tolist() == [255, 255, 255]


def test_half_transparent_ink_is_blended():
    rgba = np.zeros((4, 4, 4), np.uint8)
    rgba[0, 0] = (0, 0, 0, 128)
    assert over_ground(rgba)[0, 0].tolist() == [127, 127, 127]


def test_wholly_transparent_is_white():
    assert (over_ground(np.zeros((5, 5, 4), np.uint8)) == 255).all()


def test_sixteen_bits_are_scaled_not_clipped():
    samples = np.array([[0, 1000, 32768, 65535]], np.uint16)
    pixels = from_image(reopened(Image.fromarray(samples), "PNG"))
    assert pixels[0, :, 0].tolist() == [0, 4, 128, 255]


def test_twelve_bits_in_sixteen_use_the_whole_range():
    assert scale_integers(np.array([[0, 2048, 4095]], np.uint16)).tolist() == [[0, 128, 255]]


def test_eight_bits_in_more_stay_what_they_are():
    assert scale_integers(np.array([[0, 7, 200]], np.int64)).tolist() == [[0, 7, 200]]


def test_palette_with_transparency():
    image = Image.new("P", (10, 10), 1)
    image.putpalette([0, 0, 0, 9, 9, 9] + [0] * 762)
    image.paste(0, (0, 0, 5, 1))
    pixels = from_image(reopened(image, "PNG", transparency=1))
    assert pixels[0, 0].tolist() == [0, 0, 0]
    assert pixels[5, 5].tolist() == [255, 255, 255]


def test_grey_with_a_transparent_value():
    image = Image.new("L", (10, 10), 0)
    image.paste(30, (0, 0, 5, 1))
    pixels = from_image(reopened(image, "PNG", transparency=0))
    assert pixels[0, 0].tolist() == [30, 30, 30]
    assert pixels[5, 5].tolist() == [255, 255, 255]


@pytest.mark.parametrize("kind", ["JPEG", "TIFF"])
def test_cmyk_white_stays_white(kind):
    image = Image.new("CMYK", (16, 16), (0, 0, 0, 0))
    image.paste((0, 0, 0, 255), (0, 0, 8, 16))
    pixels = from_image(reopened(image, kind))
    assert pixels[8, 2].max() < 30
    assert pixels[8, 13].min() > 225


def test_bilevel():
    image = Image.new("1", (9, 9), 1)
    image.putpixel((3, 4), 0)
    pixels = from_image(reopened(image, "TIFF", compression="group4"))
    assert pixels[4, 3].tolist() == [0, 0, 0]
    assert pixels[0, 0].tolist() == [255, 255, 255]


def test_float_tiff_is_stretched_and_nan_refused():
    samples = np.array([[0.0, 0.5], [1.0, 0.25]], np.float32)
    assert from_image(reopened(Image.fromarray(samples), "TIFF"))[:, :, 0].tolist() == [[0, 127], [255, 63]]
    samples[0, 0] = np.nan
    with pytest.raises(UnreadableError, match="NaN"):
        from_image(reopened(Image.fromarray(samples), "TIFF"))


@pytest.mark.parametrize(
    "array",
    [
        np.full((4, 5), -0.5),
        np.full((4, 5), 256.0),
        np.full((4, 5), np.nan),
        np.zeros((4, 5), complex),
        np.zeros((4, 5), object),
        np.zeros(5, np.uint8),
        np.zeros((4, 5, 2), np.uint8),
        np.zeros((2, 4, 5, 3), np.uint8),
        np.zeros((0, 5), np.uint8),
        np.zeros((4, 0, 3), np.uint8),
    ],
)
def test_arrays_that_are_no_pictures(array):
    with pytest.raises(UnreadableError):
        from_array(array, Limits())


def test_shapes_and_types_of_arrays():
    grey = np.array([[0, 255], [9, 3]], np.uint8)
    want = np.repeat(grey[:, :, None], 3, axis=2)
    for array in (
        grey,
        grey[:, :, None],
        want,
        grey.astype(np.int32),
        np.dstack([want, np.full((2, 2), 255, np.uint8)]),
    ):
        assert (from_array(array, Limits()) == want).all()
    assert from_array(grey > 100, Limits())[0, 1].tolist() == [255, 255, 255]


@pytest.mark.parametrize("kind", [np.float16, np.float32, np.float64])
def test_floats_are_pictures_in_0_to_1_or_0_to_255(kind):
    grey = np.array([[0, 255], [102, 51]], np.uint8)
    assert (from_array((grey / 255.0).astype(kind), Limits())[:, :, 0] == grey).all()
    assert (from_array(grey.astype(kind), Limits())[:, :, 0] == grey).all()
    rgba = np.dstack([grey / 255.0] * 3 + [np.ones((2, 2))])
    assert (from_array(rgba, Limits())[:, :, 1] == grey).all()
    assert (from_array(np.zeros((2, 2), kind), Limits()) == 0).all()


def test_the_caller_keeps_an_array_of_his_own():
    array = np.zeros((4, 5, 3), np.uint8)
    from_array(array, Limits())[:] = 7
    assert (array == 0).all()


@given(st.lists(st.integers(-(2**31), 2**31 - 1), min_size=1, max_size=30))
def test_scaling_keeps_the_order_of_any_integers(values):
    array = np.array([values])
    scaled = scale_integers(array)[0].astype(int)
    order = np.argsort(array[0], kind="stable")
    assert (np.diff(scaled[order]) >= 0).all()
