"""Skeleton: the ink thinned to lines one pixel wide, and what lies near them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink import drawn, thinned_ink
from sketch2shape.model import Bools, Floats, Ink, Ints
from sketch2shape.strokes.blots import blots_of
from sketch2shape.strokes.known_lines import known_paths

FAR_AWAY = 1e4
"""Pixels to the ink of what lies outside the picture."""
MOST_AT_ONCE = 32000
"""Points that OpenCV looks up at once."""
FAR = 6.0
"""Pixels from the skeleton up to which a dilation is faster than a distance transform."""


@dataclass(frozen=True)
class Skeleton:
    """The thinned ink.

    mask      : (h, w) uint8, 1 on the skeleton
    points    : (k, 2) float, x and y of its pixels
    paths     : (m, 2) int32 each, x and y of the pixels of every branch in walking order; float where the lines are
                known, not thinned
    pen_width : pixels
    blots     : (h, w) float32, pixels by which a line may run beside the skeleton within a blot; None without any
    """

    mask: NDArray[np.uint8]
    points: Floats
    paths: tuple[NDArray[Any], ...]
    pen_width: float
    blots: NDArray[np.float32] | None = None

    @property
    def is_known(self) -> bool:
        """Whether the lines came as vectors: where they run is known between the pixels."""
        return bool(self.paths) and self.paths[0].dtype.kind == "f"

    @property
    def outside_blots(self) -> Floats:
        """(l, 2) float, those of the points that tell where lines run."""
        return self.points if self.blots is None else self.points[self.slack(self.points) == 0]

    def slack(self, points: Floats) -> Floats:
        """(k,) pixels by which a line may run beside points (k, 2) of the skeleton."""
        if self.blots is None:
            return np.zeros(len(points))
        x, y = np.rint(points).astype(np.intp).T
        return np.asarray(self.blots[y, x], float)

    @cached_property
    def _lines(self) -> NDArray[np.uint8]:
        """(h, w), 1 on the skeleton and in blots."""
        return self.mask if self.blots is None else np.maximum(self.mask, (self.blots > 0).view(np.uint8))

    @cached_property
    def distance(self) -> NDArray[np.float32]:
        """(h, w), distance of every pixel to the skeleton, or to a blot, pixels."""
        return _distance(1 - self._lines)

    def near(self, reach: float) -> NDArray[np.uint8]:
        """(h, w), 1 within reach, in pixels, of the skeleton or a blot."""
        if reach > FAR:
            return np.asarray(self.distance <= reach).view(np.uint8)
        point = np.ones((2 * int(reach) + 1,) * 2, np.uint8)
        point[int(reach), int(reach)] = 0
        ball = np.asarray(_distance(point) <= reach, np.uint8)
        return np.asarray(cv2.dilate(self._lines, ball), np.uint8)


def thin(ink: Ink) -> Skeleton:
    """Skeleton of the ink, split into its branches; of lines that are known, those themselves."""
    if ink.lines is not None:
        known = known_paths(ink.lines, ink.mask.shape)
        drawn_thinly = drawn(known, ink.mask.shape, 1).view(np.uint8)
        return Skeleton(drawn_thinly, np.concatenate([np.zeros((0, 2)), *known]), tuple(known), ink.pen_width)
    mask = thinned_ink(ink.mask)
    # one pixel of margin lets the neighbour count and the contours treat border pixels like all others
    branches = cv2.copyMakeBorder(mask, 1, 1, 1, 1, cv2.BORDER_CONSTANT)
    around = cv2.boxFilter(branches, cv2.CV_8U, (3, 3), normalize=False, borderType=cv2.BORDER_CONSTANT)
    branches[around > 3] = 0  # junctions; whatever else has so many around is empty already
    paths = _ordered_paths(np.asarray(branches, np.uint8))
    ys, xs = np.divmod(np.flatnonzero(mask.view(np.bool_)), mask.shape[1])
    points = np.stack([xs, ys], axis=1, dtype=np.float64, casting="unsafe")
    return Skeleton(mask, points, tuple(paths), ink.pen_width, blots_of(ink))


def _distance(away: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Of every pixel to the next one that is 0."""
    return np.asarray(cv2.distanceTransform(away, cv2.DIST_L2, cv2.DIST_MASK_5), np.float32)


def _ordered_paths(branches: NDArray[np.uint8]) -> list[NDArray[np.int32]]:
    """Pixels of every one-pixel-wide component in walking order, less the margin.

    The outer contour of such a component runs along it and back again, so the part between its two turning points is
    the path.
    """
    contours, _ = cv2.findContours(branches, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE, offset=(-1, -1))
    if not contours:
        return []
    points = np.concatenate(contours)[:, 0]
    ends = np.cumsum([len(c) for c in contours])
    starts = np.append(0, ends[:-1])
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    before[starts], after[ends - 1] = points[ends - 1], points[starts]
    same = before == after
    turns = np.flatnonzero(same[:, 0] & same[:, 1])
    first, last = np.searchsorted(turns, starts).tolist(), np.searchsorted(turns, ends).tolist()
    paths = []
    for start, end, i, j in zip(starts.tolist(), ends.tolist(), first, last, strict=True):
        path = points[start:end]
        if end - start > 2 and j - i >= 2:
            path = points[turns[i] : turns[i + 1] + 1]
        elif end - start > 2 and j - i == 1:
            path = np.roll(path, start - int(turns[i]), axis=0)[: len(path) // 2 + 1]
        paths.append(np.asarray(path, np.int32))
    return paths


def interpolated(distance: NDArray[np.float32], points: Floats) -> Floats:
    """Values of a map of distances at points (..., 2) between its pixels; very much outside it."""
    at = points.reshape(-1, 1, 2).astype(np.float32)
    parts = [
        cv2.remap(distance, some, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=FAR_AWAY)  # type: ignore[call-overload]
        for some in np.array_split(at, 1 + len(at) // MOST_AT_ONCE)
    ]
    return np.asarray(np.concatenate(parts), float).reshape(points.shape[:-1])


def are_covered(near: NDArray[np.uint8], a: Floats, b: Floats, least: float) -> Bools:
    """(k,) whether more than a part of each segment lies near the skeleton (see `Skeleton.near`).

    a, b  : (k, 2) float, end points in pixels
    least : 0..1

    Seen at 48 places of each, but first at every sixth, where most turn out to miss too many.
    """
    places = np.arange(48)
    first = places % 6 == 2
    left, missed = np.arange(len(a)), np.zeros(len(a), np.intp)
    for some in (places[first], places[~first]):
        missed = missed + _missed(near, a[left], b[left], (some + 0.5) / 48)
        hopeful = missed < (1.0 - least) * 48 - 1e-9
        left, missed = left[hopeful], missed[hopeful]
    covered = np.zeros(len(a), np.bool_)
    covered[left] = True
    return covered


def _missed(near: NDArray[np.uint8], a: Floats, b: Floats, steps: Floats) -> Ints:
    """(k,) how many of the places at these parts (m,) of the way from a to b, (k, 2) each, are not near."""
    h, w = near.shape
    (x, y), (dx, dy) = a.T[..., None], (b - a).T[..., None]
    columns = np.minimum(np.maximum(np.rint(x + steps * dx), 0), w - 1)
    rows = np.minimum(np.maximum(np.rint(y + steps * dy), 0), h - 1)
    found = near.ravel().take((rows * w + columns).astype(np.intp))
    return np.asarray(len(steps) - np.count_nonzero(found, axis=1), np.intp)
