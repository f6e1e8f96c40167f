"""Eroded: the front face of a prism from what its whole drawing covers.

A prism covers the Minkowski sum of its front face and the segment to the back face. Eroded by that segment, which is
mathematical morphology (J. Serra, "Image Analysis and Mathematical Morphology", 1982), it is the front face again, but
for notches narrower than the prism is deep. Of a round hole what is seen through both rims is left; dilated by the
segment it is the hole. Lines need not be told apart for that, so thin plates, whose lines run into each other, have it.
"""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import Floats, Gray, as_gray
from sketch2shape.sweeps.insides import ROOM
from sketch2shape.sweeps.loops import border


def eroded_outline(lines: Gray, shift: Floats) -> Floats | None:
    """(k, 2) the border of the front face of a prism that is drawn alone, or None if nothing is left.

    lines : (h, w), not 0 on the thinned lines
    shift : (2,) to its back face, pixels
    """
    roomy = cv2.copyMakeBorder(lines, ROOM, ROOM, ROOM, ROOM, cv2.BORDER_CONSTANT)
    _, labels = cv2.connectedComponents(as_gray((roomy == 0).astype(np.uint8)), connectivity=4)
    front = _along(as_gray((labels != labels[0, 0]).astype(np.uint8)), shift)
    return border(front) - ROOM if front.any() else None


def _along(region: Gray, shift: Floats) -> Gray:
    """The pixels from which a segment lies inside a region: what that holds for a part of it is moved by as much."""
    steps = max(int(np.ceil(np.abs(shift).max())), 1)
    done, kept = 0, region
    while done < steps:
        more = min(max(done, 1), steps - done)
        by = np.rint(shift * (done + more) / steps) - np.rint(shift * done / steps)
        moved = np.array([[1, 0, -by[0]], [0, 1, -by[1]]], np.float32)
        h, w = region.shape
        kept = as_gray(cv2.bitwise_and(kept, cv2.warpAffine(kept, moved, (w, h), flags=cv2.INTER_NEAREST)))
        done += more
    return kept
