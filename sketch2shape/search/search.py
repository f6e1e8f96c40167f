"""Search: from the ink of one object to the best verified hypothesis.

Nobody knows beforehand how straight a drawing's lines are, so hypotheses are looked for in rounds of growing tolerance
(`attempts`). Those that could win are refined and priced by one energy under the noise of one hand; the cheapest holds.
The search ends when no other could save as much as it would cost, when more rounds bring nothing new, or, before the
second look, when the answer can be trusted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from sketch2shape.evidence import (
    EVEN_ODDS,
    LEAST_DRAWN,
    PERFECT,
    REFUSE_BELOW,
    WITNESSES,
    View,
    against_rivals,
    confidence,
    is_crowded,
    is_table,
    rivalry,
    shows_little,
    with_hidden,
    witnesses,
)
from sketch2shape.fit import EXACT
from sketch2shape.hypotheses import Rings, has_edges, plausible
from sketch2shape.model import TRUSTED, Bools, Floats
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
from sketch2shape.search.climbing import climb
from sketch2shape.search.found import TIE, Found, alike, best_of, is_same, priced, total
from sketch2shape.search.observed import DENSE, Observed
from sketch2shape.search.refining import HOPELESS, at_dashes, compared_with, refined
from sketch2shape.search.shortlist import LEAST
from sketch2shape.search.tolerances import is_wireframe

MOST_REFINED = 40
"""Vertices of a face, of all hypotheses that have been refined, after which a round refines no other."""
SETTLED = 1.0
"""Vertices whose price another hypothesis would have to save: it costs at least as much more, or is worse."""
LEFT_OVER = 0.4
"""Fraction of the price of all ink that a settled answer may leave unexplained."""
STALE = 2
"""Attempts without anything new after which a sound answer holds."""
STARTS = 2
"""Hypotheses from which a climb by the energy starts where the answer is doubtful."""
OUTSTANDING = 0.7
"""Confidence, beside all rivals, of an object that only such a climb has found; and, by itself, of one that costs more
than so much foreign ink."""
LEAST_MAP, PLAIN = 2, 1.5
"""Numbers of the plainest plane map, a translation, and more by which a hypothesis may cost and be the plainest."""
WITNESSED, LOG_ODDS = 10.0, 4.6
"""Nats that log odds of one, which witnesses give, are worth in a doubtful drawing; and log odds beyond which they say
no more. Chosen on pictures of people and programs and drawings of the generator."""
LAID = 0.4
"""Part of all that is seen of edges that lies along others from which on both faces are one; right answers with
vertices that nobody has drawn have 0.2 at most."""
BARE = 0.05
"""Part of an edge with ink below which it has none."""
TANGLE = 40
"""Strokes from which on a drawing is not looked at again if what was found is none, and dearer than foreign ink: of 767
drawings 37 were so, and none was answered right; of drawn ones that a second look put right one had 27."""
ANOTHER = 0.03
"""Fraction of the drawing's size by which an edge lies elsewhere at least where it makes another object."""


def find(seen: Observed) -> Found | None:
    """The best hypothesis without arcs for the ink of one object, or None.

    An answer that can be trusted needs no second look: of 106 such answers it changed two, none for the better.
    """
    looks = Looks(seen.group, seen.skeleton)
    tried, found = list[Attempt](), list[Found]()
    for look in (attempts, second_attempts):
        _search(_noted(look(looks), tried), seen.view, found, is_dense=looks.strokes > DENSE)
        best = _told(best_of(found))
        if best is not None and (best.confidence >= TRUSTED or _leaves_nothing(best)):
            break
        if looks.strokes > TANGLE and (best is None or (best.is_none and _is_dear(best))):
            return best and _against(best, found)
    else:
        _search(climbed_attempts(looks, tried), seen.view, found)
        best = _likelier(best, _told(best_of(found)), found)
    if best is None or best.confidence < TRUSTED:
        best = _above(best, looks, seen.view, found)
    if best is not None and best.confidence >= TRUSTED:
        best = _looked_at_again(best, looks, seen.view, found)
    return best and _with_hidden(_against(best, found))


def _above(known: Found | None, looks: Looks, view: View, found: list[Found]) -> Found | None:
    """A doubtful answer, or what a climb by the energy finds: an object where none was has to be likely beside all."""
    found += climb(found, looks, view, STARTS)
    best = _likelier(known, _told(best_of(found)), found)
    if best is None or (known is not None and known.confidence >= REFUSE_BELOW):
        return best
    return best if _against(best, found).confidence >= OUTSTANDING else known


def _looked_at_again(best: Found, looks: Looks, view: View, found: list[Found]) -> Found:
    """A trusted answer, or a cheaper one with more vertices, with one elsewhere, exchanged or left out."""
    nothing = _leaves_nothing(best)
    if not nothing:
        _search(grown_attempts(looks, (best.rings, best.evidence)), view, found)
    found += climb(found, looks, view, 1, closely=nothing)
    cheapest = best_of(found)
    if cheapest is None or cheapest.rings is best.rings:
        return best
    other = _told(cheapest)
    return other if other is not None and _is_cheaper(other, best) else best


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
    most = total(best) + WITNESSED * LOG_ODDS
    rivals = [told for f in priced(found) if total(f) < most and (told := _told(f)) is not None]
    other = min(rivals, key=_doubted, default=best)
    return other if _doubted(other) < _doubted(best) - TIE else best


def _doubted(found: Found) -> float:
    """Nats: what it costs, less what its witnesses are worth."""
    odds = float(np.log(max(found.confidence, 1e-9) / max(1.0 - found.confidence, 1e-9)))
    return total(found) - WITNESSED * float(np.clip(odds, -LOG_ODDS, LOG_ODDS))


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
    is_none = _is_flat(best.evidence.drawn, told) or _is_vague(best, sure)
    is_none |= is_table(best.rings, best.energy.noise, is_all=_leaves_nothing(best))
    is_none |= is_crowded(*best.rings.segments, best.energy.noise)
    return replace(best, witnesses=told, is_none=is_none, confidence=min(sure, 0.5 * REFUSE_BELOW) if is_none else sure)


def _is_vague(best: Found, sure: float) -> bool:
    """Whether it is doubtful, or dearer than so much foreign ink, and nothing but a face is drawn well."""
    if best.energy is None or best.compared is None:
        return True
    is_dear = _is_dear(best)
    if is_dear and sure < OUTSTANDING:
        return True
    # an edge that nobody has drawn, or nothing behind the face
    is_bare = best.evidence.weakest < BARE or shows_little(best.rings, best.compared)
    return is_bare and (is_dear or sure < EVEN_ODDS)


def _is_dear(best: Found) -> bool:
    """Whether it costs more than so much foreign ink."""
    return best.energy is None or best.compared is None or best.energy.total > best.compared.view.all_foreign


def _is_flat(drawn: Bools, told: Floats) -> bool:
    """Whether a face is drawn alone, or another that nobody has drawn whole lies along it."""
    laid = told[WITNESSES.index("doubled")]
    return bool(np.count_nonzero(drawn) < LEAST_DRAWN or (laid > LAID and not drawn.all()))


def _against(best: Found, found: list[Found]) -> Found:
    """The answer, and how sure it is beside all others that were found; they make it doubtful, but not none."""
    if best.compared is None:
        return best
    rival = rivalry(_gap(best, found), best.compared.view.all_foreign)
    sure = max(against_rivals(best.confidence, rival), min(best.confidence, REFUSE_BELOW))
    sure = min(sure, best.confidence) if best.is_none else sure
    return replace(best, alone=best.confidence, rival=rival, confidence=sure)


def _gap(best: Found, found: list[Found]) -> float:
    """Nats to the next best that is another object, or to none, which leaves all ink unexplained.

    One with the same lines, whatever it calls its faces, is no other.
    """
    if best.compared is None or best.energy is None:
        return np.inf
    view, drawn = best.compared.view, best.evidence.drawn
    near = max(ANOTHER * view.size, view.pen + 2.0 * best.energy.noise)
    rivals = [total(f) for f in priced(found) if not has_edges(f.rings, best.rings, drawn, near)]
    return min([view.all_foreign, *rivals]) - best.energy.total


def _search(tries: Iterable[Attempt], view: View, found: list[Found], *, is_dense: bool = False) -> None:
    """Add the hypotheses of some attempts to those found, until more of them bring nothing new.

    What explains little is refined last, and only if no attempt explains the drawing.

    is_dense : whether there are more strokes than any drawing has
    """
    stale, best, poor = 0, best_of(found), list[Attempt]()
    for attempt in tries:
        if is_dense and best is None and not poor and _is_scribble(attempt):
            break
        if 0.0 < attempt.score < LEAST:
            poor.append(attempt)
        else:
            found += _refined_of(attempt, view, found)
        before, best = best, best_of(found)
        stale = 0 if best is not before and not is_same(before, best) else stale + attempt.is_whole
        if best is not None and (_leaves_nothing(best) or (stale >= STALE and _is_settled(best))):
            return
    for attempt in poor if best is None or not _is_settled(best) else ():
        found += _refined_of(attempt, view, found)


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


def _is_scribble(attempt: Attempt) -> bool:
    """Whether nothing explains so many strokes even roughly. A wireframe may have as many: it gets another round."""
    return attempt.score < 0.5 and (attempt.number > 0 or not is_wireframe(attempt.traced.corners))


def _refined_of(attempt: Attempt, view: View, known: list[Found]) -> list[Found]:
    """The hypotheses of a round that could win, moved to the ink and held against it, but for those known already.

    Once one leaves nothing to be explained and its faces are plainly related, only fewer vertices could cost less.
    """
    traced, sheet = attempt.traced, attempt.sheet
    fresh: list[Found] = []
    tried: list[Rings] = []
    vertices, enough = 0, np.inf
    top = max((f.evidence.score for f in known if is_sound(f.evidence)), default=0.0)
    for rings, evidence in attempt.shortlist:
        if evidence.score < top - HOPELESS or vertices > MOST_REFINED:
            break
        if sum(rings.sizes) >= enough or any(alike(rings, other, sheet.reach) for other in tried):
            continue
        tried.append(rings)
        vertices += sum(rings.sizes)
        rings, evidence = at_dashes(rings, evidence, sheet, traced)
        found = refined(traced, rings, evidence, sheet)
        top = max(top, found.evidence.score)
        if not any(is_same(found, other) for other in known):
            found = compared_with(found, view)
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
