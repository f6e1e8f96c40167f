"""Levels: how many pixels have each grey level, and what follows from it."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import Bools, Floats, Gray


def counts_of(gray: Gray) -> Floats:
    """(256,) how many pixels of a plane have each level."""
    return np.asarray(cv2.calcHist([gray], [0], None, [256], [0, 256]).ravel(), dtype=np.float64)


def above(gray: Gray, level: float) -> Bools:
    """Where a plane is above a level of 0 or more; bytes compare ten times as fast with bytes as with floats."""
    return np.asarray(gray > np.uint8(min(level, 255)), dtype=np.bool_)


def quantile(ordered: Floats, share: float) -> float:
    """That of (n,) values in rising order, n > 0, as `numpy.quantile` has it."""
    rank = share * (len(ordered) - 1)
    low, high = ordered[int(rank)], ordered[min(int(rank) + 1, len(ordered) - 1)]
    return float(low + (high - low) * (rank - int(rank)))


def percentile(values: Gray, percent: float) -> float:
    """That of (n,) bytes, n > 0, as `numpy.percentile` has it; by counting, which is faster than sorting."""
    below = np.cumsum(np.bincount(values, minlength=256))
    rank = percent / 100 * (len(values) - 1)
    low, high = np.searchsorted(below, (int(rank), min(int(rank) + 1, len(values) - 1)), side="right").tolist()
    return float(low + (high - low) * (rank - int(rank)))
