"""Doubts: what speaks against an answer although it explains nearly all ink.

Two kinds of wrong answers score well. In a table or a grid, faces and connecting edges can be laid over the same lines;
and a connecting edge can be left out, with its two vertices, where both faces run nearly straight on.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.evidence.score import PERFECT, Evidence
from sketch2shape.evidence.sheet import Sheet
from sketch2shape.geometry import project
from sketch2shape.hypotheses import Rings, frame
from sketch2shape.model import Bools, Floats
from sketch2shape.strokes import trace_skeleton

DOUBLED, DOUBLED_FACTOR = 0.5, 0.6
"""Part of the edges' length that lies on other edges beyond which an answer is none, and the factor on its score ..."""
DOUBLED_PERFECT = 0.67
"""... and for an answer that explains all ink: right ones reach 0.63 where the depth runs along edges of a face."""
LONG = 1.1
"""Length of all edges over that of the ink from which on some may lie on each other."""
LEFT, LEFT_FACTOR = 0.6, 0.8
"""Unexplained length of a stroke over a connecting edge's from which it is one, and the factor on the score."""
PLACES = ((np.arange(24) + 0.5) / 24)[:, None]
"""Where on a line it is looked at."""


def doubted(rings: Rings, evidence: Evidence, sheet: Sheet) -> Evidence:
    """The evidence with the score that is left after all doubts."""
    score, is_perfect = evidence.score, evidence.score >= PERFECT
    a, b = _edges(rings)
    is_long = np.abs(b - a).max(axis=1).sum() > LONG * sheet.ink
    if is_long and doubled(rings, sheet.reach) > (DOUBLED_PERFECT if is_perfect else DOUBLED):
        score *= DOUBLED_FACTOR
    if not is_perfect and has_edge_left(rings, sheet):
        score *= LEFT_FACTOR
    return replace(evidence, score=score)


def doubled(rings: Rings, reach: float) -> float:
    """Part of the length of all edges that lies along another edge, at most reach pixels off."""
    a, b = _edges(rings)
    beside = _beside(_samples(a, b), a, b, reach).reshape(len(a), -1, len(a)) & _parallel(a, b, a, b, 0.1)[:, None]
    beside[np.arange(len(a)), :, np.arange(len(a))] = False
    length = np.linalg.norm(b - a, axis=1)
    return float((beside.any(axis=2).mean(axis=1) * length).sum() / length.sum())


def has_edge_left(rings: Rings, sheet: Sheet) -> bool:
    """Whether an unexplained stroke runs from edge to edge, as long as a connecting edge and parallel to one."""
    a, b = _edges(rings)
    m = len(a) // 3
    front, back = rings.vertices[:m], rings.vertices[m:]
    rung = float(np.median(np.linalg.norm(back - front, axis=1)))
    ends = trace_skeleton(sheet.skeleton, max(1.5, sheet.reach / 2)).ends
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    ends, length = ends[length >= LEFT * rung], length[length >= LEFT * rung]
    if not len(ends):
        return False
    start, end = ends[:, 0], ends[:, 1]
    known = _beside(_samples(start, end), a, b, sheet.reach + 1.5).any(axis=1).reshape(len(ends), -1)
    left = (~known).mean(axis=1) * length >= LEFT * rung
    joined = _beside(ends.reshape(-1, 2), a, b, 1.5 * sheet.reach + 3.0).any(axis=1).reshape(-1, 2).all(axis=1)
    return bool((left & joined & _parallel(start, end, front, back, 0.15).any(axis=1)).any())


def _edges(rings: Rings) -> tuple[Floats, Floats]:
    """Both ends of all edges, (3m, 2) each."""
    v, edges = rings.vertices, frame(rings.sizes).edges
    return v[edges[:, 0]], v[edges[:, 1]]


def _samples(a: Floats, b: Floats) -> Floats:
    """Points on the segments from a to b, (k, 2) each, one segment after the other."""
    return np.asarray((a[:, None] + PLACES * (b - a)[:, None]).reshape(-1, 2))


def _beside(points: Floats, a: Floats, b: Floats, reach: float) -> Bools:
    """(k, m): which points (k, 2) lie at most reach pixels off the m segments from a to b."""
    length = np.linalg.norm(b - a, axis=1) + 1e-9
    along, across = project(points, a, (b - a) / length[:, None])
    return np.asarray((across <= reach) & (along >= -reach) & (along <= length + reach))


def _parallel(a: Floats, b: Floats, c: Floats, d: Floats, sine: float) -> Bools:
    """(k, m): which of k segments from a to b enclose an angle of a smaller sine with which of m from c to d."""
    (x, y), (u, v) = (b - a).T, (d - c).T
    cross = np.abs(x[:, None] * v - y[:, None] * u)
    return np.asarray(cross < sine * np.hypot(x, y)[:, None] * np.hypot(u, v))
