"""Thinning: ink worn away from both sides until lines one pixel wide are left.

The two passes of T. Y. Zhang, C. Y. Suen, "A fast parallel algorithm for thinning digital patterns" (1984), told by the
eight neighbours of a pixel, with the corners of staircases worn away too. The result is that of scikit-image's
`skeletonize` pixel for pixel; the tests compare them. Only pixels of ink are looked at, so that a drawing takes less
time than there, and a command needs not load scikit-image, which takes longer than anything else it loads. What departs
from the paper was found by comparing the results of both on random ink.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools

_CORNERS = (5, 20, 65, 80)
"""Corners of staircases: two neighbours at a right angle; the way past the corner stays."""
_FIRST_ONLY = (3, 6, 7, 67, 97, 99, 129, 133, 193, 208)
"""Ends and corners of lines two pixels wide that only the first pass wears away, ..."""
_SECOND_ONLY = (12, 13, 28, 48, 52, 54, 88, 96, 112)
"""... and those that only the second does, lest both sides go at once."""
_NEVER = (24, 192)
"""Ends of lines two pixels wide that stay."""


def thinned_ink(mask: NDArray[Any]) -> NDArray[np.uint8]:
    """(h, w) uint8, 1 on the skeleton; mask (h, w) is not 0 where there is ink."""
    # with a margin every pixel of ink has eight neighbours
    ink = cv2.copyMakeBorder(np.asarray(mask > 0).view(np.uint8), 1, 1, 1, 1, cv2.BORDER_CONSTANT)
    pixels, w = ink.reshape(-1), ink.shape[1]
    neighbours = (-w, 1 - w, 1, w + 1, w, w - 1, -1, -w - 1)
    at, before = np.flatnonzero(pixels), -1
    while len(at) != before:
        before = len(at)
        for kept in _kept():
            around = pixels[at + neighbours[0]]
            for bit, way in enumerate(neighbours[1:], 1):
                around |= pixels[at + way] << bit
            stays = kept[around]
            pixels[at[~stays]] = 0
            at = at[stays]
    return np.ascontiguousarray(ink[1:-1, 1:-1])


@lru_cache(maxsize=1)
def _kept() -> tuple[Bools, Bools]:
    """For each pass (256,) bool, whether a pixel stays whose neighbours have this number: north 1, then clockwise."""
    around = (np.arange(256)[:, None] >> np.arange(8)) & 1
    many = around.sum(axis=1)
    once = ((around == 0) & (np.roll(around, -1, axis=1) == 1)).sum(axis=1) == 1
    north, east, south, west = around[:, ::2].T > 0
    border = (many >= 2) & (many <= 6) & once
    first = border & ~(north & east & south) & ~(east & south & west)
    second = border & ~(north & east & west) & ~(north & south & west)
    for worn, never in ((first, _SECOND_ONLY), (second, _FIRST_ONLY)):
        worn[[*never, *_NEVER]] = False
        worn[list(_CORNERS)] = True
    first[list(_FIRST_ONLY)] = second[list(_SECOND_ONLY)] = True
    return ~first, ~second
