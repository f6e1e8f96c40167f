"""Wrong arguments of the public functions: always an error of ours that names them, never one from inside."""

import numpy as np
import pytest
from sketches import DEPTH, SQUARE, prism

import sketch2shape as s2s

PICTURE = prism(SQUARE, SQUARE + DEPTH)
BOX = s2s.TwoFaceObject(SQUARE, SQUARE + DEPTH)
NAN = float("nan")

WRONG = {
    "corrections": lambda: s2s.reconstruct(PICTURE, corrections="x"),
    "limits": lambda: s2s.reconstruct(PICTURE, limits={"max_pixel": 5}),
    "limits of text": lambda: s2s.Limits(max_pixels="many"),
    "min_confidence": lambda: s2s.reconstruct(PICTURE, min_confidence="high"),
    "min_confidence nan": lambda: s2s.reconstruct(PICTURE, min_confidence=NAN),
    "min_confidence 7": lambda: s2s.reconstruct(PICTURE, min_confidence=7),
    "connector": lambda: s2s.reconstruct(PICTURE, connector=["auto"]),
    "detector": lambda: s2s.reconstruct(PICTURE, detector=3),
    "tolerance": lambda: s2s.detect_corners(PICTURE, tolerance="fine"),
    "tolerance below 0": lambda: s2s.detect_corners(PICTURE, tolerance=-1),
    "tolerance nan": lambda: s2s.trace_strokes(PICTURE, tolerance=NAN),
    "most": lambda: s2s.separate_faces(PICTURE, most=0),
    "most of text": lambda: s2s.separate_faces(PICTURE, most="all"),
    "corners": lambda: s2s.separate_faces(PICTURE, corners="x"),
    "picture_size": lambda: s2s.lift(BOX, picture_size=5),
    "method": lambda: s2s.connect(SQUARE, method=[1]),
    "parameter": lambda: s2s.connect(SQUARE, method="tour", foo=3),
    "ink of nothing": lambda: s2s.find_ink(None),
    "sources": lambda: s2s.reconstruct_many("a.png"),
    "no sources": lambda: s2s.reconstruct_many(None),
    "jobs": lambda: s2s.reconstruct_many([PICTURE], jobs="all"),
    "half a job": lambda: s2s.reconstruct_many([PICTURE], jobs=0.5),
    "timeout": lambda: s2s.reconstruct_many([PICTURE], timeout=-1),
    "max_memory": lambda: s2s.reconstruct_many([PICTURE], max_memory=0),
    "option of many": lambda: s2s.reconstruct_many([PICTURE], width="40mm"),
    "hole": lambda: s2s.TwoFaceObject(SQUARE, SQUARE + 9, holes=(SQUARE,)),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_argument_is_an_error_of_ours(case):
    with pytest.raises(s2s.Sketch2ShapeError) as caught:
        WRONG[case]()
    assert caught.value.message
    assert caught.value.advice


def test_what_files_hold_may_be_given_as_it_is():
    box = {"f1": SQUARE.tolist(), "d": DEPTH.tolist()}
    given = s2s.reconstruct(PICTURE, corrections={"objects": [box]}, limits={"max_pixels": 10**6})
    assert np.array_equal(given.objects[0].f1, SQUARE)
    holes = s2s.TwoFaceObject(SQUARE, SQUARE + 9, holes=((SQUARE / 2 + 90, SQUARE / 2 + 99),)).holes
    assert isinstance(holes[0], s2s.FacePair)
