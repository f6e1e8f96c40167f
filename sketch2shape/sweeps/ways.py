"""Ways: how an outline may become the back face, by where the drawing shows the back face's line.

The back of a prism is its front moved along a straight line of the drawing; the back of a tapered object its front
drawn together to where such lines meet. Along each of these a probe moves the outline until what would be seen of it
lies on ink.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import cv2
import numpy as np

from sketch2shape.geometry import line_crossings
from sketch2shape.model import Bools, Floats, as_gray
from sketch2shape.strokes import Skeleton, Strokes, interpolated
from sketch2shape.sweeps.sweep import Way

PROBES = 64
"""Points of an outline that are moved."""
STEPS = 90
"""Steps of a probe across the drawing's size."""
MOST_DIRECTIONS, MOST_CENTRES = 14, 6
"""Directions, and meeting points, that are probed: those of the longest lines."""
FARTHEST_CENTRE = 6.0
"""Distance from the lines' ends to where they meet, over the drawing's size, from which on they are parallel."""
ONE_WAY = 0.035
"""Radians up to which two lines have one direction."""
MOST_FAR, MOST_NEAR = 4, 2
"""Ways of one outline that are looked at more closely, by how much they hit for their length, and whatever that is."""
FAR = 0.3
"""Length of a way over the drawing's size from which on it says the most."""
LEAST_HITS = 0.6
"""Part of what would be seen of the back face that must lie on ink."""
LEAST_SEEN = 0.12
"""Part of the back face's outline that must be seen to say anything."""
LEAST_STROKE = 0.07
"""Length of a line over the drawing's size from which it may tell a direction."""
CELLS, LEAST_CELL = 110, 3.0
"""Cells across the drawing's size, and least side of one, pixels."""
MOSTLY = 0.75
"""Part of a line near ink from which on it is drawn."""
LACKING = 1.5
"""Cells with ink that one which lacks it outweighs."""
OUTWARD = 3.0
"""Largest scale of a back face that is the larger one."""


class _Probed(NamedTuple):
    """A way with what speaks for it: the part of what would be seen of the back face on ink, and the part seen."""

    way: Way
    hits: float
    seen: float


def directions(strokes: Strokes, size: float) -> Floats:
    """(k, 2) unit vectors of the drawing's straight lines, the longest first."""
    long = strokes.lengths
    some = long > LEAST_STROKE * size
    return np.asarray((strokes.ends[some, 1] - strokes.ends[some, 0]) / long[some, None]).reshape(-1, 2)


def distinct_directions(along: Floats) -> Floats:
    """(k, 2) the first directions of those that are nearly alike, each with its opposite."""
    found: list[Floats] = []
    for u in along:
        if len(found) < MOST_DIRECTIONS and all(abs(u[0] * v[1] - u[1] * v[0]) > ONE_WAY for v in found):
            found.append(u)
    return np.array([s * u for u in found for s in (1.0, -1.0)]).reshape(-1, 2)


def centres(strokes: Strokes, size: float) -> Floats:
    """(k, 2) points, pixels, at or beyond the ends of both of two long lines, where they meet."""
    some = strokes.ends[strokes.lengths > 2 * LEAST_STROKE * size][:10]
    i, j = np.triu_indices(len(some), 1)
    span = some[:, 1] - some[:, 0]
    long = np.hypot(*span.T) + 1e-9
    u = span / long[:, None]
    slanted = np.abs(u[i, 0] * u[j, 1] - u[i, 1] * u[j, 0]) > ONE_WAY
    i, j = i[slanted], j[slanted]
    s, t = line_crossings(some[i, 0], span[i], some[j, 0], span[j])
    ends = np.minimum(np.abs(s), np.abs(1 - s)) * long[i] + np.minimum(np.abs(t), np.abs(1 - t)) * long[j]
    inner = (s > 0.05) & (s < 0.95) & (np.minimum(s, 1 - s) * long[i] > 0.03 * size)
    inner |= (t > 0.05) & (t < 0.95) & (np.minimum(t, 1 - t) * long[j] > 0.03 * size)
    at = some[i, 0] + s[:, None] * span[i]
    kept: list[Floats] = []
    for k in np.argsort(np.where(inner, np.inf, -np.minimum(long[i], long[j])), kind="stable"):
        if inner[k] or len(kept) >= MOST_CENTRES:
            break
        if ends[k] < FARTHEST_CENTRE * size and all(np.hypot(*(at[k] - c)) > 0.02 * size for c in kept):
            kept.append(at[k])
    return np.array(kept).reshape(-1, 2)


def ways_of(loop: Floats, skeleton: Skeleton, along: Floats, meeting: Floats, size: float) -> list[Way]:
    """The likeliest ways of an outline to the back face.

    loop    : (k, 2) float, pixels
    along   : (d, 2) directions to probe
    meeting : (c, 2) centres to probe
    """
    p = loop[np.linspace(0, len(loop), PROBES, endpoint=False).astype(np.intp)]
    depth = _Depth.of(loop)
    reach = max(2.0, 0.006 * size)
    step = size / STEPS
    distance = (np.arange(STEPS) + 1.0) * step
    least = max(3 * skeleton.pen_width, 0.02 * size)
    far = distance[distance > least]
    found: list[_Probed] = []
    for u, (hits, seen) in zip(
        along, _probe(p, along[:, None] * far[:, None], depth, skeleton, reach + 0.5 * step), strict=True
    ):
        found += [_Probed(Way(far[k] * u), float(hits[k]), float(seen[k])) for k in _peaks(hits, seen)]
    for c in meeting:
        nearest = min(least / max(float(np.hypot(*(c - p).T).mean()), 1.0), 0.5)
        inward, outward = np.linspace(nearest, 0.9, 40), np.linspace(nearest, OUTWARD - 1.0, 60)
        for parts in (inward, -outward):
            ray = parts[None, :, None] * (c - p)[:, None]
            ((hits, seen),) = _probe(p, ray[None], depth, skeleton, reach + 0.5 * step)
            found += [
                _Probed(Way(np.zeros(2), c, 1.0 - float(parts[k])), float(hits[k]), float(seen[k]))
                for k in _peaks(hits, seen)
            ]
    straight = [f for f in found if f.way.centre is None]
    tapered = [f for f in found if f.way.centre is not None]
    return [*_likeliest(straight, p, size), *_likeliest(tapered, p, size)]


def _likeliest(found: list[_Probed], p: Floats, size: float) -> list[Way]:
    """The ways with the most hits, and those with the most for how far they lead: a line lies near itself."""

    def far(f: _Probed) -> float:
        return min(float(np.median(np.hypot(*f.way.of(p).T))) / (FAR * size), 1.0)

    ranked = sorted(found, key=lambda f: -f.hits * min(f.seen, 0.5))
    by_length = sorted(found, key=lambda f: -f.hits * min(f.seen, 0.5) * far(f))
    some = [*by_length[:MOST_FAR], *ranked[:MOST_NEAR]]
    return [f.way for k, f in enumerate(some) if not any(f is g for g in some[:k])]


def settled(way: Way, loop: Floats, skeleton: Skeleton, size: float, *, is_wire: bool = False) -> Way:
    """The way moved by small steps to where the seen image of an outline lies nearest to the ink."""
    p = loop[np.linspace(0, len(loop), PROBES, endpoint=False).astype(np.intp)]
    return _settled(way, p, None if is_wire else _Depth.of(loop), skeleton, size / STEPS)


class _Depth(NamedTuple):
    """How far inside an outline a place lies."""

    low: Floats
    map: np.ndarray

    @classmethod
    def of(cls, loop: Floats) -> _Depth:
        low = np.floor(loop.min(axis=0)) - 2
        size = np.ceil(loop.max(axis=0)) + 3 - low
        mask = np.zeros((int(size[1]), int(size[0])), np.uint8)
        cv2.fillPoly(mask, [np.round(loop - low).astype(np.int32)], 1)
        return cls(low, cv2.distanceTransform(as_gray(mask), cv2.DIST_L2, cv2.DIST_MASK_3))

    def within(self, points: Floats, margin: float) -> Bools:
        """Whether points (..., 2) lie more than the margin inside."""
        at = (points - (self.low - 0.5)).astype(np.int32)
        h, w = self.map.shape
        x, y = at[..., 0], at[..., 1]
        ok = (x >= 0) & (y >= 0) & (x < w) & (y < h)
        return np.asarray(ok & (self.map.take(np.where(ok, y * w + x, 0)) > margin))


def _probe(
    p: Floats, moves: Floats, depth: _Depth, skeleton: Skeleton, reach: float
) -> Iterator[tuple[Floats, Floats]]:
    """(s,) part of the seen outline on ink, and part that is seen, for each of some series of moves.

    p     : (p, 2) points of the outline
    moves : (m, s, 2), alike for all points, or (m, p, s, 2)
    """
    for move in moves:
        ray = p[:, None] + move
        hidden = np.logical_or.accumulate(depth.within(ray, 2.5), axis=1)
        on = _on_ink(ray, skeleton, reach)
        seen = np.count_nonzero(~hidden, axis=0)
        yield np.count_nonzero(on & ~hidden, axis=0) / np.maximum(seen, 1), seen / len(p)


def _on_ink(points: Floats, skeleton: Skeleton, reach: float) -> Bools:
    """Whether points (..., 2) lie on ink."""
    h, w = skeleton.distance.shape
    at = (points + 0.5).astype(np.int32)
    x, y = at[..., 0], at[..., 1]
    ok = (x >= 0) & (y >= 0) & (x < w) & (y < h)
    return np.asarray(ok & (skeleton.distance.take(np.where(ok, y * w + x, 0)) <= reach))


def _peaks(hits: Floats, seen: Floats) -> Iterator[int]:
    """The best two steps that are apart."""
    value = np.where(seen >= LEAST_SEEN, hits, 0.0)
    for _ in range(2):
        k = int(value.argmax())
        if value[k] < LEAST_HITS:
            return
        yield k
        value[max(k - 4, 0) : k + 5] = 0.0


def _settled(way: Way, p: Floats, depth: _Depth | None, skeleton: Skeleton, step: float) -> Way:
    """The way moved by small steps to where the seen outline lies nearest to the ink."""

    def cost(w: Way) -> float:
        to = w.of(p)
        at = p + to
        if depth is not None:
            at = at[~depth.within(p[:, None] + np.linspace(0.05, 1, 20)[:, None] * to[:, None], 2.5).any(axis=1)]
        if len(at) < 8:
            return np.inf
        off = interpolated(skeleton.distance, at)
        return float(np.minimum(off, 3 * step).mean())

    best, value = way, cost(way)
    for size in (step, 0.5 * step, 0.25 * step, 0.5):
        for _ in range(3):
            ways = list(_steps(best, size, float(np.hypot(*best.of(p[:1])[0]))))
            costs = [cost(w) for w in ways]
            k = int(np.argmin(costs))
            if costs[k] >= value - 1e-6:
                break
            best, value = ways[k], costs[k]
    return best


def _steps(way: Way, size: float, long: float) -> Iterator[Way]:
    if way.centre is None:
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            yield Way(way.shift + size * np.array([dx, dy], float))
    else:
        for s in (1.0, -1.0):
            scale = 1.0 - (1.0 - way.scale) * (1.0 + s * size / max(long, 1.0))
            if scale > 0:
                yield Way(way.shift, way.centre, scale)


@dataclass(frozen=True, eq=False)
class Cells:
    """The drawing in coarse cells, for a quick look at what an outline and its way would explain.

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
        high, wide = self.ink.shape
        at = (points.reshape(-1, 2) / self.side + 1.5).astype(np.int32)
        np.clip(at, 0, [wide - 1, high - 1], out=at)
        cells = np.zeros(high * wide, np.bool_)
        cells[at[:, 1] * wide + at[:, 0]] = True
        return cells.reshape(high, wide)

    def value(self, loop: Floats, way: Way, *, is_near: bool = True) -> float:
        """Part of the ink that an outline, what is seen of its image and the lines between explain, less what lacks."""
        p = loop[:: max(1, len(loop) // 400)]
        to = way.of(p)
        depth = _Depth.of(loop)
        t = np.linspace(0.04, 1.0, 24)
        ray = p[:, None] + t[:, None] * to[:, None]
        if not is_near:
            # the base of a cone behind its point
            ray = p[:, None] - 2 * t[:, None] * to[:, None]
            p = p[~depth.within(ray, 2.5).any(axis=1)]
            back = p[:0]
        else:
            back = (p + to)[~depth.within(ray, 2.5).any(axis=1)]
        told = self.of_points(np.concatenate([p, back, *self._drawn_sides(loop, way, depth, is_near=is_near)]))
        lacking = np.count_nonzero(told & ~self.near)
        explained = np.count_nonzero(_widened(told) & self.ink)
        return (explained - LACKING * lacking) / (np.count_nonzero(self.ink) + 1)

    def value_of_lines(self, ends: Floats) -> float:
        """The same of straight lines (k, 2, 2), dashed or not."""
        told = np.zeros(self.ink.shape, np.uint8)
        cv2.polylines(told, [*(ends / self.side + 1.5).astype(np.int32)], False, 1)
        cells = told.view(np.bool_)
        lacking = np.count_nonzero(cells & ~self.beside)
        explained = np.count_nonzero(_widened(cells) & self.ink)
        return (explained - LACKING * lacking) / (np.count_nonzero(self.ink) + 1)

    @cached_property
    def beside(self) -> Bools:
        """(h, w) bool, cells with or beside ink."""
        return _widened(self.ink)

    def _drawn_sides(self, loop: Floats, way: Way, depth: _Depth, *, is_near: bool) -> Iterator[Floats]:
        """Points of what is seen of the lines between an outline and its image, if they are drawn.

        A polygon that stands for an arc has corners from which no line starts.
        """
        q = loop[_sides(loop, way)]
        lines = q[:, None] + np.linspace(0, 1, 60)[:, None] * way.of(q)[:, None]
        inside = np.logical_or.accumulate(depth.within(lines, 2.5), axis=1)
        for line, hidden in zip(lines, inside, strict=True):
            seen = line[~hidden] if is_near else line
            if len(seen) and self._near_at(seen).mean() > MOSTLY:
                yield seen

    def _near_at(self, points: Floats) -> Bools:
        high, wide = self.ink.shape
        x, y = np.clip((points / self.side + 1.5).astype(np.int32), 0, [wide - 1, high - 1]).T
        return np.asarray(self.near[y, x])


def _widened(cells: Bools) -> Bools:
    return cv2.dilate(cells.view(np.uint8), np.ones((3, 3), np.uint8)).view(np.bool_)


def _sides(loop: Floats, way: Way) -> np.ndarray:
    """Where lines run from an outline to its image: its corners, and its ends across the way."""
    if way.is_pointed and way.centre is not None:
        # the tangents from the point
        seen = np.unwrap(np.arctan2(*(loop - way.centre).T[::-1]))
        return np.unique([int(seen.argmin()), int(seen.argmax())])
    bends = cv2.approxPolyDP(loop.astype(np.float32)[:, None], 0.012 * float(np.hypot(*np.ptp(loop, axis=0))), True)[
        :, 0
    ]
    before, after = bends - np.roll(bends, 1, axis=0), np.roll(bends, -1, axis=0) - bends
    turn = np.abs(np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1)))
    sharp = bends[turn > 0.5]
    found = [int(np.hypot(*(loop - b).T).argmin()) for b in sharp]
    to = way.of(loop)
    middle = loop.mean(axis=0)
    side = ((loop - middle)[:, 0] * to[:, 1] - (loop - middle)[:, 1] * to[:, 0]) / (np.hypot(*to.T) + 1e-9)
    return np.unique([*found, int(side.argmax()), int(side.argmin())])


def shifts(skeleton: Skeleton, along: Floats, size: float, most: int = 6) -> Floats:
    """(k, 2) shifts along some directions by which the most ink comes to lie on ink."""
    p = skeleton.points[:: max(1, len(skeleton.points) // 700)]
    step = size / STEPS
    far = np.arange(max(int(0.06 * STEPS), 3), int(0.8 * STEPS)) * step
    found: list[tuple[float, Floats]] = []
    for u in along[::2]:
        on = _on_ink(p[:, None] + far[:, None] * u, skeleton, max(2.0, 0.6 * step))
        value = on.mean(axis=0)
        rise = value - 0.5 * (
            value[np.clip(np.arange(len(far)) - 5, 0, None)]
            + value[np.clip(np.arange(len(far)) + 5, None, len(far) - 1)]
        )
        for _ in range(2):
            k = int((value + rise).argmax())
            if value[k] > 0.2:
                found.append((float(value[k] + rise[k]), far[k] * u))
            value[max(k - 4, 0) : k + 5] = -1.0
    found.sort(key=lambda f: -f[0])
    return np.array([d for _, d in found[:most]]).reshape(-1, 2)
