"""Fills: shaded faces become their outlines.

A filled face is wide where a stroke is narrow. An opening keeps what is wide; what rises above it are the outlines
drawn on or around the fill; where two fills meet, or a fill meets the paper, without a drawn line, their border is the
ink. Strokes can be as wide as faces are elsewhere (icons), so wide ink as dark as everything else that encloses
several faces stays a stroke.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink.histogram import above, percentile
from sketch2shape.ink.kernels import square
from sketch2shape.ink.pen_width import rough_pen_width
from sketch2shape.model import Gray, as_gray

WIDE = 0.03
"""Ink wider than this share of the picture's diagonal may be a fill."""
NARROW = 0.02
"""Strokes on and around fills are narrower than this share of the diagonal."""
BLOT = 3.0
"""Wide ink smaller than this many of the boxes that tell what is wide is a blot, not a face."""
SAME_FILL = 0.6
"""A neighbour with less than this share of a fill's contrast is not the same fill."""
PALE = 0.3
"""Wide areas below this share of the darkest ink's contrast are stains ..."""
GRAIN = 1.5
"""... and what they add to the contrast is up to this many times that of their palest parts."""
PALER = 0.8
"""Wide ink below this share of the darkest ink's contrast is a fill."""


def without_fills(contrast: Gray, floor: float, diagonal: float) -> Gray:
    """Contrast with every fill replaced by its outline.

    contrast : (h, w) uint8, see `Ground`
    floor    : contrast below which nothing is ink
    diagonal : of the picture of which this is a part, pixels
    returns  : (h, w) uint8; `contrast` itself where nothing is filled
    """
    core = _wide_core(contrast, floor, diagonal)
    if not core.any() or _are_thick_strokes(contrast, core):
        return contrast
    level = _fill_level(contrast, core, floor, NARROW * diagonal)
    strokes = as_gray(cv2.subtract(contrast, level))
    borders = _borders(level, strokes, floor, diagonal)
    return np.maximum(strokes, borders)


def without_stains(contrast: Gray, floor: float, diagonal: float) -> Gray:
    """Contrast less that of wide pale areas with a grain: stains, smudges, the wash of a wiped board.

    The arguments are those of `without_fills`; returns `contrast` itself where there is no such area.
    """
    soft = as_gray(cv2.blur(contrast, (5, 5)))
    if not _may_be_wide(soft, square(NARROW * diagonal), floor):
        return contrast
    darkest = percentile(contrast[above(contrast, floor)], 95)
    pen_width = rough_pen_width(above(contrast, 0.4 * darkest))
    box = square(max(NARROW * diagonal, 5.0 * pen_width))
    wide = as_gray(cv2.morphologyEx(soft, cv2.MORPH_OPEN, box))
    if int(wide.max()) <= floor:
        return contrast
    count, area = cv2.connectedComponents(above(wide, 0.5 * floor).view(np.uint8), connectivity=4)
    dark = above(wide, PALE * darkest)
    pale = np.bincount(area[dark], minlength=count) == 0  # an area that is dark in part is a fill
    stain = np.where(pale[area], wide, np.uint8(0))
    return as_gray(cv2.subtract(contrast, as_gray(cv2.convertScaleAbs(stain, alpha=GRAIN))))


def _may_be_wide(contrast: Gray, box: Gray, floor: float) -> bool:
    """Whether a box may fit into what is above the floor: every fourth pixel of it would be so too."""
    return int(cv2.erode(contrast[::4, ::4], np.ones((len(box) // 4,) * 2, np.uint8)).max()) > floor


def _wide_core(contrast: Gray, floor: float, diagonal: float) -> NDArray[np.bool_]:
    """(h, w) centres of large boxes that fit into the ink, except in blots: thick corners, arrow heads, vertex dots."""
    box = square(WIDE * diagonal)
    if not _may_be_wide(contrast, box, floor):
        return np.zeros(contrast.shape, np.bool_)
    core = above(as_gray(cv2.erode(contrast, box)), floor).view(np.uint8)
    if not core.any():
        return core > 0
    _, labels, stats, _ = cv2.connectedComponentsWithStatsWithAlgorithm(
        as_gray(cv2.dilate(core, box)), 8, cv2.CV_32S, cv2.CCL_GRANA
    )
    large = stats[:, cv2.CC_STAT_AREA] >= BLOT * box.size
    large[0] = False
    return np.asarray(large[labels] & (core > 0), dtype=np.bool_)


def _are_thick_strokes(contrast: Gray, core: NDArray[np.bool_]) -> bool:
    """All wide ink is as dark as the rest and encloses two faces or more, or is long for its width."""
    darkest = percentile(contrast[above(contrast, int(contrast.max()) // 4)], 90)
    if percentile(contrast[core], 20) < PALER * darkest:
        return False
    solid = above(contrast, 0.5 * darkest).view(np.uint8)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(solid, connectivity=8)
    distance = cv2.distanceTransform(solid, cv2.DIST_L2, cv2.DIST_MASK_5)
    for label in np.unique(labels[core]):
        x, y, w, h, area = stats[label]
        part = np.asarray(labels[y : y + h, x : x + w] == label, dtype=np.uint8)
        width = 2.0 * float((distance[y : y + h, x : x + w] * part).max())
        if area < 8.0 * width**2 and _holes(part) < 2:
            return False
    return True


def _holes(part: Gray) -> int:
    """Number of background areas that a component encloses, larger than specks."""
    padded = np.pad(1 - part, 1, constant_values=1)
    _, _, stats, _ = cv2.connectedComponentsWithStats(padded, connectivity=4)
    return int(np.count_nonzero(stats[1:, cv2.CC_STAT_AREA] > 0.002 * part.size)) - 1


def _fill_level(contrast: Gray, core: NDArray[np.bool_], floor: float, narrow: float) -> Gray:
    """The contrast of the fills alone, grown back into their sharp corners as far as the opening can have cut them."""
    opened = as_gray(cv2.morphologyEx(contrast, cv2.MORPH_OPEN, square(narrow)))
    _, labels = cv2.connectedComponents(above(opened, floor).view(np.uint8), connectivity=4)
    filled = np.zeros(int(labels.max()) + 1, np.bool_)
    filled[labels[core]] = True
    level = np.where(filled[labels], opened, np.uint8(0))
    highest = as_gray(cv2.convertScaleAbs(contrast, alpha=1.0 / SAME_FILL))
    lowest = as_gray(cv2.convertScaleAbs(contrast, alpha=SAME_FILL))
    whole = opened > 0.9 * contrast  # nothing was cut off here
    for _ in range(int(narrow) + 2):
        grown = as_gray(cv2.dilate(level, np.ones((3, 3), np.uint8)))
        other = whole | (highest < grown) | (lowest > grown)  # the paper or another face, an outline
        level = np.where(other, level, np.minimum(grown, contrast))
    return level


def _borders(level: Gray, strokes: Gray, floor: float, diagonal: float) -> Gray:
    """Contrast of the borders between fills that no stroke follows."""
    edges = as_gray(cv2.Canny(level, 3.0 * floor, 6.0 * floor))
    drawn = np.asarray(strokes > max(floor, 0.3 * float(strokes.max())), dtype=np.uint8)
    near = cv2.dilate(drawn, square(NARROW * diagonal))
    edges[near > 0] = 0
    step = as_gray(cv2.morphologyEx(level, cv2.MORPH_GRADIENT, np.ones((5, 5), np.uint8)))
    wide = cv2.dilate(edges, np.ones((3, 3), np.uint8)) > 0
    return np.where(wide, np.maximum(step, np.uint8(2 * min(int(floor), 127))), np.uint8(0))
