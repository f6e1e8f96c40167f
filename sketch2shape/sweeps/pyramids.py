"""Pyramids: a corner that lines join to all corners of a base.

Where all edges are drawn, the base is a cycle of such corners. With hidden edges left out only the near corners of a
base that is behind are seen; of a regular base, three tell the rest. A base in front is seen whole, but some of the
edges to the apex lie behind it.
"""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np

from sketch2shape.geometry import are_simple
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes import Skeleton, Strokes, are_covered, join_ends
from sketch2shape.sweeps.outlines import polygon
from sketch2shape.sweeps.sweep import Sweep, Way

MOST_CORNERS = 24
"""Corners that are looked at, the surest."""
MOST_SIDES = 12
"""Sides of a base."""
SIDES = {4: 0.7, 3: 1.6, 6: 1.9, 5: 2.3, 8: 3.0}
"""Nats for the number of sides of a regular base, the likeliest first."""
MOST_BEHIND = 4
"""Corners of a base in front whose edges to the apex lie behind it."""
MISFIT = 0.03
"""Fraction of the size by which seen corners may miss a regular base."""
LEANING = 0.06
"""Fraction of the size by which a point may stand off the middle of its base, in the picture."""
APART, APEX_ROOM = 0.02, 0.05
"""Fractions of the size within which two points are one, and within which of the apex strokes make no corner."""
LEAST_REACH, REACH = 4.0, 0.014
"""Pixels, and fraction of the size, from a line within which ink is its own: half a gap between dashes."""
COVERED = 0.8
"""Part of an edge that must have ink: dashes have gaps."""


def pyramids(traced: list[Strokes], meeting: Floats, skeleton: Skeleton, size: float) -> Iterator[Sweep]:
    """Pyramids that the corners of a drawing may show, seen from either side of the base.

    traced  : strokes at growing tolerance, dashes too
    meeting : (c, 2) float, pixels, where long lines meet: many strokes that end in one point seldom make one corner
    size    : of the drawing, pixels
    """
    for strokes in traced:
        joined = join_ends(strokes, skeleton.pen_width)
        points = joined.points[(joined.degree >= 2) | joined.on][:MOST_CORNERS]
        reach = max(LEAST_REACH, REACH * size, strokes.tolerance)
        some = np.concatenate([meeting, points])
        for k, apex in enumerate(some):
            if k and np.hypot(*(some[:k] - apex).T).min() < APART * size:
                continue
            corners = np.concatenate([apex[None], points[np.hypot(*(points - apex).T) > APEX_ROOM * size]])
            inked = _inked(corners, skeleton, reach)
            around = np.flatnonzero(inked[0])
            feet = _feet(around, corners, reach)
            for chosen in (feet, around) if len(feet) < len(around) else (around,):
                if 3 <= len(chosen) <= MOST_SIDES:
                    yield from _over(chosen, corners, inked, size, reach)


def _feet(around: Ints, points: Floats, reach: float) -> Ints:
    """Those of some corners that no line from the first point runs past to a farther one."""
    to = points[around] - points[0]
    long = np.hypot(*to.T) + 1e-9
    along = (to @ to.T) / long[None]
    across = np.abs(to[:, :1] * to[None, :, 1] - to[:, 1:] * to[None, :, 0]) / long[None]
    passed = (along > 0) & (along < 0.92 * long[None]) & (across < reach)
    return np.asarray(around[~passed.any(axis=1)])


def _inked(points: Floats, skeleton: Skeleton, reach: float) -> Bools:
    """(k, k) whether there is ink between two corners, and, but for lines from the first, no other on the way."""
    k = len(points)
    i, j = np.triu_indices(k, 1)
    inked = np.zeros((k, k), np.bool_)
    if not len(i):
        return inked
    covered = are_covered(skeleton.near(reach), points[i], points[j], COVERED)
    span = points[j] - points[i]
    long = np.hypot(*span.T) + 1e-9
    covered &= long > 2 * skeleton.pen_width
    to = points[None] - points[i][:, None]
    along = (to * span[:, None]).sum(axis=2) / long[:, None]
    across = np.abs(to[..., 0] * span[:, None, 1] - to[..., 1] * span[:, None, 0]) / long[:, None]
    between = (along > 0.08 * long[:, None]) & (along < 0.92 * long[:, None]) & (across < 0.5 * reach)
    # a side's foot may lie where another line runs past
    covered &= ~between.any(axis=1) | (i == 0)
    inked[i, j] = inked[j, i] = covered
    return inked


def _over(around: Ints, points: Floats, inked: Bools, size: float, reach: float) -> Iterator[Sweep]:
    """Pyramids with the first point and a base among the corners that it is joined to.

    reach : pixels by which sides may stray: corners where dashes end or lines cross a side are none of the base
    """
    way = Way(np.zeros(2), points[0], 0.0)
    chains: list[list[int]] = []
    for chain in _chains([int(a) for a in around], points, inked):
        closed = len(chain) > 2 and bool(inked[chain[0], chain[-1]])
        if closed:
            base = _without_straight(points[chain], reach)
            if len(base) >= 3:
                yield from (Sweep((polygon(base),), way, is_near) for is_near in (True, False))
        else:
            chains.append(chain)
    if chains:
        longest = max(map(len, chains))
        for chain in [c for c in chains if len(c) == longest][:2]:
            for base in _regular_bases(points[chain], points[0], size):
                yield Sweep((polygon(base),), way, is_near=False, regular=SIDES[len(base)])
            for walk in _closed(chain, inked):
                base = _without_straight(points[walk], reach)
                if len(base) == len(walk) and are_simple(base):
                    yield Sweep((polygon(base),), way, is_near=True)


def _chains(around: list[int], points: Floats, inked: Bools) -> Iterator[list[int]]:
    """Walks along edges between some corners that cannot go on or close, each once and at most a few hundred.

    One that crosses itself when closed is no base.
    """
    left = 400
    seen: set[frozenset[int]] = set()
    stack = [[a] for a in around]
    while stack and left:
        left -= 1
        walk = stack.pop()
        after = [b for b in around if inked[walk[-1], b] and b not in walk]
        stack += [[*walk, b] for b in after]
        closes = len(walk) > 2 and inked[walk[0], walk[-1]]
        if (after and not closes) or len(walk) < 3 or frozenset(walk) in seen:
            continue
        if not closes or are_simple(points[walk]):
            seen.add(frozenset(walk))
            yield walk


def _without_straight(base: Floats, reach: float) -> Floats:
    """Corners of a base but for those that lie on the line of their neighbours, to a few pixels."""
    return np.asarray(cv2.approxPolyDP(base.astype(np.float32)[:, None], reach, True)[:, 0], float)


def _closed(chain: list[int], inked: Bools) -> Iterator[list[int]]:
    """A walk gone on along edges until it is back, through corners that the apex, the first, is not joined to."""
    stack = [chain]
    while stack:
        walk = stack.pop()
        if len(walk) > len(chain) and inked[walk[-1], chain[0]]:
            yield walk
        elif len(walk) < len(chain) + MOST_BEHIND:
            ahead = np.flatnonzero(inked[walk[-1]] & ~inked[0]).tolist()
            stack += [[*walk, k] for k in ahead if k and k not in walk]


def _regular_bases(chain: Floats, apex: Floats, size: float) -> Iterator[Floats]:
    """Regular bases (n, 2), seen askew, whose seen corners a chain is, under a point above their middle."""
    k = len(chain)
    for n in SIDES:
        if n < k:
            continue
        turn = 2 * np.pi * np.arange(n) / n
        corners = np.stack([np.cos(turn), np.sin(turn), np.ones(n)], axis=1)
        told = np.linalg.lstsq(corners[:k], chain, rcond=None)[0]
        base = corners @ told
        if np.hypot(*(base[:k] - chain).T).max() > MISFIT * size or abs(told[2, 0] - apex[0]) > LEANING * size:
            continue
        hull = cv2.convexHull(np.concatenate([chain, apex[None]]).astype(np.float32))
        inside = [cv2.pointPolygonTest(hull, (float(x), float(y)), True) for x, y in base[k:]]
        # a corner beyond the seen outline would be seen
        if all(i > -MISFIT * size for i in inside):
            yield np.concatenate([chain, base[k:]])
