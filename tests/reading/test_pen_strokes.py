"""Strokes of a pen as JSON and as arrays; what is no drawing is refused with a word of advice."""

import json

import numpy as np
import pytest

import sketch2shape as s2s
from sketch2shape.reading.pen_strokes import from_strokes
from sketch2shape.reading.read import read_picture


def read(held):
    return read_picture(json.dumps(held).encode() if not isinstance(held, bytes) else held)


@pytest.mark.parametrize(
    "stroke",
    [
        [[10, 20], [30.5, 40]],
        [[10, 20, 0, 0.5], [30.5, 40, 16, 0.7]],
        [{"x": 10, "y": 20, "t": 0}, {"x": 30.5, "y": 40, "pressure": 1}],
        {"points": [[10, 20], [30.5, 40]], "time": [0, 16]},
    ],
)
def test_points_come_in_several_forms(stroke):
    for held in ({"strokes": [stroke], "width": 300, "height": 200}, {"strokes": [stroke], "app": "pad"}, [stroke]):
        (line,) = read(held).drawing.lines
        assert line.points.tolist() == [[10, 20], [30.5, 40]] if "width" in held else len(line.points) == 2
        assert not line.dashed


def test_a_stroke_may_say_that_it_is_dashed():
    picture = read({"strokes": [{"points": [[0, 0], [300, 9]], "dashed": True}, [[0, 0], [9, 300]]]})
    assert [line.dashed for line in picture.drawing.lines] == [True, False]


def test_the_sheet_is_the_one_given_or_fits():
    strokes = [[[100, 50], [400, 250]]]
    assert read({"strokes": strokes, "width": 800.5, "height": 600}).size == (801, 600)
    assert read({"strokes": strokes}).size == (415, 265)
    shifted = read({"strokes": [[[-100, 50], [400, 250]]]})
    assert shifted.drawing.origin == (-125.0, 25.0)
    assert shifted.drawing.lines[0].points.tolist() == [[25, 25], [525, 225]]


def test_small_units_are_enlarged_by_tens():
    drawing = read({"strokes": [[[0.1, 0.2], [0.9, 0.8]]], "width": 1, "height": 1}).drawing
    assert drawing.scale == 1000.0
    assert drawing.lines[0].points.tolist() == [[100, 200], [900, 800]]


@pytest.mark.parametrize(
    ("held", "words"),
    [
        (b'{"strokes": [[[1, 2], [3', "damaged JSON"),
        (b"[" * 10_000, "damaged JSON"),
        (b'{"strokes": [[[1, NaN], [3, 4]]]}', "no numbers"),
        (b'{"strokes": [[[1, 1e300], [3, 4]]]}', "huge"),
        (b'{"strokes": [[[1, ' + b"9" * 5000 + b"], [3, 4]]]}", "damaged JSON"),
        (b'{"strokes": [[[1, ' + b"9" * 400 + b"], [3, 4]]]}", "too large"),
        ({"strokes": "abc"}, "not a list"),
        ({"strokes": [["ab", "cd"]]}, "one of its points"),
        ({"strokes": [[[True, 2], [3, 4]]]}, "x is bool"),
        ({"strokes": [[1, 2], [3, 4]]}, "one of its points"),
        ({"strokes": [{"points": None}]}, "not a list"),
        ({"strokes": [{"points": [{"x": "1", "y": 2}]}]}, "x is str"),
        ({"strokes": [[[1, 2], [3, 4]]], "width": "wide", "height": 1}, "width is str"),
        ({"schema": "sketch2shape/1", "objects": []}, "no drawing"),
        (b'\xff{"strokes": []}', "not a picture"),
    ],
)
def test_what_is_no_drawing_is_refused(held, words):
    with pytest.raises(s2s.UnreadableError, match=words):
        read(held)


def test_too_many_points_are_refused_before_they_are_read():
    with pytest.raises(s2s.LimitError, match="too many"):
        read(b'{"strokes": [[' + b"[1,2]," * 400_000 + b"[1,2]]]}")
    with pytest.raises(s2s.LimitError, match="too many"):
        from_strokes([np.zeros((200_000, 2))])


@pytest.mark.parametrize(
    "strokes", [5, "ab", {"a": 1}, [[1, 2]], [np.zeros((3, 3))], [[["a", "b"]]], [[[np.nan, 1]]], [None]]
)
def test_arrays_of_another_kind_are_refused(strokes):
    with pytest.raises(s2s.PointsError, match="stroke"):
        s2s.reconstruct(strokes=strokes)


def test_a_view_for_people_is_drawn():
    picture = read({"strokes": [[[100, 50], [1900, 950]]], "width": 2000, "height": 1000})
    assert picture.size == (2000, 1000)
    assert max(picture.pixels.shape) <= 960
    assert picture.pixels.min() < 60
    assert picture.reduction == 3
