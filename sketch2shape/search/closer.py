"""A closer look: fine lines of which no reading is likely, in more pixels."""

from __future__ import annotations

from sketch2shape.evidence import REFUSE_BELOW, WITNESSES
from sketch2shape.ink import enlarged
from sketch2shape.model import TRUSTED, Ink
from sketch2shape.search.found import Found
from sketch2shape.search.found_sweep import FoundSweep
from sketch2shape.search.objects import LIKELY, AnyFound, find_all
from sketch2shape.search.sweeping import SLIGHT

FINE = 2.5
"""Width of a pen, working pixels, up to which lines may lie too close for the pixels there are. With 3.5 four more of
1550 drawings were read, and wireframes of CAD programs took twice as long."""
PARTLY = 0.95
"""Price of a refused answer, over that of so much foreign ink, below which it is part of something else, not too fine:
of seven plates of a few pixels that were refused and then read so, none had less than 1."""
MOST_PIXELS = 500_000
"""Pixels of the frame of the ink up to which a drawing is enlarged."""


def find_closely(ink: Ink) -> tuple[list[AnyFound], Ink]:
    """The best hypothesis for every group of ink that has one, and the ink in whose pixels it is.

    Fine lines are enlarged if no reading of them is likely; what they show then has to be all there is, and sure, or
    likely where there was no answer.
    """
    found = find_all(ink)
    best = max((f.confidence for f in found), default=0.0)
    if best >= LIKELY or not _is_fine(ink) or (best < REFUSE_BELOW and any(_is_partly(f) for f in found)):
        return found, ink
    closer = enlarged(ink)
    again = find_all(closer)
    least = LIKELY if best < REFUSE_BELOW else TRUSTED
    return (again, closer) if any(f.confidence >= least and _is_all(f) for f in again) else (found, ink)


def _is_partly(found: AnyFound) -> bool:
    """Whether it costs less than so much foreign ink: there are pixels enough then, and it is no object."""
    if not isinstance(found, Found | FoundSweep) or found.compared is None or found.energy is None:
        return False
    return found.energy.total < PARTLY * found.compared.view.all_foreign


def _is_all(found: AnyFound) -> bool:
    """Whether it leaves hardly any ink."""
    if isinstance(found, FoundSweep):
        return found.unexplained <= SLIGHT
    told = found.witnesses if isinstance(found, Found) else None
    return told is None or float(told[WITNESSES.index("unexplained")]) <= SLIGHT


def _is_fine(ink: Ink) -> bool:
    return ink.lines is None and ink.pen_width <= FINE and ink.mask.size <= MOST_PIXELS
