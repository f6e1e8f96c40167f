"""The packed sort against the plain one."""

from itertools import pairwise

import numpy as np
import pytest

from sketch2shape.connectors import sorting
from sketch2shape.connectors.sorting import sorted_pieces


@pytest.mark.parametrize("size", [1, 100, 2**15])
@pytest.mark.parametrize("n", [255, 256, 5000])
@pytest.mark.parametrize("kind", ["whole", "wide", "fractions", "few levels"])
def test_packed_sort_equals_lexsort(n, kind, size, monkeypatch):
    monkeypatch.setattr(sorting, "PIECE", size)
    rng = np.random.default_rng(n)
    x, y = {
        "whole": lambda: rng.integers(-50, 50, (2, n)).astype(float),
        "wide": lambda: rng.integers(-(2**40), 2**40, (2, n)).astype(float),
        "fractions": lambda: rng.normal(0, 1, (2, n)),
        "few levels": lambda: np.r_[rng.integers(0, 4, n) * 1e-14, rng.normal(0, 1, n)].reshape(2, n),
    }[kind]()
    pieces = list(sorted_pieces(x, y))
    order, xs, ys = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    assert all(one[1][-1] < other[1][0] for one, other in pairwise(pieces))
    assert np.array_equal(order, np.lexsort((y, x)))
    assert np.array_equal(xs, x[order])
    assert np.array_equal(ys, y[order])
