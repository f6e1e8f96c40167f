"""Strokes: the straight lines of a drawing, with their ends.

Strategy. The ink is thinned to a skeleton; without its junction pixels the skeleton falls into paths of pixels one
wide. Douglas-Peucker (Douglas and Peucker 1973) cuts every path into nearly straight pieces, a total-least-squares
line is fitted to the middle of each, and pieces that lie on one line are merged across crossings and gaps. What is
left are strokes. Everything is measured against one number, the tolerance: how far, in pixels, the hand that drew this
may have strayed from a straight line.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats, Ink, Ints

RULED = 1.0
"""Tolerance, pixels, up to which lines are taken for ruled."""
RULED_BOW, HAND_BOW = 0.004, 0.012
"""How far a line may bow, as a part of its length."""
FAR = 6.0
"""Pixels from the skeleton up to which a dilation is faster than a distance transform."""
KEPT = 40
"""Pixels of a growing stroke that are looked at again when it grows."""
MOST_PIECES = 700
"""Pieces of lines that are looked at, the longest: a drawing has far fewer, a scribble or a texture any number."""


@dataclass(frozen=True)
class Skeleton:
    """The thinned ink.

    mask      : (h, w) uint8, 1 on the skeleton
    points    : (k, 2) float, x and y of its pixels
    paths     : (m, 2) int32 each, x and y of the pixels of every branch in walking order
    pen_width : pixels
    """

    mask: NDArray[np.uint8]
    points: Floats
    paths: tuple[NDArray[np.int32], ...]
    pen_width: float

    @cached_property
    def distance(self) -> NDArray[np.float32]:
        """(h, w), distance of every pixel to the skeleton, pixels."""
        return _distance(1 - self.mask)

    def near(self, reach: float) -> NDArray[np.uint8]:
        """(h, w), 1 within reach, in pixels, of the skeleton."""
        if reach > FAR:
            return np.asarray(self.distance <= reach).view(np.uint8)
        point = np.ones((2 * int(reach) + 1,) * 2, np.uint8)
        point[int(reach), int(reach)] = 0
        ball = np.asarray(_distance(point) <= reach, np.uint8)
        return np.asarray(cv2.dilate(self.mask, ball), np.uint8)


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
    points = np.stack([xs, ys], axis=1, dtype=np.float64, casting="unsafe")
    return Skeleton(mask, points, tuple(paths), ink.pen_width)


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


@lru_cache(maxsize=64)
def thinned(count: int, most: int) -> Ints:
    """Indices of about `most` of `count` points, evenly, but without a period that could skip every other line."""
    index = np.arange(count)
    some = index if count <= most else index[(index * 0.6180339887) % 1.0 < most / count]
    some.flags.writeable = False
    return some


def _pieces(skeleton: Skeleton, tolerance: float, where: Bools | None) -> tuple[Floats, Ints, Ints]:
    """Nearly straight runs of two or more skeleton pixels, the longest first.

    Returns pixels (n, 2), one path after the other, and where among them each run begins and ends (with its last).
    """
    paths = [p for p in skeleton.paths if len(p) > 1 and (where is None or where[p[0, 1], p[0, 0]])]
    if not paths:
        return np.zeros((0, 2)), np.zeros(0, np.intp), np.zeros(0, np.intp)
    points = np.concatenate(paths)
    place = np.empty(skeleton.mask.shape, np.intp)
    place[points[:, 1], points[:, 0]] = np.arange(len(points))
    bends = [cv2.approxPolyDP(p[:, None], tolerance, False)[:, 0] if len(p) > 2 else p for p in paths]
    x, y = np.concatenate(bends).T
    # an index can fall only where a path crosses itself
    index = np.maximum.accumulate(place[y, x])
    run = np.diff(index) > 0
    run[np.cumsum([len(b) for b in bends])[:-1] - 1] = False
    first, last = index[:-1][run], index[1:][run]
    order = np.argsort(first - last, kind="stable")[:MOST_PIECES]
    return points.astype(np.float64), first[order], last[order]


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


def trace_strokes(skeleton: Skeleton, tolerance: float, where: Bools | None = None) -> Strokes:
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
