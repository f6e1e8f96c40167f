"""Planes made smaller."""

from __future__ import annotations

import numpy as np
import pytest

from sketch2shape.sizes import averaged, halved


def test_half_the_size_is_the_mean_of_four_pixels() -> None:
    plane = np.array([[0, 4, 100], [8, 12, 100], [50, 50, 50]], np.uint8)
    assert halved(plane).tolist() == [[6]]


@pytest.mark.parametrize("shape", [(300, 500), (300, 500, 3), (750, 1000)])
@pytest.mark.parametrize("size", [(250, 150), (96, 72), (200, 200), (13, 7)])
def test_what_is_averaged_keeps_its_mean(shape: tuple[int, ...], size: tuple[int, int]) -> None:
    plane = np.random.default_rng(3).integers(0, 256, shape).astype(np.uint8)
    small = averaged(plane, size)
    assert small.shape == (size[1], size[0], *shape[2:])
    assert small.mean() == pytest.approx(plane.mean(), abs=2)
    assert small.std() < plane.std()


def test_a_thin_line_pales_instead_of_breaking() -> None:
    plane = np.zeros((400, 400), np.uint8)
    plane[np.arange(400), np.arange(400)] = 255
    small = averaged(plane, (120, 120))
    assert (np.diagonal(small) > 20).all()


def test_the_same_size_is_the_same_plane() -> None:
    plane = np.arange(12, dtype=np.uint8).reshape(3, 4)
    assert averaged(plane, (4, 3)) is plane
