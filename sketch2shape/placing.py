"""Placing: from the working pixels of the ink to the pixels of the picture."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import FacePair, Floats, Ink, TwoFaceObject
from sketch2shape.rings import Rings
from sketch2shape.verify import Evidence


def to_picture(points: Floats, scale: float) -> Floats:
    """Working pixels as picture pixels; the centre of a working pixel is the centre of those it stands for."""
    return (points + 0.5) / scale - 0.5


def to_working(points: Floats, scale: float) -> Floats:
    """Picture pixels as working pixels."""
    return (points + 0.5) * scale - 0.5


def as_object(rings: Rings, evidence: Evidence, ink: Ink) -> TwoFaceObject:
    """A hypothesis of the whole sheet in picture pixels; its confidence is how well it explains the drawing."""
    pairs = [
        FacePair(to_picture(a, ink.scale), to_picture(b, ink.scale))
        for a, b in zip(rings.front, rings.back, strict=True)
    ]
    return TwoFaceObject(
        pairs[0].f1,
        pairs[0].f2,
        tuple(pairs[1:]),
        confidence=float(np.clip(evidence.score, 0.0, 1.0)),
        lines=evidence.lines,
        f2_drawn=evidence.drawn,
        page=ink.page,
    )
