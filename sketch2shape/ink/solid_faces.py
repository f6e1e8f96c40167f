"""Solid faces: areas as dark as the lines around them, among strokes as wide as faces are elsewhere, hollowed out.

In an icon one face of a cube may be filled with the colour of its edges. What lies deeper in the ink than a stroke is
wide is the inside of such a face; what is left around it is its outline, drawn with the same pen.
"""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.ink.depth import depth_of
from sketch2shape.model import Bools

LEAST_DEPTH = 0.015
"""Fraction of the picture's diagonal by which a face lies deeper than a stroke is wide: less is a filled corner."""


def without_solid_faces(mask: Bools, pen_width: float, diagonal: float) -> Bools:
    """Ink (h, w) with the insides of solid faces left out.

    pen_width, diagonal : of the lines and of the picture, pixels
    """
    depth = depth_of(mask)
    if float(depth.max()) <= pen_width + LEAST_DEPTH * diagonal:
        return mask
    inside = depth > pen_width
    count, label = cv2.connectedComponents(inside.view(np.uint8), connectivity=4)
    face = np.zeros(count, np.bool_)
    face[label[depth > pen_width + LEAST_DEPTH * diagonal]] = True
    return np.asarray(mask & ~face[label])
