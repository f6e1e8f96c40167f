"""Simplification: of two answers that explain a drawing alike, the one with fewer vertices holds.

A wavy hand bends its lines, and every bend looks like a flat vertex.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from sketch2shape.evidence import Evidence, Sheet, judge, judge_all
from sketch2shape.fit.refinement import refine
from sketch2shape.hypotheses import Rings, plausible, without_edge
from sketch2shape.model import Bools, Floats

UNSEEN_BEND = 0.03
"""Score that a wavy drawing may lose with a flat vertex of which only a bend in the front's outline tells."""
MARK = 0.006
"""Score that any drawing may lose with a vertex whose ink the rest of the object does not need: a mark at a corner."""
BATCH = 12
"""Ways that are judged together: the first good one is taken."""
MOST_SETTLED = 12
"""Ways of one hypothesis that are moved to the ink to be judged: only arcs cut into short edges have more."""
FLAT = 0.35
"""A vertex that turns less than this (radians) in both faces may be a bend of the hand."""


def simplified(rings: Rings, evidence: Evidence, sheet: Sheet, noise: float, points: Floats) -> tuple[Rings, Evidence]:
    """Without the vertices that the drawing does not need.

    noise  : rms distance between lines and ink, pixels; a steady hand means every bend it makes
    points : (k, 2) float, skeleton pixels
    """
    best, unsettled = evidence.score, MOST_SETTLED
    thick = max(0.0, sheet.pen / sheet.size - 0.01)
    while True:
        n = sum(rings.sizes)
        # what dropping a true vertex costs goes with its share of the edges
        slack = min(0.15 / n, 0.002 + 0.03 * max(0.0, noise - 0.3)) + thick
        ways = _simpler(rings, 3 * sheet.pen + 12 * max(0.0, noise - 0.5), evidence.drawn, sheet.pen)
        for way, judged in _judged(ways, sheet):
            fewer = way.rings
            limit = best - slack - (noise > 0.5 and way.is_unseen_bend) * UNSEEN_BEND
            hopeful = judged.score < limit and (way.is_blunt_tip or judged.score > limit - 0.3)
            if noise > 0.5 and hopeful and unsettled:
                unsettled -= 1
                fewer, judged = _settled(way, judged, sheet, points)
            if judged.support >= evidence.support - 0.0005 and judged.weakest >= evidence.weakest - 0.01:
                limit -= MARK
            if judged.score >= limit:
                rings, evidence, best = fewer, judged, max(best, judged.score)
                break
        else:
            return rings, evidence


class _Way(NamedTuple):
    """A way to make a hypothesis simpler.

    rings          : what is left of it
    drawn          : (m,) bool, back vertices that ink shows
    is_blunt_tip   : whether an edge of no more than two pen widths has been drawn together to a tip
    is_unseen_bend : whether a flat vertex goes whose partner behind nobody sees
    """

    rings: Rings
    drawn: Bools
    is_blunt_tip: bool = False
    is_unseen_bend: bool = False


def _judged(ways: list[_Way], sheet: Sheet) -> Iterator[tuple[_Way, Evidence]]:
    """Those that could be an object and how well each explains the drawing, a few at a time."""
    for k in range(0, len(ways), BATCH):
        some = [w for w in ways[k : k + BATCH] if plausible(w.rings, 0.0)]
        yield from zip(some, judge_all([w.rings for w in some], sheet), strict=True)


def _settled(way: _Way, judged: Evidence, sheet: Sheet, points: Floats) -> tuple[Rings, Evidence]:
    """Moved to the ink: one stroke in place of two lies between them, and a blunt tip does not reach its corner."""
    moved, _ = refine(way.rings, points, 3 * sheet.reach, way.drawn)
    return moved, judge(moved, sheet) if plausible(moved, 0.0) else judged


def _simpler(rings: Rings, short: float, drawn: Bools, pen: float) -> list[_Way]:
    """Without a flat vertex, or with an edge that is short in both faces drawn together to a tip."""
    ways, start = [], 0
    for k, (front, back) in enumerate(zip(rings.front, rings.back, strict=True)):
        n = len(front)
        here = start + np.arange(n)
        start += n
        if n <= 3:
            continue
        bends = turns(front) + turns(back)
        for i in np.argsort(bends, kind="stable")[: np.count_nonzero(bends < 2 * FLAT)]:
            fewer = _replaced(rings, k, np.delete(front, i, axis=0), np.delete(back, i, axis=0))
            ways.append(_Way(fewer, np.delete(drawn, here[i]), is_unseen_bend=not drawn[here[i]]))
        lengths = np.maximum(_edge_lengths(front), _edge_lengths(back))
        for i in np.flatnonzero(lengths < short).tolist():
            j = (i + 1) % n
            either = drawn.copy()
            either[here[i]] |= drawn[here[j]]
            fewer = _replaced(rings, k, without_edge(front, i), without_edge(back, i))
            ways.append(_Way(fewer, np.delete(either, here[j]), is_blunt_tip=bool(lengths[i] < 2 * pen)))
    return ways


def _replaced(rings: Rings, k: int, front: Floats, back: Floats) -> Rings:
    """The rings with the k-th pair replaced."""
    return Rings(
        tuple(front if j == k else r for j, r in enumerate(rings.front)),
        tuple(back if j == k else r for j, r in enumerate(rings.back)),
    )


def turns(ring: Floats) -> Floats:
    """(n,) float, by how much a ring turns at each vertex, radians."""
    v = np.concatenate([ring[1:], ring[:1]]) - ring
    u = np.concatenate([v[-1:], v[:-1]])
    return np.asarray(np.abs(np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1))))


def _edge_lengths(ring: Floats) -> Floats:
    """(n,) float, pixels, of the edge from each vertex to the next."""
    way = np.concatenate([ring[1:], ring[:1]]) - ring
    return np.asarray(np.hypot(way[:, 0], way[:, 1]))
