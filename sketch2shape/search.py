"""Search: from the ink of one object to the best verified hypothesis.

Nobody knows beforehand how straight a drawing's lines are, so the search runs in rounds of growing tolerance and stops
at the first that explains the drawing. A round traces strokes, joins their ends to corners, asks both face separators
(`separate` where all edges are drawn, `caps` where the back is dashed or missing) for hypotheses, best first and within
a budget, and has them verified.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np

from sketch2shape import caps, separate
from sketch2shape.model import Floats, Ink
from sketch2shape.refine import map_cost, on_map, refine
from sketch2shape.rings import Rings, coincide, plausible, split
from sketch2shape.rounds import (
    CLOSE,
    Round,
    Traced,
    corner_graph,
    is_wireframe,
    rounds_for,
    sheet_for,
    vertex_candidates,
)
from sketch2shape.sheet import Group, split_groups
from sketch2shape.shortlist import PERFECT, SHORTLIST, Judged, shortlist
from sketch2shape.simplify import simplified
from sketch2shape.strokes import Skeleton, thin
from sketch2shape.verify import Evidence, Sheet, is_dashed, judge

GOOD = 0.98
"""Score of an answer that only has to hold against those of the next round."""
MOST_VAIN = 3
"""Groups of ink without an object after which a sheet is taken for writing; the largest are looked at first."""
MOST_STEPS = 24000
"""Steps of the search for cycles in one round."""
COARSEST = 0.1
"""Reach, as a part of the ink's narrow side, beyond which everything fits: letters would be objects."""
STEADY = 0.4
"""Wobble of finely traced strokes, pixels, up to which a close look may find bends that no hand has made."""
ROUGH = 0.9
"""Score that the roughest round has to reach: so much tolerance finds something in any tangle."""
CONTENT = 0.95
"""Score from which neither the roughest round nor a close look is worth taking."""
UNSTEADY = 0.5
"""Wobble of strokes, pixels, with which the round for ruled lines is left out."""
RULED = 3.0
"""Reach of a round, pixels, up to which lines count as ruled."""
LEAST_SCORE = 0.7
"""Below this a group of ink beside an object is not taken for a second one."""
LEAST_COMPANION = 0.3
"""A second object has at least this part of the first one's size; smaller things are letters."""
HOPELESS = 0.1
"""Refinement rarely gains more than this."""
POOR = 0.8
"""A round whose best hypothesis scores less is refined only if no other round does better."""
DENSE = 150
"""Strokes beyond which ink that the first round cannot explain at all is a scribble."""
MOST_PATHS = 2500
"""Branches of the skeleton beyond which the ink is a texture or a page of text, not a drawing."""


@dataclass(frozen=True)
class Found:
    """A verified hypothesis.

    rings     : in working pixels
    evidence  : how well it agrees with the ink
    sheet     : what it was compared with, as strictly as its lines allow
    noise     : rms distance between model and ink, pixels
    """

    rings: Rings
    evidence: Evidence
    sheet: Sheet
    noise: float = 0.0

    @property
    def size(self) -> float:
        """Diagonal of the object's bounding box, pixels."""
        return float(np.linalg.norm(np.ptp(self.rings.vertices, axis=0)))


def wire_hypotheses(graph: separate.CornerGraph) -> Iterator[Rings]:
    """Closed ladders of rungs, each also with the smaller ones inside it as holes."""
    steps = iter(range(MOST_STEPS))
    for ladder in separate.ladders(graph):
        found: dict[frozenset[int], Rings] = {}
        for cycle in separate.likely_cycles(ladder, graph, MOST_STEPS // 6, steps):
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
    found: list[Found] = []
    vain = 0
    for group in split_groups(ink):
        if found and group.size < LEAST_COMPANION * found[0].size:
            break
        if vain >= MOST_VAIN:
            break
        best = find(group)
        vain += best is None or best.evidence.score < LEAST_SCORE
        if best is not None and (best.evidence.score >= LEAST_SCORE or not found):
            found.append(replace(best, rings=best.rings.shifted(group.offset)))
            found.sort(key=lambda f: -(f.evidence.score >= LEAST_SCORE) * f.size)
    if len(found) > 1:
        found = [f for f in found if f.evidence.score >= LEAST_SCORE] or found[:1]
    return found


def find(group: Group) -> Found | None:
    """The best hypothesis for the ink of one object, or None."""
    skeleton = thin(group.ink)
    if len(skeleton.points) < 30 or len(skeleton.paths) > MOST_PATHS:
        return None
    best: Found | None = None
    poor: Attempt | None = None
    good_since = 99
    before: list[Attempt] = []
    for attempt in _attempts(group, skeleton):
        k = attempt.number
        if attempt.score >= POOR:
            best = _better(best, _best_of(attempt), 0.004 * k)
        elif poor is None or attempt.score > poor.score:
            poor = attempt
        # an answer that is good but not perfect has to hold against those of the next round
        if best is not None and (best.evidence.score >= PERFECT or k > good_since + _is_busy(best)):
            break
        if (best is None and _is_scribble(attempt)) or _is_settled(best, attempt, before):
            break
        before.append(attempt)
        if best is not None and best.evidence.score >= GOOD - 0.01 * k:
            good_since = min(good_since, k)
    if poor is not None and (best is None or best.evidence.score < poor.score):
        best = _better(best, _best_of(poor))
    return best


def _is_sound(evidence: Evidence) -> bool:
    """Whether all that should have been drawn has, whatever else has been drawn."""
    return evidence.score >= POOR and evidence.support > 0.97 and evidence.weakest > 0.8


def _is_scribble(attempt: Attempt) -> bool:
    """Whether there are more strokes than any drawing has, and nothing explains them even roughly.

    A wireframe may have as many: it gets another round.
    """
    if attempt.score >= 0.5 or len(attempt.traced.strokes.ends) <= DENSE:
        return False
    return attempt.number > 0 or not is_wireframe(attempt.traced.corners)


def _is_settled(best: Found | None, attempt: Attempt, before: list[Attempt]) -> bool:
    """Whether a clearly wider search finds the same object, all of it drawn: the ink left over is none of it."""
    reach = attempt.sheet.reach
    if best is None or not _is_sound(best.evidence) or not attempt.is_sound or best.evidence.explained > GOOD:
        return False
    return any(b.is_sound and 1.5 * b.sheet.reach < reach and _alike(attempt.best, b.best, reach) for b in before)


def _better(best: Found | None, other: Found | None, handicap: float = 0.0) -> Found | None:
    """The one with more merit under the same tolerance; the other needs more by the handicap."""
    if best is None or other is None:
        return best or other
    same = best
    if other.sheet.reach > best.sheet.reach:
        seen = judge(best.rings, other.sheet)
        same = replace(best, evidence=seen) if seen.score > best.evidence.score else best
    return other if _merit(other) - handicap > _merit(same) else best


@dataclass(frozen=True)
class Attempt:
    """The outcome of one round, before refinement.

    number    : of the round
    traced    : the drawing as the round saw it
    shortlist : the best few hypotheses, the best first
    sheet     : what they were compared with
    """

    number: int
    traced: Traced
    shortlist: list[Judged]
    sheet: Sheet

    @property
    def score(self) -> float:
        """Of the best hypothesis; 0 if there is none."""
        return self.shortlist[0][1].score if self.shortlist else 0.0

    @property
    def best(self) -> Rings:
        """The best hypothesis."""
        return self.shortlist[0][0]

    @property
    def is_sound(self) -> bool:
        """Whether all of the best hypothesis has been drawn, whatever else has."""
        return bool(self.shortlist) and _is_sound(self.shortlist[0][1])


def _attempts(group: Group, skeleton: Skeleton) -> Iterator[Attempt]:
    """Round after round, but for those that promise nothing new."""
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0)))
    narrow = min(cv2.minAreaRect(skeleton.points.astype(np.float32))[1])
    traced = Traced(group, skeleton, 0.0)
    found: list[Attempt] = []
    for k, tolerant in enumerate(rounds_for(size, skeleton.pen_width)):
        if k and tolerant.reach > COARSEST * narrow:
            break
        if traced.tolerance != tolerant.trace:
            traced = Traced(group, skeleton, tolerant.trace)
        if (k == 0 and traced.wobble > UNSTEADY) or (k == 1 and found and found[-1].is_sound):
            continue
        if tolerant.last_resort and found and max(a.score for a in found) >= CONTENT:
            break
        attempt = _attempt(traced, tolerant, k)
        if tolerant.last_resort and attempt.score < ROUGH:
            break
        found.append(attempt)
        yield attempt
    traced = Traced(group, skeleton, CLOSE.trace)
    if found and max(a.score for a in found) < CONTENT and traced.wobble < STEADY:
        yield _attempt(traced, CLOSE, len(found))


def _attempt(traced: Traced, tolerant: Round, number: int) -> Attempt:
    skeleton, pen = traced.skeleton, traced.skeleton.pen_width
    graph = corner_graph(skeleton, vertex_candidates(traced.strokes, traced.corners, tolerant, pen), tolerant.reach)
    sheet = sheet_for(traced.group, skeleton, tolerant.reach)
    # within the width of a ruled line there is no second answer to a wireframe
    enough = 1 if tolerant.reach <= RULED else SHORTLIST
    best = shortlist(wire_hypotheses(graph), sheet, [], enough)
    if not best or best[0][1].score < GOOD:
        best = shortlist(caps.caps(graph, traced.regions, pen), sheet, best)
        if tolerant.loose and (not best or best[0][1].score < GOOD):
            best = shortlist(caps.loose_caps(graph, traced.regions, pen), sheet, best)
    return Attempt(number, traced, best, sheet)


def _best_of(attempt: Attempt) -> Found | None:
    """The best of a round's hypotheses after refinement."""
    traced = attempt.traced
    found: Found | None = None
    tried: list[Rings] = []
    for rings, evidence in attempt.shortlist:
        if found is not None:
            hopeless = HOPELESS if found.evidence.score < PERFECT else HOPELESS / 2
            if evidence.score < found.evidence.score - hopeless:
                break
            if any(_alike(rings, other, attempt.sheet.reach) for other in tried):
                continue
        tried.append(rings)
        rings, evidence = _at_dashes(rings, evidence, attempt.sheet, traced.dash_ends)
        refined = _refined(traced.skeleton, rings, evidence, attempt.sheet)
        if found is None or _merit(refined) > _merit(found):
            found = refined
    return found


def _alike(a: Rings, b: Rings, near: float) -> bool:
    """Whether refinement will make the same of both: the same rings to within the reach of a line."""
    if a.sizes != b.sizes:
        return False
    return coincide(a.front[0], b.front[0], near) and coincide(a.back[0], b.back[0], near)


def _at_dashes(rings: Rings, evidence: Evidence, sheet: Sheet, dashes: Floats) -> tuple[Rings, Evidence]:
    """Hidden vertices moved to where dashed lines meet, where that explains the drawing better."""
    if evidence.lines == "wire" or not len(dashes) or evidence.score < 0.6:
        return rings, evidence
    m = len(evidence.drawn)
    for i in np.flatnonzero(~evidence.drawn)[:8]:
        vertices = rings.vertices
        off = np.linalg.norm(dashes - vertices[m + i], axis=1)
        for k in np.argsort(off)[:5]:
            if off[k] > 0.12 * sheet.size:
                break
            moved = vertices.copy()
            moved[m + i] = dashes[k]
            other = split(moved, rings.sizes)
            judged = judge(other, sheet) if plausible(other, 0.0) else evidence
            more = judged.explained > evidence.explained + 0.003
            if more and judged.lines == "dashed" and judged.score > evidence.score - 0.01:
                rings, evidence = other, judged
    return rings, evidence


def _is_busy(found: Found) -> bool:
    """Whether so many vertices were found on wavy lines that some may be bends of the hand."""
    return found.noise > 0.5 and len(found.rings.vertices) > 2 * 12


def _merit(found: Found) -> float:
    """Of answers that explain the drawing alike, the one with fewer vertices and the plainer plane map holds."""
    front, back = np.concatenate(found.rings.front), np.concatenate(found.rings.back)
    return found.evidence.score - 0.002 * len(front) - 0.5 * map_cost(front, back, found.evidence.drawn)


def _put_right(rings: Rings, judged: Evidence, sheet: Sheet, points: Floats) -> tuple[Rings, Evidence]:
    """With a vertex that was caught by the wrong ink put where the plane map has it, if that explains more."""
    for _ in range(3):
        for way in on_map(rings, judged.drawn, 3.0 * sheet.reach):
            moved, _ = refine(way, points, sheet.reach, judged.drawn)
            if plausible(moved, 0.0):
                better = judge(moved, sheet)
                if better.score > judged.score:
                    rings, judged = moved, better
                    break
        else:
            break
    return rings, judged


def _refined(skeleton: Skeleton, rings: Rings, evidence: Evidence, sheet: Sheet) -> Found:
    """The hypothesis moved to the ink and without needless vertices, judged as strictly as the lines allow."""
    moved, noise = refine(rings, skeleton.points, sheet.reach, evidence.drawn)
    if not plausible(moved, 0.0) or judge(moved, sheet).score < evidence.score - 0.01:
        moved = rings
    strict = replace(sheet, reach=min(sheet.reach, max(2.0, 3.0 * noise + 0.1 * sheet.pen + 1.0)))
    moved, judged = _put_right(moved, judge(moved, strict), strict, skeleton.points)
    simpler, judged = simplified(moved, judged, strict, noise, skeleton.points)
    if len(simpler.vertices) < len(moved.vertices):
        again, noise = refine(simpler, skeleton.points, sheet.reach, judged.drawn)
        if plausible(again, 0.0):
            better = judge(again, strict)
            if better.score >= judged.score - 0.01:
                simpler, judged = again, better
    if judged.lines == "wire":
        # a wide reach bridges the gaps of dashes; and only a front that is seen whole can be in front
        for way in (simpler, simpler.swapped()):
            if is_dashed(way, strict):
                return Found(way, replace(judge(way, strict), lines="dashed"), strict, noise)
    return Found(simpler, judged, strict, noise)
