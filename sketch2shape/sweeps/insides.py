"""Insides: how deep inside closed lines places lie, looked up in a map of distances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats, Gray, as_gray

ROOM = 2
"""Pixels around the lines that the map reaches beyond them, so that its border lies outside."""
MOST_SIDE = 4096
"""Pixels of a side of the map: of a larger shape, which no drawing shows, the rest is outside."""


@dataclass(frozen=True, eq=False)
class Inside:
    """How deep inside closed lines places lie.

    low   : (2,) float, pixels, the middle of the map's first pixel
    depth : (h, w) float32, pixels to the border; 0 outside
    """

    low: Floats
    depth: NDArray[np.float32]

    @classmethod
    def of(cls, lines: Sequence[Floats]) -> Inside:
        """The inside of closed lines (k, 2), the outer one first, those of holes after it."""
        low = np.floor(lines[0].min(axis=0)) - ROOM
        extent = np.ceil(lines[0].max(axis=0)) + ROOM + 1 - low
        wide, high = np.minimum(extent, MOST_SIDE).astype(int).tolist()
        mask: Gray = np.zeros((high, wide), np.uint8)
        cv2.fillPoly(mask, [np.round(line - low).astype(np.int32) for line in lines], 1)
        depth = cv2.distanceTransform(as_gray(mask), cv2.DIST_L2, cv2.DIST_MASK_3)
        return cls(low, np.asarray(depth, np.float32))

    def at(self, points: Floats) -> Floats:
        """(...) pixels from points (..., 2) to the border; 0 outside."""
        at = (points - (self.low - 0.5)).astype(np.int32)
        h, w = self.depth.shape
        x, y = at[..., 0], at[..., 1]
        ok = (x >= 0) & (y >= 0) & (x < w) & (y < h)
        # the first pixel lies outside
        return np.asarray(self.depth.take(np.where(ok, y * w + x, 0)))

    def holds(self, points: Floats, margin: float) -> Bools:
        """(...) whether points (..., 2) lie more than the margin inside."""
        return np.asarray(self.at(points) > margin)
