"""Pieces: the connected components of a mask, and where they lie."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats, Ints


@dataclass(frozen=True)
class Pieces:
    """Connected pieces of a mask, diagonal neighbours included.

    mask      : (h, w) uint8, 0 or 1
    low, high : (n + 1, 2) x and y of the first and the last pixel of each; row 0 means nothing
    outlines  : n times (k, 1, 2) int32, the turning points of the outline of each, without its holes
    holes     : (n + 1,) area of the largest hole of each, square pixels; 0 for row 0
    """

    mask: NDArray[np.uint8]
    low: Ints
    high: Ints
    outlines: tuple[NDArray[Any], ...]
    holes: Floats

    @cached_property
    def extent(self) -> Floats:
        """(n + 1,) diagonal of the box around each; 0 for row 0."""
        size = self.high - self.low + 1
        size[0] = 0
        return np.asarray(np.hypot(size[:, 0], size[:, 1]), dtype=np.float64)

    @cached_property
    def where(self) -> Ints:
        """(m,) all pixels of the mask, counted row by row."""
        return np.flatnonzero(self.mask.view(np.bool_))

    @cached_property
    def piece(self) -> Ints:
        """(m,) the piece, 1 to n, that each of `where` belongs to."""
        count, label = cv2.connectedComponents(self.mask, connectivity=8)
        name = np.zeros(count, np.intp)
        x, y = self.first.T
        name[label[y, x]] = np.arange(1, count)
        return np.asarray(name[np.asarray(label).ravel().take(self.where)], np.intp)

    @property
    def first(self) -> Ints:
        """(n, 2) x and y of one pixel of each."""
        return np.array([outline[0, 0] for outline in self.outlines], np.intp).reshape(-1, 2)

    def only(self, some: Bools) -> Bools:
        """(h, w) map of some of the pieces, given as (n + 1,)."""
        result = np.zeros(self.mask.size, np.bool_)
        result[self.where[some[self.piece]]] = True
        return result.reshape(self.mask.shape)


def connected_pieces(mask: NDArray[np.uint8]) -> Pieces:
    """Find and box the pieces of a (h, w) mask.

    By their outlines: OpenCV's labels take as long, and its measures of what they label four times that.
    """
    contours, tree = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    parents = tree[0, :, 3].tolist() if contours else []
    number = np.cumsum([above < 0 for above in parents])
    outer = [c for c, above in zip(contours, parents, strict=True) if above < 0]
    holes = np.zeros(len(outer) + 1)
    for contour, above in zip(contours, parents, strict=True):
        if above >= 0:
            holes[number[above]] = max(holes[number[above]], cv2.contourArea(contour))
    low, high = np.zeros((len(outer) + 1, 2), np.intp), np.zeros((len(outer) + 1, 2), np.intp)
    if outer:
        points = np.concatenate(outer)[:, 0]
        starts = np.cumsum([0, *(len(c) for c in outer[:-1])])
        low[1:], high[1:] = np.minimum.reduceat(points, starts), np.maximum.reduceat(points, starts)
    return Pieces(mask, low, high, tuple(outer), holes)
