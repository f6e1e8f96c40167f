"""Pen: the width of the strokes."""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.model import Bools


def pen_width_of(mask: Bools) -> float:
    """Typical stroke width, pixels: median over the ridge of the distance transform; 1 without ink."""
    if not mask.any():
        return 1.0
    padded = np.pad(mask.astype(np.uint8), 1)
    distance = cv2.distanceTransform(padded, cv2.DIST_L2, cv2.DIST_MASK_5)
    ridge = (distance >= cv2.dilate(distance, np.ones((3, 3), np.uint8))) & (padded > 0)
    return max(1.0, 2.0 * float(np.median(distance[ridge])) - 0.7)
