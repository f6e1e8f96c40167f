"""Simplification: of two answers that explain a drawing alike, the one with fewer vertices holds.

A wavy hand bends its lines, and every bend looks like a flat vertex.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sketch2shape.model import Bools, Floats
from sketch2shape.refine import refine
from sketch2shape.regions import without_edge
from sketch2shape.rings import Rings, plausible
from sketch2shape.verify import Evidence, Sheet, judge, judge_all

UNSEEN_BEND = 0.03
"""Score that a wavy drawing may lose with a flat vertex of which only a bend in the front's outline tells."""
FLAT = 0.35
"""A vertex that turns less than this (radians) in both faces may be a bend of the hand."""


def simplified(rings: Rings, evidence: Evidence, sheet: Sheet, noise: float, points: Floats) -> tuple[Rings, Evidence]:
    """Without the vertices that the drawing does not need.

    noise  : rms distance between lines and ink, pixels; a steady hand means every bend it makes
    points : (k, 2) float, skeleton pixels
    """
    best = evidence.score
    thick = max(0.0, sheet.pen / sheet.size - 0.01)
    while True:
        n = sum(rings.sizes)
        # what dropping a true vertex costs goes with its share of the edges
        slack = min(0.15 / n, 0.002 + 0.03 * max(0.0, noise - 0.3)) + thick
        seen = evidence.drawn if noise > 0.5 else np.ones(n, bool)
        ways = [w for w in _simpler(rings, 3 * sheet.pen + 12 * max(0.0, noise - 0.5), seen) if plausible(w[0], 0.0)]
        for (fewer, hidden), judged in zip(ways, judge_all([w[0] for w in ways], sheet), strict=True):
            limit = best - slack - hidden * UNSEEN_BEND
            if noise > 0.5 and limit - 0.3 < judged.score < limit:
                fewer, judged = _settled(fewer, judged, sheet, points)
            if judged.score >= limit:
                rings, evidence, best = fewer, judged, max(best, judged.score)
                break
        else:
            return rings, evidence


def _settled(rings: Rings, judged: Evidence, sheet: Sheet, points: Floats) -> tuple[Rings, Evidence]:
    """Moved to the ink: one stroke in place of two lies between them."""
    moved, _ = refine(rings, points, 3 * sheet.reach, judged.drawn)
    return moved, judge(moved, sheet) if plausible(moved, 0.0) else judged


def _simpler(rings: Rings, short: float, drawn: Bools) -> Iterator[tuple[Rings, bool]]:
    """The rings with a flat vertex dropped, or with an edge that is short in both faces drawn together to a tip.

    Also says whether what goes is a flat vertex whose partner behind nobody sees.
    """
    start = 0
    for k, (front, back) in enumerate(zip(rings.front, rings.back, strict=True)):
        n = len(front)
        seen = drawn[start : start + n]
        start += n
        if n <= 3:
            continue
        turns = [_turn(front, i) + _turn(back, i) for i in range(n)]
        for i in np.argsort(turns)[: sum(t < 2 * FLAT for t in turns)]:
            yield _replaced(rings, k, np.delete(front, i, axis=0), np.delete(back, i, axis=0)), not seen[i]
        for i in range(n):
            j = (i + 1) % n
            if np.linalg.norm(front[i] - front[j]) < short and np.linalg.norm(back[i] - back[j]) < short:
                tips = without_edge(front, i), without_edge(back, i)
                yield _replaced(rings, k, *tips), False


def _replaced(rings: Rings, k: int, front: Floats, back: Floats) -> Rings:
    """The rings with the k-th pair replaced."""
    return Rings(
        tuple(front if j == k else r for j, r in enumerate(rings.front)),
        tuple(back if j == k else r for j, r in enumerate(rings.back)),
    )


def _turn(ring: Floats, i: int) -> float:
    """By how much a ring turns at vertex i, radians."""
    u, v = ring[i] - ring[i - 1], ring[(i + 1) % len(ring)] - ring[i]
    return abs(float(np.arctan2(u[0] * v[1] - u[1] * v[0], u @ v)))
