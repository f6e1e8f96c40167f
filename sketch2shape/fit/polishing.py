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

from sketch2shape.model import Floats, Ints
from sketch2shape.sweeps import Circle, Frame, Outline, Sweep, Way, turning_points

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
MOST_SCALE, LEAST_SCALE = 0.98, 0.02
"""Scales of a back face that can be told from one of the same size, and from a point."""


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
        turns = [_turns(ring, sweep.way) for ring in sweep.rings]
        points, along = _samples(sweep, turns)
        distance, nearest = ink.query(points, distance_upper_bound=reach)
        used = np.isfinite(distance)
        if used.sum() < len(numbers):
            return sweep
        normal = np.stack([-along[used, 1], along[used, 0]], axis=1)
        off = ((pixels[nearest[used]] - points[used]) * normal).sum(axis=1)
        slopes = (_slopes(sweep, turns, numbers, scale, points)[used] * normal[:, None]).sum(axis=2)
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


def _turns(ring: Outline, way: Way) -> Ints:
    """(s,) int, the points of a ring whose silhouettes are fitted too: in perspective they tell where sides meet."""
    return np.zeros(0, np.intp) if way.slope is None else turning_points(ring, way.of(ring.line))


def _slopes(sweep: Sweep, turns: list[Ints], numbers: Floats, scale: Floats, points: Floats) -> Floats:
    """(k, n, 2) by how much each number, over its scale, moves each of the samples, points (k, 2)."""
    slopes = np.zeros((len(points), len(numbers), 2))
    parts = _parts(sweep)
    ends = np.cumsum([0, *(len(_ring_samples(ring, t, sweep)[0]) for ring, t in zip(sweep.rings, turns, strict=True))])
    for ring, t, part, first, last in zip(sweep.rings, turns, parts, ends[:-1], ends[1:], strict=True):
        for k in range(part.start, part.stop):
            step = numbers[part].copy()
            step[k - part.start] += NUDGE * scale[k]
            moved, _ = _ring_samples(_ring_with(ring, sweep.frame, step), t, sweep)
            slopes[first:last, k] = (moved - points[first:last]) / NUDGE
    for k in range(parts[-1].stop, len(numbers)):
        step = numbers.copy()
        step[k] += NUDGE * scale[k]
        moved, _ = _samples(_with(sweep, step), turns)
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
    way, line = sweep.way, sweep.rings[0].line
    if way.slope is not None:
        reach = 0.5 * float(np.hypot(*np.ptp(line, axis=0))) * float(np.hypot(*way.of(line).T).mean())
        parts.append(way.slope)
        scale.append(np.full(2, 1.0 / max(reach, 1.0)))
    if way.centre is None:
        parts.append(way.shift)
        scale.append(np.ones(2))
    else:
        long = float(np.hypot(*(way.centre - line).T).mean())
        # a far centre has to move far to be told
        far = 1.0 if way.slope is None else 1.0 / max(abs(1.0 - way.scale), LEAST_RATIO)
        parts.append(np.array([*way.centre, *([] if way.is_pointed else [way.scale])]))
        scale.append(np.array([far, far, *([] if way.is_pointed else [1.0 / long])]))
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
    if way.centre is None:
        way, rest = replace(way, shift=numbers[-2:].copy()), numbers[:-2]
    elif way.is_pointed:
        way, rest = replace(way, centre=numbers[-2:].copy()), numbers[:-2]
    else:
        most = MOST_SCALE if way.slope is None else 1.0 / LEAST_SCALE
        scale = float(np.clip(numbers[-1], LEAST_SCALE, most))
        way, rest = replace(way, centre=numbers[-3:-1].copy(), scale=scale), numbers[:-3]
    return (way, rest) if way.slope is None else (replace(way, slope=rest[-2:].copy()), rest[:-2])


def _samples(sweep: Sweep, turns: list[Ints]) -> tuple[Floats, Floats]:
    """Points of all its lines, ring by ring, and the direction of the line at each.

    turns : the points of each ring whose silhouettes count
    """
    every = (_ring_samples(ring, t, sweep) for ring, t in zip(sweep.rings, turns, strict=True))
    points, along = zip(*every, strict=True)
    return np.concatenate(points), np.concatenate(along)


def _ring_samples(ring: Outline, turns: Ints, sweep: Sweep) -> tuple[Floats, Floats]:
    """The same of one ring. Lines drawn at smooth joints tell where these are: the rims run on alike on both sides."""
    line, way = ring.line, sweep.way
    ends = [line] if way.is_pointed else [line, line + way.of(line)]
    points, along = [], []
    for rim in ends:
        span = np.roll(rim, -1, axis=0) - rim
        points.append(rim + 0.5 * span)
        along.append(span)
    sides = line[turns]
    if len(ring.vertices):
        sides = np.concatenate([ring.vertices[~ring.smooth | sweep.tangents], sides])
    to = way.of(sides)
    t = (np.arange(SIDES) + 0.5) / SIDES
    points.append((sides[:, None] + t[:, None] * to[:, None]).reshape(-1, 2))
    along.append(np.repeat(to, SIDES, axis=0))
    p, a = np.concatenate(points), np.concatenate(along)
    return p, a / (np.hypot(a[:, 0], a[:, 1]) + 1e-9)[:, None]
