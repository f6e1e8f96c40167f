"""The measure for arcs and apexes, on answers whose score is known by construction."""

import copy

import numpy as np
import pytest

from evaluation import curves
from synthetic.drawing import draw

CATEGORIES = ("cylinder_wire", "tube_dashed", "plate_wire", "arcs_dashed", "cone_wire", "frustum_wire", "pyramid_wire")


def answer(truth, **changes):
    return copy.deepcopy({k: truth[k] for k in ("f1", "f2", "holes", "arcs")} | {"confidence": 0.9} | changes)


@pytest.mark.parametrize("category", CATEGORIES)
def test_the_truth_itself_is_exact(category):
    for index in range(2):
        truth = draw(category, 2, index).truth
        verdict = curves.judge(truth, [answer(truth)])
        assert verdict.exact, verdict.cause
        assert verdict.error == 0


def test_a_moved_ring_a_missing_hole_and_chords_are_wrong():
    truth = draw("tube_dashed", 2, 0).truth
    moved = answer(truth)
    for arc in moved["arcs"]:
        if arc["face"] == "f2" and arc["hole"] is None:
            arc["points"] = (np.array(arc["points"]) + [25, 0]).tolist()
    assert "line is off" in curves.judge(truth, [moved]).cause
    assert "holes instead of" in curves.judge(truth, [answer(truth, holes=[])]).cause
    chords = answer(truth)
    for face in ("f1", "f2"):
        chords[face] = next(a["points"][:-1] for a in truth["arcs"] if a["face"] == face and a["hole"] is None)
    chords["arcs"] = [a for a in chords["arcs"] if a["hole"] is not None]
    assert "chords for an ellipse" in curves.judge(truth, [chords]).cause
    assert "0 objects" in curves.judge(truth, []).cause


def test_holes_may_come_in_any_order():
    truth = next(t for t in (draw("plate_wire", 3, i).truth for i in range(20)) if len(t["holes"]) == 2)
    other = answer(truth)
    for arc in other["arcs"]:
        if arc["hole"] is not None:
            arc["hole"] = 1 - arc["hole"]
    assert curves.judge(truth, [other]).exact


def test_every_ring_has_a_line_to_be_drawn():
    assert len(curves.ring_lines(draw("tube_dashed", 2, 0).truth)) == 4
    assert len(curves.ring_lines(draw("pyramid_wire", 2, 0).truth)) == 1


def test_an_apex_is_one_vertex_in_its_place():
    truth = draw("pyramid_wire", 2, 0).truth
    assert "the apex is off" in curves.judge(truth, [answer(truth, f2=(np.array(truth["f2"]) + 40).tolist())]).cause
    assert "no apex" in curves.judge(truth, [answer(truth, f2=truth["f1"])]).cause
    base = truth["f1"][:-1] + [(np.array(truth["f1"][-1]) + 60).tolist()]
    assert not curves.judge(truth, [answer(truth, f1=base)]).exact


BEFORE = [[1, 0, 0.3, 0], [0, 1, -0.4, 0], [0, 0, 0, 1]]
"""Camera to which z leads away, so that f1 of the generator is in front."""
BEHIND = [[1, 0, 0.3, 0], [0, -1, -0.4, 0], [0, 0, 0, 1]]
"""Camera to which z leads nearer."""


def exchanged(thing):
    arcs = [a | {"face": {"f1": "f2", "f2": "f1"}[a["face"]]} for a in thing["arcs"]]
    holes = [{"f1": hole["f2"], "f2": hole["f1"]} for hole in thing["holes"]]
    return copy.deepcopy(thing) | {"f1": thing["f2"], "f2": thing["f1"], "holes": holes, "arcs": arcs}


def seen_by(camera, truth):
    return {"solid": {k: truth["solid"][k] for k in ("vertices", "arcs")} | {"camera": camera}}


@pytest.mark.parametrize("category", ["cylinder_wire", "tube_wire", "frustum_wire", "plate_wire"])
def test_a_wireframe_does_not_tell_which_face_is_in_front(category):
    truth = draw(category, 2, 0).truth
    for camera in (BEFORE, BEHIND):
        assert curves.judge(truth, [answer(truth) | seen_by(camera, truth)]).exact
        assert curves.judge(truth, [exchanged(answer(truth)) | seen_by(camera, truth)]).exact


DASHED = ("cylinder_dashed", "tube_dashed", "arcs_removed", "cone_dashed", "frustum_dashed")


@pytest.mark.parametrize("category", DASHED)
def test_dashes_tell_which_face_is_in_front_whatever_it_is_called(category):
    for index in range(3):
        truth = draw(category, 2, index).truth
        same, mirrored = (BEFORE, BEHIND) if truth["front"] == "f1" else (BEHIND, BEFORE)
        named, other = answer(truth), exchanged(answer(truth))
        assert curves.judge(truth, [named | seen_by(same, truth)]).exact
        assert curves.judge(truth, [named | seen_by(mirrored, truth)]).cause == (
            "the face behind is taken for the one in front"
        )
        assert not curves.judge(truth, [other]).exact
        if len(truth["f2"]) != 1:  # the solid of the other names starts with the other face
            turned = {"solid": exchanged(truth["solid"] | {"f1": [], "f2": [], "holes": []})}
            half = len(turned["solid"]["vertices"]) // 2
            turned["solid"]["vertices"] = turned["solid"]["vertices"][half:] + turned["solid"]["vertices"][:half]
            assert curves.judge(truth, [other | {"solid": turned["solid"] | {"camera": same}}]).exact
            assert not curves.judge(truth, [other | {"solid": turned["solid"] | {"camera": mirrored}}]).exact


def test_nearer_is_nearer_in_perspective_too():
    truth = draw("tube_dashed", 2, 0).truth
    before = np.array([[500.0, 0, 0, 300], [0, 500, 0, 200], [0, 0, 1, 4]])
    assert curves.front_of(answer(truth) | seen_by(before.tolist(), truth)) == "f1"
    assert curves.front_of(answer(truth) | seen_by((-before).tolist(), truth)) == "f1"
    before[2] = [0, 0, -1, 4]
    before[1, 1] = -500
    assert curves.front_of(answer(truth) | seen_by(before.tolist(), truth)) == "f2"


def test_exchanged_names_forgive_nothing_else():
    truth = draw("tube_wire", 2, 0).truth
    for changed in (answer(truth), exchanged(answer(truth))):
        for arc in changed["arcs"]:
            if arc["face"] == "f2" and arc["hole"] is None:
                arc["points"] = (np.array(arc["points"]) + [25, 0]).tolist()
        assert not curves.judge(truth, [changed]).exact
    halves = answer(truth)
    for arc in halves["arcs"]:  # one face's hole at the other's place: no exchange of whole faces
        if arc["hole"] is not None:
            arc["face"] = "f1" if arc["face"] == "f2" else "f2"
    assert not curves.judge(truth, [halves]).exact
