"""Observed: the ink of one object made ready for all searches, or told to be no drawing of one."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sketch2shape.evidence import View, observe
from sketch2shape.ink import Group
from sketch2shape.search.tolerances import LEAST_INK, LEAST_TRACE, PEN_TRACE, Traced, in_threes
from sketch2shape.strokes import Skeleton, bridged, thin

DENSE = 150
"""Strokes beyond which ink that the first round cannot explain at all is a scribble."""
TANGLED = 0.16
"""Part of the stroke ends that meet in threes below which so many strokes are a scribble: an eighth in one, a quarter
and more in drawings with as many."""
MOST_PATHS = 2500
"""Branches of the skeleton beyond which the ink is a texture or a page of text, not a drawing."""


@dataclass(frozen=True, eq=False)
class Observed:
    """A group of ink as all searches see it.

    drawn    : the ink
    group    : the same with gaps at corners bridged
    skeleton : of it
    view     : what hypotheses are held against
    """

    drawn: Group
    group: Group
    skeleton: Skeleton
    view: View


def observed(group: Group) -> Observed | None:
    """A group of ink made ready for the search; None if it is no drawing of an object."""
    skeleton = thin(group.ink)
    if len(skeleton.points) < LEAST_INK or _is_no_drawing(group, skeleton):
        return None
    drawn = group
    whole = bridged(skeleton, group.solid, max(LEAST_TRACE, PEN_TRACE * skeleton.pen_width))
    if whole is not None:
        group = replace(group, ink=replace(group.ink, mask=group.ink.mask | whole), solid=group.solid | whole)
        skeleton = thin(group.ink)
    return Observed(drawn, group, skeleton, observe(group, skeleton))


def _is_no_drawing(group: Group, skeleton: Skeleton) -> bool:
    """Whether the ink is a texture, a page of text, or a scribble whose many strokes end wherever they please."""
    if len(skeleton.paths) > MOST_PATHS:
        return True
    if len(skeleton.paths) <= DENSE:
        return False
    traced = Traced(group, skeleton, max(LEAST_TRACE, PEN_TRACE * skeleton.pen_width))
    strokes = len(traced.strokes.ends)
    return not strokes or (strokes > DENSE and in_threes(traced.corners) < TANGLED)
