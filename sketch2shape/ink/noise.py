"""Paper: its noise, its grain and its printed marks (squares, rules, dots), which are not ink.

A drawing leaves parts of the picture empty, paper does not: what is everywhere belongs to the paper.
"""

from __future__ import annotations

import itertools

import cv2
import numpy as np

from sketch2shape.ink.histogram import above, counts_of, quantile
from sketch2shape.ink.pen_width import rough_pen_width
from sketch2shape.model import Bools, Floats, Gray

TILES = 10
"""The picture is cut into TILES x TILES to see what marks are everywhere."""
EMPTIEST = 0.12
"""Share of the tiles that surely hold marks only, or nothing."""
PALE = 100.0
"""Contrast below which a picture that is evenly covered is empty paper."""
CLEAR_STEP = 1.12
"""Ratio of contrasts between neighbouring tiles, in order of contrast, that parts marks from ink."""
SOLID = 0.93
"""Share of ink on the lines of a band along the frame."""
WIDE_STEP = 1.5
"""The first ratio as large as this parts them, whatever comes later: ink may be faint and strong."""
PARTS = 4
"""A mark must be in at least three of the PARTS x PARTS parts of a tile."""


def noise_of(contrast: Gray, on_page: Bools | None = None) -> float:
    """Standard deviation of white noise, from what a 3 x 3 binomial filter takes away.

    contrast : (h, w) uint8, see `Ground`
    on_page  : (h, w) where to look; then the noise of the noisier fifth of the tiles counts (the shadow's side)
    """
    if on_page is None:
        return 1.85 * _median(_rough(_strips(contrast)))
    rough = _rough(contrast)
    h, w = contrast.shape
    rows, columns = (np.unique(np.linspace(0, side, 6).astype(int)) for side in (h, w))
    medians = []
    for top, bottom in itertools.pairwise(rows):
        for left, right in itertools.pairwise(columns):
            if on_page[top:bottom:4, left:right:4].mean() > 0.9:
                medians.append(_median(rough[top:bottom, left:right]))
    return 1.85 * float(np.percentile(medians, 80)) if medians else 1.85 * _median(rough)


def _rough(plane: Gray) -> Gray:
    """What a small filter takes away."""
    return np.asarray(cv2.absdiff(plane, cv2.GaussianBlur(plane, (3, 3), 0)), dtype=np.uint8)


def _strips(plane: Gray) -> Gray:
    """Every third strip of eight rows, one below the other; white noise is the same across their seams."""
    rows = len(plane) // 24 * 24
    return plane[:rows].reshape(-1, 24, plane.shape[1])[:, 8:16].reshape(-1, plane.shape[1]) if rows else plane


def _median(values: Gray) -> float:
    """Median of bytes, between the levels."""
    if 2 * int(cv2.countNonZero(values)) <= values.size:
        return 0.0
    counts = np.cumsum(counts_of(values))
    half = 0.5 * float(counts[-1])
    level = int(np.searchsorted(counts, half))
    if level == 0:
        return 0.0
    below = float(counts[level - 1])
    share = (half - below) / max(float(counts[level]) - below, 1.0)
    return level - 0.5 + float(share)


def paper_marks(contrast: Gray, on_page: Bools | None = None) -> float:
    """Contrast up to which marks belong to the paper, because they are everywhere: squares, rules, dots, grain.

    contrast : (h, w) uint8, see `Ground`
    on_page  : (h, w) where to look, all over if None
    returns  : 0 where the emptiest tiles hold nothing, or as much as the others do and no pale marks (thick strokes)
    """
    h, w = contrast.shape
    if min(h, w) < 8 * TILES:
        return 0.0
    if on_page is None and np.count_nonzero(_highest(contrast, TILES)) < (1.0 - EMPTIEST) * TILES**2 - 1.0:
        return 0.0
    parts = _highest(contrast, PARTS * TILES).astype(np.float64).reshape(TILES, PARTS, TILES, PARTS).swapaxes(1, 2)
    tallest = np.sort(parts.reshape(TILES**2, PARTS**2), axis=1)[:, -3]  # a speck or two are no mark
    if on_page is not None:
        coarse = np.asarray(on_page[::4, ::4], dtype=np.uint8)
        share = cv2.resize(coarse * np.uint8(255), (TILES, TILES), interpolation=cv2.INTER_AREA)
        tallest = tallest[np.asarray(share).ravel() > 0.8 * 255]
        if len(tallest) < TILES:
            return 0.0
    tallest = np.sort(tallest)
    low, high = quantile(tallest, EMPTIEST), quantile(tallest, 0.95)
    if low == 0.0:
        return 0.0
    if low > 0.86 * high:
        return 1.2 * high if high < PALE else 0.0
    return _split(tallest, low)


def _highest(contrast: Gray, count: int) -> Gray:
    """(count, count) highest contrast in each of the parts into which both sides are cut."""
    rows, columns = (np.arange(count + 1) * n // count for n in contrast.shape)
    strips = np.stack([contrast[top:bottom].max(axis=0) for top, bottom in itertools.pairwise(rows.tolist())])
    return np.asarray(np.maximum.reduceat(strips, columns[:-1], axis=1), np.uint8)


def _split(tallest: Floats, low: float) -> float:
    """Contrast that parts the marks of the paper from ink, by the contrasts of the tiles in rising order.

    low : contrast of a tile that surely holds marks only
    """
    steps = np.append((tallest[1:] + 1.0) / (tallest[:-1] + 1.0), 1.0)
    steps[(tallest > 2.2 * low + 4) | (np.arange(len(steps)) <= EMPTIEST * len(steps))] = 0.0
    last = int(np.argmax(np.where(steps > WIDE_STEP, WIDE_STEP, steps)))
    if steps[last] > CLEAR_STEP and low > 20.0:
        between = float(np.sqrt(tallest[last] * tallest[last + 1]))
        return min(between, 1.2 * quantile(tallest[: last + 1], 0.95))
    alike = tallest < 1.6 * low + 4
    top = quantile(tallest[alike], 0.95)
    return 1.2 * top if top < PALE or not alike.all() else 0.0


def without_bands(contrast: Gray, floor: float) -> Gray:
    """Without solid bands along the frame: the black edge of a scan, the bars of a window.

    contrast : (h, w) uint8, see `Ground`
    floor    : contrast below which nothing is ink
    returns  : (h, w); `contrast` itself where there are none
    """
    rims = (contrast[0], contrast[-1], contrast[:, 0], contrast[:, -1])
    if not any(np.count_nonzero(above(rim, floor)) > SOLID * len(rim) for rim in rims):
        return contrast
    solid = above(contrast, floor)
    rows, columns = solid.mean(axis=1) > SOLID, solid.mean(axis=0) > SOLID
    ends = [_leading(v) for v in (rows, rows[::-1], columns, columns[::-1])]
    least = max(8, max(contrast.shape) // 100)
    if max(ends) < least:
        return contrast
    h, w = contrast.shape
    inner = contrast[ends[0] : h - ends[1], ends[2] : w - ends[3]]
    least = max(least, int(2.2 * rough_pen_width(above(inner, max(floor, 0.5 * float(inner.max()))))))
    top, bottom, left, right = (n + 3 if n >= least else 0 for n in ends)  # else it is a stroke along the frame
    result = np.zeros_like(contrast)
    result[top : h - bottom, left : w - right] = contrast[top : h - bottom, left : w - right]
    return result


def _leading(values: Bools) -> int:
    """How many values are True from the start; 0 if all or nearly all are."""
    ends = np.flatnonzero(~values)
    first = int(ends[0]) if len(ends) else len(values)
    return first if first < 0.25 * len(values) else 0
