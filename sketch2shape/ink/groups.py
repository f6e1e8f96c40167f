"""Sheet: which ink belongs together.

A sheet may hold several objects, and writing around them. Ink that nearly touches is one group; a group that lies
inside another's outline (a hole's edges, letters on a face) joins it. Each group is looked at on its own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink.components import Pieces, connected_pieces
from sketch2shape.ink.cropped import cut_off
from sketch2shape.ink.drawn_lines import drawn
from sketch2shape.model import Bools, Floats, Ink, Ints, VectorLine

MARGIN = 8
SMALLEST = 0.12
"""Groups smaller than this part of the largest are writing, not objects."""
TOUCH_PENS, TOUCH, APART = 3.0, 0.012, 3.0
"""Pens, and fraction of the ink's size, up to which pieces are one group; how many times as far they may be where
strokes stop short of each other."""
ENCLOSED, WHOLE, FEW = 10.0, 0.5, 0.16
"""Square pens of the hole of a piece that encloses something, and extent of all such pieces over that of the largest
piece of any kind, and over that of all, below which strokes do not meet: drawings whose lines do are mostly one piece.
Where strokes stop short and some cross, they have 0.11 to 0.15 of all; other drawings 0.17 and more, nearly all 0.5."""
CLUTTER = 0.07
"""Connected pieces smaller than this part of their group cannot be told from letters or dashes."""


@dataclass(frozen=True)
class Group:
    """Ink that belongs together, cut out of the sheet.

    ink    : the group's own ink, with an empty margin around it
    offset : (2,) float, where its pixel (0, 0) lies on the sheet
    solid  : (h, w) bool, ink of pieces too large to be letters or dashes
    size   : diagonal of the group's bounding box, pixels
    pieces : how many connected pieces the ink is in
    cut    : see `cut_off`, in pixels of the group
    """

    ink: Ink
    offset: Floats
    solid: Bools
    size: float
    pieces: int
    cut: Floats | None = None


def split_groups(ink: Ink, most: int = 12) -> list[Group]:
    """Groups of the sheet that could be objects, the largest first."""
    left, top, width, height = cv2.boundingRect(ink.mask.view(np.uint8))
    if not width:
        return []
    frame = (left - MARGIN, top - MARGIN, left + width + MARGIN, top + height + MARGIN)
    part = replace(ink, mask=_within(ink.mask, frame), strength=_within(ink.strength, frame))
    pieces = connected_pieces(part.mask.view(np.uint8))
    size_of_all = float(np.hypot(width - 1, height - 1))
    reach = max(TOUCH_PENS * ink.pen_width + 3, TOUCH * size_of_all)
    meet = _meet(pieces, ink.pen_width, CLUTTER * size_of_all)
    owner = _owners(pieces, int(reach if meet else APART * reach))
    boxes = {int(g): _box(pieces, owner == g) for g in np.unique(owner[1:])}
    size = {g: float(np.hypot(x1 - x0, y1 - y0)) for g, (x0, y0, x1, y1) in boxes.items()}
    largest = max(size.values())
    names = sorted((g for g in size if size[g] >= max(SMALLEST * largest, 12.0)), key=lambda g: -size[g])
    corner = np.array([left - MARGIN, top - MARGIN], float)
    groups = [_cut(part, corner, pieces, owner == g, boxes[g]) for g in names[:most]]
    cut = cut_off(ink)
    return groups if cut is None else [replace(group, cut=cut - group.offset) for group in groups]


def _meet(pieces: Pieces, pen: float, least: float) -> bool:
    """Whether there are pieces that enclose something and are not small, nor few beside those that enclose nothing.

    least : extent of pieces that count beside them, pixels: letters and dashes are smaller
    """
    encloses, extent = pieces.holes > ENCLOSED * pen * pen, pieces.extent
    enclosing, lines = float(extent[encloses].sum()), float(extent[~encloses & (extent >= least)].sum())
    return enclosing >= WHOLE * float(extent.max()) and enclosing >= FEW * (enclosing + lines)


def _within(plane: NDArray[Any], box: tuple[int, int, int, int]) -> NDArray[Any]:
    """What lies from left and top to right and bottom, empty beyond the plane's own border."""
    x0, y0, x1, y1 = box
    h, w = plane.shape
    part = plane[max(y0, 0) : y1, max(x0, 0) : x1]
    beyond = ((max(-y0, 0), max(y1 - h, 0)), (max(-x0, 0), max(x1 - w, 0)))
    return np.pad(part, beyond) if np.any(beyond) else part


def _owners(pieces: Pieces, gap: int) -> Ints:
    """Group of every connected piece: pieces less than a gap apart, then groups inside another's outline."""
    owner = np.arange(len(pieces.low))
    if len(pieces.outlines) == 1:
        return owner
    count, joined = cv2.connectedComponents(cv2.dilate(pieces.mask, np.ones((gap, gap), np.uint8)), connectivity=8)
    x, y = pieces.first.T
    owner[1:] = joined[y, x]
    return owner if count == 2 else _with_inner(owner, pieces)


def _with_inner(owner: Ints, pieces: Pieces) -> Ints:
    """`owner` with every group that lies inside another's convex hull given to that one; of the largest groups."""
    boxes = {int(g): _box(pieces, owner == g) for g in np.unique(owner[1:])}
    ranked = sorted(boxes, key=lambda g: -float(np.hypot(boxes[g][2] - boxes[g][0], boxes[g][3] - boxes[g][1])))[:24]
    before = owner
    for k, outer in enumerate(ranked):
        left, top, right, bottom = boxes[outer]
        hull = None
        for inner in ranked[k + 1 :]:
            x0, y0, x1, y1 = boxes[inner]
            if x0 < left or y0 < top or x1 > right or y1 > bottom:
                continue
            if hull is None:
                hull = cv2.convexHull(np.concatenate([pieces.outlines[i] for i in np.flatnonzero(before[1:] == outer)]))
            own = np.concatenate([pieces.outlines[i] for i in np.flatnonzero(before[1:] == inner)])
            corners = cv2.convexHull(own)[:, 0].tolist()
            if all(cv2.pointPolygonTest(hull, (float(x), float(y)), False) >= 0 for x, y in corners):
                owner = np.where(owner == inner, outer, owner)
    return owner


def _box(pieces: Pieces, mine: Bools) -> tuple[int, int, int, int]:
    """Left, top, right and bottom of some pieces; right and bottom are one pixel further."""
    own = np.flatnonzero(mine[1:]) + 1
    (x0, y0), (x1, y1) = pieces.low[own].min(axis=0).tolist(), pieces.high[own].max(axis=0).tolist()
    return x0, y0, x1 + 1, y1 + 1


def _cut(ink: Ink, corner: Floats, pieces: Pieces, mine: Bools, box: tuple[int, int, int, int]) -> Group:
    """The pieces that are `mine`, out of ink whose first pixel lies at `corner` of the sheet."""
    x0, y0, x1, y1 = box
    size = float(np.hypot(x1 - x0, y1 - y0))
    mine[0] = False
    large = mine & (pieces.extent >= CLUTTER * size)
    frame = (slice(y0 - MARGIN, y1 + MARGIN), slice(x0 - MARGIN, x1 + MARGIN))
    mask, solid = (_pixels_of(pieces, some)[frame] for some in (mine, large))
    own = replace(ink, mask=mask, strength=ink.strength[frame])
    offset = corner + [x0 - MARGIN, y0 - MARGIN]
    if ink.lines is not None:
        own = replace(own, lines=_lines_on(mask, ink.lines, offset))
        solid = solid & drawn([line.points for line in own.lines or () if not line.dashed], solid.shape)
    return Group(own, offset, solid, size, int(np.count_nonzero(mine)))


def _lines_on(mask: Bools, lines: tuple[VectorLine, ...], offset: Floats) -> tuple[VectorLine, ...]:
    """Those of the sheet's lines that are drawn on a part of it, whose first pixel lies at `offset`."""
    h, w = mask.shape
    kept = []
    for line in lines:
        own = line.mapped(offset, 1.0)
        x, y = np.rint(own.points[0]).astype(int).tolist()
        if 0 <= x < w and 0 <= y < h and mask[y, x]:
            kept.append(own)
    return tuple(kept)


def _pixels_of(pieces: Pieces, some: Bools) -> Bools:
    """Map of some of the pieces."""
    return pieces.mask.view(np.bool_) if some[1:].all() else pieces.only(some)
