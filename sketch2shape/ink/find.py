"""Ink: the pixels of a picture that were drawn.

The picture is brought to working size and measured against its ground; the table around a page, the marks and the
noise of the paper and bands along the frame are taken away. What is left lies within a frame, often a third of the
picture, and only there the rest is done: the fills of faces go, and a pixel is ink where its contrast is about half of
the strongest close by. That puts the border of a stroke where its anti-aliased or blurred flank is half way down, for
faint and for strong strokes alike. Hatching, letters and specks go last.
"""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from sketch2shape.ink.background import read_ground
from sketch2shape.ink.clutter import without_clutter
from sketch2shape.ink.components import connected_pieces
from sketch2shape.ink.drawn_lines import ink_of_lines
from sketch2shape.ink.fills import without_fills, without_stains
from sketch2shape.ink.grain import with_weak_places, without_burrs
from sketch2shape.ink.hatch_lines import without_hatch_lines
from sketch2shape.ink.hatching import without_hatching
from sketch2shape.ink.histogram import percentile
from sketch2shape.ink.noise import noise_of, paper_marks, without_bands
from sketch2shape.ink.page import find_page, page_homography
from sketch2shape.ink.pen_width import FINE, pen_width_of, rough_pen_width
from sketch2shape.ink.solid_faces import without_solid_faces
from sketch2shape.ink.tones import with_borders
from sketch2shape.model import Bools, Floats, Gray, Ink, Picture, as_gray
from sketch2shape.reading import read_picture

FLOOR = 8.0
"""Contrast below which nothing is ink, in 255ths."""
WEAKEST = 0.85
"""Part of the contrast of marks of the paper from which a pixel is ink beside one that is stronger than they are."""
MARGIN = 0.03
"""Empty border around the ink, as a share of the picture's diagonal: what closes gaps must not meet the frame."""
SPECK = 0.05
"""Pieces smaller than this part of the largest one do not tell where the drawing lies."""
PALE = 16
"""Contrast of ringing is below this nearly everywhere."""


def find_ink(source: Any) -> Ink:
    """Find the ink of a drawing on any ground, light or dark.

    source  : path, bytes, PIL image, array (gray, RGB, RGBA), or `Picture`
    returns : `Ink` at working size; an empty mask where nothing was drawn

    The lines of a vector drawing are known: they are taken as they are. Raises UnreadableError or LimitError for a
    picture that cannot be read.
    """
    picture = read_picture(source, reduced=True)
    return _found(picture) if picture.drawing is None else ink_of_lines(picture.drawing)


def _found(picture: Picture) -> Ink:
    """The ink among the pixels of a picture."""
    ground = read_ground(picture.pixels)
    scale = ground.scale / picture.reduction
    contrast, noise, page = ground.contrast, ground.noise, None
    marks = paper_marks(contrast)
    if ground.paper is not None:
        least = np.full_like(contrast, min(int(max(FLOOR, 5.0 * noise, marks)), 255))
        on_page, corners = find_page(ground.paper, _near_peak(contrast, least, least, 9, 0.5))
        if on_page is not None:
            contrast = contrast * on_page
            noise, marks = noise_of(contrast, on_page), paper_marks(contrast, on_page)
        page = None if corners is None else _rectification(corners, scale, picture)
    floor = max(FLOOR, 5.0 * noise, marks)
    contrast = without_bands(contrast, floor)
    mask, strength = np.zeros(contrast.shape, np.bool_), np.zeros_like(contrast)
    diagonal = float(np.hypot(*contrast.shape))
    drawn_on = _above(contrast, floor)
    if ground.borders is not None:
        drawn_on |= ground.borders.view(np.uint8)
    frame = _frame(drawn_on if ground.clean else _without_specks(drawn_on), MARGIN * diagonal)
    if frame is None:
        return Ink(mask=mask, strength=strength, pen_width=1.0, scale=scale, page=page)
    part = np.ascontiguousarray(contrast[frame])
    if not ground.clean:
        part = without_stains(part, floor, diagonal)
    if ground.borders is None:
        part = without_fills(part, floor, diagonal)
    ringing = ringing_of(part)
    weakest = WEAKEST if marks == floor else 1.0
    drawn = ink_mask(part, floor, ringing, weakest)
    if not ground.clean:
        drawn = with_weak_places(drawn, part, weakest * floor)
    if ground.borders is not None:
        drawn = with_borders(drawn, np.ascontiguousarray(ground.borders[frame]))
    drawn = without_hatch_lines(without_hatching(drawn, diagonal))
    drawn = without_clutter(drawn, part, noisy=ringing > 0.0 or noise > 0.5)
    pen_width = pen_width_of(drawn)
    drawn = without_solid_faces(drawn, pen_width, diagonal)
    closer = _frame(drawn.view(np.uint8), MARGIN * diagonal)
    if closer is not None:  # without what was cleared away it is smaller, often by half
        part = part[closer]
        drawn = without_burrs(np.ascontiguousarray(drawn[closer]), pen_width)
        mask[frame][closer] = drawn
        strength[frame][closer] = cv2.convertScaleAbs(part, alpha=255.0 / max(percentile(part[drawn], 90), 1.0))
    return Ink(mask=mask, strength=strength, pen_width=pen_width, scale=scale, page=page)


def _frame(marked: Gray, border: float) -> tuple[slice, slice] | None:
    """Rows and columns that hold all that is not 0, with a border around; None where there is nothing."""
    h, w = marked.shape
    x, y, width, height = cv2.boundingRect(marked)
    if not width:
        return None
    margin = round(border)
    return (
        slice(max(0, y - margin), min(h, y + height + margin)),
        slice(max(0, x - margin), min(w, x + width + margin)),
    )


def _without_specks(marked: Gray) -> Gray:
    """The boxes of all but the smallest pieces, of noise and dust: a frame around these would be the whole picture."""
    pieces = connected_pieces(marked)
    boxes = np.zeros_like(marked)
    for piece in np.flatnonzero(pieces.extent > SPECK * pieces.extent.max()).tolist():
        (left, top), (right, bottom) = pieces.low[piece], pieces.high[piece]
        boxes[top, left] = boxes[bottom, right] = 1
    return boxes


def _above(contrast: Gray, floor: float) -> Gray:
    return as_gray(cv2.threshold(contrast, min(int(floor), 254), 1, cv2.THRESH_BINARY)[1])


def _rectification(corners: Floats, scale: float, picture: Picture) -> Floats:
    """Homography of a page whose corners are given in working pixels."""
    return page_homography((corners + 0.5) / scale - 0.5, (np.array(picture.size) - 1) / 2)


def ink_mask(contrast: Gray, floor: float, ringing: float = 0.0, weakest: float = 1.0) -> Bools:
    """Ink: near the local peak of `contrast`, above `floor` and above the ringing around strong ink.

    Where the pen turns out to be fine the peak is looked for closer by, lest it drown a pale line beside it, and less
    of it suffices, as an anti-aliased hairline is half as dark where it crosses from one row of pixels to the next.
    """
    least = np.full_like(contrast, min(int(floor), 255))
    if ringing > 0.0:
        least = np.maximum(least, _scaled(_peak(contrast, 25), ringing))
    weaker = _scaled(least, weakest) if weakest < 1.0 else least
    mask = _near_peak(contrast, least, weaker, 9, 0.5)
    pen_width = rough_pen_width(mask)
    if pen_width > 4.0:
        return mask
    size, share = (5, 0.38) if pen_width < FINE else (7, 0.45)
    return _near_peak(contrast, least, weaker, size, share)


def _near_peak(contrast: Gray, least: Gray, weaker: Gray, size: int, share: float) -> Bools:
    """What has a share of the highest contrast around it, and the least that ink has, or a weaker one beside that."""
    peak = _peak(contrast, size)
    lowest = least if weaker is least else np.where(peak > least, weaker, least)
    return np.asarray(contrast > np.maximum(lowest, _scaled(peak, share)), dtype=np.bool_)


def _peak(contrast: Gray, size: int) -> Gray:
    return as_gray(cv2.dilate(contrast, np.ones((size, size), np.uint8)))


def _scaled(values: Gray, share: float) -> Gray:
    return as_gray(cv2.convertScaleAbs(values, alpha=share))


def ringing_of(contrast: Gray) -> float:
    """Height of the JPEG ringing around strokes as a share of their contrast, at most 0.3; 0 in clean pictures."""
    if _count(contrast) - _count(_above(contrast, PALE - 1)) < 0.01 * contrast.size:
        return 0.0
    sample = contrast[::2]
    peak, wide_peak = _peak(contrast, 9)[::2], _peak(contrast, 25)[::2]
    third = _scaled(wide_peak, 1 / 3)
    around = np.flatnonzero((wide_peak > np.uint8(80)) & (peak < third))
    if len(around) < 100:
        return 0.0
    share = sample.ravel()[around] / wide_peak.ravel()[around].astype(np.float32)
    rank = int(0.9 * len(share))
    return min(0.3, 5.0 * float(np.partition(share, rank)[rank]))


def _count(plane: Gray) -> int:
    return int(cv2.countNonZero(plane))
