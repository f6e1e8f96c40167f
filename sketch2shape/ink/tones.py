"""Tones: a picture made of flat areas, read by the areas instead of by a pen.

A picture that a program drew may show its faces by colour or grey alone. Wide flat areas are found first, of any tone;
what is narrow is a stroke, as dark as it differs from the areas around it, so that neither the paper nor the colour of
the pen has to be known; and where two areas of different tones meet without a stroke their border is an edge. Photos,
scans and pencil have no flat areas, and a drawing in lines has areas of one tone only: both are left to `Ground`.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.model import Bools, Gray, Ints, as_gray

FLAT = 3
"""Greatest difference among a pixel and its eight neighbours within an area, levels; JPEG of quality 75 keeps it."""
DIGITAL = 0.75
"""Share of flat pixels from which a picture was drawn by a program."""
WIDE = 0.01
"""Areas hold a square with this share of the diagonal as its side; what is narrower is a stroke."""
STEP = 6
"""Least difference of two tones whose border is an edge, levels."""
LEAST_AREA = 0.002
"""Least share of the picture that an area fills: vertex dots, arrow heads and letters are smaller."""
NARROW = 0.04
"""Strokes are narrower than this share of the diagonal ..."""
BROAD = 0.12
"""... or than this, if they are closed and long: an icon of a thick pen."""
LONG = 8.0
"""Area over the squared width, from which an area is long."""
ALL = 0.9
"""Share of a stroke that lies on one tone, at least."""
REACH = 9
"""Side of the box in which a pixel can be a mixture of two tones: twice what resampling blurs, pixels."""
RINGING = 0.25
"""Share of the step between two tones up to which what lies beyond them is ringing or the tip of a wedge."""
BORDER = 3
"""Width of the ink along a border without a stroke, pixels ..."""
BESIDE = 5
"""... and side of the box around its pixels in which there must be no stroke."""


@dataclass(frozen=True)
class Tones:
    """A picture against the flat areas in it.

    contrast : (h, w) uint8, 0 within the areas, 255 for the strongest possible stroke
    borders  : (h, w) bool, where two areas of different tones meet
    """

    contrast: Gray
    borders: Bools


def read_tones(seen: Gray) -> Tones | None:
    """Measure a picture against its flat areas; None where they have one tone, or where there are none.

    seen : (h, w) or (h, w, 3) uint8, working size
    """
    if not _may_have_tones(seen):
        return None
    areas = _areas(seen)
    if areas is None:
        return None
    owner, tone = _spread(areas, seen)
    borders = _borders(owner, tone)
    return Tones(_off(seen, tone), borders) if borders.any() else None


def _channels(plane: Gray) -> Gray:
    """The largest of the channels."""
    return plane if plane.ndim == 2 else as_gray(cv2.max(cv2.max(plane[..., 0], plane[..., 1]), plane[..., 2]))


def _range(seen: Gray) -> Gray:
    return _channels(as_gray(cv2.morphologyEx(seen, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))))


def _may_have_tones(seen: Gray) -> bool:
    """A cheap look: most pixels are flat in a sample of rows, and something wide has not the commonest level."""
    rows = len(seen) // 24 * 24
    strips = seen[:rows].reshape(-1, 24, *seen.shape[1:])[:, 8:13].reshape(-1, *seen.shape[1:]) if rows else seen
    return bool(np.count_nonzero(_range(strips) <= FLAT) > DIGITAL * strips.shape[0] * strips.shape[1])


def _box(size: float) -> Gray:
    side = 2 * (int(size) // 2) + 1
    return np.ones((side, side), np.uint8)


def _areas(seen: Gray) -> Ints | None:
    """(h, w) number of the flat area that each pixel belongs to, 0 in none; None if there are less than two."""
    flat = as_gray(_range(seen) <= FLAT)
    diagonal = float(np.hypot(*flat.shape))
    core = cv2.erode(flat, _box(WIDE * diagonal), borderType=cv2.BORDER_CONSTANT, borderValue=1)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(flat, connectivity=4)
    kept = np.zeros(count, np.bool_)
    kept[labels[core > 0]] = True
    kept &= stats[:, cv2.CC_STAT_AREA] > LEAST_AREA * flat.size
    kept[0] = False
    shapes = {label: _shape(labels, stats[label].tolist(), label) for label in np.flatnonzero(kept).tolist()}
    doubtful = [
        label
        for label, (width, long, closed) in shapes.items()
        if width < NARROW * diagonal or (width < BROAD * diagonal and long and closed)
    ]
    if doubtful:
        kept[doubtful] = False
        if not kept.any():
            return None
        _, tone = _spread(np.where(kept[labels], labels, 0), seen)
        for label in doubtful:
            width, _, closed = shapes[label]
            plain = _is_plain(tone, labels == label)
            kept[label] = not (plain or (closed and width < NARROW * diagonal))
    return np.where(kept[labels], labels, 0) if np.count_nonzero(kept) > 1 else None


def _shape(labels: Ints, stats: list[int], label: int) -> tuple[float, bool, bool]:
    """Width of an area, pixels; whether it is long for that; and whether it is closed around something."""
    x, y, w, h, area = stats
    part = as_gray(labels[y : y + h, x : x + w] == label)
    padded = as_gray(cv2.copyMakeBorder(part, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0))
    width = 2.0 * float(cv2.distanceTransform(padded, cv2.DIST_L2, cv2.DIST_MASK_5).max())
    contours, _ = cv2.findContours(padded, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    return width, area > LONG * width**2, len(contours) > 1


def _is_plain(tone: Gray, part: Bools) -> bool:
    """Nearly all of a part lies on one tone, as what is drawn on an area does."""
    own = tone[part].reshape(int(np.count_nonzero(part)), -1).astype(np.int16)
    off = np.abs(own - np.median(own, axis=0)).max(axis=1)
    return bool(np.count_nonzero(off < STEP) > ALL * len(own))


def _spread(areas: Ints, seen: Gray) -> tuple[Ints, Gray]:
    """Number and tone of the area that is nearest to each pixel."""
    seed = areas > 0
    _, labels = cv2.distanceTransformWithLabels(
        as_gray(~seed), cv2.DIST_L2, cv2.DIST_MASK_5, labelType=cv2.DIST_LABEL_PIXEL
    )
    where = np.flatnonzero(seed)
    index = np.zeros(int(labels.max()) + 1, np.intp)
    index[labels.ravel()[where]] = where
    nearest = index[labels]
    pixels = seen.reshape(seed.size, -1)
    return areas.ravel()[nearest], as_gray(pixels[nearest.ravel()].reshape(seen.shape))


def _borders(owner: Ints, tone: Gray) -> Bools:
    """(h, w) pixels beside another area of another tone."""
    border = np.zeros(owner.shape, np.uint8)
    for a, b in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
        ys, xs = np.nonzero(owner[a] != owner[b])
        step = np.abs(tone[a][ys, xs].astype(np.int16) - tone[b][ys, xs]).reshape(len(ys), -1).max(axis=1, initial=0)
        border[ys[step >= STEP], xs[step >= STEP]] = 1
    return np.asarray(border > 0, np.bool_)


def _off(seen: Gray, tone: Gray) -> Gray:
    """How far each pixel is from the tone of its area; near others from all mixtures of both, less their ringing."""
    off = _channels(as_gray(cv2.absdiff(seen, tone)))
    box = np.ones((REACH, REACH), np.uint8)
    low, high = as_gray(cv2.erode(tone, box)), as_gray(cv2.dilate(tone, box))
    near = _channels(as_gray(cv2.subtract(high, low))) >= STEP
    count = int(np.count_nonzero(near))
    colour, own, least, most = (p[near].reshape(count, -1).astype(np.float32) for p in (seen, tone, low, high))
    step = np.where(most - own > own - least, most - own, least - own)  # to the other tone
    share = ((colour - own) * step).sum(axis=1) / (step * step).sum(axis=1)
    mixed = own + np.clip(share, 0.0, 1.0)[:, None] * step
    beyond = np.abs(colour - mixed).max(axis=1) - RINGING * np.abs(step).max(axis=1)
    off[near] = np.clip(beyond, 0.0, 255.0).astype(np.uint8)
    return off


def with_borders(drawn: Bools, borders: Bools) -> Bools:
    """The strokes, and the borders that no stroke follows.

    drawn   : (h, w) ink of strokes
    borders : (h, w) see `Tones`
    """
    free = borders & ~_grown(drawn, BESIDE)
    free = borders & _grown(free, BESIDE + 4)  # up to the middle of the stroke that it ends at
    return drawn | _grown(free, BORDER)


def _grown(mask: Bools, side: int) -> Bools:
    return np.asarray(cv2.dilate(mask.view(np.uint8), np.ones((side, side), np.uint8)) > 0, np.bool_)
