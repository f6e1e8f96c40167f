"""Sizes: planes made smaller by averaging over areas, so that hairlines pale instead of breaking."""

from __future__ import annotations

import cv2

from sketch2shape.model import Gray, as_gray


def halved(plane: Gray) -> Gray:
    """(h, w) or (h, w, 3) at half the size, without the last row or column of an odd number.

    Ten times as fast as averaging over parts of pixels.
    """
    h, w = (max(1, n // 2) for n in plane.shape[:2])
    return as_gray(cv2.resize(plane[: 2 * h, : 2 * w], (w, h), interpolation=cv2.INTER_AREA))


def averaged(plane: Gray, size: tuple[int, int]) -> Gray:
    """(h, w) or (h, w, 3) at a smaller size, given as width and height."""
    while plane.shape[1] >= 2 * size[0] and plane.shape[0] >= 2 * size[1]:
        plane = halved(plane)
    return plane if plane.shape[1::-1] == size else as_gray(cv2.resize(plane, size, interpolation=cv2.INTER_AREA))
