"""Objects of a sheet: for each group of ink the best answer there is, straight or with arcs, or none."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple, TypeAlias

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence import EVEN_ODDS, REFUSE_BELOW, WITNESSES
from sketch2shape.geometry import cross
from sketch2shape.hypotheses import frame
from sketch2shape.ink import Group, closed_at_border, split_groups
from sketch2shape.model import TRUSTED, Floats, Ink
from sketch2shape.search.drilled import find_drilled
from sketch2shape.search.exact import Verified, find_exact
from sketch2shape.search.found import Found
from sketch2shape.search.found_sweep import FoundSweep
from sketch2shape.search.observed import Observed, observed
from sketch2shape.search.search import find
from sketch2shape.search.sweeping import SLIGHT, find_pyramid, find_sweep
from sketch2shape.strokes import Skeleton
from sketch2shape.sweeps import LEAST_PATH

MOST_VAIN = 3
"""Groups of ink without an object after which a sheet is taken for writing; the largest are looked at first."""
WRITING = 0.1
"""Odds of an answer after a group without an object that was looked at before, over its odds without: no right answer
of the pictures of people and programs had one before it, of 18 sheets of writing five were answered."""
LEAST_COMPANION = 0.3
"""A second object has at least this part of the first one's size; smaller things are letters."""
BOWED, SOME_BOWED = 0.08, 0.02
"""Part of the ink on bowed lines from which on arcs are looked for first, and from which on at all."""
STRAY, SHORT = 1.0, 5.0
"""Pixels by which chords may stray from a line, and of length below which they say nothing."""
OBTUSE = 16.0
"""Angle of a bend, radians, times length of the shorter chord beside it, over what chords may stray, from which it is a
corner: chords of an arc turn by eight over their length, and hands are twice as careless."""
LEAST_BENDS, SHARP = 2, 0.65
"""Bends of an arc at least, and angle of one from which it is a corner, radians."""

LEFT = 10.0
"""Nats of foreign ink from which on a straight object may have a round hole."""
LACKING, LACKED = 8.0, 0.1
"""Nats of missing lines up to which an answer lacks nothing, and part of what all its lines would cost that a figure of
few lines may lack beyond: rims drawn by hand lie a little beside each other."""
ATTACHED = 0.03
"""Part of the ink that touches a straight object and is none of it, from which on it may be a pyramid."""
CONVERGING = 0.04
"""Shortest edge of a straight object, as a part of the drawing's size, up to which it may be a blurred point."""
POSSIBLE = 0.3
"""Confidence from which on an answer with arcs or a point is given where there is no straight one; chosen on wireframes
of CAD programs and pictures of other things, both halves seen."""
LIKELY = 0.7
"""Confidence from which on an answer with arcs that explains all ink stands, and no straight one is looked for."""


class Bow(NamedTuple):
    """When a line bows.

    pens : length of chords below which they say nothing, as a pen rounds corners
    turn : by which it turns to one side at least, radians
    """

    pens: float
    turn: float


PLAINLY, PERHAPS = Bow(3.0, 0.6), Bow(2.0, 0.4)
"""As no hand's straight line does; and as those of flat arcs, and of some hands, do."""

AnyFound: TypeAlias = Verified | FoundSweep
"""An answer for a group of ink, in its working pixels or those of the sheet."""


def find_all(ink: Ink) -> list[AnyFound]:
    """The best hypothesis for every group of ink on the sheet that has one, in the sheet's working pixels.

    Where the answer is unlikely, an edge may lie along the border: the sides that ink runs into are drawn too.
    """
    exact = find_exact(ink)
    if exact is not None:
        return [exact]
    found = _find_groups(ink)
    # where nothing was found at all, there is no drawing
    doubted = bool(found) and max(f.confidence for f in found) < EVEN_ODDS
    if doubted and (closed := closed_at_border(ink)) is not None:
        again = _find_groups(closed)
        return again if any(f.confidence >= EVEN_ODDS for f in again) else found
    return found


def _find_groups(ink: Ink) -> list[AnyFound]:
    found: list[AnyFound] = []
    vain = 0
    for group in split_groups(ink):
        if found and group.size < LEAST_COMPANION * found[0].size:
            break
        if vain >= MOST_VAIN:
            break
        best = find_one(group)
        if best is not None and _is_answer(best) and vain:
            best = replace(best, confidence=_among_writing(best.confidence, vain))
        vain += best is None or not _is_answer(best)
        if best is not None and (_is_answer(best) or not found):
            found.append(best.shifted(group.offset))
            found.sort(key=lambda f: -_is_answer(f) * f.size)
    # beside a likely object an unlikely one is writing
    likely = [f for f in found if f.confidence >= EVEN_ODDS]
    return likely or [f for f in found if _is_answer(f)] or found[:1]


def _among_writing(alone: float, vain: int) -> float:
    """How sure an answer is, 0..1, that is looked at after so many groups without an object."""
    odds = alone / max(1.0 - alone, 1e-9) * WRITING**vain
    return odds / (1.0 + odds)


def _is_answer(found: AnyFound) -> bool:
    return found.confidence >= REFUSE_BELOW


def find_one(group: Group) -> AnyFound | None:
    """The best answer for the ink of one object, or None."""
    seen = observed(group)
    if seen is None:
        return None
    bowed = bowed_part(seen.skeleton, seen.view.size)
    swept = find_sweep(seen) if bowed >= BOWED else None
    if swept is not None and _is_given(swept, LIKELY) and swept.unexplained <= SLIGHT:
        return swept
    straight = find(seen)
    drilled = find_drilled(seen, straight) if straight is not None and _leaves_some(straight) else None
    if drilled is not None and drilled.confidence >= LIKELY and drilled.unexplained <= SLIGHT:
        return drilled
    if bowed < BOWED:
        swept = _find_other(seen, straight)
    return _better(straight, min((s for s in (drilled, swept) if s is not None), key=lambda s: s.nats, default=None))


def _find_other(seen: Observed, straight: Found | None) -> FoundSweep | None:
    """The best answer with arcs, holes or an apex, where few lines bow and what the straight one leaves tells it."""
    below = np.inf if straight is None or straight.energy is None else straight.energy.total
    is_doubted = straight is None or _is_doubted(straight)
    some_bowed = bowed_part(seen.skeleton, seen.view.size, PERHAPS if is_doubted else PLAINLY) >= SOME_BOWED
    if straight is None or is_doubted or some_bowed:
        return find_sweep(seen, arcs=some_bowed, below=below)
    return find_pyramid(seen, below) if _may_be_pointed(straight) else None


def _is_doubted(straight: Found) -> bool:
    """Whether it is unsure by itself, as its rivals are straight too and say nothing of arcs, or may have holes."""
    return straight.alone < TRUSTED or _may_have_narrow_holes(straight)


def _leaves_some(straight: Found) -> bool:
    """Whether there is ink left that may be a hole."""
    return straight.energy is not None and straight.energy.foreign > LEFT


def _may_have_narrow_holes(straight: Found) -> bool:
    """Whether there is ink left in a wireframe: round holes that edges cross do not bow to the eye."""
    return straight.energy is not None and straight.energy.lines == "wire" and _leaves_some(straight)


def _may_be_pointed(straight: Found) -> bool:
    """Whether it may be a pyramid taken for a prism: ink is left that touches it, or two vertices nearly meet."""
    if straight.witnesses is not None and straight.witnesses[WITNESSES.index("attached")] > ATTACHED:
        return True
    ends = straight.rings.vertices[frame(straight.rings.sizes).edges]
    shortest = float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).min())
    return straight.compared is not None and shortest < CONVERGING * straight.compared.view.size


def _better(straight: Found | None, swept: FoundSweep | None) -> AnyFound | None:
    """The answer of less energy; a sweep without arcs or a point is none that the other search has not seen.

    What is cheaper and yet no answer gives way to a likely one.
    """
    is_answer = straight is not None and _is_answer(straight)
    if swept is None or not _is_given(swept, EVEN_ODDS if is_answer else POSSIBLE):
        return straight
    if straight is None or straight.energy is None:
        return swept
    gap = straight.energy.total - swept.nats
    if gap > 0:
        return swept.against(gap)
    return straight if is_answer or swept.confidence < EVEN_ODDS else swept


def _is_given(swept: FoundSweep, least: float) -> bool:
    """Whether it is an answer at this least confidence.

    An ellipse alone is the base of a cone whose sides are lacking, and of anything.
    """
    if not _is_proper(swept) or swept.confidence < least:
        return False
    missing = swept.energy.missing
    # what lacks something and what is unlikely have to be a shorter tale than so much foreign ink
    if (missing > LACKING or swept.confidence < EVEN_ODDS) and swept.nats >= swept.compared.view.all_foreign:
        return False
    return not (swept.is_lone and missing > max(LACKING, LACKED * float(swept.compared.wanted.sum())))


def _is_proper(swept: FoundSweep) -> bool:
    return swept.sweep.has_arcs or swept.sweep.way.is_pointed


def bowed_part(skeleton: Skeleton, size: float, bow: Bow = PLAINLY) -> float:
    """Part of the ink that lies on bowed lines, 0..1."""
    least, short = LEAST_PATH * size, max(SHORT, bow.pens * skeleton.pen_width)
    bowed = sum(_bowed_length(p, least, short, bow.turn) for p in skeleton.paths)
    return bowed / max(sum(map(len, skeleton.paths)), 1)


def _bowed_length(path: NDArray[Any], least: float, short: float, least_turn: float) -> float:
    """Length of those parts of a line that turn, and nowhere sharply: an arc's chords have many small turns.

    They turn to one side; those of a hand that trembles turn to either.
    """
    if len(path) < max(least, 8):
        return 0.0
    bends = cv2.approxPolyDP(path[:, None].astype(np.float32), STRAY, False)[:, 0].astype(float)
    if len(bends) < LEAST_BENDS + 2:
        return 0.0
    span = np.diff(bends, axis=0)
    long = np.hypot(*span.T)
    turn = np.arctan2(cross(span[:-1], span[1:]), (span[:-1] * span[1:]).sum(axis=1))
    chord = np.minimum(long[:-1], long[1:])
    turn[chord < short] = 0.0  # the ends of a line are bent where it meets others
    corners = (np.abs(turn) >= SHARP) | (np.abs(turn) * chord > OBTUSE * STRAY)
    parts = np.split(np.arange(len(span)), np.flatnonzero(corners) + 1)
    return sum(float(long[p].sum()) for p in parts if _is_bowed(turn[p[:-1]], long[p], least, least_turn))


def _is_bowed(turn: Floats, long: Floats, least: float, least_turn: float) -> bool:
    heading = np.append(0.0, np.cumsum(turn))
    return bool(long.sum() >= least and np.count_nonzero(turn) >= LEAST_BENDS and np.ptp(heading) > least_turn)
