"""The data that flows between the stages: small frozen dataclasses of NumPy arrays.

Units: image coordinates are pixels of the picture as a viewer sees it, x to the right, y down, the centre of the
first pixel at (0, 0). Solid coordinates are right-handed: x right, y down, z away from the viewer.
"""

from __future__ import annotations

from sketch2shape.model.answer import Answer
from sketch2shape.model.arrays import Bools, Floats, Gray, Ints, as_gray
from sketch2shape.model.drawing import FacePair, Lines, TwoFaceObject, ring_edges
from sketch2shape.model.picture import Ink, Picture, to_picture, to_working
from sketch2shape.model.solid import Projection, Solid

__all__ = [
    "Answer",
    "Bools",
    "FacePair",
    "Floats",
    "Gray",
    "Ink",
    "Ints",
    "Lines",
    "Picture",
    "Projection",
    "Solid",
    "TwoFaceObject",
    "as_gray",
    "ring_edges",
    "to_picture",
    "to_working",
]
