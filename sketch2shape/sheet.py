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

from sketch2shape.model import Bools, Floats, Ink, Ints
from sketch2shape.pieces import Pieces, connected_pieces

MARGIN = 8
SMALLEST = 0.12
"""Groups smaller than this part of the largest are writing, not objects."""
CLUTTER = 0.07
"""Connected pieces smaller than this part of their group cannot be told from letters or dashes."""


@dataclass(frozen=True)
class Group:
    """Ink that belongs together, cut out of the sheet.

    ink    : the group's own ink, with a margin around it
    offset : (2,) float, where its pixel (0, 0) lies on the sheet
    solid  : (h, w) bool, ink of pieces too large to be letters or dashes
    size   : diagonal of the group's bounding box, pixels
    """

    ink: Ink
    offset: Floats
    solid: Bools
    size: float


def split_groups(ink: Ink, most: int = 12) -> list[Group]:
    """Groups of the sheet that could be objects, the largest first."""
    mask = np.asarray(ink.mask, np.bool_).view(np.uint8)
    left, top, width, height = cv2.boundingRect(mask)
    if not width:
        return []
    frame = (slice(top, top + height), slice(left, left + width))
    part = replace(ink, mask=ink.mask[frame], strength=ink.strength[frame])
    pieces = connected_pieces(mask[frame])
    owner = _owners(mask[frame], pieces, ink.pen_width)
    boxes = {int(g): _box(pieces, owner == g) for g in np.unique(owner[1:])}
    size = {g: float(np.hypot(x1 - x0, y1 - y0)) for g, (x0, y0, x1, y1) in boxes.items()}
    largest = max(size.values())
    names = sorted((g for g in size if size[g] >= max(SMALLEST * largest, 12.0)), key=lambda g: -size[g])
    corner = np.array([left, top], float)
    return [_cut(part, corner, pieces, owner == g, boxes[g]) for g in names[:most]]


def _owners(mask: NDArray[Any], pieces: Pieces, pen: float) -> Ints:
    """Group of every connected piece: pieces that nearly touch, then groups inside another's outline."""
    gap = int(max(3 * pen + 3, 0.012 * float(np.hypot(mask.shape[0] - 1, mask.shape[1] - 1))))
    grown = cv2.dilate(mask, np.ones((gap, gap), np.uint8))
    count, joined = cv2.connectedComponents(grown, connectivity=8)
    owner = np.zeros(len(pieces.low), np.intp)
    first = np.array([outline[0, 0] for outline in pieces.outlines])
    owner[pieces.owner] = joined[first[:, 1], first[:, 0]]
    return owner if count == 2 else _with_inner(owner, pieces)


def _with_inner(owner: Ints, pieces: Pieces) -> Ints:
    """`owner` with every group that lies inside another's convex hull given to that one; of the largest groups."""
    boxes = {int(g): _box(pieces, owner == g) for g in np.unique(owner[1:])}
    ranked = sorted(boxes, key=lambda g: -float(np.hypot(boxes[g][2] - boxes[g][0], boxes[g][3] - boxes[g][1])))[:24]
    group_of = owner[pieces.owner]
    for k, outer in enumerate(ranked):
        left, top, right, bottom = boxes[outer]
        hull = None
        for inner in ranked[k + 1 :]:
            x0, y0, x1, y1 = boxes[inner]
            if x0 < left or y0 < top or x1 > right or y1 > bottom:
                continue
            if hull is None:
                hull = cv2.convexHull(np.concatenate([pieces.outlines[i] for i in np.flatnonzero(group_of == outer)]))
            corners = [(x0, y0), (x1 - 1, y0), (x0, y1 - 1), (x1 - 1, y1 - 1)]
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
    mask, solid = (_pixels_of(pieces.label[y0:y1, x0:x1], some) for some in (mine, large))
    strength = np.asarray(ink.strength[y0:y1, x0:x1] * mask, np.float32)
    return Group(
        replace(ink, mask=_framed(mask).view(np.bool_), strength=_framed(strength)),
        corner + [x0 - MARGIN, y0 - MARGIN],
        _framed(solid).view(np.bool_),
        size,
    )


def _pixels_of(label: NDArray[np.int32], some: Bools) -> NDArray[np.uint8]:
    """0/1 map of some of the pieces."""
    if some[1:].all():
        return np.asarray(label > 0).view(np.uint8)
    return some.view(np.uint8).take(label)


def _framed(plane: NDArray[Any]) -> NDArray[Any]:
    """With an empty margin around it."""
    framed = cv2.copyMakeBorder(plane, MARGIN, MARGIN, MARGIN, MARGIN, cv2.BORDER_CONSTANT, value=0)
    return np.asarray(framed, dtype=plane.dtype)
