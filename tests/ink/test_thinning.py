"""Thinning: lines one pixel wide, those of scikit-image pixel for pixel."""

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sketches import DEPTH, HEXAGON, SQUARE, prism
from skimage.morphology import skeletonize

from sketch2shape.ink import thinned_ink


def is_same(mask):
    return bool((thinned_ink(mask) == skeletonize(mask > 0)).all())


@pytest.mark.parametrize("width", [1, 2, 3, 7, 12])
@pytest.mark.parametrize("ring", [SQUARE, HEXAGON], ids=["square", "hexagon"])
def test_drawings_are_thinned_as_scikit_image_thins_them(ring, width):
    assert is_same(prism(ring, ring + DEPTH, width=width) < 128)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.05, 0.97), st.sampled_from([1, 2, 3, 5]))
def test_so_is_whatever_else_there_may_be(seed, density, blob):
    ink = (np.random.default_rng(seed).random((40, 50)) < density / blob**2).astype(np.uint8)
    assert is_same(cv2.dilate(ink, np.ones((blob, blob), np.uint8)))


def test_ink_at_the_border_and_none_at_all():
    assert is_same(np.ones((9, 14), np.uint8))
    assert is_same(np.ones((1, 30), np.uint8))
    assert not thinned_ink(np.zeros((5, 6), np.bool_)).any()


def test_the_ink_given_stays_as_it_is_and_may_be_a_view():
    mask = np.zeros((30, 40), np.uint8)
    mask[5:25, 4:36] = 255
    before, part = mask.copy(), mask[3:28, 2:38]
    thin = thinned_ink(part)
    assert (mask == before).all()
    assert thin.max() == 1
    assert (thin == skeletonize(np.ascontiguousarray(part) > 0)).all()


@pytest.mark.parametrize("slope", [0.5, 1.0, 1.6])
def test_a_long_stroke_of_any_slope_becomes_one_line_without_corners(slope):
    mask = np.zeros((400, 400), np.uint8)
    cv2.line(mask, (20, 20), (int(20 + 350 / max(slope, 1)), int(20 + 350 / max(slope, 1) * slope)), 1, 5)
    thin = thinned_ink(mask)
    around = cv2.boxFilter(thin, cv2.CV_8U, (3, 3), normalize=False)[thin > 0]
    assert around.max() <= 3
