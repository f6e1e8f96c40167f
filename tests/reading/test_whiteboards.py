"""Excalidraw and tldraw: every kind of element, moved and turned as the programs do; what is no line is left out."""

import base64
import json

import numpy as np
import pytest

from sketch2shape.errors import UnreadableError
from sketch2shape.reading.excalidraw import excalidraw_shapes
from sketch2shape.reading.painted import visible_lines
from sketch2shape.reading.read import read_picture
from sketch2shape.reading.tldraw import tldraw_shapes, unpacked


def excalidraw(*elements):
    return visible_lines(excalidraw_shapes({"type": "excalidraw", "elements": list(elements)}))


def element(kind, **more):
    return {"type": kind, "x": 100, "y": 50, "width": 60, "height": 40, "angle": 0, "strokeColor": "#1e1e1e"} | more


def box_of(one):
    return [*one.points.min(axis=0).round(6).tolist(), *one.points.max(axis=0).round(6).tolist()]


@pytest.mark.parametrize("kind", ["rectangle", "diamond", "ellipse"])
def test_shapes_of_excalidraw_fill_their_box(kind):
    (one,) = excalidraw(element(kind))
    assert box_of(one) == pytest.approx([100, 50, 160, 90], abs=0.1)
    assert one.curved == (kind == "ellipse")


def test_a_rectangle_of_excalidraw_may_have_round_corners():
    found = excalidraw(element("rectangle", roundness={"type": 3}))
    assert [one.curved for one in found] == [False, True] * 4
    assert box_of(type(found[0])(np.concatenate([one.points for one in found]))) == pytest.approx([100, 50, 160, 90])


def test_elements_of_excalidraw_turn_about_their_middle():
    (one,) = excalidraw(element("line", points=[[0, 0], [60, 0]], angle=np.pi / 2))
    assert one.points.round(6).tolist() == [[130, 20], [130, 80]]


def test_lines_of_excalidraw_are_smooth_where_it_says_so():
    points = [[0, 0], [30, 30], [60, 0]]
    (sharp,) = excalidraw(element("line", points=points))
    (bent,) = excalidraw(element("line", points=points, roundness={"type": 2}))
    (pen,) = excalidraw(element("freedraw", points=points, roundness={"type": 2}))
    assert len(sharp.points) == len(pen.points) == 3
    assert len(bent.points) > 20
    assert bent.curved


@pytest.mark.parametrize(("style", "dashed"), [("solid", False), ("dashed", True), ("dotted", True)])
def test_stroke_styles_of_excalidraw(style, dashed):
    assert excalidraw(element("ellipse", strokeStyle=style))[0].dashed is dashed


@pytest.mark.parametrize(
    "other",
    [
        element("text", text="word"),
        element("image", fileId="f"),
        element("frame"),
        element("arrow", points=[[0, 0], [60, 0]], startArrowhead=None, endArrowhead="arrow"),
        element("rectangle", isDeleted=True),
        element("rectangle", strokeColor="transparent"),
        element("line", points=[]),
        element("something new"),
    ],
)
def test_what_is_no_line_of_excalidraw_is_left_out(other):
    assert excalidraw(other) == []


def test_filled_elements_of_excalidraw_hide_what_is_under_them():
    under = element("line", x=0, y=70, points=[[0, 0], [300, 0]])
    cover = element("rectangle", backgroundColor="#ffc9c9", fillStyle="solid", opacity=100)
    assert len(excalidraw(under, cover)) == 3
    assert len(excalidraw(under, cover | {"fillStyle": "hachure"})) == 2
    assert len(excalidraw(under, cover | {"opacity": 40})) == 2


def shape(kind, props, **more):
    record = {"typeName": "shape", "type": kind, "id": "shape:a", "parentId": "page:p", "index": "a1", "x": 10, "y": 20}
    return record | {"rotation": 0, "props": props} | more


def tldraw(*records):
    page = {"typeName": "page", "id": "page:p", "index": "a1"}
    return visible_lines(tldraw_shapes({"tldrawFileFormatVersion": 1, "records": [page, *records]}))


@pytest.mark.parametrize(
    "geo", ["rectangle", "ellipse", "oval", "triangle", "diamond", "trapezoid", "rhombus", "hexagon"]
)
def test_shapes_of_tldraw_fill_their_box(geo):
    (one,) = tldraw(shape("geo", {"geo": geo, "w": 60, "h": 30, "growY": 10}))
    assert box_of(one) == pytest.approx([10, 20, 70, 60], abs=0.1)


def test_groups_of_tldraw_carry_their_shapes():
    group = shape("group", {}, id="shape:g", x=100, y=0, rotation=np.pi / 2)
    line = {
        "dash": "dashed",
        "spline": "line",
        "points": {"b": {"index": "a2", "x": 50, "y": 0}, "a": {"index": "a1", "x": 0, "y": 0}},
    }
    (one,) = tldraw(group, shape("line", line, parentId="shape:g"))
    assert one.points.round(6).tolist() == [[80, 10], [80, 60]]
    assert one.dashed


def test_older_lines_of_tldraw_have_handles():
    handles = {
        "start": {"type": "vertex", "index": "a1", "x": 0, "y": 0},
        "mid": {"type": "create", "index": "a15", "x": 9, "y": 9},
        "end": {"type": "vertex", "index": "a2", "x": 30, "y": 0},
    }
    (one,) = tldraw(shape("line", {"spline": "line", "handles": handles}))
    assert one.points.tolist() == [[10, 20], [40, 20]]


def test_the_pen_of_tldraw_in_both_forms():
    points = [{"x": 0, "y": 0, "z": 0.5}, {"x": 3.5, "y": -2, "z": 0.5}, {"x": 8, "y": -2.25, "z": 0.25}]
    packed = np.array([0, 0, 0.5], "<f4").tobytes() + np.array([[3.5, -2, 0], [4.5, -0.25, -0.25]], "<f2").tobytes()
    for segment in ({"points": points}, {"path": base64.b64encode(packed).decode()}):
        (one,) = tldraw(shape("draw", {"segments": [{"type": "free"} | segment], "scaleX": 2}))
        assert one.points.tolist() == [[10, 20], [17, 18], [26, 17.75]]


@pytest.mark.parametrize("packed", [5, "", "!!", "AAAA", base64.b64encode(bytes(13)).decode()])
def test_strokes_that_are_no_base64_are_refused(packed):
    with pytest.raises(UnreadableError):
        unpacked(packed)


@pytest.mark.parametrize(
    "other",
    [
        shape("text", {"richText": {}}),
        shape("arrow", {"start": {"x": 0, "y": 0}, "end": {"x": 9, "y": 9}, "arrowheadEnd": "arrow"}),
        shape("image", {"w": 9, "h": 9}),
        shape("geo", {"geo": "cloud", "w": 9, "h": 9}),
        shape("draw", {"segments": []}),
    ],
)
def test_what_is_no_line_of_tldraw_is_left_out(other):
    assert tldraw(other) == []


def test_only_the_first_page_with_shapes_is_read():
    one = shape("geo", {"geo": "rectangle", "w": 60, "h": 30})
    other = shape("geo", {"geo": "rectangle", "w": 900, "h": 30}, id="shape:b", parentId="page:q")
    assert len(tldraw(other, one, {"typeName": "page", "id": "page:q", "index": "a2"})) == 1


@pytest.mark.parametrize(
    "held",
    [
        {"type": "excalidraw"},
        {"type": "excalidraw", "elements": {"a": 1}},
        {"type": "excalidraw", "elements": [5]},
        {"type": "excalidraw", "elements": [{"type": "line", "points": 3}]},
        {"type": "excalidraw", "elements": [element("line", points=[[0, "a"]])]},
        {"type": "excalidraw", "elements": [element("rectangle", width=None)]},
        {"type": "excalidraw", "elements": [element("ellipse", angle="north")]},
        {"type": "excalidraw", "elements": [element("ellipse", x=1e300)]},
        {"tldrawFileFormatVersion": 1},
        {"tldrawFileFormatVersion": 1, "records": [None]},
        {"tldrawFileFormatVersion": 1, "records": [shape("geo", {"geo": "rectangle", "w": "wide", "h": 1})]},
        {"tldrawFileFormatVersion": 1, "records": [shape("geo", [], parentId="shape:a")]},
        {"tldrawFileFormatVersion": 1, "records": [shape("line", {"points": {"a": 5}})]},
        {"tldrawFileFormatVersion": 1, "records": [shape("draw", {"segments": [{"points": "ab"}]})]},
    ],
)
def test_values_of_another_kind_are_refused(held):
    with pytest.raises(UnreadableError):
        read_picture(json.dumps(held).encode())
