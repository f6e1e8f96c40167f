"""From pixels to ink: which pixels were drawn, and which of them belong together."""

from __future__ import annotations

from sketch2shape.ink.cropped import closed_at_border
from sketch2shape.ink.depth import depth_of
from sketch2shape.ink.drawn_lines import drawn, is_ruled, strokes_of
from sketch2shape.ink.enlarged import enlarged
from sketch2shape.ink.find import find_ink
from sketch2shape.ink.groups import Group, split_groups
from sketch2shape.ink.thinning import thinned_ink

__all__ = [
    "Group",
    "closed_at_border",
    "depth_of",
    "drawn",
    "enlarged",
    "find_ink",
    "is_ruled",
    "split_groups",
    "strokes_of",
    "thinned_ink",
]
