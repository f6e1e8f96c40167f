"""Gaps between the faces of an icon stand for its lines; notches and the paper around it do not."""

import cv2
import numpy as np
import pytest

import sketch2shape as s2s
from sketch2shape.ink.find import find_ink
from sketch2shape.ink.gaps import gaps_between
from sketch2shape.model import Picture

FRONT = np.array([[40, 110], [190, 110], [190, 260], [40, 260]])
BACK = FRONT + [70, -60]
OUTLINE = np.array([FRONT[0], BACK[0], BACK[1], BACK[2], FRONT[2], FRONT[3]])


def icon(gap, *, ink=0, paper=255):
    """A box in one tone whose inner edges are gaps, smooth as in a program's picture."""
    image = np.full((1200, 1200), paper, np.uint8)
    cv2.fillPoly(image, [4 * OUTLINE], ink)
    for a, b in ((FRONT[0], FRONT[1]), (FRONT[1], FRONT[2]), (FRONT[1], BACK[1])):
        cv2.line(image, (4 * a).tolist(), (4 * b).tolist(), paper, 4 * gap)
    return cv2.resize(image, (300, 300), interpolation=cv2.INTER_AREA)


@pytest.mark.parametrize("gap", [4, 8, 12])
@pytest.mark.parametrize(("ink", "paper"), [(0, 255), (255, 0), (120, 230)])
def test_an_icon_parted_by_gaps_is_the_box(gap, ink, paper):
    (obj,) = s2s.reconstruct(icon(gap, ink=ink, paper=paper)).objects
    assert len(obj.f1) == 4
    drawn = [*FRONT, *BACK[:3]]
    assert max(np.hypot(*(obj.vertices - v).T).min() for v in drawn) < 6


def test_three_faces_of_a_hexagon_are_a_cube():
    angle = np.radians([90, 150, 210, 270, 330, 30])
    middle = np.array([512.0, 512.0])
    rim = middle + 410 * np.stack([np.cos(angle), -np.sin(angle)], axis=1)
    image = np.full((1024, 1024), 255, np.uint8)
    cv2.fillPoly(image, [rim.astype(np.int32)], 0)
    for corner in rim[1::2]:
        cv2.line(image, middle.astype(int).tolist(), corner.astype(int).tolist(), 255, 40)
    for side in (256, 64):
        (obj,) = s2s.reconstruct(cv2.resize(image, (side, side), interpolation=cv2.INTER_AREA)).objects
        assert len(obj.f1) == 4
        assert max(np.hypot(*(obj.vertices - v * side / 1024).T).min() for v in (middle, *rim)) < 0.03 * side


def test_the_paper_between_a_face_and_a_line_beside_it_is_no_gap():
    image = np.full((400, 500), 255, np.uint8)
    for face, tone in (
        (FRONT, 200),
        (np.array([FRONT[0], BACK[0], BACK[1], FRONT[1]]), 170),
        (OUTLINE[[2, 3, 4]], 140),
    ):
        cv2.fillPoly(image, [face + [90, 60]], tone)
    cv2.fillPoly(image, [np.array([FRONT[1], BACK[1], BACK[2], FRONT[2]]) + [90, 60]], 140)
    cv2.line(image, (130, 332), (280, 332), 0, 2)  # a dimension
    mask = find_ink(Picture(np.dstack([image] * 3))).mask
    assert not mask[323:329, 140:270].any()


def test_a_gap_is_one_line_and_not_its_two_sides():
    mask = find_ink(Picture(np.dstack([icon(10)] * 3))).mask
    middle = mask[mask.shape[0] * 200 // 300]
    assert np.count_nonzero(np.diff(middle.astype(int)) == 1) == 3  # left, between the faces, right


def test_a_notch_and_the_paper_around_are_no_gaps():
    faces = np.zeros((200, 200), np.uint8)
    faces[50:150, 50:150] = 1
    notched = faces.copy()
    notched[50:100, 98:102] = 0
    parted = faces.copy()
    parted[50:150, 98:102] = 0
    found = [np.count_nonzero(gaps_between(one > 0, one == 0)) for one in (faces, notched, parted)]
    assert found[:2] == [0, 0]
    assert 300 < found[2] <= 400


def test_a_wide_way_between_two_things_is_paper():
    faces = np.zeros((200, 200), np.bool_)
    faces[50:150, 20:90] = faces[50:150, 110:180] = True
    assert not gaps_between(faces, ~faces).any()
