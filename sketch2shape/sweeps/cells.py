"""Cells: a drawing in coarse cells, for a quick look at how much of it an outline and its way would explain."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes import Skeleton
from sketch2shape.sweeps.loops import Loop
from sketch2shape.sweeps.sweep import Way
from sketch2shape.sweeps.ways import BESIDE

CELLS, LEAST_CELL = 110, 3.0
"""Cells across the drawing's size, and least side of one, pixels."""
MOSTLY = 0.75
"""Part of a line near ink from which on it is drawn."""
LACKING = 1.5
"""Cells with ink that one which lacks it outweighs."""
LOOKS, PLACES = 128, 14
"""Points of an outline from which it is asked what hides their images, and places on the way to each."""
ON_A_SIDE = 60
"""Points of a straight line between an outline and its image."""
BEHIND = 2.0
"""Ways to the point of a far base that are followed beyond its line."""


@dataclass(frozen=True, eq=False)
class Cells:
    """The drawing in coarse cells.

    side : of a cell, pixels
    ink  : (h, w) bool, cells with ink
    near : (h, w) bool, cells with or beside solid lines
    """

    side: float
    ink: Bools
    near: Bools

    @classmethod
    def of(cls, skeleton: Skeleton, size: float, solid: Bools) -> Cells:
        """The cells of a skeleton.

        size  : of the drawing, pixels
        solid : (h, w) bool, ink that is no dash
        """
        side = max(size / CELLS, LEAST_CELL)
        high, wide = (int(n / side) + 4 for n in skeleton.mask.shape)
        empty = np.zeros((high, wide), np.bool_)
        cells = cls(side, empty, empty)
        at = skeleton.points.astype(np.intp)
        whole = cells.of_points(skeleton.points[solid[at[:, 1], at[:, 0]]])
        return cls(side, cells.of_points(skeleton.points), _widened(whole))

    def of_points(self, points: Floats) -> Bools:
        """(h, w) bool, cells with some of these points (..., 2)."""
        cells = np.zeros(self.ink.size, np.bool_)
        cells[self._numbers(points)] = True
        return cells.reshape(self.ink.shape)

    def value(self, loop: Loop, way: Way, *, is_near: bool = True) -> float:
        """Part of the ink that an outline, what is seen of its image and the lines between explain, less what lacks."""
        every = max(1, len(loop.line) // (4 * LOOKS))
        p = loop.line[::every]
        looks = slice(None, None, max(1, len(p) // LOOKS))
        to = way.of(p)
        t = np.linspace(0.04, 1.0, PLACES)
        # a far base is hidden by what lies between it and its point
        ray = p[looks, None] + (t if is_near else -BEHIND * t)[:, None] * to[looks, None]
        hidden = np.repeat(loop.inside.holds(ray, BESIDE).any(axis=1), looks.step)[: len(p)]
        lines = [p, (p + to)[~hidden]] if is_near else [p[~hidden]]
        told = self.of_points(np.concatenate([*lines, self._drawn_sides(loop, way, hides=is_near)]))
        return self._value(told, self.near)

    def value_of_wire(self, loops: Iterable[Loop], way: Way) -> float:
        """The same where nothing is hidden, for an outline and its holes, dashed or not."""
        lines = [
            np.concatenate([p.line, p.line + way.of(p.line), self._drawn_sides(p, way, hides=False)]) for p in loops
        ]
        return self._value(self.of_points(np.concatenate(lines)), self._beside)

    def value_of_lines(self, ends: Floats) -> float:
        """The same of straight lines (k, 2, 2), dashed or not."""
        told = np.zeros(self.ink.shape, np.uint8)
        cv2.polylines(told, [*(ends / self.side + 1.5).astype(np.int32)], False, 1)
        return self._value(told.view(np.bool_), self._beside)

    def _value(self, told: Bools, lined: Bools) -> float:
        lacking = np.count_nonzero(told & ~lined)
        explained = np.count_nonzero(_widened(told) & self.ink)
        return (explained - LACKING * lacking) / (self._inked + 1)

    @cached_property
    def _beside(self) -> Bools:
        """(h, w) bool, cells with or beside ink."""
        return _widened(self.ink)

    @cached_property
    def _inked(self) -> int:
        return int(np.count_nonzero(self.ink))

    def _drawn_sides(self, loop: Loop, way: Way, *, hides: bool) -> Floats:
        """(k, 2) points of what is seen of the lines between an outline and its image, if they are drawn.

        A polygon that stands for an arc has corners from which no line starts.
        """
        q = loop.line[_sides(loop, way)]
        lines = q[:, None] + np.linspace(0, 1, ON_A_SIDE)[:, None] * way.of(q)[:, None]
        seen = np.ones(lines.shape[:2], np.bool_)
        if hides:
            seen = ~np.logical_or.accumulate(loop.inside.holds(lines, BESIDE), axis=1)
        drawn = np.count_nonzero(self.near.take(self._numbers(lines)) & seen, axis=1)
        return np.asarray(lines[seen & (drawn > MOSTLY * np.count_nonzero(seen, axis=1))[:, None]])

    def _numbers(self, points: Floats) -> Ints:
        """(...) numbers of the cells in which points (..., 2) lie."""
        high, wide = self.ink.shape
        at = (points / self.side + 1.5).astype(np.intp)
        return np.asarray(np.clip(at[..., 1], 0, high - 1) * wide + np.clip(at[..., 0], 0, wide - 1))


def _widened(cells: Bools) -> Bools:
    return cv2.dilate(cells.view(np.uint8), np.ones((3, 3), np.uint8)).view(np.bool_)


def _sides(loop: Loop, way: Way) -> Ints:
    """Where lines run from an outline to its image: its corners, and its ends across the way."""
    if way.centre is not None and (way.is_pointed or way.slope is not None):
        # the tangents from the point
        seen = np.unwrap(np.arctan2(*(loop.line - way.centre).T[::-1]))
        return np.unique([int(seen.argmin()), int(seen.argmax())])
    to = way.of(loop.line)
    x, y = (loop.line - loop.line.mean(axis=0)).T
    across = (x * to[:, 1] - y * to[:, 0]) / (np.hypot(*to.T) + 1e-9)
    return np.unique([*loop.corners.tolist(), int(across.argmax()), int(across.argmin())])
