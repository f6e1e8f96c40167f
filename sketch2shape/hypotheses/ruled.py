"""Hypotheses for drawings whose lines are ruled and known: their corners need no tolerance, their regions no raster."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from sketch2shape.geometry import homology, plane_map, signed_area
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.hypotheses.wireframe import CornerGraph
from sketch2shape.model import Floats, Ints
from sketch2shape.strokes import MEET, RuledLines

EXACT_MAP = 0.15
"""Working pixels by which vertices may miss a simpler plane map than the drawing's."""
MOST_VERTICES = 64
"""Vertices of a face."""


def ruled_graph(lines: RuledLines) -> CornerGraph:
    """The corners, and which of them the drawing joins."""
    return CornerGraph(lines.corners, lines.joined, 2 * MEET)


def ruled_caps(lines: RuledLines) -> Iterator[Rings]:
    """Each region between the lines as a front face, the largest first, with the back that lines leaving it tell of."""
    rings = [_without_straight(region, lines) for region in _regions(lines)]
    proper = [ring for ring in rings if 3 <= len(ring) <= MOST_VERTICES and len(set(ring)) == len(ring)]
    for ring in sorted(proper, key=lambda r: -signed_area(lines.corners[r])):
        back = _back(np.array(ring), lines)
        if back is not None:
            yield Rings((lines.corners[ring],), (back,))


def _regions(lines: RuledLines) -> Iterator[list[int]]:
    """Corners around each region that the lines enclose, counter-clockwise (y up)."""
    after = _turns(lines)
    done: set[tuple[int, int]] = set()
    for first in after:
        way, ring = first, list[int]()
        while way not in done:
            done.add(way)
            ring.append(way[0])
            way = after[way]
        if not ring:
            continue
        if signed_area(lines.corners[ring]) > 0:  # the rest of the plane is gone round clockwise
            yield ring


def _turns(lines: RuledLines) -> dict[tuple[int, int], tuple[int, int]]:
    """For each way between neighbouring corners on a segment the one after it, with one region on the left of both."""
    near: list[list[int]] = [[] for _ in lines.corners]
    for own, (a, b) in zip(lines.on.T, lines.ends.tolist(), strict=True):
        row = np.flatnonzero(own)
        along = (lines.corners[row] - lines.corners[a]) @ (lines.corners[b] - lines.corners[a])
        row = row[np.argsort(along)].tolist()
        for i, j in pairwise(row):
            if j not in near[i]:  # two segments may join the same corners, one hardly beside the other
                near[i].append(j)
                near[j].append(i)
    after = {}
    for k, others in enumerate(near):
        x, y = (lines.corners[others] - lines.corners[k]).T
        around = [others[n] for n in np.argsort(np.arctan2(y, x))]
        for n, other in enumerate(around):
            after[other, k] = k, around[n - 1]
    return after


def _without_straight(ring: list[int], lines: RuledLines) -> list[int]:
    """Without the corners at which the ring runs straight on."""
    on = lines.on[ring]
    through = np.roll(on, 1, axis=0) & on & np.roll(on, -1, axis=0)
    return [ring[k] for k in np.flatnonzero(~through.any(axis=1))]


def _back(ring: Ints, lines: RuledLines) -> Floats | None:
    """(n, 2) the back face: the ends of lines that leave the ring, the rest where the plainest map has it."""
    far = [_far_end(k, ring, lines) for k in range(len(ring))]
    seen = np.array([k is not None for k in far])
    front, back = lines.corners[ring], lines.corners[[k or 0 for k in far]]
    if not seen.any():
        return None
    if np.count_nonzero(seen) == 1:
        return np.asarray(front + (back[seen] - front[seen]))
    image = homology.apply(plane_map(front, back, seen, EXACT_MAP), front)
    if not np.isfinite(image).all() or np.abs(image - back)[seen].max() > MEET:
        return None
    gap = image[:, None] - lines.corners
    off = np.hypot(gap[..., 0], gap[..., 1])
    nearest = off.argmin(axis=1)
    known = seen | (off.min(axis=1) <= MEET)
    return np.where(known[:, None], np.where(seen[:, None], back, lines.corners[nearest]), image)


def _far_end(k: int, ring: Ints, lines: RuledLines) -> int | None:
    """Where the one line ends that leaves the ring at its vertex k; None if none does, or it is cut off."""
    corner, n = ring[k], len(ring)
    along = lines.on[ring[k - 1]] | lines.on[ring[(k + 1) % n]]
    leaving = np.flatnonzero((lines.ends == corner).any(axis=1) & ~along)
    if len(leaving) != 1:
        return None
    far = int(lines.ends[leaving[0]].sum() - corner)
    return None if lines.is_cut[far] or far in ring else far
