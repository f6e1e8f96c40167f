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

from sketch2shape.ink.components import connected_pieces
from sketch2shape.ink.gaps import gaps_between
from sketch2shape.ink.histogram import counts_of
from sketch2shape.ink.kernels import square
from sketch2shape.model import Bools, Gray, Ints, as_gray

SMOOTH = 5
"""Side of the box of the median that takes hairlines and the noise of JPEG off the areas, pixels."""
CALM = 2
"""Greatest difference among a pixel and its eight neighbours where neither light nor a hand has left its noise ..."""
DIGITAL = 0.72
"""... and share of such pixels from which a picture was drawn by a program; photos of drawings have less, levels."""
FLAT = 5
"""The same within an area, of the smoothed picture."""
EVEN = 1
"""Greatest difference from the commonest colours of an area that has few of them, levels ..."""
MOST_EVEN = 0.75
"""... share of an area that is so, if its tone is not graded (of which it is three fifths) ..."""
LEAST_PART = 0.02
"""... and least share that each of its tones has."""
SAMPLED = 3
"""Every so manyeth pixel tells the tones of an area."""
CLEANED = 7
"""Side of the box of the median that takes single pixels of one tone out of another, pixels."""
WIDE = 0.01
"""Areas hold a square with this share of the diagonal as its side; what is narrower is a stroke."""
STEP = 6
"""Least difference of two tones, levels ..."""
BORDER_STEP = 4
"""... and of the pixels on both sides of their border."""
COARSE = 4
"""Every so manyeth row and column tells whether there may be any, and where ..."""
RIM = 32
"""... within this many pixels: hairlines may slip through."""
LEAST_AREA = 0.002
"""Least share of the part that is drawn on that an area fills: vertex dots, arrow heads and letters are smaller."""
NARROW = 0.04
"""Strokes are narrower than this share of the diagonal ..."""
BROAD = 0.12
"""... or than this, if they are long: an icon of a thick pen."""
LONG = 16.0
"""Area over the squared mean width, from which an area is long; of a frame twice as wide as its hole it is 12."""
ALL = 0.9
"""Share of a stroke that lies on one tone, at least."""
REACH = 9
"""Side of the box in which a pixel can be a mixture of two tones: twice what resampling blurs, pixels."""
FAINTER = 0.5
"""Share of the step between two tones up to which what lies beyond them is blur or the tip of a wedge, no stroke."""
BLOCK = 17
"""Side of the box in which JPEG rings around a step: two of its blocks, pixels ..."""
RINGING = 0.15
"""... and the height of that as a share of the step."""
ABRUPT = 7
"""Side of the box around a border in which there is most of the step ..."""
SHARP = 0.7
"""... namely this share, unless it is the soft edge of a shadow ..."""
SOFT = 0.1
"""... and share of soft borders from which a picture was lit by a lamp."""
SURROUNDED, MUCH = 0.9, 0.5
"""Share of the frame along which the surroundings of a sheet, of a panel, or the paper lies; and how much there is of
the paper, over what there is of the commonest tone."""
BORDER = 3
"""Width of the ink along a border without a stroke, pixels ..."""
BESIDE = 5
"""... side of the box around its pixels in which there must be no stroke ..."""
SPECK = 8
"""... and greatest diagonal of what JPEG leaves of a stroke there, half a block and a half, pixels."""


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
    if not _is_calm(seen):
        return None
    sample = np.ascontiguousarray(seen[::COARSE, ::COARSE])
    paper = _paper(sample)
    frame = _drawn_part(sample, paper)
    if frame is None:
        return None
    part = np.ascontiguousarray(seen[frame])
    smooth = as_gray(cv2.medianBlur(part, SMOOTH))
    areas = _areas(smooth, paper, float(np.hypot(*seen.shape[:2])))
    if areas is None:
        return None
    areas = _without_gaps(areas, smooth, paper)
    largest = int(np.argmax(np.bincount(areas[areas > 0])))
    if not _tones_of(smooth.reshape(areas.size, -1)[areas.ravel() == largest][::SAMPLED]):
        return None  # lit by a lamp
    off, tone = _off(part, smooth, _spread(areas > 0, _parted(areas, smooth)))
    edges = _borders(tone)
    if _are_soft(edges, off > STEP, tone, part) or _is_sheet(areas, edges, off):
        return None
    contrast, borders = np.zeros(seen.shape[:2], np.uint8), np.zeros(seen.shape[:2], np.bool_)
    contrast[frame], borders[frame] = off, edges
    return Tones(contrast, borders)


def _channels(plane: Gray) -> Gray:
    """The largest of the channels."""
    return plane if plane.ndim == 2 else as_gray(cv2.max(cv2.max(plane[..., 0], plane[..., 1]), plane[..., 2]))


def _range(seen: Gray) -> Gray:
    return _channels(as_gray(cv2.morphologyEx(seen, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))))


def _is_calm(seen: Gray) -> bool:
    """Most pixels of some rows are calm."""
    rows = len(seen) // 24 * 24
    strips = seen[:rows].reshape(-1, 24, *seen.shape[1:])[:, 8:13].reshape(-1, *seen.shape[1:]) if rows else seen
    return bool(np.count_nonzero(_range(strips) <= CALM) > DIGITAL * strips.shape[0] * strips.shape[1])


def _paper(sample: Gray) -> list[int]:
    """The level all along the frame, if there is much of it, or else the commonest; or the colour of what has that."""
    gray = sample if sample.ndim == 2 else as_gray(cv2.cvtColor(sample, cv2.COLOR_RGB2GRAY))
    counts = counts_of(gray)
    rim = counts_of(np.concatenate([gray[0], gray[-1], gray[:, 0], gray[:, -1]])[None])
    level, along = int(np.argmax(counts)), int(np.argmax(rim))
    if rim[along] > SURROUNDED * rim.sum() and counts[along] > MUCH * counts[level]:
        level = along
    return [level] if sample.ndim == 2 else np.median(sample[gray == level], axis=0).astype(int).tolist()


def _drawn_part(sample: Gray, paper: list[int]) -> tuple[slice, slice] | None:
    """Rows and columns of all that has not the commonest tone, with a rim; None if nothing of that is wide."""
    other = as_gray(_channels(as_gray(cv2.absdiff(sample, np.full_like(sample, paper)))) >= STEP)
    wide = cv2.erode(other, np.ones((3, 3), np.uint8))
    if np.count_nonzero(wide) < 0.5 * LEAST_AREA * other.size:
        return None
    x, y, w, h = (COARSE * n for n in cv2.boundingRect(other))
    return slice(max(0, y - RIM), y + h + RIM), slice(max(0, x - RIM), x + w + RIM)


def _areas(smooth: Gray, paper: list[int], diagonal: float) -> Ints | None:
    """(h, w) number of the wide flat area that each pixel belongs to, 0 in none; None if they have one tone."""
    flat = as_gray(_range(smooth) <= FLAT)
    core = cv2.erode(flat, square(WIDE * diagonal), borderType=cv2.BORDER_CONSTANT, borderValue=1)
    count, found, stats, _ = cv2.connectedComponentsWithStats(flat, connectivity=4)
    labels = np.asarray(found, np.intp)
    kept = np.zeros(count, np.bool_)
    kept[labels[core > 0]] = True
    kept &= stats[:, cv2.CC_STAT_AREA] > LEAST_AREA * flat.size
    kept[0] = False
    if not _differ(smooth, labels, np.flatnonzero(kept)):
        return None
    kept = _without_strokes(kept, labels, np.asarray(stats, np.intp), smooth, paper, diagonal)
    if not _differ(smooth, labels, np.flatnonzero(kept)):
        return None
    return np.where(kept[labels], labels, 0)


def _without_gaps(areas: Ints, smooth: Gray, paper: list[int]) -> Ints:
    """The areas without what of the paper runs between the others like a pen."""
    own = np.zeros(areas.shape, np.bool_)
    for name in np.unique(areas[areas > 0]).tolist():
        area = areas == name
        if _is_paper(smooth, area, paper):
            own |= area
    return np.where(gaps_between((areas > 0) & ~own, own), 0, areas)


def _parted(areas: Ints, smooth: Gray) -> Gray:
    """The smoothed picture with one tone on each side where an area has several that differ by little."""
    result = smooth
    colours = smooth.reshape(areas.size, -1)
    order = np.argsort(areas.ravel()[::SAMPLED], kind="stable") * SAMPLED
    numbers, starts = np.unique(areas.ravel()[order], return_index=True)
    for number, sample in zip(numbers.tolist(), np.split(order, starts[1:]), strict=True):
        tones = _tones_of(colours[sample]) if number else []
        if len(tones) < 2:
            continue
        where = np.flatnonzero(areas == number)
        own = colours[where].astype(np.int16)
        off = np.stack([np.abs(own - tone).max(axis=1) for tone in tones])
        result = result.copy() if result is smooth else result
        result.reshape(areas.size, -1)[where] = np.array(tones, np.uint8)[off.argmin(axis=0)]
    return result if result is smooth else as_gray(cv2.medianBlur(result, CLEANED))


def _tones_of(colours: Gray) -> list[Ints]:
    """Tones, the commonest first, of which nearly all of (n, 1 or 3) colours are; none where they change gradually."""
    own = colours.astype(np.intp)
    packed = own @ (256 ** np.arange(own.shape[1]))
    _, first, counts = np.unique(packed, return_index=True, return_counts=True)
    found, held = own[first], counts.astype(np.float64)
    tones: list[Ints] = []
    free = np.ones(len(found), np.bool_)
    explained = 0.0
    while free.any():
        tone = found[np.argmax(np.where(free, held, 0.0))]
        off = np.abs(found - tone).max(axis=1)
        part = float(held[free & (off <= EVEN)].sum())
        if part < LEAST_PART * len(own):
            break
        tones.append(tone)
        explained += part
        free &= off >= STEP
    return tones if explained > MOST_EVEN * len(own) else []


def _differ(seen: Gray, labels: Ints, areas: Ints) -> bool:
    """Some areas have tones that differ."""
    tones = np.array([cv2.mean(seen, as_gray(labels == area))[:3] for area in areas.tolist()])
    return len(tones) > 1 and float(np.ptp(tones, axis=0).max()) >= STEP


def _without_strokes(kept: Bools, labels: Ints, stats: Ints, smooth: Gray, paper: list[int], diagonal: float) -> Bools:
    """The areas that are no strokes of a thick pen: narrow or long ones, drawn on one tone or around something.

    paper : the commonest tone, which no stroke has
    """
    shapes = {name: _shape(labels, stats[name].tolist(), name) for name in np.flatnonzero(kept).tolist()}
    narrow = {name for name, shape in shapes.items() if shape.width < NARROW * diagonal}
    long = {name for name, shape in shapes.items() if shape.mean_width < BROAD * diagonal and shape.is_long}
    white = {name for name in narrow | long if _is_paper(smooth, labels == name, paper)}
    doubtful = sorted((narrow | long) - white)
    if not doubtful:
        return kept
    result = kept.copy()
    result[doubtful] = False
    sure = np.flatnonzero(result).tolist()
    if not sure:
        return result
    tone = _spread(result[labels], smooth)
    for name in doubtful:
        drawn = (name in narrow and shapes[name].closed) or _is_plain(tone, labels == name)
        result[name] = not drawn or not all(_differ(smooth, labels, np.array([area, name])) for area in sure)
    return result


@dataclass(frozen=True)
class _Shape:
    """Greatest and mean width of an area and its size, pixels, and whether it is closed around something."""

    width: float
    mean_width: float
    area: float
    closed: bool

    @property
    def is_long(self) -> bool:
        return self.area > LONG * self.mean_width**2


def _shape(labels: Ints, stats: list[int], label: int) -> _Shape:
    x, y, w, h, area = stats
    part = as_gray(labels[y : y + h, x : x + w] == label)
    padded = as_gray(cv2.copyMakeBorder(part, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0))
    width = 2.0 * float(cv2.distanceTransform(padded, cv2.DIST_L2, cv2.DIST_MASK_5).max())
    contours, _ = cv2.findContours(padded, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    outline = sum(cv2.arcLength(contour, True) for contour in contours)
    return _Shape(width, 2.0 * area / outline, area, len(contours) > 1)


def _is_paper(smooth: Gray, part: Bools, paper: list[int]) -> bool:
    tone = np.array(cv2.mean(smooth, part.view(np.uint8))[: len(paper)])
    return float(np.abs(tone - paper).max()) < STEP


def _is_plain(tone: Gray, part: Bools) -> bool:
    """Nearly all of a part lies on one tone, as what is drawn on an area does."""
    own = tone[part].reshape(int(np.count_nonzero(part)), -1).astype(np.int16)
    off = np.abs(own - np.median(own, axis=0)).max(axis=1)
    return bool(np.count_nonzero(off < STEP) > ALL * len(own))


def _spread(seed: Bools, seen: Gray) -> Gray:
    """The picture with the tone of the nearest area all over."""
    _, labels = cv2.distanceTransformWithLabels(
        as_gray(~seed), cv2.DIST_L2, cv2.DIST_MASK_5, labelType=cv2.DIST_LABEL_PIXEL
    )
    where = np.flatnonzero(seed)
    index = np.zeros(int(labels.max()) + 1, np.intp)
    index[labels.ravel()[where]] = where
    return as_gray(seen.reshape(seed.size, -1)[index[labels.ravel()]].reshape(seen.shape))


def _borders(tone: Gray) -> Bools:
    """(h, w) pixels with another tone to the right or below."""
    border = np.zeros(tone.shape[:2], np.bool_)
    for a, b in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
        border[a] |= _channels(as_gray(cv2.absdiff(tone[a], tone[b]))) >= BORDER_STEP
    return border


def _are_soft(edges: Bools, strokes: Bools, tone: Gray, seen: Gray) -> bool:
    """Much of the borders has neither a stroke nor a step but a slope: the edge of a shadow."""
    steps = _channels(_contrast_within(tone, SMOOTH))[edges].astype(np.float32)
    seen_steps = _channels(_contrast_within(seen, ABRUPT))[edges]
    return bool(np.count_nonzero((seen_steps < SHARP * steps) & ~strokes[edges]) > SOFT * len(steps))


def _is_sheet(areas: Ints, edges: Bools, off: Gray) -> bool:
    """One area holds all the others but the one around it, and no stroke or border ends at its outline."""
    rim = np.concatenate([areas[0], areas[-1], areas[:, 0], areas[:, -1]])
    around = int(np.argmax(np.bincount(rim[rim > 0], minlength=2)))
    within = as_gray((areas > 0) & (areas != around))
    if np.count_nonzero(rim == around) < SURROUNDED * len(rim) or not within.any():
        return False
    contours, _ = cv2.findContours(within, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    outline = max(contours, key=cv2.contourArea)
    sheet = cv2.drawContours(np.zeros_like(within), [outline], -1, 1, cv2.FILLED)
    inner, deeper = (cv2.erode(sheet, np.ones((side, side), np.uint8)) for side in (REACH, 3 * REACH))
    ring = (inner > 0) & (deeper == 0)
    outer = cv2.dilate(sheet, np.ones((REACH, REACH), np.uint8)) == 0
    drawn = (off > STEP) | edges
    drawn_within = np.count_nonzero(drawn & (inner > 0))
    return bool(drawn_within > 0 and not drawn[ring].any() and np.count_nonzero(drawn & outer) < drawn_within)


def _off(seen: Gray, smooth: Gray, tone: Gray) -> tuple[Gray, Gray]:
    """How far each pixel is from the tone of its area; near others from all mixtures of both, less their ringing.

    tone    : of the nearest area
    returns : that, and the tone with each pixel near a border on the side that its colour is closer to
    """
    off = _channels(as_gray(cv2.absdiff(seen, tone)))
    ringing = _channels(_contrast_within(tone, BLOCK))
    off[off < as_gray(cv2.convertScaleAbs(ringing, alpha=RINGING))] = 0
    box = np.ones((REACH, REACH), np.uint8)
    low, high = as_gray(cv2.erode(tone, box)), as_gray(cv2.dilate(tone, box))
    near = _channels(as_gray(cv2.subtract(high, low))) >= BORDER_STEP
    count = int(np.count_nonzero(near))
    if count == 0:
        return off, tone
    colour, even, own, least, most = (
        p[near].reshape(count, -1).astype(np.float32) for p in (seen, smooth, tone, low, high)
    )
    step = np.where(most - own > own - least, most - own, least - own)  # to the other tone
    length = (step * step).sum(axis=1)
    share = ((colour - own) * step).sum(axis=1) / length
    mixed = own + np.clip(share, 0.0, 1.0)[:, None] * step
    beyond = np.abs(colour - mixed).max(axis=1)
    off[near] = np.where(beyond < FAINTER * np.abs(step).max(axis=1), 0.0, beyond).astype(np.uint8)
    other = ((even - own) * step).sum(axis=1) > 0.5 * length
    sided = tone.copy()
    sided[near] = (own + other[:, None] * step).astype(np.uint8).reshape(sided[near].shape)
    return off, as_gray(cv2.medianBlur(sided, SMOOTH))


def _contrast_within(tone: Gray, side: int) -> Gray:
    """Difference between the highest and the lowest tone in a box around each pixel."""
    return as_gray(cv2.morphologyEx(tone, cv2.MORPH_GRADIENT, np.ones((side, side), np.uint8)))


def with_borders(drawn: Bools, borders: Bools) -> Bools:
    """The strokes, and the borders that no stroke follows.

    drawn   : (h, w) ink of strokes
    borders : (h, w) see `Tones`
    """
    beside = _grown(borders, REACH)
    pieces = connected_pieces(drawn.view(np.uint8))
    specks = pieces.extent < SPECK
    specks[0] = False
    if specks.any():
        at_border = np.zeros(len(specks), np.bool_)
        at_border[pieces.piece[beside.ravel()[pieces.where]]] = True
        drawn = pieces.only(~(specks & at_border))
    free = borders & ~_grown(drawn, BESIDE)
    free = borders & _grown(free, BESIDE + 4)  # up to the middle of the stroke that it ends at
    return drawn | _grown(free, BORDER)


def _grown(mask: Bools, side: int) -> Bools:
    return np.asarray(cv2.dilate(mask.view(np.uint8), np.ones((side, side), np.uint8)) > 0, np.bool_)
