"""Polishing: a sweep moved to the ink, all its numbers together.

Gauss-Newton steps on the distances between what is seen of its lines and the nearest ink (iterative closest points, as
in P. Besl and N. McKay, "A method for registration of 3-D shapes", TPAMI 1992). The back face stays bound to the front,
all circles keep one shape.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from sketch2shape.model import Floats
from sketch2shape.sweeps import Circle, Frame, Outline, Sweep, Way

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

ROUNDS = 3
"""Times that the nearest ink is looked for again."""
SIDES = 12
"""Points of a straight line between the faces."""
DAMPING = 1e-3
"""Of the steps, over the mean square of the slopes: what the ink does not tell stays."""
NUDGE = 1e-3
"""Change of a number by which slopes are measured."""
FIXED_RATIO = 0.02
"""How near to 1 the ratio of circles is one of circles seen face on, which stays."""
MOST_RATIO, LEAST_RATIO = 1.2, 0.05
"""Ratios of circles that can be told."""


def polished(sweep: Sweep, ink: cKDTree, reach: float) -> Sweep:
    """The sweep moved to the ink.

    ink   : of the skeleton's pixels
    reach : pixels from which ink is that of another line
    """
    pixels = np.asarray(ink.data)
    if sweep.regular is not None:
        return sweep
    for _ in range(ROUNDS):
        numbers, scale = _numbers(sweep)
        points, along = _samples(sweep)
        distance, nearest = ink.query(points, distance_upper_bound=reach)
        used = np.isfinite(distance)
        if used.sum() < len(numbers):
            return sweep
        normal = np.stack([-along[used, 1], along[used, 0]], axis=1)
        off = ((pixels[nearest[used]] - points[used]) * normal).sum(axis=1)
        slopes = (_slopes(sweep, numbers, scale, points)[used] * normal[:, None]).sum(axis=2)
        weight = 1.0 / (1.0 + (off / (0.35 * reach)) ** 2)
        square = slopes.T @ (slopes * weight[:, None])
        damping = DAMPING * np.trace(square) / len(numbers) * np.eye(len(numbers))
        change = np.linalg.solve(square + damping, slopes.T @ (weight * off))
        sweep = _aligned(_with(sweep, numbers + np.clip(change, -2 * reach, 2 * reach) * scale))
    return sweep


def _aligned(sweep: Sweep) -> Sweep:
    """With its circles seen shortened along the way to the back face, as those of a prism are, where that has moved."""
    way, frame = sweep.way, sweep.frame
    if way.centre is not None or not _has_free_ratio(sweep):
        return sweep
    along = way.shift / (np.hypot(*way.shift) + 1e-9)
    turned = Frame(along if along @ frame.along > 0 else -along, frame.ratio)
    return replace(sweep, rings=tuple(ring.within(turned) for ring in sweep.rings))


def _slopes(sweep: Sweep, numbers: Floats, scale: Floats, points: Floats) -> Floats:
    """(k, n, 2) by how much each number, over its scale, moves each of the samples, points (k, 2)."""
    slopes = np.zeros((len(points), len(numbers), 2))
    parts = _parts(sweep)
    ends = np.cumsum([0, *(len(_ring_samples(ring, sweep)[0]) for ring in sweep.rings)])
    for ring, part, first, last in zip(sweep.rings, parts, ends[:-1], ends[1:], strict=True):
        for k in range(part.start, part.stop):
            step = numbers[part].copy()
            step[k - part.start] += NUDGE * scale[k]
            moved, _ = _ring_samples(_ring_with(ring, sweep.frame, step), sweep)
            slopes[first:last, k] = (moved - points[first:last]) / NUDGE
    for k in range(parts[-1].stop, len(numbers)):
        step = numbers.copy()
        step[k] += NUDGE * scale[k]
        moved, _ = _samples(_with(sweep, step))
        slopes[:, k] = (moved - points) / NUDGE
    return slopes


def _has_free_ratio(sweep: Sweep) -> bool:
    return sweep.has_arcs and abs(sweep.frame.ratio - 1.0) > FIXED_RATIO


def _numbers(sweep: Sweep) -> tuple[Floats, Floats]:
    """All numbers that may change, and what of each moves its line by about a pixel."""
    parts, scale = [], []
    for ring in sweep.rings:
        if ring.circle is not None:
            parts.append(np.array([*ring.circle.centre, ring.circle.radius]))
            scale.append(np.array([1.0 / max(sweep.frame.ratio, 0.1), 1.0, 1.0]))
            continue
        chord = np.hypot(*(np.roll(ring.vertices, -1, axis=0) - ring.vertices).T) + 1.0
        parts += [ring.vertices.ravel(), ring.bulges[ring.curved]]
        scale += [np.ones(ring.vertices.size), (2.0 / chord)[ring.curved]]
    if _has_free_ratio(sweep):
        size = float(np.hypot(*np.ptp(sweep.rings[0].line, axis=0)))
        parts.append(np.array([sweep.frame.ratio]))
        scale.append(np.array([4.0 / size]))
    way = sweep.way
    if way.centre is None:
        parts.append(way.shift)
        scale.append(np.ones(2))
        if way.slope is not None:
            reach = 0.5 * float(np.hypot(*np.ptp(sweep.rings[0].line, axis=0))) * float(np.hypot(*way.shift))
            parts.insert(-1, way.slope)
            scale.insert(-1, np.full(2, 1.0 / max(reach, 1.0)))
    else:
        long = float(np.hypot(*(way.centre - sweep.rings[0].line).T).mean())
        parts.append(np.array([*way.centre, *([] if way.is_pointed else [way.scale])]))
        scale.append(np.array([1.0, 1.0, *([] if way.is_pointed else [1.0 / long])]))
    return np.concatenate(parts), np.concatenate(scale)


def _with(sweep: Sweep, numbers: Floats) -> Sweep:
    """The sweep with these numbers."""
    way, rest = _way(sweep.way, numbers)
    frame = sweep.frame
    if _has_free_ratio(sweep):
        frame = Frame(frame.along, float(np.clip(rest[-1], LEAST_RATIO, MOST_RATIO)))
    rings = tuple(_ring_with(r, frame, numbers[p]) for r, p in zip(sweep.rings, _parts(sweep), strict=True))
    return replace(sweep, rings=rings, way=way)


def _parts(sweep: Sweep) -> list[slice]:
    """Where among the numbers those of each ring are."""
    counts = [3 if r.circle is not None else r.vertices.size + int(r.curved.sum()) for r in sweep.rings]
    ends = np.cumsum([0, *counts]).tolist()
    return [slice(a, b) for a, b in pairwise(ends)]


def _ring_with(ring: Outline, frame: Frame, numbers: Floats) -> Outline:
    """The ring with these numbers, in a frame."""
    if ring.circle is not None:
        x, y, radius = numbers
        return replace(ring, frame=frame, circle=Circle(np.array([x, y]), float(max(radius, 1.0))))
    n, bulges = ring.vertices.size, ring.bulges.copy()
    bulges[ring.curved] = numbers[n:]
    return Outline(frame, numbers[:n].reshape(-1, 2), bulges, ring.smooth)


def _way(way: Way, numbers: Floats) -> tuple[Way, Floats]:
    """The way told by the last numbers, and the numbers before."""
    if way.centre is None and way.slope is not None:
        return replace(way, shift=numbers[-2:].copy(), slope=numbers[-4:-2].copy()), numbers[:-4]
    if way.centre is None:
        return Way(numbers[-2:].copy()), numbers[:-2]
    if way.is_pointed:
        return replace(way, centre=numbers[-2:].copy()), numbers[:-2]
    return replace(way, centre=numbers[-3:-1].copy(), scale=float(np.clip(numbers[-1], 0.02, 0.98))), numbers[:-3]


def _samples(sweep: Sweep) -> tuple[Floats, Floats]:
    """Points of all its lines but silhouettes, ring by ring, and the direction of the line at each."""
    points, along = zip(*(_ring_samples(ring, sweep) for ring in sweep.rings), strict=True)
    return np.concatenate(points), np.concatenate(along)


def _ring_samples(ring: Outline, sweep: Sweep) -> tuple[Floats, Floats]:
    """The same of one ring. Lines drawn at smooth joints tell where these are: the rims run on alike on both sides."""
    line, way = ring.line, sweep.way
    ends = [line] if way.is_pointed else [line, line + way.of(line)]
    points, along = [], []
    for rim in ends:
        span = np.roll(rim, -1, axis=0) - rim
        points.append(rim + 0.5 * span)
        along.append(span)
    if len(ring.vertices):
        sharp = ring.vertices[~ring.smooth | sweep.tangents]
        to = way.of(sharp)
        t = (np.arange(SIDES) + 0.5) / SIDES
        points.append((sharp[:, None] + t[:, None] * to[:, None]).reshape(-1, 2))
        along.append(np.repeat(to, SIDES, axis=0))
    p, a = np.concatenate(points), np.concatenate(along)
    return p, a / (np.hypot(a[:, 0], a[:, 1]) + 1e-9)[:, None]
