"""Grain: what rough paper, pencil and chalk do to strokes.

A hairline drawn over the grain of paper is pale in places and falls into bits, which would pass for dashes; a thick
stroke of chalk has a ragged border, at whose every burr its skeleton would branch. Both are put right here.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink.components import connected_pieces
from sketch2shape.ink.pen_width import FINE, outline_length, rough_pen_width
from sketch2shape.model import Bools, Gray, as_gray

ALONG = 7
"""Pixels along which the contrast of a hairline is averaged ..."""
WEAK = 0.2
"""... and share of the strongest contrast close by that its weakest place has: the gap of a dotted line has less."""
THICK = 3.0
"""Pen width, pixels, from which strokes can have burrs ..."""
BURR = 0.25
"""... and the size of these as a part of it."""
RAGGED = 1.08
"""Length of the outline over that of a smoothed one, from which strokes have burrs."""


def with_weak_places(drawn: Bools, contrast: Gray, floor: float) -> Bools:
    """The ink of hairlines, complete where grain leaves little of them: some ink, and much along a short line.

    drawn    : (h, w) ink
    contrast : (h, w) uint8, see `Ground`
    floor    : contrast below which nothing is ink
    returns  : (h, w); the same array where the pen is no fine one

    Means along a line even out what varies along a stroke and stay steep across it. What does not make strokes with the
    rest, such as the surroundings of a dot, stays out.
    """
    if rough_pen_width(drawn) >= FINE:
        return drawn
    both = drawn | _weak_places(contrast, floor)
    pieces = connected_pieces(both.view(np.uint8))
    return drawn | pieces.only(pieces.extent > 2 * ALONG)


def _weak_places(contrast: Gray, floor: float) -> Bools:
    means = np.zeros_like(contrast)
    for turn in range(8):
        means = np.maximum(means, as_gray(cv2.filter2D(contrast, cv2.CV_8U, _short_line(turn * np.pi / 8))))
    box = np.ones((5, 5), np.uint8)
    least = as_gray(cv2.convertScaleAbs(cv2.dilate(contrast, box), alpha=WEAK))
    along = as_gray(cv2.convertScaleAbs(cv2.dilate(means, box), alpha=0.5))
    return np.asarray((contrast > least) & (means > along) & (np.minimum(contrast, means) > int(floor)), dtype=np.bool_)


def _short_line(angle: float) -> NDArray[np.float32]:
    """Kernel that averages along a line through its middle."""
    kernel = np.zeros((ALONG, ALONG), np.float32)
    steps = np.linspace(-0.5, 0.5, 4 * ALONG) * (ALONG - 1)
    middle = (ALONG - 1) / 2
    rows, columns = (np.rint(middle + steps * part).astype(int) for part in (np.sin(angle), np.cos(angle)))
    kernel[rows, columns] = 1.0
    return kernel / np.float32(kernel.sum())


def without_burrs(drawn: Bools, pen_width: float) -> Bools:
    """The ink of thick strokes with smooth borders, and finer lines as they are.

    drawn   : (h, w) ink
    returns : (h, w); the same array where strokes are fine or smooth already
    """
    if pen_width < THICK:
        return drawn
    ink = drawn.view(np.uint8)
    even = np.asarray(cv2.GaussianBlur(ink * np.uint8(255), (0, 0), BURR * pen_width) > 127, dtype=np.bool_)
    if outline_length(drawn) < RAGGED * outline_length(even):
        return drawn
    side = 2 * round(0.5 * pen_width) + 1
    fine = drawn & (cv2.dilate(even.view(np.uint8), np.ones((side, side), np.uint8)) == 0)
    if fine.any():
        even |= drawn & (cv2.dilate(fine.view(np.uint8), np.ones((side + 2, side + 2), np.uint8)) > 0)
    return even
