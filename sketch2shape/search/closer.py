"""A closer look: fine lines that were not read for sure, in more pixels."""

from __future__ import annotations

from sketch2shape.evidence import EVEN_ODDS
from sketch2shape.ink import enlarged
from sketch2shape.model import TRUSTED, Ink
from sketch2shape.search.objects import AnyFound, find_all

FINE = 3.5
"""Width of a pen, pixels, up to which lines may lie too close for the pixels there are."""
MOST_PIXELS = 500_000
"""Pixels of the frame of the ink up to which a drawing is enlarged."""
SURER = 0.1
"""Confidence by which a closer look has to be surer to be believed."""


def find_closely(ink: Ink) -> tuple[list[AnyFound], Ink]:
    """The best hypothesis for every group of ink that has one, and the ink in whose pixels it is.

    Fine lines are enlarged if they are not read for sure, and read surer so.
    """
    found = find_all(ink)
    best = max((f.confidence for f in found), default=0.0)
    if best >= TRUSTED or not _is_fine(ink):
        return found, ink
    closer = enlarged(ink)
    again = find_all(closer)
    surest = max((f.confidence for f in again), default=0.0)
    return (again, closer) if surest >= max(EVEN_ODDS, best + SURER) else (found, ink)


def _is_fine(ink: Ink) -> bool:
    return ink.lines is None and ink.pen_width <= FINE and ink.mask.size <= MOST_PIXELS
