"""Gaps: the paper between the faces of an icon, where it stands for its lines."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.ink.kernels import square
from sketch2shape.model import Bools, as_gray

WIDEST = 0.06
"""Width of a gap at most, as a share of the diagonal of all faces: wider ones are notches and ways between things."""
ENDS = 2
"""Ends at which a gap runs out of the object, at least: a notch has one."""
BESIDE, MOSTLY = 15, 0.8
"""Side of the box, pixels, in which a face lies beside a gap, and part of its rim along which one does, at least: what
runs between a face and a line, or the frame, has one along a half."""


def gaps_between(faces: Bools, paper: Bools) -> Bools:
    """What of the paper runs between faces, like a pen.

    faces : (h, w) bool, areas of other tones than the paper's
    paper : (h, w) bool, those of its own
    returns : (h, w) bool
    """
    _, _, width, height = cv2.boundingRect(as_gray(faces))
    box = square(WIDEST * float(np.hypot(width, height)))
    wide = as_gray(cv2.morphologyEx(as_gray(paper), cv2.MORPH_OPEN, box, borderType=cv2.BORDER_CONSTANT, borderValue=1))
    narrow = as_gray(cv2.copyMakeBorder(as_gray(paper & (wide == 0)), 1, 1, 1, 1, cv2.BORDER_CONSTANT))
    near = cv2.dilate(as_gray(cv2.copyMakeBorder(as_gray(faces), 1, 1, 1, 1, cv2.BORDER_CONSTANT)), square(BESIDE))
    room = as_gray(cv2.copyMakeBorder(wide, 1, 1, 1, 1, cv2.BORDER_CONSTANT))
    _, part, stats, _ = cv2.connectedComponentsWithStats(narrow, connectivity=4)
    gaps = np.zeros(narrow.shape, np.bool_)
    for name, (x, y, w, h, _) in enumerate(stats.tolist()):
        if name == 0 or np.hypot(w, h) < len(box):
            continue
        around = np.s_[y - 1 : y + h + 1, x - 1 : x + w + 1]
        one = part[around] == name
        beside = cv2.dilate(as_gray(one), np.ones((3, 3), np.uint8)) > 0
        open_end = beside & (room[around] > 0)
        rim = beside & ~one & ~open_end
        ends, _ = cv2.connectedComponents(as_gray(open_end))
        # what lies between the ends is counted too
        if ends > ENDS and np.count_nonzero(near[around][rim]) > MOSTLY * np.count_nonzero(rim):
            gaps[around] |= one
    return gaps[1:-1, 1:-1]
