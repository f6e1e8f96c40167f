"""Ink: the pixels of a picture that were drawn.

The picture is brought to working size, divided by its background (uneven light, coloured paper, shadow), and a pixel
is ink where it is at least half as dark as the darkest ink close by and clearly darker than the noise of the paper.
Half of the local peak puts the border of a stroke where its anti-aliased or blurred flank is half way down, for faint
and for strong strokes alike.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Ink, Picture

Gray = NDArray[np.uint8]

LONG_SIDE = 1100
"""Long side of the working size for large pictures, pixels."""
SMALL_SIDE = 300
"""Pictures with a shorter long side are enlarged so that junctions separate."""


def find_ink(picture: Picture) -> Ink:
    """Find the ink of a drawing on any ground, light or dark.

    picture : (h, w, 3) uint8 RGB
    returns : `Ink` at working size; an empty mask where nothing was drawn
    """
    gray, scale = working_gray(picture.pixels)
    contrast = contrast_of(gray)
    mask = ink_mask(contrast)
    peak = float(np.percentile(contrast[mask], 90)) if mask.any() else 255.0
    strength = np.minimum(contrast.astype(np.float32) / max(peak, 1.0), 1.0)
    return Ink(mask=mask, strength=strength, pen_width=pen_width_of(mask), scale=scale)


def working_gray(pixels: NDArray[np.uint8]) -> tuple[Gray, float]:
    """(h, w, 3) RGB -> gray at working size, and working pixels per picture pixel."""
    gray: Gray = np.asarray(cv2.cvtColor(pixels, cv2.COLOR_RGB2GRAY), dtype=np.uint8)
    side = max(gray.shape)
    if side > LONG_SIDE:
        scale = LONG_SIDE / side
        return _resized(gray, scale, cv2.INTER_AREA), scale
    if side < SMALL_SIDE:
        scale = 3.0 if side < SMALL_SIDE // 2 else 2.0
        return _resized(gray, scale, cv2.INTER_CUBIC), scale
    return gray, 1.0


def _resized(gray: Gray, scale: float, interpolation: int) -> Gray:
    size = (max(1, round(gray.shape[1] * scale)), max(1, round(gray.shape[0] * scale)))
    return np.asarray(cv2.resize(gray, size, interpolation=interpolation), dtype=np.uint8)


def contrast_of(gray: Gray) -> Gray:
    """How far each pixel stands off its background towards ink: 0 ground, 255 the strongest possible."""
    level = int(np.argmax(np.bincount(gray.ravel(), minlength=256)))
    darker, lighter = np.count_nonzero(gray < level - 40), np.count_nonzero(gray > level + 40)
    if level < 128 and lighter > darker:
        gray = np.asarray(cv2.bitwise_not(gray), dtype=np.uint8)
        level = 255 - level
    spread = np.count_nonzero(cv2.absdiff(gray, np.full_like(gray, level)) <= 3) / gray.size
    background = np.full_like(gray, level) if spread > 0.8 else paper_of(gray)
    ratio = cv2.divide(gray, background, scale=255.0)
    return np.asarray(cv2.bitwise_not(ratio), dtype=np.uint8)


def paper_of(gray: Gray) -> Gray:
    """The ground without the drawing: strokes closed away on a reduced copy, then smoothed; same shape as `gray`."""
    h, w = gray.shape
    factor = max(1.0, max(h, w) / 256.0)
    small = cv2.resize(gray, (max(1, round(w / factor)), max(1, round(h / factor))), interpolation=cv2.INTER_AREA)
    small = cv2.morphologyEx(small, cv2.MORPH_CLOSE, cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (13, 13)))
    small = cv2.medianBlur(small, 13)
    return np.asarray(cv2.resize(small, (w, h), interpolation=cv2.INTER_LINEAR), dtype=np.uint8)


def ink_mask(contrast: Gray) -> NDArray[np.bool_]:
    """Ink: at least half of the local peak of `contrast`, which must stand clear of the noise."""
    noise = 1.4826 * float(np.median(contrast))
    floor = max(14.0, 6.0 * noise)
    peak = cv2.dilate(contrast, cv2.getStructuringElement(cv2.MORPH_RECT, (9, 9)))
    near = np.maximum(np.asarray(peak, dtype=np.uint8) // 2, int(floor))
    return np.asarray(contrast > near, dtype=np.bool_)


def pen_width_of(mask: NDArray[np.bool_]) -> float:
    """Typical stroke width, working pixels: median over the ridge of the distance transform; 1 without ink."""
    if not mask.any():
        return 1.0
    padded = np.pad(mask.astype(np.uint8), 1)
    distance = cv2.distanceTransform(padded, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    ridge = (distance >= cv2.dilate(distance, np.ones((3, 3), np.uint8))) & (padded > 0)
    return max(1.0, 2.0 * float(np.median(distance[ridge])) - 0.7)
