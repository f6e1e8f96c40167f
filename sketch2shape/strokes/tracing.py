"""Strokes: the straight lines of a drawing, with their ends.

Strategy. The ink is thinned to a skeleton; without its junction pixels the skeleton falls into paths of pixels one
wide. Douglas-Peucker (Douglas and Peucker 1973) cuts every path into nearly straight pieces, a total-least-squares
line is fitted to the middle of each, and pieces that lie on one line are merged across crossings and gaps. What is
left are strokes. Everything is measured against one number, the tolerance: how far, in pixels, the hand that drew this
may have strayed from a straight line.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.geometry import fit_lines, moments
from sketch2shape.model import Bools, Brief, Floats, Ints
from sketch2shape.strokes.skeleton import Skeleton

RULED = 1.0
"""Tolerance, pixels, up to which lines are taken for ruled."""
RULED_BOW, HAND_BOW = 0.004, 0.012
"""How far a line may bow, as a part of its length."""
KEPT = 40
"""Pixels of a growing stroke that are looked at again when it grows."""
MOST_PIECES = 700
"""Pieces of lines that are looked at, the longest: a drawing has far fewer, a scribble or a texture any number."""


@dataclass(frozen=True, eq=False, repr=False)
class Strokes(Brief):
    """Straight strokes, longest first.

    ends      : (k, 2, 2) float, both end points of each, pixels
    inked     : (k,) float, part of the length that lies on ink: about 1 for a solid stroke, about 0.6 for a dashed one
    tolerance : pixels a stroke may stray from its line
    """

    ends: Floats
    inked: Floats
    tolerance: float

    @cached_property
    def lengths(self) -> Floats:
        """(k,) float, pixels."""
        return np.asarray(np.linalg.norm(self.ends[:, 1] - self.ends[:, 0], axis=1))


def _pieces(skeleton: Skeleton, tolerance: float, where: Bools | None) -> tuple[Floats, Ints, Ints]:
    """Nearly straight runs of two or more skeleton pixels, the longest first.

    Returns pixels (n, 2), one path after the other, and where among them each run begins and ends (with its last).
    """
    paths = [p for p in skeleton.paths if len(p) > 1 and (where is None or _is_on(where, p[len(p) // 2]))]
    if not paths:
        return np.zeros((0, 2)), np.zeros(0, np.intp), np.zeros(0, np.intp)
    points = np.concatenate(paths)
    bends = _point_bends(paths, tolerance) if skeleton.is_known else _pixel_bends(paths, tolerance, skeleton.mask.shape)
    index = np.concatenate(bends)
    run = np.diff(index) > 0
    run[np.cumsum([len(b) for b in bends])[:-1] - 1] = False
    first, last = index[:-1][run], index[1:][run]
    order = np.argsort(first - last, kind="stable")[:MOST_PIECES]
    return points.astype(np.float64), first[order], last[order]


def _is_on(where: Bools, point: NDArray[Any]) -> bool:
    x, y = np.rint(point).astype(int).tolist()
    return bool(where[y, x])


def _pixel_bends(paths: list[NDArray[Any]], tolerance: float, shape: tuple[int, int]) -> list[Ints]:
    """Where each path begins, bends and ends, among the pixels of all."""
    points = np.concatenate(paths)
    place = np.empty(shape, np.intp)
    place[points[:, 1], points[:, 0]] = np.arange(len(points))
    bends = [cv2.approxPolyDP(p[:, None], tolerance, False)[:, 0] if len(p) > 2 else p for p in paths]
    x, y = np.concatenate(bends).T
    # an index can fall only where a path crosses itself
    index = np.maximum.accumulate(place[y, x])
    return np.split(index, np.cumsum([len(b) for b in bends])[:-1])


def _point_bends(paths: list[NDArray[Any]], tolerance: float) -> list[Ints]:
    """The same for paths of points between the pixels."""
    bends, start = [], 0
    for path in paths:
        fine = np.ascontiguousarray(path, np.float32)
        kept = cv2.approxPolyDP(fine[:, None], tolerance, False)[:, 0]
        x_and_y = np.complex64
        bends.append(start + np.flatnonzero(np.isin(fine.view(x_and_y), np.ascontiguousarray(kept).view(x_and_y))))
        start += len(path)
    return bends


@dataclass(frozen=True)
class _Lines:
    """Growing strokes.

    points  : (k, 2, KEPT) float, x and y of some of the pixels of each
    moments : (k, 6) float, of all of them (see `moments`)
    ends    : (k, 2, 2) float
    inked   : (k,) float, pixels of length on ink
    """

    points: Floats
    moments: Floats
    ends: Floats
    inked: Floats


def _straighten(points: Floats, first: Ints, last: Ints, pen: float) -> _Lines:
    """Pieces as lines; the bent ends near junctions do not count for their directions."""
    count = last - first + 1
    trim = np.where(count > 4, np.minimum(int(pen), count // 4), 0)
    x, y = points.T
    sums = np.zeros((len(x) + 1, 6))
    np.cumsum(np.stack([np.ones_like(x), x, y, x * x, y * y, x * y], axis=1), axis=0, out=sums[1:])
    centre, direction, _ = fit_lines(sums[last + 1 - trim] - sums[first + trim])
    kept = points[first[:, None] + np.arange(KEPT) * (count - 1)[:, None] // (KEPT - 1)]
    share = np.minimum(count, KEPT) / KEPT
    along = ((kept - centre[:, None]) * direction[:, None]).sum(axis=2)
    extent = np.stack([along.min(axis=1), along.max(axis=1)], axis=1)
    ends = centre[:, None] + extent[..., None] * direction[:, None]
    inked = extent[:, 1] - extent[:, 0] + 1.0
    return _Lines(kept.swapaxes(1, 2).copy(), moments(kept) * share[:, None], ends, inked)


def _merge(lines: _Lines, tolerance: float, bow: float, bridge: float) -> _Lines:
    """Merge pieces of one line, the closest ends first, until nothing fits any more."""
    new = len(lines.inked)
    while True:
        i, j = _close_pairs(lines, new, tolerance, bridge)
        if not len(i):
            return lines
        ends, fits = _joined(lines, i, j, tolerance, bow)
        free = [True] * len(lines.inked)
        chosen = []
        pairs = np.flatnonzero(fits)
        for k, a, b in zip(pairs.tolist(), i[pairs].tolist(), j[pairs].tolist(), strict=True):
            if free[a] and free[b]:
                free[a] = free[b] = False
                chosen.append(k)
        if not chosen:
            return lines
        new = len(chosen)
        lines = _with_joined(lines, np.flatnonzero(free), i[chosen], j[chosen], ends[chosen])


def _close_pairs(lines: _Lines, new: int, tolerance: float, bridge: float) -> tuple[Ints, Ints]:
    """Pairs of lines whose ends nearly touch and whose directions agree, the closest first.

    One of each pair is among the last `new` lines; others have been tried already.
    """
    old = len(lines.ends) - new
    x, y = lines.ends.transpose(2, 1, 0)  # (2, k) each: the starts, the ends
    gap = np.full((old + new, new), np.inf)
    for m in range(2):
        for n in range(2):
            dx, dy = x[m][:, None] - x[n, old:], y[m][:, None] - y[n, old:]
            gap = np.minimum(gap, dx * dx + dy * dy)
    i, j = np.nonzero(gap < (3.5 * bridge) ** 2)
    gap, j = np.sqrt(gap[i, j]), j + old
    span = lines.ends[:, 1] - lines.ends[:, 0]
    lengths = np.hypot(span[:, 0], span[:, 1])
    shorter = np.minimum(lengths[i], lengths[j])
    limit = np.maximum(bridge, np.minimum(1.6 * shorter, 3.5 * bridge))
    ux, uy = (span / (lengths[:, None] + 1e-9)).T
    sine = np.abs(ux[i] * uy[j] - uy[i] * ux[j])
    close = np.flatnonzero((i < j) & (gap < limit) & (sine < 0.05 + 2.5 * tolerance / (shorter + 1e-9)))
    order = close[np.argsort(gap[close], kind="stable")]
    return i[order], j[order]


def _joined(lines: _Lines, i: Ints, j: Ints, tolerance: float, bow: float) -> tuple[Floats, Bools]:
    """Ends (k, 2, 2) of the lines that k pairs of lines would make, and which pairs do lie on one line."""
    ends = np.concatenate([lines.ends[i], lines.ends[j]], axis=1)
    centre, direction, _ = fit_lines(lines.moments[i] + lines.moments[j] + moments(ends))
    (cx, cy), (dx, dy) = centre.T[..., None], direction.T[..., None]
    off = np.zeros(len(i))
    for points in (lines.points[i], lines.points[j]):
        off = np.maximum(off, np.abs((points[:, 1] - cy) * dx - (points[:, 0] - cx) * dy).max(axis=1))
    along = (ends[..., 0] - cx) * dx + (ends[..., 1] - cy) * dy
    extent = np.stack([along.min(axis=1), along.max(axis=1)], axis=1)
    joined = centre[:, None] + extent[..., None] * direction[:, None]
    return joined, off <= np.maximum(tolerance, bow * (extent[:, 1] - extent[:, 0]))


def _with_joined(lines: _Lines, rest: Ints, i: Ints, j: Ints, ends: Floats) -> _Lines:
    """The rest of the lines, and then pairs of them as one each, with these ends (k, 2, 2)."""
    both = np.concatenate([lines.points[i], lines.points[j]], axis=2)
    kept = both[..., np.arange(KEPT) * (2 * KEPT - 1) // (KEPT - 1)]
    return _Lines(
        np.concatenate([lines.points[rest], kept]),
        np.concatenate([lines.moments[rest], lines.moments[i] + lines.moments[j]]),
        np.concatenate([lines.ends[rest], ends]),
        np.concatenate([lines.inked[rest], lines.inked[i] + lines.inked[j]]),
    )


def trace_skeleton(skeleton: Skeleton, tolerance: float, where: Bools | None = None) -> Strokes:
    """Straight strokes of a drawing.

    tolerance : pixels, how far a drawn line may stray from a straight one
    where     : (h, w) bool, ink to look at; all of it if None
    """
    pen = skeleton.pen_width
    points, first, last = _pieces(skeleton, tolerance, where)
    if not len(first):
        return Strokes(np.zeros((0, 2, 2)), np.zeros(0), tolerance)
    # a ruler makes no bows, however long the line; a hand does
    bow = RULED_BOW if tolerance <= RULED else HAND_BOW
    lines = _merge(_straighten(points, first, last, pen), tolerance, bow, 2.5 * pen + 2 * tolerance + 2)
    lengths = np.linalg.norm(lines.ends[:, 1] - lines.ends[:, 0], axis=1)
    order = np.argsort(-lengths, kind="stable")
    return Strokes(lines.ends[order], np.minimum(lines.inked / (lengths + 1.0), 1.0)[order], tolerance)
