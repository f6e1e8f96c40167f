"""Gaps: the paper between the faces of an icon, where it stands for its lines."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.ink.kernels import square
from sketch2shape.model import Bools, as_gray

WIDEST = 0.06
"""Width of a gap at most, as a share of the diagonal of all faces: wide ones of icons are 0.044."""
ENDS = 2
"""Ends at which a gap runs out of the object, at least: a notch has one."""


def gaps_between(faces: Bools, paper: Bools) -> Bools:
    """What of the paper runs between faces, like a pen.

    faces : (h, w) bool, areas of other tones than the paper's
    paper : (h, w) bool, those of its own
    """
    _, _, width, height = cv2.boundingRect(as_gray(faces))
    box = square(WIDEST * float(np.hypot(width, height)))
    wide = as_gray(cv2.morphologyEx(as_gray(paper), cv2.MORPH_OPEN, box, borderType=cv2.BORDER_CONSTANT, borderValue=1))
    count, part = cv2.connectedComponents(as_gray(paper & (wide == 0)), connectivity=4)
    gaps = np.zeros(paper.shape, np.bool_)
    for name in range(1, count):
        one = part == name
        beside = cv2.dilate(as_gray(one), np.ones((3, 3), np.uint8)) > 0
        ends, _ = cv2.connectedComponents(as_gray(beside & (wide > 0)))
        if ends > ENDS:  # what lies between them is counted too
            gaps |= one
    return gaps
