"""The evaluation itself: an oracle scores 100 %, and what goes wrong is counted and named."""

from dataclasses import replace

import numpy as np
import pytest

from evaluation import metrics
from evaluation.cases import Case, case_of
from evaluation.measure import judged, lost, measure
from evaluation.page import kind_of
from sketch2shape import errors
from sketch2shape.model import FacePair, Picture, Projection, Solid, TwoFaceObject, two_face_boundary
from sketch2shape.pipeline.result import Result
from synthetic.drawing import draw


def solid_of(vertices):
    return Solid(two_face_boundary(vertices, (len(vertices) // 2,)), Projection("axonometric"))


def perfect(truth, confidence=0.95, turn=0):
    """What a perfect tool would say; `turn` gives the back face a wrong order."""
    f2 = np.roll(truth["f2"], turn, 0)
    found = TwoFaceObject(np.array(truth["f1"]), np.array(f2), tuple(FacePair(**h) for h in truth["holes"]), confidence)
    solid = solid_of(metrics.true_solid(truth))
    return Result((found,), (solid,), Picture(np.zeros((2, 2, 3), np.uint8)))


def refuse(_):
    raise errors.NoObjectError("no two faces")


def fail(_):
    raise ZeroDivisionError("oh")


def test_an_oracle_is_right_with_a_good_mesh_and_solid(case):
    outcome = measure(case, lambda _: perfect(case.truth))
    assert outcome.right
    assert outcome.mesh
    assert outcome.solid
    assert outcome.sure
    assert outcome.iou == pytest.approx(1, abs=1e-6)
    # Two independent samples of one surface still lie a little apart.
    assert outcome.chamfer < 0.03


def test_wrong_answers_refusals_and_bugs_are_told_apart(case):
    kinds = []
    for answer in (lambda _: perfect(case.truth, turn=1), refuse, fail):
        outcome = measure(case, answer)
        assert outcome.wrong
        kinds.append(kind_of(outcome))
    assert kinds == ["edges wrong", "refused", "crashed: ZeroDivisionError"]
    assert kind_of(lost(case, TimeoutError("30 s"), 30.0)) == "lost: TimeoutError"


def test_arcs_between_the_right_vertices_are_wrong(case):
    outcome = measure(case, lambda _: perfect(case.truth))
    bowed = replace(outcome, answers=({**outcome.answers[0], "arcs": [{"face": "f1"}]},))
    assert judged(bowed, []).wrong


def test_only_a_refusal_is_right_where_there_is_no_object(tmp_path):
    case = case_of(draw("negative", 1, 3).save(tmp_path))
    other = draw("clean_wire_axono", 3, 0).truth
    assert measure(case, refuse).right
    assert measure(case, fail).wrong
    assert measure(case, lambda _: perfect(other)).wrong


def test_an_answer_to_a_picture_that_only_the_eye_can_judge_is_neither_right_nor_wrong(case):
    unknown = Case("refuse", "neg_multi/1", case.picture, {"objects": None, "category": "neg_multi"})
    answered = measure(unknown, lambda _: perfect(case.truth))
    assert answered.right is None
    assert not answered.wrong
    assert measure(unknown, refuse).right


def test_a_wireframe_may_be_read_in_the_mirror(tmp_path):
    case = case_of(draw("clean_wire_axono", 3, 0).save(tmp_path))
    mirrored = perfect(case.truth)
    solid = solid_of(mirrored.solids[0].vertices * [1, 1, -1])
    outcome = measure(case, lambda _: replace(mirrored, solids=(solid,)))
    assert outcome.solid
    assert outcome.iou == pytest.approx(1, abs=1e-6)
    removed = replace(case, truth=case.truth | {"lines": "removed"})
    assert not measure(removed, lambda _: replace(mirrored, solids=(solid,))).solid


@pytest.mark.parametrize(("stem", "half"), [("000", "even"), ("007", "odd"), ("cuboid_b", "even"), ("axis", "odd")])
def test_halves_go_by_the_last_character(stem, half):
    assert Case("real", f"cad/{stem}", "", {}).half == half


def test_halves_of_cad_parts_go_by_the_last_but_one():
    assert Case("abc", "stack/00000021", "", {}).half == "even"
