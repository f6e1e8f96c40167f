"""What all data has in common: it shows itself in a line, is equal to itself alone, and takes points in any form."""

import numpy as np
import pytest
from sketches import DEPTH, L_SHAPE, SQUARE, ink_of, prism

import sketch2shape as s2s
from sketch2shape.model import brief

PICTURE = prism(SQUARE, SQUARE + DEPTH)


def values():
    result = s2s.reconstruct(PICTURE)
    ink = ink_of(PICTURE)
    found = (s2s.detect_corners(ink), s2s.trace_strokes(ink), ink, result.picture, s2s.FacePair(SQUARE, SQUARE + 9))
    return (result, result.objects[0], result.solids[0], result.solids[0].projection, *found)


@pytest.mark.parametrize("value", values(), ids=lambda v: type(v).__name__)
def test_values_can_be_compared_hashed_and_shown(value):
    twin = next(v for v in values() if type(v) is type(value))
    assert value == value
    assert value != twin
    assert hash(value) != hash(twin)
    assert len({value, twin, value}) == 2
    shown = repr(value)
    assert shown.startswith(type(value).__name__)
    assert len(shown) < 700
    assert "\n" not in shown
    assert "array(" not in shown


def test_arrays_are_shown_by_their_shape_and_defaults_not_at_all():
    assert repr(s2s.TwoFaceObject(SQUARE, SQUARE + 9)) == "TwoFaceObject(f1=(4, 2) float64, f2=(4, 2) float64)"
    assert "confidence=0.5" in repr(s2s.TwoFaceObject(SQUARE, SQUARE + 9, confidence=0.5))
    assert brief(tuple("abc")) == "('a', 'b', 'c')"
    assert brief((1,)) == "(1,)"
    assert brief(tuple(range(100))) == "(100 int)"
    assert brief(0.123456) == "0.1235"


@pytest.mark.parametrize("form", [np.ndarray.tolist, lambda a: a[:, None], lambda a: a.astype(np.float32), np.rint])
def test_rings_in_any_form(form):
    obj = s2s.TwoFaceObject(form(L_SHAPE), form(L_SHAPE + DEPTH), (s2s.FacePair(form(SQUARE), form(SQUARE + DEPTH)),))
    assert obj.f1.dtype == obj.holes[0].f2.dtype == np.float64
    assert np.array_equal(obj.f1, L_SHAPE)
    assert obj.vertices.shape == (20, 2)


@pytest.mark.parametrize(
    "rings", [(SQUARE, SQUARE[:3]), (SQUARE[:, :1], SQUARE), ("no", SQUARE), (SQUARE.ravel(), SQUARE)]
)
def test_what_is_no_pair_of_rings_is_refused(rings):
    for kind in (s2s.TwoFaceObject, s2s.FacePair):
        with pytest.raises(s2s.PointsError):
            kind(*rings)
