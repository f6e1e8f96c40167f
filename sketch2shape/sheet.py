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
    mask = ink.mask.astype(np.uint8)
    count, label, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=8)
    if count < 2:
        return []
    owner = _owners(mask, label, ink.pen_width)
    extent = {g: _box(stats, owner, g) for g in np.unique(owner[1:])}
    size = {g: float(np.hypot(x1 - x0, y1 - y0)) for g, (x0, y0, x1, y1) in extent.items()}
    largest = max(size.values())
    names = sorted((g for g in size if size[g] >= max(SMALLEST * largest, 12.0)), key=lambda g: -size[g])
    return [_cut(ink, label, stats, owner, g, extent[g], size[g]) for g in names[:most]]


def _owners(mask: NDArray[Any], label: NDArray[Any], pen: float) -> Ints:
    """Group of every connected piece: pieces that nearly touch, then groups inside another's outline."""
    ys, xs = np.nonzero(mask)
    diagonal = float(np.hypot(np.ptp(xs), np.ptp(ys)))
    gap = int(max(3 * pen + 3, 0.012 * diagonal))
    grown = cv2.dilate(mask, np.ones((gap, gap), np.uint8))
    _, joined = cv2.connectedComponents(grown, connectivity=8)
    owner = np.zeros(int(label.max()) + 1, np.intp)
    owner[label[ys, xs]] = joined[ys, xs]
    names, sizes = np.unique(joined[ys, xs], return_counts=True)
    points = {int(g): np.c_[xs, ys][joined[ys, xs] == g] for g in names[np.argsort(-sizes)][:24]}
    ranked = sorted(points, key=lambda g: -float(np.linalg.norm(np.ptp(points[g], axis=0))))
    for k, outer in enumerate(ranked):
        hull = cv2.convexHull(points[outer].astype(np.int32))
        for inner in ranked[k + 1 :]:
            low, high = points[inner].min(axis=0), points[inner].max(axis=0)
            box = [(low[0], low[1]), (high[0], low[1]), (low[0], high[1]), (high[0], high[1])]
            if all(cv2.pointPolygonTest(hull, (float(x), float(y)), False) >= 0 for x, y in box):
                owner[owner == inner] = outer
    return owner


def _box(stats: NDArray[Any], owner: Ints, group: int) -> tuple[int, int, int, int]:
    own = stats[1:][owner[1:] == group]
    x, y, w, h = (own[:, k] for k in range(4))
    return int(x.min()), int(y.min()), int((x + w).max()), int((y + h).max())


def _cut(
    ink: Ink,
    label: NDArray[Any],
    stats: NDArray[Any],
    owner: Ints,
    group: int,
    box: tuple[int, int, int, int],
    size: float,
) -> Group:
    x0, y0, x1, y1 = box
    mine = owner == group
    mine[0] = False
    part = label[y0:y1, x0:x1]
    large = mine & (np.hypot(stats[:, 2], stats[:, 3]) >= CLUTTER * size)
    pad = ((MARGIN, MARGIN), (MARGIN, MARGIN))
    mask = np.pad(mine[part], pad)
    strength = np.pad(ink.strength[y0:y1, x0:x1], pad) * mask
    return Group(
        replace(ink, mask=mask, strength=strength),
        np.array([x0 - MARGIN, y0 - MARGIN], float),
        np.pad(large[part], pad),
        size,
    )
