"""Search: from the ink of one object to the best verified hypothesis.

Nobody knows beforehand how straight a drawing's lines are, so hypotheses are looked for in rounds of growing tolerance
(`attempts`). Those that could win are refined and priced by one energy under the noise of one hand; the cheapest holds.
The search ends when no other could save as much as it would cost, when more rounds bring nothing new, or, before the
second look, when the answer can be trusted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from sketch2shape.evidence import (
    EVEN_ODDS,
    LEAST_DRAWN,
    PERFECT,
    REFUSE_BELOW,
    Comparison,
    Energy,
    Evidence,
    Sheet,
    View,
    against_rivals,
    compare,
    confidence,
    is_dashed,
    judge,
    rivalry,
    with_hidden,
    witnesses,
)
from sketch2shape.fit import EXACT, on_map, refine, simplified
from sketch2shape.hypotheses import Rings, coincide, has_edges, plausible, split
from sketch2shape.model import TRUSTED, Floats
from sketch2shape.search.attempts import (
    GOOD,
    Attempt,
    Looks,
    attempts,
    climbed_attempts,
    grown_attempts,
    is_sound,
    second_attempts,
)
from sketch2shape.search.exact import Verified
from sketch2shape.search.observed import DENSE, Observed
from sketch2shape.search.tolerances import Traced, is_wireframe

HOPELESS = 0.1
"""Refinement rarely gains more than this."""
MOST_REFINED = 40
"""Vertices of a face, of all hypotheses that have been refined, after which a round refines no other."""
SETTLED = 1.0
"""Vertices whose price another hypothesis would have to save: it costs at least as much more, or is worse."""
LEFT_OVER = 0.4
"""Fraction of the price of all ink that a settled answer may leave unexplained."""
STALE = 2
"""Attempts without anything new after which a sound answer holds."""
LEAST_MAP, PLAIN = 2, 1.5
"""Numbers of the plainest plane map, a translation, and more by which a hypothesis may cost and be the plainest."""
TIE = 3.0
"""Nats that are no reason to prefer a later hypothesis."""
WITNESSED, LOG_ODDS = 10.0, 4.6
"""Nats that log odds of one, which witnesses give, are worth in a doubtful drawing; and log odds beyond which they say
no more. Chosen on pictures of people and programs and drawings of the generator."""
BARE = 0.05
"""Part of an edge with ink below which it has none."""
COMPARABLE = 0.1
"""Difference of scores up to which answers tell the noise of the hand that drew."""
ANOTHER = 0.03
"""Fraction of the drawing's size by which an edge lies elsewhere at least where it makes another object."""
MAIN = 0.5
"""Part of the ink from which on an answer that is drawn whole tells the noise of the hand, whatever else is drawn."""


@dataclass(frozen=True)
class Found(Verified):
    """A verified hypothesis that others are weighed against.

    sheet     : what it was compared with, as strictly as its lines allow
    compared  : held against the drawing
    energy    : what it and the drawing under it cost
    witnesses : what speaks for and against it by itself
    alone     : 0..1, how sure that alone makes it
    rival     : 0..1, how close another comes
    """

    sheet: Sheet = field(kw_only=True)
    compared: Comparison | None = None
    energy: Energy | None = None
    witnesses: Floats | None = None
    alone: float = 0.0
    rival: float = 0.0


def find(seen: Observed) -> Found | None:
    """The best hypothesis without arcs for the ink of one object, or None.

    An answer that can be trusted needs no second look: of 106 such answers it changed two, none for the better.
    """
    looks = Looks(seen.group, seen.skeleton)
    tried, found = list[Attempt](), list[Found]()
    for look in (attempts, second_attempts):
        _search(_noted(look(looks), tried), seen.view, found)
        best = _told(_best(found))
        if best is not None and (best.confidence >= TRUSTED or _leaves_nothing(best)):
            break
    else:
        _search(climbed_attempts(looks, tried), seen.view, found)
        best = _likelier(best, _told(_best(found)), found)
    if best is not None and best.confidence >= TRUSTED and not _leaves_nothing(best):
        _search(grown_attempts(looks, (best.rings, best.evidence)), seen.view, found)
        other = _told(_best(found))
        best = other if other is not None and _is_cheaper(other, best) else best
    return best and _with_hidden(_against(best, found))


def _is_cheaper(other: Found, best: Found) -> bool:
    """Whether it costs less under any hand: a vertex more for every wobble always makes less noise."""
    priced = [f.compared.energy(np.inf).total for f in (other, best) if f.compared is not None]
    return len(priced) == 2 and priced[0] < priced[1] - TIE


def _likelier(known: Found | None, best: Found | None, found: list[Found]) -> Found | None:
    """The answer after a climb. In any tangle it finds something: what was none before has to be likelier right."""
    other, is_none = best and _likeliest(best, found), known is None or known.confidence < REFUSE_BELOW
    return known if other is None or (is_none and other.confidence < EVEN_ODDS) else other


def _likeliest(best: Found, found: list[Found]) -> Found:
    """Of hypotheses that cost hardly more than the best, the one that the witnesses speak for most."""
    most = _total(best) + WITNESSED * LOG_ODDS
    rivals = [told for f in _priced(found) if _total(f) < most and (told := _told(f)) is not None]
    other = min(rivals, key=_doubted, default=best)
    return other if _doubted(other) < _doubted(best) - TIE else best


def _doubted(found: Found) -> float:
    """Nats: what it costs, less what its witnesses are worth."""
    odds = float(np.log(max(found.confidence, 1e-9) / max(1.0 - found.confidence, 1e-9)))
    return _total(found) - WITNESSED * float(np.clip(odds, -LOG_ODDS, LOG_ODDS))


def _with_hidden(found: Found) -> Found:
    """The answer with what nobody has drawn where the plainest way from face to face has it."""
    energy, compared, drawn = found.energy, found.compared, found.evidence.drawn
    if energy is None or compared is None or energy.lines != "removed":
        return found
    rings = with_hidden(found.rings, drawn, energy, compared.view.size)
    return replace(found, rings=rings) if plausible(rings, 0.0) else found


def _noted(tries: Iterable[Attempt], tried: list[Attempt]) -> Iterator[Attempt]:
    """The attempts, which are added to those tried as they are made."""
    for attempt in tries:
        tried.append(attempt)
        yield attempt


def _told(best: Found | None) -> Found | None:
    """The answer with what speaks for and against it by itself, and how sure that makes it.

    How far to search is decided by that: the longer a search goes on, the more rivals it finds.
    """
    if best is None or best.energy is None or best.compared is None:
        return None
    told = witnesses(best.rings, best.energy, best.compared, best.evidence)
    sure = confidence(told)
    # a face alone, or doubtful and an edge that nobody has drawn
    is_face = np.count_nonzero(best.evidence.drawn) < LEAST_DRAWN
    is_none = is_face or (sure < EVEN_ODDS and best.evidence.weakest < BARE)
    return replace(best, witnesses=told, confidence=min(sure, 0.5 * REFUSE_BELOW) if is_none else sure)


def _against(best: Found, found: list[Found]) -> Found:
    """The answer, and how sure it is beside all others that were found; they make it doubtful, but not none."""
    if best.compared is None:
        return best
    rival = rivalry(_gap(best, found), best.compared.view.all_foreign)
    sure = max(against_rivals(best.confidence, rival), min(best.confidence, REFUSE_BELOW))
    return replace(best, alone=best.confidence, rival=rival, confidence=sure)


def _gap(best: Found, found: list[Found]) -> float:
    """Nats to the next best that is another object, or to none, which leaves all ink unexplained.

    One with the same lines, whatever it calls its faces, is no other.
    """
    if best.compared is None or best.energy is None:
        return np.inf
    view, drawn = best.compared.view, best.evidence.drawn
    near = max(ANOTHER * view.size, view.pen + 2.0 * best.energy.noise)
    rivals = [_total(f) for f in _priced(found) if not has_edges(f.rings, best.rings, drawn, near)]
    return min([view.all_foreign, *rivals]) - best.energy.total


def _search(tries: Iterable[Attempt], view: View, found: list[Found]) -> None:
    """Add the hypotheses of some attempts to those found, until more of them bring nothing new."""
    stale, best = 0, _best(found)
    for attempt in tries:
        if best is None and _is_scribble(attempt):
            break
        found += _refined_of(attempt, view, found)
        before, best = best, _best(found)
        stale = 0 if best is not before and not _is_same(before, best) else stale + attempt.is_whole
        if best is not None and (_leaves_nothing(best) or (stale >= STALE and _is_settled(best))):
            break


def _compared(found: Found, view: View) -> Found:
    return replace(found, compared=compare(found.rings, view, found.evidence.drawn, 1.5 * found.sheet.reach))


def _is_same(a: Found | None, b: Found | None) -> bool:
    """Whether both are the same object, to within the reach of a line."""
    return a is not None and b is not None and _alike(a.rings, b.rings, 0.5 * (a.sheet.reach + b.sheet.reach))


def _is_settled(best: Found) -> bool:
    """Whether all of the answer is drawn, and it explains most of what is."""
    energy, compared = best.energy, best.compared
    if energy is None or compared is None or not is_sound(best.evidence):
        return False
    return energy.unexplained < LEFT_OVER * compared.view.all_foreign


def _leaves_nothing(best: Found) -> bool:
    """Whether no other hypothesis could save as much as it would cost."""
    energy = best.energy
    return energy is not None and best.evidence.score >= GOOD and energy.unexplained < SETTLED * energy.vertex


def _best(found: list[Found]) -> Found | None:
    """The hypothesis of least energy, all under the noise of one hand."""
    if not found:
        return None
    priced = _priced(found)
    best = priced[0]
    for other in priced[1:]:
        # of those that cost alike, the one that is drawn better by far, or else that was thought of first
        is_better = other.evidence.score > best.evidence.score + COMPARABLE
        if _total(other) < _total(best) + (TIE if is_better else -TIE):
            best = other
    return best


def _priced(found: list[Found]) -> list[Found]:
    """What each costs under the noise of one hand."""
    hand = _hand(found)
    return [replace(f, energy=f.compared.energy(hand)) for f in found if f.compared is not None]


def _hand(found: list[Found]) -> float:
    """Noise of the hand that drew, pixels: the least under which an answer as good as any, or one all drawn, holds."""
    top = max(f.evidence.score for f in found)
    return min(f.noise for f in found if f.evidence.score >= top - COMPARABLE or _is_all_drawn(f.evidence))


def _is_all_drawn(evidence: Evidence) -> bool:
    """Whether all that should have been drawn has, and it is a good part of the drawing."""
    return evidence.is_all_drawn and evidence.explained > MAIN


def _total(found: Found) -> float:
    """Nats."""
    return found.energy.total if found.energy else np.inf


def _is_scribble(attempt: Attempt) -> bool:
    """Whether there are more strokes than any drawing has, and nothing explains them even roughly.

    A wireframe may have as many: it gets another round.
    """
    if attempt.score >= 0.5 or len(attempt.traced.strokes.ends) <= DENSE:
        return False
    return attempt.number > 0 or not is_wireframe(attempt.traced.corners)


def _refined_of(attempt: Attempt, view: View, known: list[Found]) -> list[Found]:
    """The hypotheses of a round that could win, moved to the ink and held against it, but for those known already.

    Once one leaves nothing to be explained and its faces are plainly related, only fewer vertices could cost less.
    """
    traced, sheet = attempt.traced, attempt.sheet
    fresh: list[Found] = []
    tried: list[Rings] = []
    vertices, top, enough = 0, 0.0, np.inf
    for rings, evidence in attempt.shortlist:
        if tried and (evidence.score < top - HOPELESS or vertices > MOST_REFINED):
            break
        if sum(rings.sizes) >= enough or any(_alike(rings, other, sheet.reach) for other in tried):
            continue
        tried.append(rings)
        vertices += sum(rings.sizes)
        rings, evidence = _at_dashes(rings, evidence, sheet, traced)
        found = _refined(traced, rings, evidence, sheet)
        top = max(top, found.evidence.score)
        if not any(_is_same(found, other) for other in known):
            found = _compared(found, view)
            fresh.append(found)
            if _is_plainest(found):
                enough = sum(found.rings.sizes)
        if _is_exact(found):
            break
    return fresh


def _is_plainest(found: Found) -> bool:
    """Whether all of the hypothesis is drawn, it leaves nothing, and its shape costs hardly more than its vertices."""
    if found.compared is None or not found.evidence.drawn.all():
        return False
    energy = found.compared.energy(found.noise)
    bare = sum(found.rings.sizes) * energy.vertex + LEAST_MAP * energy.digit
    return energy.shape - bare < PLAIN * energy.digit and _leaves_nothing(replace(found, energy=energy))


def _is_exact(found: Found) -> bool:
    """Whether all vertices lie on known lines, to a part of a pixel: nothing is left for another hypothesis to do."""
    return found.noise < EXACT and found.evidence.score > PERFECT and bool(found.evidence.drawn.all())


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
    points = traced.skeleton.outside_blots
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
                return Found(way, replace(judge(way, strict), lines="dashed"), noise, sheet=strict)
    return Found(simpler, judged, noise, sheet=strict)
