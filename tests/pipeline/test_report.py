"""The report's schema."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sketch2shape import __version__
from sketch2shape.errors import NoObjectError
from sketch2shape.lifting import lift
from sketch2shape.model import Answer, Projection, Solid, two_face_boundary
from sketch2shape.model.drawing import FacePair, TwoFaceObject
from sketch2shape.model.picture import Picture
from sketch2shape.pipeline.report import encode_report, plain, report
from sketch2shape.pipeline.result import Result
from tests.lifting.round_views import CIRCLE, SLOT, STANDING, Drawer, axonometric
from tests.lifting.round_views import HOLE as ROUND_HOLE

SQUARE = np.array([[0.0, 0], [9, 0], [9, 9], [0, 9]])
HOLE = SQUARE / 3 + 3


@pytest.fixture
def answer():
    obj = TwoFaceObject(
        SQUARE, SQUARE + [4, -2], (FacePair(HOLE, HOLE + [4, -2]),), confidence=0.95, connectors=("split-walk", "ink")
    )
    flat = np.concatenate([SQUARE, HOLE])
    vertices = np.r_[np.c_[flat, np.zeros(8)], np.c_[flat, np.full(8, 5)]]
    solid = Solid(
        two_face_boundary(vertices, (4, 4)),
        Projection("oblique", {"angle": np.float64(30.0), "bad": np.nan}),
        "mm",
        ("guess",),
    )
    picture = Picture(np.zeros((20, 30, 3), np.uint8), "a.png")
    return Result((obj,), (solid,), picture, {"ink": 1.23456})


def test_keys_of_the_contract(answer):
    data = report(answer)
    assert list(data)[:6] == ["schema", "source", "width", "height", "status", "message"]
    assert (data["schema"], data["source"], data["width"], data["height"]) == ("sketch2shape/1", "a.png", 30, 20)
    assert (data["status"], data["message"], data["version"]) == ("ok", None, __version__)
    assert data["timings_ms"] == {"ink": 1.23}
    (obj,) = data["objects"]
    assert obj["f1"] == SQUARE.tolist()
    assert obj["f2"][0] == [4.0, -2.0]
    assert obj["holes"][0]["f1"] == HOLE.tolist()
    assert obj["projection"] == {"family": "oblique", "angle": 30.0, "bad": None}
    assert obj["confidence"] == 0.95
    assert obj["connectors"] == {"f1": "split-walk", "f2": "ink"}
    assert obj["solid"]["unit"] == "mm"
    assert obj["solid"]["volume"] == pytest.approx(answer.solids[0].volume)
    assert obj["solid"]["surface"] == pytest.approx(answer.solids[0].area)
    assert obj["solid"]["confidence"] == 1.0
    assert obj["solid"]["camera"] is None
    assert obj["alternatives"] == []


def test_the_solids_confidence_camera_and_alternatives_are_told():
    obj = TwoFaceObject(20 * SQUARE, 20 * SQUARE + [60, -60], confidence=0.95)
    solid = lift(obj)
    (told,) = report(Result((obj,), (solid,), Picture(np.zeros((20, 30, 3), np.uint8))))["objects"]
    assert told["confidence"] == 0.95
    assert told["solid"]["confidence"] == pytest.approx(solid.confidence, abs=1e-4)
    assert np.array(told["solid"]["camera"]).shape == (3, 4)
    assert told["solid"]["camera"][2] == [0.0, 0.0, 0.0, 1.0]
    assert [other["reading"] for other in told["alternatives"]] == [a.reading for a in solid.alternatives]
    assert told["alternatives"][0]["projection"]["family"] == "oblique"
    assert len(told["alternatives"][0]["dimensions"]) == 3


def test_edges_index_f1_then_holes_then_f2_as_the_solid_does(answer):
    (obj,) = report(answer)["objects"]
    rings = obj["f1"] + obj["holes"][0]["f1"] + obj["f2"] + obj["holes"][0]["f2"]
    assert len(obj["solid"]["vertices"]) == len(rings) == 16
    joins = [(i, j) for i, j in obj["edges"] if j == i + 8]
    assert len(joins) == 8
    assert all(np.allclose(np.subtract(rings[j], rings[i]), [4, -2]) for i, j in joins)
    assert len(obj["edges"]) == 24


def test_a_failure_has_a_report_too():
    data = report(NoObjectError("blank"), source="b.png", size=(7, 5))
    assert (data["status"], data["message"], data["objects"]) == ("failed", "blank", [])
    assert (data["width"], data["height"], data["timings_ms"]) == (7, 5, {})
    assert report(NoObjectError("x"))["width"] is None


def test_encoded_is_strict_ascii_json(answer):
    data = report(answer, source="ä\udcff\n.png", timings_ms={})
    text = encode_report(data).decode("ascii")
    assert text.endswith("}\n")
    assert json.loads(text, parse_constant=pytest.fail)["source"] == "ä\udcff\n.png"


def test_plain_leaves_only_json_types():
    mixed = {1: np.int32(3), "a": (np.bool_(True), np.array([1.5, np.inf])), "b": {2.0}, "c": object, "d": None}
    assert plain(mixed) == {"1": 3, "a": [True, [1.5, None]], "b": [2.0], "c": str(object), "d": None}


def test_arcs_are_told_of_the_drawing_and_of_the_solid():
    plate = Drawer(axonometric()).draw([SLOT, ROUND_HOLE], 0.7)
    told = report(Answer((plate,), (lift(plate),), Picture(np.zeros((9, 9, 3), np.uint8))))["objects"][0]
    assert told["shape"] == "slot prism with a round hole"
    places = [(arc["face"], arc["hole"], arc["from"], arc["to"]) for arc in told["arcs"]]
    ends = [("f1", None, 1, 2), ("f1", None, 3, 0), ("f2", None, 1, 2), ("f2", None, 3, 0)]
    assert places == [*ends, ("f1", 0, None, None), ("f2", 0, None, None)]
    solid = told["solid"]
    assert sorted(map(str, places)) == sorted(str((a["face"], a["hole"], a["from"], a["to"])) for a in solid["arcs"])
    vertices = np.array(solid["vertices"])
    assert len(vertices) == 8
    for arc in solid["arcs"]:
        away = np.array(arc["points"]) - arc["center"]
        assert np.linalg.norm(away, axis=1) == pytest.approx(arc["radius"], rel=1e-4)
        assert away @ arc["normal"] == pytest.approx(0.0, abs=1e-4)
        if arc["from"] is not None:
            start = arc["from"] + (4 if arc["face"] == "f2" else 0)
            assert arc["points"][0] == pytest.approx(vertices[start], abs=1e-4)
    assert all(arc["ellipse"]["axes"][0] >= arc["ellipse"]["axes"][1] for arc in told["arcs"])
    json.dumps(told, allow_nan=False)


def test_a_cone_has_one_vertex():
    cone = Drawer(axonometric(), STANDING).draw([CIRCLE], -1.5, 0.0)
    told = report(Answer((cone,), (lift(cone),), Picture(np.zeros((9, 9, 3), np.uint8))))["objects"][0]
    assert (told["f1"], len(told["f2"]), told["edges"]) == ([], 1, [])
    assert len(told["solid"]["vertices"]) == len(told["solid"]["arcs"]) == 1
    assert told["shape"] == "cone"
