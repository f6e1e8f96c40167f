"""Depth: how far within the ink a place lies."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools


def depth_of(mask: Bools) -> NDArray[np.float32]:
    """(h, w), distance of every pixel to the nearest that is no ink, pixels; there is none beyond the border."""
    within = cv2.copyMakeBorder(mask.view(np.uint8), 1, 1, 1, 1, cv2.BORDER_CONSTANT)
    return np.asarray(cv2.distanceTransform(within, cv2.DIST_L2, cv2.DIST_MASK_5), np.float32)[1:-1, 1:-1]
