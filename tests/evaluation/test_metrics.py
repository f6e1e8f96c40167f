"""The measures, on answers whose score is known by construction."""

import copy

import numpy as np
import pytest

from evaluation import metrics
from synthetic.drawing import draw

BOX = {
    **{"f1": [[100, 100], [300, 100], [300, 300], [100, 300]], "f2": [[160, 40], [360, 40], [360, 240], [160, 240]]},
    **{"holes": [], "lines": "wire", "medium": "clean", "projection": "oblique", "width": 640, "height": 480},
}


def answer(thing=BOX, confidence=0.9, **changes):
    return {k: copy.deepcopy(thing[k]) for k in ("f1", "f2", "holes")} | {"confidence": confidence} | changes


def test_the_truth_itself_is_exact():
    verdict = metrics.judge(BOX, [answer()])
    assert verdict.exact
    assert verdict.error == 0
    assert (verdict.match == np.arange(8)).all()


def test_a_pyramid_is_no_box():
    pyramid = answer(f2=[[200, 20]])
    vertices, edges = metrics.wireframe(pyramid)
    assert (vertices.shape, len(edges), edges.max()) == ((5, 2), 8, 4)
    assert not metrics.judge(BOX, [pyramid]).exact


def test_other_order_and_swapped_faces_are_exact_too():
    turned = answer(f1=BOX["f2"][::-1], f2=BOX["f1"][::-1])
    assert metrics.judge(BOX, [turned]).exact


def test_a_box_split_along_another_axis_is_the_same_object():
    # A box has three pairs of opposite faces; all give the same vertices and edges.
    f1, f2 = BOX["f1"], BOX["f2"]
    other = answer(f1=[f1[0], f1[1], f2[1], f2[0]], f2=[f1[3], f1[2], f2[2], f2[3]])
    assert metrics.judge(BOX, [other]).exact


def test_two_vertices_in_one_place_may_go_by_either_name():
    cube = draw("accident_cube", 1, 0).truth
    f1, f2 = np.array(cube["f1"]), np.array(cube["f2"])
    front, back = np.argwhere(np.linalg.norm(f1[:, None] - f2[None], axis=2) < 0.1)[0]
    for step in (-0.5, 0.5):
        # Half a pixel of noise decides which of the two is nearer; the object is the same.
        f1[front] += step
        f2[back] -= step
        assert metrics.judge(cube, [answer(cube, f1=f1.tolist(), f2=f2.tolist())]).exact


@pytest.mark.parametrize(
    ("changes", "cause"),
    [
        ({"f1": [[110, 100], *BOX["f1"][1:]]}, "off by"),
        ({"f1": [BOX["f1"][k] for k in (0, 2, 1, 3)]}, "edges wrong"),
        ({"f1": BOX["f1"][:3], "f2": BOX["f2"][:3]}, "3 vertices a face instead of 4"),
    ],
)
def test_wrong_answers_are_named(changes, cause):
    verdict = metrics.judge(BOX, [answer(**changes)])
    assert not verdict.exact
    assert cause in verdict.cause


def test_one_object_too_many_is_wrong_and_silence_is_right_only_for_negatives():
    assert not metrics.judge(BOX, [answer(), answer()]).exact
    assert not metrics.judge(BOX, []).exact
    assert metrics.judge({"objects": []}, []).exact
    assert not metrics.judge({"objects": []}, [answer()]).exact


def test_junctions_count_what_is_right():
    shifted = answer(f2=[[x + 40, y] for x, y in BOX["f2"]])
    assert metrics.junction_counts(BOX, [answer()]) == (8, 8, 8)
    assert metrics.junction_counts(BOX, [shifted]) == (4, 8, 8)
    assert metrics.junction_counts(BOX, []) == (0, 0, 8)


def test_structural_ap_is_one_for_the_truth_and_falls_with_confident_errors():
    far = answer(f1=[[x + 90, y] for x, y in BOX["f1"]], f2=[[x + 90, y + 9] for x, y in BOX["f2"]])
    assert metrics.structural_ap([(BOX, [answer()])]) == [1, 1, 1]
    assert metrics.structural_ap([(BOX, [far])]) == [0, 0, 0]
    half = metrics.structural_ap([(BOX, [answer(confidence=0.5)]), (BOX, [far | {"confidence": 0.9}])])
    # 12 wrong edges rank before 12 right ones of 24: precision ends at one half, recall too.
    assert half == pytest.approx([0.25] * 3)
    late = metrics.structural_ap([(BOX, [answer(confidence=0.9)]), (BOX, [far | {"confidence": 0.5}])])
    assert late == pytest.approx([0.5] * 3)


def test_solid_error_ignores_place_size_and_turn_but_not_proportions():
    truth = draw("clean_wire_axono", 1, 0).truth
    solid = metrics.true_solid(truth)
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    match = np.arange(len(solid))
    same = answer(truth) | {"solid": {"vertices": (7 * solid @ turn + 5).tolist()}}
    longer = answer(truth) | {"solid": {"vertices": (solid * [1, 1, 1.5]).tolist()}}
    assert metrics.solid_error(truth, same, match) < 1e-9
    assert metrics.solid_error(truth, longer, match) > metrics.solid_limit(truth)


def test_depth_is_free_in_oblique_drawings():
    truth = draw("clean_wire_oblique", 1, 0).truth
    deeper = answer(truth) | {"solid": {"vertices": (metrics.true_solid(truth) * [1, 1, 2]).tolist()}}
    assert metrics.solid_error(truth, deeper, np.arange(2 * truth["n"])) < 1e-9
