"""Corners: proposed by detectors, confirmed and placed by strokes, and their kind."""

import cv2
import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, line, paper, prism, same_object

import sketch2shape as s2s
from sketch2shape.errors import UnreadableError, UsageError
from sketch2shape.strokes import propose


def kinds_at(found, points, within=1.0):
    """Kind of the corner at each point; None where there is none."""
    gap = np.linalg.norm(found.points[:, None] - np.asarray(points, float)[None], axis=2)
    return [found.kinds[k] if gap[k, i] <= within else None for i, k in enumerate(gap.argmin(axis=0))]


@pytest.mark.parametrize(
    ("detector", "within"),
    [("both", 1.0), ("auto", 1.0), ("goodFeaturesToTrack", 6.0), ("shi-tomasi", 6.0), ("harris", 6.0)],
)
def test_a_wireframe_box_has_eight_vertices_and_two_crossings(detector, within):
    found = s2s.detect_corners(prism(SQUARE, SQUARE + DEPTH), detector)
    truth = np.r_[SQUARE, SQUARE + DEPTH]
    assert len(found.vertices) == 8
    assert None not in kinds_at(found, truth, within)
    assert list(found.kinds).count("X") == 2
    labelled = [k for k, kind in enumerate(found.kinds) if kind == "X"]
    gap = np.linalg.norm(found.points[labelled][:, None] - np.array([[210, 140], [270, 230]]), axis=2)
    assert gap.min(axis=0).max() <= within


def test_each_detector_gives_its_own_corners():
    picture = prism(L_SHAPE, L_SHAPE + DEPTH)
    ink = s2s.find_ink(picture)
    given = {name: s2s.detect_corners(picture, name).points for name in ("both", "shi-tomasi", "harris")}
    for name in ("shi-tomasi", "harris"):
        assert np.array_equal(given[name], ink.to_picture(propose(ink, name)))
    sets = {frozenset(map(tuple, points.tolist())) for points in given.values()}
    assert len(sets) == 3
    assert np.array_equal(given["shi-tomasi"], s2s.detect_corners(picture, "goodFeaturesToTrack").points)


@pytest.mark.parametrize("detector", ["both", "shi-tomasi", "harris"])
def test_corners_chain_into_the_separator(detector):
    picture = prism(L_SHAPE, L_SHAPE + DEPTH)
    found = s2s.separate_faces(picture, corners=s2s.detect_corners(picture, detector))
    assert same_object(found[0], L_SHAPE, L_SHAPE + DEPTH)
    exact = s2s.detect_corners(picture, detector).vertices
    assert s2s.separate_faces(picture, corners=exact[:, None])[0].f1.tolist() == found[0].f1.tolist()


def test_a_box_without_hidden_edges_has_one_fork_and_arrows_and_elbows():
    found = s2s.detect_corners(prism(SQUARE, SQUARE + DEPTH, "removed"))
    #    4---5      front 0 1 2 3, back 4 5 6; the nearest vertex 1 is a fork, its neighbours are arrows
    #  0---1 |
    #  |   | 6
    #  3---2
    assert kinds_at(found, SQUARE) == ["W", "Y", "W", "L"]
    assert kinds_at(found, SQUARE[:3] + DEPTH) == ["L", "W", "L"]
    assert len(found) == 7


def test_kinds_of_strokes_that_end_on_cross_or_miss_each_other():
    picture = line(paper(), [60, 60], [420, 60])
    line(picture, [150, 60], [150, 200])
    line(picture, [100, 130], [330, 150])
    found = s2s.detect_corners(picture)
    assert kinds_at(found, [[150, 60], [150, 134.35], [60, 60]], 2.1) == ["T", "X", "end"]
    assert found.degree[list(found.kinds).index("T")] == 3
    assert found.is_vertex.sum() == 1


def test_three_lines_through_one_point_may_be_two_vertices():
    cube = np.array([240.0, 200]) + 120 * np.array([[np.sin(t), -np.cos(t)] for t in np.arange(6) * np.pi / 3])
    picture = paper()
    for k in range(6):
        line(picture, cube[k], cube[(k + 1) % 6])
    for k in range(3):
        line(picture, cube[k], cube[k + 3])
    found = s2s.detect_corners(picture)
    assert kinds_at(found, [[240, 200]]) == ["multi"]
    assert kinds_at(found, cube) == ["W"] * 6


def test_positions_are_right_to_a_fraction_of_a_pixel():
    for shape in (L_SHAPE, HEXAGON):
        truth = np.r_[shape, shape + DEPTH] + 0.37
        found = s2s.detect_corners(prism(shape + 0.37, shape + DEPTH + 0.37)).vertices
        gap = np.linalg.norm(found[:, None] - truth[None], axis=2).min(axis=0)
        assert np.median(gap) < 0.5
        assert gap.max() < 1.0


def test_positions_are_those_of_the_picture_whatever_size_it_is_worked_on():
    big = cv2.resize(prism(SQUARE, SQUARE + DEPTH), None, fx=6, fy=6, interpolation=cv2.INTER_CUBIC)
    ink = s2s.find_ink(s2s.read_picture(big))
    assert ink.scale < 1
    truth = (np.r_[SQUARE, SQUARE + DEPTH] + 0.5) * 6 - 0.5
    found = s2s.detect_corners(ink)
    assert None not in kinds_at(found, truth, 5.0)
    assert np.array_equal(found.points, s2s.detect_corners(big).points)


def test_dashed_lines_have_corners_where_they_meet_and_none_at_every_dash():
    found = s2s.detect_corners(prism(SQUARE, SQUARE + DEPTH, "dashed"))
    assert kinds_at(found, [SQUARE[3] + DEPTH], 4.0) != [None]
    assert found.is_vertex.sum() <= 10


def test_only_what_the_chosen_detector_sees_counts():
    # a bend of eight degrees: a vertex to the strokes, but no gradient to speak of in a second direction
    picture = line(line(paper(), [60, 200], [240, 200]), [240, 200], [420, 175])
    found = s2s.detect_corners(picture, "harris")
    assert found.harris.all()
    assert s2s.detect_corners(picture, "shi-tomasi").shi_tomasi.all()
    assert not found.is_vertex.any()


def test_blank_paper_has_no_corners():
    found = s2s.detect_corners(paper())
    assert len(found) == 0
    assert found.vertices.shape == (0, 2)


def test_bad_requests_are_told_apart():
    with pytest.raises(UsageError, match="fast"):
        s2s.detect_corners(paper(), "fast")
    with pytest.raises(UnreadableError):
        s2s.detect_corners(b"no picture")
