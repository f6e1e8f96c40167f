"""Blots: where lines of a thick pen run into one, or a hand went over a corner again.

The skeleton of a blot says nothing of where lines run in it, only that there are some: whatever runs through it is on
ink, and explains it.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.ink import depth_of
from sketch2shape.model import Ink

THICK = 60.0
"""Size of a drawing in pens up to which the pen is thick: with a finer one, blots are the heads of arrows and dots."""
DEEP, DEEP_PENS = 1.0, 0.65
"""Pixels, and pens more, from its border at which ink is a blot: in a line it is half a pen, where two cross at a right
angle 0.71."""


def blots_of(ink: Ink) -> NDArray[np.float32] | None:
    """(h, w), how far a line of the pen may run beside the middle of a blot, pixels; 0 elsewhere. None without any."""
    _, _, width, height = cv2.boundingRect(np.ascontiguousarray(ink.mask).view(np.uint8))
    if np.hypot(width, height) > THICK * ink.pen_width:
        return None
    depth = depth_of(ink.mask)
    blot = depth > DEEP + DEEP_PENS * ink.pen_width
    return np.where(blot, depth - 0.5 * ink.pen_width, 0.0).astype(np.float32) if blot.any() else None
