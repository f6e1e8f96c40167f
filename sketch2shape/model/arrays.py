"""Types of NumPy arrays that all stages share."""

from __future__ import annotations

from dataclasses import MISSING, Field, fields
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


Ints = NDArray[np.intp]


Bools = NDArray[np.bool_]


Gray = NDArray[np.uint8]


_MOST = 3
"""Items up to which a tuple is shown whole."""


class Brief:
    """Shows itself in a line: arrays by their shape, and nothing that has its default value.

    Base of dataclasses that hold arrays. Those are equal to themselves alone (`eq=False`): an array has no truth value.
    """

    def __repr__(self) -> str:
        """As in `TwoFaceObject(f1=(4, 2) float64, f2=(4, 2) float64, confidence=0.99)`."""
        own = cast("Any", self)
        shown = [
            f"{field.name}={brief(getattr(own, field.name))}"
            for field in fields(own)
            if field.repr and not _is_default(getattr(own, field.name), field)
        ]
        return f"{type(self).__name__}({', '.join(shown)})"


def brief(value: object) -> str:
    """A value in a few words: an array by its shape and type, a long tuple by its length."""
    if isinstance(value, np.ndarray):
        return f"{value.shape} {value.dtype}"
    if isinstance(value, tuple) and len(value) > _MOST:
        return f"({len(value)} {type(value[0]).__name__})"
    if isinstance(value, tuple):
        return f"({', '.join(map(brief, value))}{',' * (len(value) == 1)})"
    return f"{value:.4g}" if isinstance(value, float) else repr(value)


def _is_default(value: object, field: Field[Any]) -> bool:
    if isinstance(value, np.ndarray):
        return False
    return value == (field.default_factory() if field.default_factory is not MISSING else field.default)


def as_gray(array: NDArray[Any]) -> Gray:
    """The array as uint8, which OpenCV's types do not tell."""
    return np.asarray(array, dtype=np.uint8)
