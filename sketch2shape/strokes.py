"""Strokes: the straight lines of a drawing, with their ends.

Strategy. The ink is thinned to a skeleton; without its junction pixels the skeleton falls into paths of pixels one
wide. Douglas-Peucker (Douglas and Peucker 1973) cuts every path into nearly straight pieces, a total-least-squares
line is fitted to the middle of each, and pieces that lie on one line are merged across crossings and gaps. What is
left are strokes. Everything is measured against one number, the tolerance: how far, in pixels, the hand that drew this
may have strayed from a straight line.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats, Ink, Ints

RULED = 1.0
"""Tolerance, pixels, up to which lines are taken for ruled."""
RULED_BOW, HAND_BOW = 0.004, 0.012
"""How far a line may bow, as a part of its length."""
KEPT = 40
"""Pixels of a growing stroke that are looked at again when it grows."""
MOST_PIECES = 700
"""Pieces of lines that are looked at, the longest: a drawing has far fewer, a scribble or a texture any number."""


@dataclass(frozen=True)
class Skeleton:
    """The thinned ink.

    mask      : (h, w) uint8, 1 on the skeleton
    points    : (k, 2) float, x and y of its pixels
    distance  : (h, w) float32, distance of every pixel to the skeleton, pixels
    paths     : ordered pixels of each branch, (m, 2) float each
    pen_width : pixels
    """

    mask: NDArray[np.uint8]
    points: Floats
    distance: NDArray[np.float32]
    paths: tuple[Floats, ...]
    pen_width: float


@dataclass(frozen=True)
class Strokes:
    """Straight strokes, longest first.

    ends      : (k, 2, 2) float, both end points of each, pixels
    inked     : (k,) float, part of the length that lies on ink: about 1 for a solid stroke, about 0.6 for a dashed one
    tolerance : pixels a stroke may stray from its line
    """

    ends: Floats
    inked: Floats
    tolerance: float

    @property
    def lengths(self) -> Floats:
        """(k,) float, pixels."""
        return np.asarray(np.linalg.norm(self.ends[:, 1] - self.ends[:, 0], axis=1))


def thin(ink: Ink) -> Skeleton:
    """Skeleton of the ink, split into its branches."""
    from skimage.morphology import skeletonize

    mask = np.asarray(skeletonize(ink.mask), np.uint8)  # type: ignore[no-untyped-call]
    # one pixel of margin lets the neighbour count and the contours treat border pixels like all others
    branches = cv2.copyMakeBorder(mask, 1, 1, 1, 1, cv2.BORDER_CONSTANT)
    around = cv2.boxFilter(branches, cv2.CV_8U, (3, 3), normalize=False, borderType=cv2.BORDER_CONSTANT)
    branches[around > 3] = 0  # junctions; whatever else has so many around is empty already
    paths = _ordered_paths(np.asarray(branches, np.uint8))
    ys, xs = np.divmod(np.flatnonzero(mask.view(np.bool_)), mask.shape[1])
    distance = np.asarray(cv2.distanceTransform(1 - mask, cv2.DIST_L2, cv2.DIST_MASK_5), dtype=np.float32)
    return Skeleton(mask, np.c_[xs, ys].astype(float), distance, tuple(p - 1.0 for p in paths), ink.pen_width)


def _ordered_paths(branches: NDArray[np.uint8]) -> list[Floats]:
    """Pixels of every one-pixel-wide component in walking order.

    The outer contour of such a component runs along it and back again, so the part between its two turning points is
    the path.
    """
    contours, _ = cv2.findContours(branches, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    if not contours:
        return []
    points = np.concatenate(contours)[:, 0].astype(float)
    ends = np.cumsum([len(c) for c in contours])
    starts = ends - [len(c) for c in contours]
    before, after = np.arange(len(points)) - 1, np.arange(len(points)) + 1
    before[starts], after[ends - 1] = ends - 1, starts
    turns = np.flatnonzero((points[before] == points[after]).all(axis=1))
    first, last = np.searchsorted(turns, starts), np.searchsorted(turns, ends)
    paths = []
    for start, end, i, j in zip(starts.tolist(), ends.tolist(), first.tolist(), last.tolist(), strict=True):
        path = points[start:end]
        if end - start > 2 and j - i >= 2:
            path = points[turns[i] : turns[i + 1] + 1]
        elif end - start > 2 and j - i == 1:
            path = np.roll(path, start - int(turns[i]), axis=0)[: len(path) // 2 + 1]
        paths.append(path)
    return paths


def moments(points: Floats) -> Floats:
    """(..., 6) of points (..., n, 2): count, sums of x, y, x squared, y squared and x times y."""
    x, y = points[..., 0], points[..., 1]
    return np.asarray(np.stack([np.ones_like(x), x, y, x * x, y * y, x * y], axis=-1).sum(axis=-2))


def fit_lines(sums: Floats) -> tuple[Floats, Floats, Floats]:
    """Total-least-squares lines of points with these moments (k, 6).

    Returns centres (k, 2) and unit directions (k, 2), pixels, and the rms distances of the points, (k,) pixels.
    """
    mean = sums[:, 1:] / sums[:, :1]
    x, y = mean[:, 0], mean[:, 1]
    xx, yy, xy = mean[:, 2] - x * x, mean[:, 3] - y * y, mean[:, 4] - x * y
    angle = 0.5 * np.arctan2(2 * xy, xx - yy)
    c, s = np.cos(angle), np.sin(angle)
    across = s * s * xx + c * c * yy - 2 * s * c * xy
    return mean[:, :2], np.stack([c, s], axis=1), np.sqrt(np.maximum(across, 0.0))


def project(points: Floats, starts: Floats, directions: Floats) -> tuple[Floats, Floats]:
    """Points against lines: distance along each line from its start, and distance off it; both (k, m) float, pixels.

    points             : (k, 2) float
    starts, directions : (m, 2) float, directions of unit length
    """
    normals = np.stack([-directions[:, 1], directions[:, 0]], axis=1)
    along = points @ directions.T - (starts * directions).sum(axis=1)
    return along, np.abs(points @ normals.T - (starts * normals).sum(axis=1))


def thinned(count: int, most: int) -> Ints:
    """Indices of about `most` of `count` points, evenly, but without a period that could skip every other line."""
    index = np.arange(count)
    return index if count <= most else index[(index * 0.6180339887) % 1.0 < most / count]


def _pieces(skeleton: Skeleton, tolerance: float, where: Bools | None) -> list[Floats]:
    """Nearly straight runs of skeleton pixels."""
    pieces = []
    for path in skeleton.paths:
        if where is not None and not where[int(path[0, 1]), int(path[0, 0])]:
            continue
        if len(path) < 3:
            pieces.append(path)
            continue
        bends = cv2.approxPolyDP(path.astype(np.int32)[:, None], tolerance, False)[:, 0]
        index = _positions(path, bends)
        pieces += [path[a : b + 1] for a, b in pairwise(index)]
    return pieces


def _positions(path: Floats, bends: NDArray[Any]) -> list[int]:
    """Where along the path its bends lie."""
    found, start = [], 0
    for bend in bends:
        hits = np.flatnonzero((path[start:] == bend).all(axis=1))
        if len(hits):
            start += int(hits[0])
            found.append(start)
    if not found or found[-1] != len(path) - 1:
        found.append(len(path) - 1)
    return found


@dataclass(frozen=True)
class _Lines:
    """Growing strokes.

    points  : (k, KEPT, 2) float, some of the pixels of each
    moments : (k, 6) float, of all of them (see `moments`)
    ends    : (k, 2, 2) float
    inked   : (k,) float, pixels of length on ink
    """

    points: Floats
    moments: Floats
    ends: Floats
    inked: Floats

    def some(self, index: Ints) -> _Lines:
        return _Lines(self.points[index], self.moments[index], self.ends[index], self.inked[index])

    def and_also(self, more: _Lines) -> _Lines:
        pairs = (
            (self.points, more.points),
            (self.moments, more.moments),
            (self.ends, more.ends),
            (self.inked, more.inked),
        )
        return _Lines(*(np.concatenate(p) for p in pairs))


def _kept(points: Floats) -> Floats:
    """KEPT of the points (..., n, 2), evenly, the first and the last among them; repeated where there are fewer."""
    n = points.shape[-2]
    return np.asarray(points[..., np.arange(KEPT) * (n - 1) // (KEPT - 1), :])


def _straighten(pieces: list[Floats], pen: float) -> _Lines:
    """Pieces as lines; the bent ends near junctions do not count for their directions."""
    trims = [min(int(pen), len(p) // 4) if len(p) > 4 else 0 for p in pieces]
    middles = [moments(p[t : len(p) - t]) for p, t in zip(pieces, trims, strict=True)]
    centre, direction, _ = fit_lines(np.array(middles))
    kept = np.array([_kept(p) for p in pieces])
    share = np.array([min(len(p), KEPT) / KEPT for p in pieces])
    along = ((kept - centre[:, None]) * direction[:, None]).sum(axis=2)
    extent = np.stack([along.min(axis=1), along.max(axis=1)], axis=1)
    ends = centre[:, None] + extent[..., None] * direction[:, None]
    return _Lines(kept, moments(kept) * share[:, None], ends, extent[:, 1] - extent[:, 0] + 1.0)


def _joined(a: _Lines, b: _Lines, tolerance: float, bow: float) -> tuple[_Lines, Bools]:
    """Pairs of lines as one stroke each, and which pairs do lie on one line."""
    points = np.concatenate([a.points, b.points], axis=1)
    ends = np.concatenate([a.ends, b.ends], axis=1)
    sums = a.moments + b.moments
    centre, direction, _ = fit_lines(sums + moments(ends))
    normal = np.stack([-direction[:, 1], direction[:, 0]], axis=1)
    off = np.abs(((points - centre[:, None]) * normal[:, None]).sum(axis=2)).max(axis=1)
    along = ((ends - centre[:, None]) * direction[:, None]).sum(axis=2)
    low, high = along.min(axis=1), along.max(axis=1)
    joined = centre[:, None] + np.stack([low, high], axis=1)[..., None] * direction[:, None]
    return _Lines(_kept(points), sums, joined, a.inked + b.inked), off <= np.maximum(tolerance, bow * (high - low))


def _merge(lines: _Lines, tolerance: float, bow: float, bridge: float) -> _Lines:
    """Merge pieces of one line, the closest ends first, until nothing fits any more."""
    while True:
        i, j = _close_pairs(lines, tolerance, bridge)
        merged, fits = _joined(lines.some(i), lines.some(j), tolerance, bow)
        free = np.ones(len(lines.inked), bool)
        chosen = []
        for k in np.flatnonzero(fits).tolist():
            if free[i[k]] and free[j[k]]:
                free[i[k]] = free[j[k]] = False
                chosen.append(k)
        if not chosen:
            return lines
        lines = lines.some(np.flatnonzero(free)).and_also(merged.some(np.array(chosen)))


def _close_pairs(lines: _Lines, tolerance: float, bridge: float) -> tuple[Ints, Ints]:
    """Pairs of lines whose ends nearly touch and whose directions agree, the closest first."""
    ends, k = lines.ends, len(lines.ends)
    span = ends[:, 1] - ends[:, 0]
    lengths = np.hypot(span[:, 0], span[:, 1])
    x, y = ends.reshape(-1, 2).T
    gap = np.hypot(x[:, None] - x, y[:, None] - y).reshape(k, 2, k, 2).min(axis=(1, 3))
    shorter = np.minimum(lengths[:, None], lengths[None])
    limit = np.maximum(bridge, np.minimum(1.6 * shorter, 3.5 * bridge))
    u = span / (lengths[:, None] + 1e-9)
    sine = np.abs(u[:, None, 0] * u[None, :, 1] - u[:, None, 1] * u[None, :, 0])
    close = (gap < limit) & (sine < 0.05 + 2.5 * tolerance / (shorter + 1e-9))
    i, j = np.nonzero(np.triu(close, 1))
    order = np.argsort(gap[i, j], kind="stable")
    return i[order], j[order]


def trace_strokes(skeleton: Skeleton, tolerance: float, where: Bools | None = None) -> Strokes:
    """Straight strokes of a drawing.

    tolerance : pixels, how far a drawn line may stray from a straight one
    where     : (h, w) bool, ink to look at; all of it if None
    """
    pen = skeleton.pen_width
    pieces = [p for p in _pieces(skeleton, tolerance, where) if len(p) >= 2]
    pieces = sorted(pieces, key=lambda p: -len(p))[:MOST_PIECES]
    if not pieces:
        return Strokes(np.zeros((0, 2, 2)), np.zeros(0), tolerance)
    # a ruler makes no bows, however long the line; a hand does
    bow = RULED_BOW if tolerance <= RULED else HAND_BOW
    lines = _merge(_straighten(pieces, pen), tolerance, bow, 2.5 * pen + 2 * tolerance + 2)
    lengths = np.linalg.norm(lines.ends[:, 1] - lines.ends[:, 0], axis=1)
    order = np.argsort(-lengths, kind="stable")
    return Strokes(lines.ends[order], np.minimum(lines.inked / (lengths + 1.0), 1.0)[order], tolerance)


def coverage(distance: NDArray[np.float32], a: Floats, b: Floats, reach: float, samples: int = 48) -> Floats:
    """Part of each segment that lies within reach of the skeleton.

    a, b  : (k, 2) float, end points in pixels
    reach : pixels
    Returns (k,) float in 0..1.
    """
    s = (np.arange(samples) + 0.5) / samples
    p = a[:, None] + s[None, :, None] * (b - a)[:, None]
    h, w = distance.shape
    x = np.clip(np.rint(p[..., 0]).astype(np.intp), 0, w - 1)
    y = np.clip(np.rint(p[..., 1]).astype(np.intp), 0, h - 1)
    return np.asarray((distance[y, x] <= reach).mean(axis=1))
