"""Attempts: what each round makes of a drawing.

A round traces strokes, joins their ends to corners, asks the sources (`wireframe` where all edges are drawn,
`opaque` where the back is dashed or missing) for hypotheses, best first and within a budget, and has them verified.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice

import cv2
import numpy as np

from sketch2shape.evidence import Evidence, Sheet, sheet_for
from sketch2shape.geometry import thinned
from sketch2shape.hypotheses import Rings, opaque, united, walked, wireframe
from sketch2shape.ink import Group, is_ruled
from sketch2shape.search.neighbours import climbed, grown
from sketch2shape.search.shortlist import ENOUGH, Judged, shortlist
from sketch2shape.search.tolerances import (
    CLOSE,
    ROUGHLY,
    Round,
    Traced,
    corner_graph,
    in_threes,
    rounds_for,
    vertex_candidates,
)
from sketch2shape.strokes import Skeleton, crossed

GOOD = 0.98
"""Score from which on a round asks no further source, and an answer may end the search."""
POOR = 0.8
"""Least score of an answer all of which is drawn."""
MOST_STEPS = 24000
"""Steps of the search for cycles in one round, ..."""
MOST_STEPS_IN_ALL = 2 * MOST_STEPS
"""... and in all rounds: grids and walls have cycles without end, the most a drawing took was 37,600."""
COARSEST = 0.1
"""Reach, as a part of the ink's narrow side, beyond which everything fits: letters would be objects."""
OUTLINED = 400
"""Pixels of the skeleton that tell how narrow the ink is."""
STEADY = 0.4
"""Wobble of finely traced strokes, pixels, up to which a close look may find bends that no hand has made."""
BENT = 2.5
"""Wobble of finely traced strokes over that of a close look from which on lines have bends that no wobble makes."""
COARSE = 3
"""The first round that traces coarsely."""
ROUGH = 0.9
"""Score that the roughest round has to reach: so much tolerance finds something in any tangle."""
CONTENT = 0.95
"""Score from which neither the roughest round nor a close look is worth taking."""
UNSTEADY = 0.5
"""Wobble of strokes, pixels, with which the round for ruled lines is left out."""
RULED = 3.0
"""Reach of a round, pixels, up to which lines count as ruled."""
SEE_THROUGH = 2
"""Strokes that run across each other from which a drawing is likely to show its hidden edges."""
FEW_IN_THREES = 0.4
"""Part of the stroke ends that meet in threes below which lines no ruler drew are no wireframe: so traced, at least."""
DASHED = 0.1
"""Part of the ink in pieces as small as dashes from which on a drawing is likely to dash hidden edges; wireframes with
dimensions have 0.02, drawings with dashes 0.1 to 0.3."""
EARLY = 4
"""Rounds of such a drawing that look for it alone before any looks for faces with nothing behind them."""


@dataclass(frozen=True)
class Attempt:
    """The outcome of one round, before refinement.

    number    : of the round
    traced    : the drawing as the round saw it
    shortlist : the best few hypotheses, the best first
    sheet     : what they were compared with
    is_whole  : whether every source has been asked
    """

    number: int
    traced: Traced
    shortlist: list[Judged]
    sheet: Sheet
    is_whole: bool = True

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
        return bool(self.shortlist) and is_sound(self.shortlist[0][1])


def is_sound(evidence: Evidence) -> bool:
    """Whether all that should have been drawn has, and it explains enough to be an answer."""
    return evidence.score >= POOR and evidence.is_all_drawn


@dataclass(frozen=True, eq=False)
class _Look:
    """A round's look at a drawing; nothing is worked out before it is asked for."""

    number: int
    round: Round
    traced: Traced
    steps: Iterator[int]

    @cached_property
    def sheet(self) -> Sheet:
        return sheet_for(self.traced.group, self.traced.skeleton, self.round.reach)

    @cached_property
    def graph(self) -> wireframe.CornerGraph:
        traced, pen = self.traced, self.traced.skeleton.pen_width
        points = vertex_candidates(traced.strokes, traced.corners, self.round, pen)
        return corner_graph(traced.skeleton, points, self.round.reach)

    @property
    def is_steady(self) -> bool:
        """Whether lines are straight enough to be ruled ones."""
        return self.traced.wobble <= UNSTEADY

    @cached_property
    def crossed(self) -> int:
        """How often strokes run across each other."""
        return len(crossed(self.traced.strokes, self.traced.skeleton.pen_width + self.round.trace / 2))

    @cached_property
    def wires(self) -> Attempt:
        """With all edges drawn."""
        return self._with_wires([])

    def attempt(self) -> Attempt:
        """With all edges drawn or, if that is not good, with the hidden ones dashed or missing."""
        # hidden edges of ruled lines cross others
        is_opaque = self.crossed == 0 and self.is_steady
        found = self._attempt([]) if is_opaque else self.wires
        for source in (opaque.caps, opaque.loose_caps)[: 1 + self.round.loose]:
            if found.score < GOOD:
                hypotheses = source(self.graph, self.traced.regions, self.traced.skeleton.pen_width)
                found = self._attempt(shortlist(hypotheses, self.sheet, found.shortlist))
        return self._with_wires(found.shortlist) if is_opaque and found.score < GOOD else found

    def second(self, with_unions: bool) -> Attempt:
        """With what a careless hand or foreign lines may have hidden from the first look."""
        skeleton = self.traced.skeleton
        graph = corner_graph(skeleton, self.graph.points, self.round.reach, ROUGHLY)
        found = shortlist(walked(graph, self.sheet.size, 1.5 * skeleton.pen_width), self.sheet, [])
        if with_unions:
            unions = united(self.traced.regions, skeleton.pen_width, self.round.trace)
            found = shortlist(opaque.united_caps(self.graph, unions, skeleton.pen_width), self.sheet, found)
        return self._attempt(found)

    def _with_wires(self, known: list[Judged]) -> Attempt:
        is_ruled = self.round.reach <= RULED
        if not (is_ruled and self.is_steady) and in_threes(self.traced.corners) < FEW_IN_THREES:
            return self._attempt(known)
        # within the width of a ruled line there is no second answer to a wireframe
        enough = 1 if is_ruled else ENOUGH
        return self._attempt(shortlist(wire_hypotheses(self.graph, self.steps), self.sheet, known, enough))

    def _attempt(self, found: list[Judged]) -> Attempt:
        return Attempt(self.number, self.traced, found, self.sheet)


@dataclass(frozen=True, eq=False)
class Looks:
    """All looks at a drawing: what one pass over them has worked out the next need not."""

    group: Group
    skeleton: Skeleton

    @cached_property
    def rounds(self) -> list[_Look]:
        """Those of the rounds that promise anything, as far as the drawing alone can tell."""
        return list(_rounds(self.group, self.skeleton, iter(range(MOST_STEPS_IN_ALL))))

    @cached_property
    def strokes(self) -> int:
        """How many strokes there are: those of a hand that trembles traced coarsely, as a fine trace cuts them."""
        finest = next(iter(self.rounds), self.close)
        coarse = next((look for look in self.rounds if look.number >= COARSE), finest)
        return len((finest if finest.is_steady else coarse).traced.strokes.ends)

    @cached_property
    def close(self) -> _Look:
        """A close look."""
        steps = self.rounds[0].steps if self.rounds else iter(())
        return _Look(len(self.rounds), CLOSE, Traced(self.group, self.skeleton, CLOSE.trace), steps)


def _rounds(group: Group, skeleton: Skeleton, steps: Iterator[int]) -> Iterator[_Look]:
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0)))
    some = skeleton.points[thinned(len(skeleton.points), OUTLINED)]
    narrow = min(cv2.minAreaRect(some.astype(np.float32))[1])
    traced = Traced(group, skeleton, 0.0)
    for k, tolerant in enumerate(rounds_for(size, skeleton.pen_width)):
        if k and tolerant.reach > COARSEST * narrow:
            break
        if traced.tolerance != tolerant.trace:
            traced = Traced(group, skeleton, tolerant.trace)
        look = _Look(k, tolerant, traced, steps)
        if k or look.is_steady:
            yield look


def attempts(looks: Looks) -> Iterator[Attempt]:
    """Round after round, but for those that promise nothing new."""
    rounds, close = looks.rounds, looks.close
    found: list[Attempt] = []
    is_bent = bool(rounds) and not rounds[0].is_steady and close.traced.wobble < rounds[0].traced.wobble / BENT
    if is_bent:
        found.append(close.attempt())
        yield found[0]
    early = _early(rounds)
    for look in early:
        yield replace(look.wires, is_whole=False)
    for look in _likely_first(rounds):
        if look.number == 1 and found and found[-1].is_sound:
            continue
        if look.round.last_resort and found and max(a.score for a in found) >= CONTENT:
            break
        attempt = look.attempt()
        if look.round.last_resort and attempt.score < ROUGH:
            break
        found.append(attempt)
        if look not in early or attempt is not look.wires:
            yield attempt
    if found and not is_bent and max(a.score for a in found) < CONTENT and close.traced.wobble < STEADY:
        yield close.attempt()


def _likely_first(looks: list[_Look]) -> list[_Look]:
    """Rounds that trace more finely than a hand draws come later, where lines are known: their wobble is the hand's."""
    lines = looks[0].traced.group.ink.lines if looks else None
    if lines is None or is_ruled(lines, looks[0].traced.group.size):
        return looks
    return sorted(looks, key=lambda look: (look.round.last_resort, look.number < COARSE))


def second_attempts(looks: Looks) -> Iterator[Attempt]:
    """A second look at some of the rounds, for drawings that no round has explained."""
    united = looks.rounds[1:4:2] or looks.rounds
    for look in united:
        yield look.second(True)
    for look in looks.rounds:
        if look not in united:
            yield look.second(False)


def climbed_attempts(looks: Looks, known: list[Attempt]) -> Iterator[Attempt]:
    """A third look, for drawings that no other has explained: what lies around the hypotheses of other attempts."""
    for look in looks.rounds:
        own = [judged for a in known if a.number == look.number for judged in a.shortlist]
        own.sort(key=lambda judged: -judged[1].score)
        corners = np.concatenate([look.graph.points, look.traced.dash_ends])
        yield Attempt(look.number, look.traced, climbed(own, look.sheet, corners), look.sheet)


def grown_attempts(looks: Looks, best: Judged) -> Iterator[Attempt]:
    """A last look at an answer that leaves more ink than a vertex costs: with more vertices, where strokes end.

    Strokes that end close to each other share a corner: both ends of a chamfer may be one there.
    """
    for look in looks.rounds[:1]:
        ends = look.traced.strokes.ends.reshape(-1, 2)
        yield Attempt(look.number, look.traced, grown(best, look.sheet, ends), look.sheet)


def _early(looks: list[_Look]) -> list[_Look]:
    """Those that look for a wireframe alone: the first few, if strokes cross. A fine trace cuts wavy ones in pieces."""
    first = looks[:EARLY] if looks and not _is_dashed(looks[0].traced) else []
    some = first[:1] if first and first[0].is_steady else first
    return first if any(look.crossed >= SEE_THROUGH for look in some) else []


def _is_dashed(traced: Traced) -> bool:
    """Whether so much of the ink is in small pieces that hidden edges seem to be dashed."""
    x, y = np.rint(traced.skeleton.points).astype(np.intp).T
    return bool(1.0 - traced.group.solid[y, x].mean() > DASHED)


def wire_hypotheses(
    graph: wireframe.CornerGraph,
    steps: Iterable[int] = range(MOST_STEPS),
    ladders: Iterable[wireframe.Ladder] | None = None,
) -> Iterator[Rings]:
    """Closed ladders of rungs, each also with the smaller ones inside it as holes, within what is left of the steps."""
    left = islice(steps, MOST_STEPS)
    for ladder in wireframe.ladders(graph) if ladders is None else ladders:
        found: dict[frozenset[int], Rings] = {}
        for cycle in wireframe.likely_cycles(ladder, graph, MOST_STEPS // 6, left):
            key = frozenset(cycle.tolist())
            if key not in found:
                found[key] = wireframe.ring_pair(ladder, graph, cycle)
                yield found[key]
        if len(found) > 1:
            yield from _holed(found)


def _holed(found: dict[frozenset[int], Rings]) -> Iterator[Rings]:
    keys = sorted(found, key=len, reverse=True)
    for key in keys[:6]:
        others = [found[k] for k in keys if not k & key]
        rings = wireframe.with_holes(found[key], others[:8]) if others else None
        if rings is not None:
            yield rings
