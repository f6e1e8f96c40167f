"""Levels of grey and ranks among them."""

from __future__ import annotations

import numpy as np
import pytest

from sketch2shape.ink.histogram import counts_of, percentile


def test_every_level_is_counted() -> None:
    gray = np.array([[0, 7, 7], [255, 7, 0]], np.uint8)
    counts = counts_of(gray)
    assert counts[[0, 7, 255]].tolist() == [2, 3, 1]
    assert counts.sum() == 6


@pytest.mark.parametrize("count", [1, 2, 9, 500])
@pytest.mark.parametrize("percent", [0, 20, 75, 90, 100])
def test_percentiles_are_those_of_numpy(count: int, percent: float) -> None:
    values = np.random.default_rng(count).integers(0, 256, count).astype(np.uint8)
    assert percentile(values, percent) == pytest.approx(float(np.percentile(values, percent)))
