"""Face separation: every reading a drawing allows, the best first."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, outline, paper, prism, same_object, shrunk

import sketch2shape as s2s
from sketch2shape.errors import PointsError, UnreadableError


def has_face(obj, ring, within=3.0):
    """Whether one of the object's faces has these vertices."""
    return any(
        len(face) == len(ring) and np.linalg.norm(face[:, None] - ring[None], axis=2).min(axis=0).max() <= within
        for face in (obj.f1, obj.f2)
    )


def test_a_wireframe_box_may_be_read_in_three_ways():
    readings = [o for o in s2s.separate_faces(prism(SQUARE, SQUARE + DEPTH)) if o.confidence > 0.9]
    assert len(readings) == 3
    side = np.array([SQUARE[0], SQUARE[3], SQUARE[3] + DEPTH, SQUARE[0] + DEPTH])
    top = np.array([SQUARE[0], SQUARE[1], SQUARE[1] + DEPTH, SQUARE[0] + DEPTH])
    for face in (SQUARE, side, top):
        assert sum(has_face(o, face) for o in readings) == 1
    assert all(same_object(o, SQUARE, SQUARE + DEPTH, 3.0) for o in readings)


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_hexagonal_prism_is_read_however_its_hidden_edges_are_drawn(lines):
    readings = s2s.separate_faces(prism(HEXAGON, HEXAGON + DEPTH, lines))
    assert has_face(readings[0], HEXAGON)
    assert readings[0].lines == lines
    assert same_object(readings[0], HEXAGON, HEXAGON + DEPTH, 4.0)
    assert [o.confidence for o in readings] == sorted((o.confidence for o in readings), reverse=True)
    assert readings[0].confidence > 0.95


def test_known_corners_are_used_as_they_are():
    f2 = shrunk(L_SHAPE, 0.7, np.array([400.0, 60]))
    corners = np.random.default_rng(0).permutation(np.r_[L_SHAPE, f2])
    best = s2s.separate_faces(prism(L_SHAPE, f2), corners=corners)[0]
    assert {tuple(p) for p in best.vertices.round(6)} == {tuple(p) for p in corners.round(6)}
    assert same_object(best, L_SHAPE, f2, 1e-6)


def test_readings_go_on_to_the_next_stage():
    assert s2s.lift(s2s.separate_faces(prism(L_SHAPE, L_SHAPE + DEPTH))[0]).volume > 0


def test_no_more_readings_than_asked_for():
    assert len(s2s.separate_faces(prism(SQUARE, SQUARE + DEPTH), most=2)) == 2


def test_a_triangle_by_itself_has_no_reading():
    assert s2s.separate_faces(outline(np.array([[50, 50], [250, 60], [120, 280]]))) == ()
    assert s2s.separate_faces(paper()) == ()


def test_corners_must_be_points_and_a_picture_a_picture():
    with pytest.raises(PointsError, match="at least 6"):
        s2s.separate_faces(paper(), corners=SQUARE)
    with pytest.raises(UnreadableError):
        s2s.separate_faces(b"nothing")
