"""Types of NumPy arrays that all stages share."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


Ints = NDArray[np.intp]


Bools = NDArray[np.bool_]


Gray = NDArray[np.uint8]


def as_gray(array: NDArray[Any]) -> Gray:
    """The array as uint8, which OpenCV's types do not tell."""
    return np.asarray(array, dtype=np.uint8)
