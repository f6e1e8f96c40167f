"""Search: from the ink of one object to the best verified hypothesis.

Nobody knows beforehand how straight a drawing's lines are, so the search runs in rounds of growing tolerance and stops
at the first that explains the drawing. A round traces strokes, joins their ends to corners, asks both face separators
(`separate` where all edges are drawn, `caps` where the back is dashed or missing) for hypotheses, best first and within
a budget, and has them verified.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from sketch2shape import caps, separate
from sketch2shape.corners import Corners, join_ends
from sketch2shape.model import Ink
from sketch2shape.refine import refine
from sketch2shape.sheet import Group, split_groups
from sketch2shape.strokes import Skeleton, coverage, thin, trace_strokes
from sketch2shape.verify import Evidence, Rings, Sheet, judge, skeleton_sheet

GOOD = 0.975
MOST_HYPOTHESES = 160
MOST_CORNERS = 120


@dataclass(frozen=True)
class Found:
    """A verified hypothesis.

    rings     : in working pixels
    evidence  : how well it agrees with the ink
    tolerance : of the round that found it, pixels
    noise     : rms distance between model and ink, pixels
    """

    rings: Rings
    evidence: Evidence
    tolerance: float
    noise: float = 0.0

    @property
    def confidence(self) -> float:
        """0..1, how sure one can be that this is the object."""
        return float(np.clip(self.evidence.score, 0.0, 1.0))


def corner_graph(skeleton: Skeleton, corners: Corners, tolerance: float) -> separate.CornerGraph:
    """Corners that can be vertices, and which of them have ink between them."""
    keep = np.flatnonzero((corners.degree >= 2) | corners.on)[:MOST_CORNERS]
    points = corners.points[keep]
    k = len(points)
    i, j = np.triu_indices(k, 1)
    share = coverage(skeleton.distance, points[i], points[j], tolerance + 0.5)
    apart = np.linalg.norm(points[i] - points[j], axis=1) > 2 * skeleton.pen_width
    inked = np.zeros((k, k), bool)
    inked[i, j] = inked[j, i] = (share > 0.9) & apart
    return separate.CornerGraph(points, inked, 0.75 * skeleton.pen_width + 2.5 * tolerance + 1)


def wire_hypotheses(graph: separate.CornerGraph) -> Iterator[Rings]:
    """Closed ladders of rungs, each also with the smaller ones inside it as holes."""
    for ladder in separate.ladders(graph):
        found: dict[frozenset[int], Rings] = {}
        for cycle in separate.cycles(ladder):
            key = frozenset(cycle.tolist())
            if key not in found:
                found[key] = separate.ring_pair(ladder, graph, cycle)
                yield found[key]
        if len(found) > 1:
            yield from _holed(found)


def _holed(found: dict[frozenset[int], Rings]) -> Iterator[Rings]:
    keys = sorted(found, key=len, reverse=True)
    for key in keys[:6]:
        others = [found[k] for k in keys if not k & key]
        rings = separate.with_holes(found[key], others[:8]) if others else None
        if rings is not None:
            yield rings


def find_all(ink: Ink) -> list[Found]:
    """The best hypothesis for every group of ink on the sheet that has one, in the sheet's working pixels."""
    found = []
    for group in split_groups(ink):
        best = find(group)
        if best is not None:
            shift = group.offset
            rings = Rings(tuple(r + shift for r in best.rings.front), tuple(r + shift for r in best.rings.back))
            found.append(replace(best, rings=rings))
    return found


def find(group: Group) -> Found | None:
    """The best hypothesis for the ink of one object, or None."""
    skeleton = thin(group.ink)
    if len(skeleton.points) < 30:
        return None
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0)))
    best: Found | None = None
    for k, tolerance in enumerate(_tolerances(size)):
        found = _round(group, skeleton, tolerance)
        if found is not None and (best is None or found.evidence.score - 0.01 * k > best.evidence.score):
            best = found
        if best is not None and best.evidence.score >= GOOD - 0.01 * k:
            break
    return None if best is None else _refined(best, group, skeleton)


def _tolerances(size: float) -> list[float]:
    """Pixels a line may stray, for each round."""
    return [1.5, max(2.5, 0.006 * size), max(4.0, 0.012 * size), max(6.0, 0.02 * size)]


def _sheet(group: Group, skeleton: Skeleton, tolerance: float) -> Sheet:
    """Small pieces may be letters: explaining them counts for little."""
    at = skeleton.points.astype(np.intp)
    weights = np.where(group.solid[at[:, 1], at[:, 0]], 1.0, 0.2)
    return skeleton_sheet(skeleton.distance, skeleton.points, weights, tolerance + 1)


def _round(group: Group, skeleton: Skeleton, tolerance: float) -> Found | None:
    pen = group.ink.pen_width
    strokes = trace_strokes(skeleton, tolerance, group.solid)
    graph = corner_graph(skeleton, join_ends(strokes, pen), tolerance)
    sheet = _sheet(group, skeleton, tolerance)
    best = _best(wire_hypotheses(graph), sheet, None)
    if best is None or best[1].score < GOOD:
        regions = caps.enclosed_regions(group.ink.mask, pen, tolerance)
        best = _best(caps.caps(graph, regions), sheet, best)
    return None if best is None else Found(best[0], best[1], tolerance)


def _best(
    hypotheses: Iterator[Rings], sheet: Sheet, best: tuple[Rings, Evidence] | None
) -> tuple[Rings, Evidence] | None:
    for count, rings in enumerate(hypotheses):
        if count >= MOST_HYPOTHESES:
            break
        evidence = judge(rings, sheet)
        if best is None or evidence.score > best[1].score:
            best = rings, evidence
    return best


def _refined(found: Found, group: Group, skeleton: Skeleton) -> Found:
    rings, noise = refine(found.rings, skeleton.points, found.tolerance + 1, found.evidence.drawn)
    evidence = judge(rings, _sheet(group, skeleton, found.tolerance))
    if evidence.score < found.evidence.score - 0.02:
        return found
    return Found(rings, evidence, found.tolerance, noise)
