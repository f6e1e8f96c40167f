"""The data that flows between the stages: small frozen dataclasses of NumPy arrays.

Units: image coordinates are pixels of the picture as a viewer sees it, x to the right, y down, the centre of the
first pixel at (0, 0). Solid coordinates are right-handed: x right, y down, z away from the viewer.
"""

from __future__ import annotations

from sketch2shape.model.answer import TRUSTED, Answer
from sketch2shape.model.arguments import checked_count, checked_number
from sketch2shape.model.arrays import Bools, Brief, Floats, Gray, Ints, as_gray, brief
from sketch2shape.model.boundary import (
    Boundary,
    Cone,
    Cylinder,
    DirectedEdge,
    Edge,
    Face,
    Loop,
    Plane,
    Ring,
    Surface,
    polyhedron,
)
from sketch2shape.model.curves import Arc, Circle, Curve, Line, arc_between
from sketch2shape.model.drawing import DrawnArc, Ellipse, FacePair, Lines, Side, TwoFaceObject, ring_edges
from sketch2shape.model.picture import Ink, Picture
from sketch2shape.model.solid import Alternative, Projection, Solid
from sketch2shape.model.two_face_boundary import ArcPlace, two_face_boundary
from sketch2shape.model.vectors import VectorDrawing, VectorLine

__all__ = [
    "TRUSTED",
    "Alternative",
    "Answer",
    "Arc",
    "ArcPlace",
    "Bools",
    "Boundary",
    "Brief",
    "Circle",
    "Cone",
    "Curve",
    "Cylinder",
    "DirectedEdge",
    "DrawnArc",
    "Edge",
    "Ellipse",
    "Face",
    "FacePair",
    "Floats",
    "Gray",
    "Ink",
    "Ints",
    "Line",
    "Lines",
    "Loop",
    "Picture",
    "Plane",
    "Projection",
    "Ring",
    "Side",
    "Solid",
    "Surface",
    "TwoFaceObject",
    "VectorDrawing",
    "VectorLine",
    "arc_between",
    "as_gray",
    "brief",
    "checked_count",
    "checked_number",
    "polyhedron",
    "ring_edges",
    "two_face_boundary",
]
