"""What the classic detectors propose, and what their vouched is worth."""

import cv2
import numpy as np
import pytest
from sketches import DEPTH, L_SHAPE, ink_of, outline, paper, prism

from sketch2shape.errors import UsageError
from sketch2shape.evidence.detectors_agree import vouched
from sketch2shape.strokes.corner_detectors import detector_named, near, propose

VERTICES = np.r_[L_SHAPE, L_SHAPE + DEPTH]


@pytest.mark.parametrize("width", [1, 2, 5, 12])
@pytest.mark.parametrize("detector", ["shi-tomasi", "harris"])
def test_proposals_are_near_every_vertex_whatever_the_pen(detector, width):
    ink = ink_of(prism(L_SHAPE, L_SHAPE + DEPTH, width=width))
    places = propose(ink, detector)
    gap = np.linalg.norm(places[:, None] - VERTICES[None], axis=2).min(axis=0)
    assert gap.max() < 4 + 2 * width
    assert len(places) >= 12


def test_both_are_the_proposals_of_either():
    ink = ink_of(prism(L_SHAPE, L_SHAPE + DEPTH))
    assert len(propose(ink, "both")) == len(propose(ink, "shi-tomasi")) + len(propose(ink, "harris"))


def test_the_detectors_speak_for_vertices_and_against_points_of_a_smooth_curve():
    ink = ink_of(prism(L_SHAPE, L_SHAPE + DEPTH))
    assert vouched(ink, VERTICES, "both", 1.0) == 1.0
    middles = (L_SHAPE + np.roll(L_SHAPE, 1, axis=0)) / 2
    assert vouched(ink, middles, "both", 1.0) < 0.5
    circle = cv2.circle(paper(), (240, 200), 120, 0, 2, cv2.LINE_AA)
    turn = np.arange(14) * 2 * np.pi / 14
    on_it = np.array([240.0, 200]) + 120 * np.c_[np.cos(turn), np.sin(turn)]
    assert vouched(ink_of(circle), on_it, "both", 1.0) < 0.7


def test_one_unseen_vertex_among_many_may_be():
    ink = ink_of(outline(L_SHAPE))
    assert vouched(ink, np.r_[L_SHAPE, [[120.0, 210]]], "harris", 1.0) == 1.0
    assert vouched(ink, np.zeros((0, 2)), "harris", 1.0) == 1.0


def test_blank_paper_proposes_nothing_and_nothing_is_near_it():
    places = propose(ink_of(paper()), "both")
    assert places.shape == (0, 2)
    assert near(VERTICES, places, 9.0).tolist() == [False] * 12


def test_detectors_have_names():
    assert detector_named("harris") == "harris"
    assert detector_named("auto") == detector_named("both") == "both"
    for name in ("shi-tomasi", "Shi_Tomasi", "goodFeaturesToTrack", "good_features_to_track"):
        assert detector_named(name) == "shi-tomasi"
    with pytest.raises(UsageError, match="canny") as caught:
        detector_named("canny")
    assert "harris" in caught.value.advice
