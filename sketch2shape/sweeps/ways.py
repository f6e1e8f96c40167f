"""Ways: how an outline may become the back face, by where the drawing shows the back face's line.

The back of a prism is its front moved along a straight line of the drawing; the back of a tapered object its front
drawn together to where such lines meet. Along each of these a probe moves the outline until what would be seen of it
lies on ink.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import cv2
import numpy as np

from sketch2shape.geometry import line_crossings
from sketch2shape.model import Bools, Floats
from sketch2shape.strokes import Skeleton, Strokes, interpolated
from sketch2shape.sweeps.loops import Loop
from sketch2shape.sweeps.sweep import Way

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

STEPS = 90
"""Steps of a probe across the drawing's size."""
MOST_DIRECTIONS, MOST_CENTRES = 14, 12
"""Directions, and meeting points, that are probed: those of the longest lines."""
FARTHEST_CENTRE = 6.0
"""Distance from the lines' ends to where they meet, over the drawing's size, from which on they are parallel."""
SAME_CENTRE = 0.02
"""Distance of two centres, over the drawing's size or their distance from it, up to which they are one."""
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
BESIDE = 2.5
"""Pixels by which a point must lie inside an outline to be hidden by it."""
ON_THE_WAY, LEAST_PROBES = np.linspace(0.05, 1, 20), 8
"""Parts of a way at which an outline may hide its image, and points of the image that have to be seen."""
CORRELATED_CELLS, AROUND = 240, (8, 4)
"""Cells across the drawing's size in which it is compared with itself, and those around a shift that it has to beat:
few for short shifts, as all ink lies on itself nearly unmoved."""
LEAST_RISE, LEAST_SHIFT = 0.03, 0.02
"""Part of the ink by which a shift must beat those around it, and its least length over the drawing's size."""
SETTLING, PARALLEL = 5, 0.06
"""Steps in which a shift is settled, and the part by which it grows over a face in a parallel drawing at most."""
REFINING = 500
"""Points of ink that settle a shift to a pixel."""
OUTWARD = 5.0
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


def distinct_centres(points: Floats, middle: Floats, size: float) -> Floats:
    """(k, 2) those of some points that no earlier one says: far ones to a part of how far off they are."""
    kept: list[Floats] = []
    for c in points:
        near = SAME_CENTRE * max(float(np.hypot(*(c - middle))), size)
        if all(np.hypot(*(c - k)) > near for k in kept):
            kept.append(c)
    return np.array(kept).reshape(-1, 2)


def ways_along(loop: Loop, skeleton: Skeleton, along: Floats, size: float) -> list[Way]:
    """The likeliest ways of an outline to a back face of its own size.

    along : (d, 2) directions to probe
    size  : of the drawing, pixels
    """
    step = size / STEPS
    distance = (np.arange(STEPS) + 1.0) * step
    far = distance[distance > _least(skeleton, size)]
    found: list[_Probed] = []
    for u, (hits, seen) in zip(along, _probe(loop, along[:, None] * far[:, None], skeleton, size), strict=True):
        found += [_Probed(Way(far[k] * u), float(hits[k]), float(seen[k])) for k in _peaks(hits, seen)]
    return _likeliest(found, loop.probes, size)


def ways_towards(loop: Loop, skeleton: Skeleton, meeting: Floats, size: float) -> list[Way]:
    """The likeliest ways of an outline to a smaller or larger back face.

    meeting : (c, 2) float, pixels, centres to probe
    size    : of the drawing, pixels
    """
    p, found = loop.probes, []
    for c in meeting:
        nearest = min(_least(skeleton, size) / max(float(np.hypot(*(c - p).T).mean()), 1.0), 0.5)
        inward, outward = np.linspace(nearest, 0.9, 40), np.linspace(nearest, OUTWARD - 1.0, 120)
        for parts in (inward, -outward):
            ray = parts[None, :, None] * (c - p)[:, None]
            ((hits, seen),) = _probe(loop, ray[None], skeleton, size)
            found += [
                _Probed(Way(np.zeros(2), c, 1.0 - float(parts[k])), float(hits[k]), float(seen[k]))
                for k in _peaks(hits, seen)
            ]
    return _likeliest(found, p, size)


def _least(skeleton: Skeleton, size: float) -> float:
    """Pixels below which an outline lies on its own ink wherever it is moved."""
    return max(3 * skeleton.pen_width, 0.02 * size)


def _likeliest(found: list[_Probed], p: Floats, size: float) -> list[Way]:
    """The ways with the most hits, and those with the most for how far they lead: a line lies near itself."""

    def far(f: _Probed) -> float:
        return min(float(np.median(np.hypot(*f.way.of(p).T))) / (FAR * size), 1.0)

    ranked = sorted(found, key=lambda f: -f.hits * min(f.seen, 0.5))
    by_length = sorted(found, key=lambda f: -f.hits * min(f.seen, 0.5) * far(f))
    some = [*by_length[:MOST_FAR], *ranked[:MOST_NEAR]]
    return [f.way for k, f in enumerate(some) if not any(f is g for g in some[:k])]


def _probe(loop: Loop, moves: Floats, skeleton: Skeleton, size: float) -> Iterator[tuple[Floats, Floats]]:
    """(s,) part of the seen outline on ink, and part that is seen, for each of some series of moves.

    moves : (m, s, 2), alike for all points of the outline, or (m, p, s, 2)
    """
    p, reach = loop.probes, max(2.0, 0.006 * size) + 0.5 * size / STEPS
    for move in moves:
        ray = p[:, None] + move
        hidden = np.logical_or.accumulate(loop.inside.holds(ray, BESIDE), axis=1)
        on = _on_ink(ray, skeleton, reach)
        seen = np.count_nonzero(~hidden, axis=0)
        yield np.count_nonzero(on & ~hidden, axis=0) / np.maximum(seen, 1), seen / len(p)


def _on_ink(points: Floats, skeleton: Skeleton, reach: float) -> Bools:
    """Whether points (..., 2) lie on ink."""
    return np.asarray(_off_ink(points, skeleton) <= reach)


def _off_ink(points: Floats, skeleton: Skeleton) -> Floats:
    """(...) pixels from points (..., 2) to ink, infinite outside the picture."""
    h, w = skeleton.distance.shape
    at = (points + 0.5).astype(np.int32)
    x, y = at[..., 0], at[..., 1]
    ok = (x >= 0) & (y >= 0) & (x < w) & (y < h)
    return np.where(ok, skeleton.distance.take(np.where(ok, y * w + x, 0)), np.inf)


def _peaks(hits: Floats, seen: Floats) -> Iterator[int]:
    """The best two steps that are apart."""
    value = np.where(seen >= LEAST_SEEN, hits, 0.0)
    for _ in range(2):
        k = int(value.argmax())
        if value[k] < LEAST_HITS:
            return
        yield k
        value[max(k - 4, 0) : k + 5] = 0.0


def settled(way: Way, loop: Loop, skeleton: Skeleton, size: float) -> Way:
    """The way moved by small steps to where the seen image of an outline lies nearest to the ink.

    size : of the drawing, pixels
    """
    p, step = loop.probes, size / STEPS

    def cost(w: Way) -> float:
        to = w.of(p)
        ray = p[:, None] + ON_THE_WAY[:, None] * to[:, None]
        at = (p + to)[~loop.inside.holds(ray, BESIDE).any(axis=1)]
        if len(at) < LEAST_PROBES:
            return np.inf
        off = interpolated(skeleton.distance, at)
        return float(np.minimum(off, 3 * step).mean())

    best, value = way, cost(way)
    for by in (step, 0.5 * step, 0.25 * step, 0.5):
        for _ in range(3):
            ways = list(_steps(best, by, float(np.hypot(*best.of(p[:1])[0]))))
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


def shifts(skeleton: Skeleton, size: float, most: int = 10) -> Floats:
    """(k, 2) shifts by which much of the ink comes to lie on ink, and more than by those around them.

    The autocorrelation of the ink, by Fourier transforms. A long line lies on itself and on what is parallel to it for
    a while: ridges, on which the shift to the back face is a summit, since by it everything lies on ink.

    size : of the drawing, pixels
    """
    from scipy import fft  # slow to load, and not needed for straight drawings

    side = size / CORRELATED_CELLS
    at = ((skeleton.points - skeleton.points.min(axis=0)) / side).astype(np.intp)
    ink = np.zeros(tuple((at.max(axis=0) + 1)[::-1]), np.float32)
    ink[at[:, 1], at[:, 0]] = 1.0
    near = cv2.dilate(cv2.copyMakeBorder(ink, 1, 1, 1, 1, cv2.BORDER_CONSTANT), np.ones((3, 3), np.uint8))
    shape = [fft.next_fast_len(2 * n + 2, real=True) for n in ink.shape]
    found = fft.irfft2(np.conj(fft.rfft2(ink, shape)) * fft.rfft2(near, shape), shape) / ink.sum()
    value = np.asarray(np.fft.fftshift(found), np.float32)
    middle = np.array([shape[1] // 2 + 1, shape[0] // 2 + 1])
    rise = np.maximum(*(value - cv2.blur(value, (2 * k + 1, 2 * k + 1)) for k in AROUND))
    summit = (rise >= cv2.dilate(rise, np.ones((7, 7), np.uint8))) & (rise > LEAST_RISE)
    places = np.argwhere(summit)[:, ::-1]
    places = places[np.argsort(-rise[places[:, 1], places[:, 0]], kind="stable")]
    shift = (places - middle) * side
    half = (shift[:, 1] > 0) | ((shift[:, 1] == 0) & (shift[:, 0] > 0))
    some = shift[half & (np.hypot(*shift.T) > LEAST_SHIFT * size)][:most]
    return np.array([_refined(d, skeleton, side) for d in some]).reshape(-1, 2)


def _refined(shift: Floats, skeleton: Skeleton, side: float) -> Floats:
    """A shift moved by up to a cell to where the most ink lies on ink."""
    p = skeleton.points[:: max(1, len(skeleton.points) // REFINING)]
    steps = np.linspace(-1.0, 1.0, 5) * side
    moved = shift + np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 1, 2)
    return np.asarray(moved[np.exp(-0.5 * _off_ink(p + moved, skeleton) ** 2).sum(axis=1).argmax(), 0])


def settled_wire(shift: Floats, line: Floats, ink: cKDTree, reach: float) -> Way:
    """The shift of a wireframe's outline to its image on ink, growing over the face if it is drawn in perspective.

    Gauss-Newton steps on the distances to the nearest ink, as in `fit.polishing`.

    line  : (k, 2) float, pixels, of the outline, and of its holes
    ink   : of the skeleton's pixels
    reach : pixels from which ink is that of another line
    """
    pixels, origin = np.asarray(ink.data), line.mean(axis=0)
    span = np.roll(line, -1, axis=0) - np.roll(line, 1, axis=0)
    normal = np.stack([-span[:, 1], span[:, 0]], axis=1) / (np.hypot(*span.T)[:, None] + 1e-9)
    size = float(np.hypot(*np.ptp(line, axis=0)))
    place = (line - origin) / size
    way = Way(shift, slope=np.zeros(2), origin=origin)
    for _ in range(SETTLING):
        at = line + way.of(line)
        distance, nearest = ink.query(at, distance_upper_bound=reach)
        used = np.isfinite(distance)
        if np.count_nonzero(used) < len(line) // 4:
            break
        off = ((pixels[nearest[used]] - at[used]) * normal[used]).sum(axis=1)
        across = normal[used] @ way.shift
        slopes = np.concatenate([normal[used], across[:, None] * place[used]], axis=1)
        weight = 1.0 / (1.0 + (off / (0.35 * reach)) ** 2)
        square = slopes.T @ (slopes * weight[:, None])
        change = np.linalg.solve(square + 1e-3 * np.trace(square) * np.eye(4), slopes.T @ (weight * off))
        slope = (np.zeros(2) if way.slope is None else way.slope) + change[2:] / size
        way = replace(way, shift=way.shift + change[:2], slope=slope)
    grows = 0.0 if way.slope is None else float(np.hypot(*way.slope)) * size
    return way if grows > PARALLEL else Way(way.shift)
