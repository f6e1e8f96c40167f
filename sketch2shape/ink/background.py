"""Ground: working size, and how far every pixel stands off the paper towards ink.

Ink is darker than a light ground and lighter than a dark one; which of the two is decided by what is thin. On an
even ground the reference is one colour per channel. On an uneven one (photo, shadow, grey scan) it is the picture
itself with everything narrow closed away, as in the division of a document by its background.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.ink.histogram import counts_of
from sketch2shape.ink.noise import noise_of
from sketch2shape.ink.resampling import averaged, halved
from sketch2shape.ink.tones import read_tones
from sketch2shape.model import Bools, Floats, Gray, as_gray

LONG_SIDE = 1100
"""Long side of the working size for large pictures, pixels."""
SMALL_SIDE = 300
"""Pictures with a shorter long side are enlarged so that junctions separate."""
CLEAN = 0.6
"""Share of the pixels that have exactly the level of the margin, from which there is no noise."""
SURFACE_SIDE = 512
"""Greatest long side of the map of the paper's colours, pixels."""
MAP_SIDE = 128
"""Long side of the map on which a table, a shadow or a page is looked for, pixels."""
TABLE = 0.08
"""Share of the picture, and of its rim, from which another level is a table or a shadow, no face and no scan's edge."""
PAGE = 0.35
"""Share of the picture from which a quadrilateral is a page, no face."""
FEW_LEVELS = 12
"""A picture nine tenths of which have fewer grey levels than this was not lit by a lamp."""
COLOUR_SHARE = 0.6
"""Weight of the channel with the most contrast against that of the luminance: pale coloured ink still counts."""


@dataclass(frozen=True)
class Ground:
    """The picture against its paper.

    contrast : (h, w) uint8, at working size, 0 on the paper, 255 for the strongest possible ink
    paper    : (height, width, 3) uint8, colours of the ground without ink, reduced, or None where the ground is even
    clean    : without noise and grain: most pixels have exactly the colour of the ground
    noise    : standard deviation of `contrast` on the paper
    scale    : working pixels per picture pixel
    borders  : (h, w) bool, where flat areas of different tones meet, or None where there is one tone; see `Tones`
    """

    contrast: Gray
    paper: Gray | None
    clean: bool
    noise: float
    scale: float
    borders: Bools | None = None


def read_ground(pixels: Gray) -> Ground:
    """Bring (h, w, 3) RGB pixels to working size and measure their contrast against the paper."""
    coloured = _is_coloured(pixels)
    seen, scale = at_working_size(pixels if coloured else _gray(pixels))
    tones = read_tones(seen)
    if tones is not None:
        return Ground(tones.contrast, None, True, 0.0, scale, tones.borders)
    gray = _gray(seen) if coloured else seen
    ground = _frame_level(gray)
    levels = counts_of(gray[::4])
    clean = bool(levels[ground] > CLEAN * levels.sum())
    even = _is_even(levels if clean else counts_of(_without_noise(gray)), ground)
    even = even and (clean or not _lies_on_table(gray, ground))
    dark = _is_dark(gray, levels, ground, even)
    beyond = levels[: max(0, ground - 24)] if dark else levels[ground + 25 :]
    even = even and bool(beyond.sum() < 0.2 * levels.sum())  # else the frame shows the table, and the page lies on it
    planes = [as_gray(p) for p in (gray, *cv2.split(seen))] if coloured else [gray]
    if dark:
        planes = [as_gray(cv2.bitwise_not(p)) for p in planes]
    papers = [] if even else [_uneven_paper(p) for p in planes]
    if even:
        margins = [255 - ground if dark else ground, *map(_frame_level, planes[1:])]
        contrasts = list(map(_even_contrast, planes, margins))
    else:
        contrasts = list(map(_contrast, planes, papers))
    contrast = contrasts[0]
    if len(contrasts) > 1:
        strongest = np.max(np.stack(contrasts[1:]), axis=0)
        contrast = np.maximum(contrast, as_gray(cv2.convertScaleAbs(strongest, alpha=COLOUR_SHARE)))
    if not even:
        contrast = np.minimum(_levelled(contrast), _thin_contrast(planes[0]))
    noise = 0.0 if clean and even else noise_of(contrast)
    if noise > 3.0:
        contrast, noise = as_gray(cv2.GaussianBlur(contrast, (3, 3), 0)), 0.4 * noise
    return Ground(contrast, None if even else _coloured_paper(pixels, dark), clean and even, noise, scale)


def at_working_size(pixels: Gray) -> tuple[Gray, float]:
    """(h, w) or (h, w, 3) pixels -> the same at working size, and working pixels per picture pixel.

    Large pictures are averaged over areas so that hairlines pale instead of breaking; small ones are interpolated.
    """
    scale = 1.0
    while max(pixels.shape[:2]) > 2 * LONG_SIDE:
        pixels, scale = halved(pixels), 0.5 * scale
    h, w = pixels.shape[:2]
    side = max(h, w)
    if SMALL_SIDE <= side <= LONG_SIDE:
        return pixels, scale
    factor = LONG_SIDE / side if side > LONG_SIDE else (3.0 if 2 * side < SMALL_SIDE else 2.0)
    size = (max(1, round(w * factor)), max(1, round(h * factor)))
    method = cv2.INTER_AREA if factor < 1 else cv2.INTER_CUBIC
    return as_gray(cv2.resize(pixels, size, interpolation=method)), scale * factor


def _gray(pixels: Gray) -> Gray:
    return as_gray(cv2.cvtColor(pixels, cv2.COLOR_RGB2GRAY))


def _reduced(gray: Gray, factor: float) -> Gray:
    h, w = gray.shape[:2]
    return averaged(gray, (max(1, round(w * factor)), max(1, round(h * factor))))


def _without_noise(gray: Gray) -> Gray:
    return _reduced(gray, 0.5 if noise_of(gray) < 6.0 else 0.25)


def _is_even(levels: Floats, ground: int) -> bool:
    """The ground is one narrow peak, or very few levels hold all: flat fills."""
    fullest = np.cumsum(np.sort(levels)[::-1])
    peak = levels[max(0, ground - 6) : ground + 7].sum()
    hump = levels[max(0, ground - 24) : ground + 25].sum()
    narrow = peak > 0.85 * hump and peak > 0.3 * fullest[-1]
    return bool(narrow or np.searchsorted(fullest, 0.9 * fullest[-1]) < FEW_LEVELS)


def _lies_on_table(gray: Gray, ground: int) -> bool:
    """Something wide has another level: a table or a shadow that runs into the frame, or a page amidst a table."""
    step = max(1, max(gray.shape) // (2 * MAP_SIDE))
    sample = np.ascontiguousarray(gray[::step, ::step])
    coarse = _reduced(sample, min(1.0, MAP_SIDE / max(sample.shape)))
    other = as_gray(cv2.threshold(cv2.absdiff(coarse, np.full_like(coarse, ground)), 24, 1, cv2.THRESH_BINARY)[1])
    wide = as_gray(cv2.morphologyEx(other, cv2.MORPH_OPEN, np.ones((5, 5), np.uint8)))
    _, labels = cv2.connectedComponents(wide, connectivity=4)
    area = np.bincount(labels.ravel()) / wide.size
    rim = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
    along = np.bincount(rim, minlength=len(area)) / len(rim)
    area[0] = 0.0
    if np.any((area > TABLE) & (along > TABLE)):
        return True
    largest = int(np.argmax(area))
    return bool(area[largest] > PAGE and _corners_of(as_gray(labels == largest)) == 4)


def _corners_of(region: Gray) -> int:
    """Number of corners of the convex hull of a region; 0 if it does not fill its hull."""
    contours, _ = cv2.findContours(region, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    hull = cv2.convexHull(np.concatenate(contours))
    if cv2.contourArea(hull) > 1.1 * sum(cv2.contourArea(c) for c in contours):
        return 0
    return len(cv2.approxPolyDP(hull, 0.03 * cv2.arcLength(hull, True), True))


def _frame_level(gray: Gray) -> int:
    """Commonest level of the picture's margin (from a 25th to a 10th of each side), where the drawing seldom is.

    The outermost strip does not count: it may be a scan's black edge, or a stroke along the frame.
    """
    h, w = gray.shape
    inner = gray[h // 25 : h - h // 25, w // 25 : w - w // 25]
    h, w = inner.shape
    y, x = max(1, h // 15), max(1, w // 15)
    parts = (inner[:y], inner[-y:], inner[y:-y, :x], inner[y:-y, -x:])
    margin = np.concatenate([p.ravel() for p in parts])
    counts = counts_of(margin)
    middle = int(np.argmax(np.convolve(counts, np.ones(5), mode="same")))
    low = max(0, middle - 2)
    return low + int(np.argmax(counts[low : middle + 3]))


def _is_coloured(pixels: Gray) -> bool:
    """Some pixels are clearly not grey; a sample of them is looked at."""
    h, w = pixels.shape[:2]
    red, green, blue = cv2.split(pixels[:: max(2, h // 240), :: max(1, w // LONG_SIDE)])
    tint = cv2.max(cv2.absdiff(red, green), cv2.absdiff(green, blue))
    return bool(cv2.countNonZero(cv2.threshold(tint, 50, 1, cv2.THRESH_BINARY)[1]) > 0.0005 * tint.size)


def _is_dark(gray: Gray, levels: Floats, ground: int, even: bool) -> bool:
    """Light ink on a dark ground: by what is thin, or else by the side of the ground on which the rest lies."""
    dark, light = levels[: max(0, ground - 24)].sum(), levels[ground + 25 :].sum()
    if dark == light == 0:
        return ground < 128
    if even and min(dark, light) < 0.003 * max(dark, light):
        return bool(light > dark)
    half = _reduced(gray, 0.5)
    box = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
    hats = [cv2.morphologyEx(half, hat, box) for hat in (cv2.MORPH_TOPHAT, cv2.MORPH_BLACKHAT)]
    # fourth powers: few pixels are stroke, all are grain
    light_thin, dark_thin = (cv2.norm(cv2.multiply(h, h, dtype=cv2.CV_32F), cv2.NORM_L2SQR) for h in hats)
    if max(light_thin, dark_thin) > 2.0 * min(light_thin, dark_thin):
        return bool(light_thin > dark_thin)
    return bool(light > dark)


def _even_contrast(plane: Gray, level: int) -> Gray:
    """1 - plane / level of the margin in 255ths, by a table."""
    level = max(level, 1)
    if level == 255:
        return as_gray(cv2.bitwise_not(plane))
    levels = np.arange(256, dtype=np.uint8)
    return as_gray(cv2.LUT(plane, _contrast(levels, np.full_like(levels, level))))


def _uneven_paper(plane: Gray) -> Gray:
    """The plane at half size with all dark things narrower than about a twentieth of the picture closed away.

    The border is continued outwards, else a strip of table along it would count as a stroke.
    """
    return _closed(_reduced(plane, 0.5))


def _coloured_paper(pixels: Gray, dark: bool) -> Gray:
    """The same for all colours, at the size at which surfaces are told apart."""
    while max(pixels.shape[:2]) > SURFACE_SIDE:
        pixels = halved(pixels)
    return _closed(as_gray(cv2.bitwise_not(pixels)) if dark else pixels)


def _closed(half: Gray) -> Gray:
    size = 2 * (max(half.shape[:2]) // 48) + 3
    wide = cv2.copyMakeBorder(half, size, size, size, size, cv2.BORDER_REPLICATE)
    closed = cv2.morphologyEx(wide, cv2.MORPH_CLOSE, np.ones((size, size), np.uint8))
    return as_gray(cv2.blur(closed, (5, 5))[size:-size, size:-size])


def _contrast(plane: Gray, paper: Gray) -> Gray:
    """1 - plane / paper in 255ths, with the paper enlarged where it comes at half size."""
    if paper.shape != plane.shape:
        paper = as_gray(cv2.resize(paper, plane.shape[::-1], interpolation=cv2.INTER_LINEAR))
    return as_gray(cv2.bitwise_not(as_gray(cv2.divide(plane, paper, scale=255.0))))


def _thin_contrast(plane: Gray) -> Gray:
    """Contrast against what a small closing leaves: high on strokes, nothing beside the sharp edge of a shadow."""
    smooth = as_gray(cv2.GaussianBlur(plane, (3, 3), 0))
    side = 2 * (max(plane.shape) // 80) + 1
    return _contrast(smooth, as_gray(cv2.morphologyEx(smooth, cv2.MORPH_CLOSE, np.ones((side, side), np.uint8))))


def _levelled(contrast: Gray) -> Gray:
    """Less the local median: what closing the noise away has added, more of it where the light is poor."""
    h, w = contrast.shape
    sample = cv2.resize(contrast, (max(1, w // 8), max(1, h // 8)), interpolation=cv2.INTER_NEAREST)
    bias = cv2.resize(cv2.blur(cv2.medianBlur(sample, 11), (5, 5)), (w, h), interpolation=cv2.INTER_LINEAR)
    return as_gray(cv2.subtract(contrast, bias))
