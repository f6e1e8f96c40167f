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
