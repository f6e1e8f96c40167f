"""Search: from the ink of one object to the best verified hypothesis.

Nobody knows beforehand how straight a drawing's lines are, so the search runs in rounds of growing tolerance
(`attempts`) and stops at the first that explains the drawing. What could win is refined; an answer that is good but not
perfect has to hold against the next round.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sketch2shape.evidence import PERFECT, Evidence, Sheet, doubted, is_dashed, judge
from sketch2shape.fit import on_map, refine, simplified
from sketch2shape.geometry import map_cost
from sketch2shape.hypotheses import Rings, coincide, plausible, split
from sketch2shape.ink import Group, split_groups
from sketch2shape.model import Bools, Floats, Ink
from sketch2shape.search.attempts import GOOD, POOR, Attempt, attempts, is_sound
from sketch2shape.search.tolerances import Traced, is_wireframe
from sketch2shape.strokes import thin

MOST_VAIN = 3
"""Groups of ink without an object after which a sheet is taken for writing; the largest are looked at first."""
LEAST_SCORE = 0.7
"""Below this a group of ink beside an object is not taken for a second one."""
LEAST_COMPANION = 0.3
"""A second object has at least this part of the first one's size; smaller things are letters."""
HOPELESS = 0.1
"""Refinement rarely gains more than this."""
MOST_REFINED = 40
"""Vertices of a face, of all hypotheses that have been refined, after which a round refines no other."""
NO_BETTER = 0.01
"""Difference of merit that is not worth a refinement."""
ALL = 0.997
"""Score with which nothing is left to be explained by another."""
PLAINER = 0.01
"""By how much the cost of a plane map may fall in refinement."""
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

    @cached_property
    def merit(self) -> float:
        """Of answers that explain the drawing alike, the one with fewer vertices and the plainer plane map holds."""
        return _merit(self.evidence.score, self.rings, self.evidence.drawn)

    @property
    def size(self) -> float:
        """Diagonal of the object's bounding box, pixels."""
        return float(np.linalg.norm(np.ptp(self.rings.vertices, axis=0)))


def _merit(score: float, rings: Rings, drawn: Bools, slack: float = 0.0) -> float:
    front, back = np.concatenate(rings.front), np.concatenate(rings.back)
    return score - 0.002 * len(front) - 0.5 * max(0.0, map_cost(front, back, drawn) - slack)


def _most_merit(rings: Rings, evidence: Evidence) -> float:
    """What a hypothesis may have after refinement, which makes its plane map no plainer than noise has hidden."""
    return _merit(1.0, rings, evidence.drawn, PLAINER)


def _is_unbeatable(found: Found, rings: Rings, evidence: Evidence) -> bool:
    """Whether another hypothesis cannot have clearly more merit after refinement."""
    least = found.merit + NO_BETTER
    # a bare translation costs nothing
    return found.evidence.score > ALL and (
        least >= 1.0 - 0.002 * sum(rings.sizes) or least >= _most_merit(rings, evidence)
    )


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
    for attempt in attempts(group, skeleton):
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
    return best and replace(best, evidence=doubted(best.rings, best.evidence, best.sheet))


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
    if best is None or not is_sound(best.evidence) or not attempt.is_sound or best.evidence.explained > GOOD:
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
    return other if other.merit - handicap > same.merit else best


def _best_of(attempt: Attempt) -> Found | None:
    """The best of a round's hypotheses after refinement."""
    traced = attempt.traced
    found: Found | None = None
    tried: list[Rings] = []
    vertices = 0
    for rings, evidence in attempt.shortlist:
        if found is not None:
            hopeless = HOPELESS if found.evidence.score < PERFECT else HOPELESS / 2
            if evidence.score < found.evidence.score - hopeless or vertices > MOST_REFINED:
                break
            if _is_unbeatable(found, rings, evidence):
                continue
            if any(_alike(rings, other, attempt.sheet.reach) for other in tried):
                continue
        tried.append(rings)
        vertices += sum(rings.sizes)
        rings, evidence = _at_dashes(rings, evidence, attempt.sheet, traced)
        refined = _refined(traced, rings, evidence, attempt.sheet)
        if found is None or refined.merit > found.merit:
            found = refined
    return found


def _alike(a: Rings, b: Rings, near: float) -> bool:
    """Whether refinement will make the same of both: the same rings to within the reach of a line."""
    if a.sizes != b.sizes:
        return False
    return coincide(a.front[0], b.front[0], near) and coincide(a.back[0], b.back[0], near)


def _at_dashes(rings: Rings, evidence: Evidence, sheet: Sheet, traced: Traced) -> tuple[Rings, Evidence]:
    """Hidden vertices moved to where dashed lines meet, where that explains the drawing better."""
    if evidence.lines == "wire" or evidence.drawn.all() or evidence.score < 0.6:
        return rings, evidence
    m, dashes = len(evidence.drawn), traced.dash_ends
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


def _refined(traced: Traced, rings: Rings, evidence: Evidence, sheet: Sheet) -> Found:
    """The hypothesis moved to the ink and without needless vertices, judged as strictly as the lines allow."""
    points = traced.skeleton.points
    moved, noise = refine(rings, points, sheet.reach, evidence.drawn)
    strict = replace(sheet, reach=min(sheet.reach, max(2.0, 3.0 * noise + 0.1 * sheet.pen + 1.0)))
    judged = judge(moved, strict) if plausible(moved, 0.0) else None
    least = evidence.score - 0.01
    if judged is None or (judged.score < least and judge(moved, sheet).score < least):
        moved, judged = rings, judge(rings, strict)
    moved, judged = _put_right(moved, judged, strict, points)
    simpler, judged = simplified(moved, judged, strict, noise, points)
    if len(simpler.vertices) < len(moved.vertices):
        again, noise = refine(simpler, points, sheet.reach, judged.drawn)
        if plausible(again, 0.0):
            better = judge(again, strict)
            if better.score >= judged.score - 0.01:
                simpler, judged = again, better
    if judged.lines == "wire" and traced.group.pieces > 1:
        # a wide reach bridges the gaps of dashes; and only a front that is seen whole can be in front
        for way in (simpler, simpler.swapped()):
            if is_dashed(way, strict):
                return Found(way, replace(judge(way, strict), lines="dashed"), strict, noise)
    return Found(simpler, judged, strict, noise)
