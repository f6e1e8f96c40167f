"""Shapes that areas are eroded, grown and closed with."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Gray


def square(size: float) -> Gray:
    """(k, k) uint8 ones, k odd so that it has a centre; `size` in pixels: 2 to 3.9 give 3, 4 to 5.9 give 5."""
    side = 2 * (int(size) // 2) + 1
    return np.ones((side, side), np.uint8)
