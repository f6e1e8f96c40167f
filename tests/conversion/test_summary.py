"""What was found, in words."""

from __future__ import annotations

import numpy as np

from sketch2shape.conversion.summary import describe
from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model import Answer, FacePair, Picture, TwoFaceObject

FACE = np.array([[100, 100], [300, 100], [300, 250], [100, 250.0]])
HOLE = np.array([[150, 150], [250, 150], [250, 200], [150, 200.0]])


def answer(*objects, **options):
    solids = tuple(lift(o, options=LiftOptions(**options)) for o in objects)
    return Answer(tuple(objects), solids, Picture(np.zeros((4, 4, 3), np.uint8)))


def test_kind_size_confidence_and_what_was_assumed():
    box = TwoFaceObject(FACE, FACE + [60, -60], confidence=0.954)
    words = describe(answer(box, width="40mm"))
    assert words.startswith("box, 40 x 30 x ")
    assert " mm, confidence 0.95; " in words
    assert "is assumed" in words


def test_a_sheet_of_several_tells_the_least_confidence():
    one = TwoFaceObject(FACE, FACE + [60, -60], confidence=0.99)
    two = TwoFaceObject(FACE, FACE + [60, -60], (FacePair(HOLE, HOLE + [60, -60]),), confidence=0.7)
    words = describe(answer(one, two))
    assert words.startswith("2 objects: box, ")
    assert "plate with a hole" in words
    assert "confidence 0.70" in words
    assert describe(answer(*[one] * 9)).count("box") == 4
    assert "5 more" in describe(answer(*[one] * 9))
