"""The object in the picture: rings, arcs, a point."""

from __future__ import annotations

import numpy as np
import pytest

from sketch2shape.errors import PointsError
from sketch2shape.model import DrawnArc, Ellipse, TwoFaceObject


def test_a_pyramid_joins_each_vertex_of_its_base_to_one_apex():
    pyramid = TwoFaceObject([[0, 0], [9, 0], [5, 8]], [[4, -9]])
    assert pyramid.is_pointed
    assert pyramid.edges.tolist() == [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]]
    with pytest.raises(PointsError, match="point"):
        pyramid.swapped()


def test_a_cylinder_has_arcs_and_no_vertices():
    rim = Ellipse(np.array([50.0, 20.0]), (30.0, 10.0), 0.0)
    arcs = tuple(DrawnArc(face, None, None, None, rim, np.zeros((9, 2))) for face in ("f1", "f2"))
    cylinder = TwoFaceObject([], [], arcs=arcs)
    assert cylinder.is_round
    assert cylinder.vertices.shape == (0, 2)
    assert cylinder.edges.shape == (0, 2)
    assert [arc.face for arc in cylinder.swapped().arcs] == ["f2", "f1"]


def test_a_ring_of_a_line_and_an_arc_has_one_edge_each_way():
    half_disc = TwoFaceObject([[0, 0], [9, 0]], [[0, 5], [9, 5]])
    assert half_disc.edges.tolist() == [[0, 1], [1, 0], [2, 3], [3, 2], [0, 2], [1, 3]]


def test_outlines_follow_the_arcs():
    path = np.array([[0, 0], [5, -3], [10, 0.0]])
    ends = np.array([[0, 0], [10, 0.0]])
    arc = DrawnArc("f1", None, 0, 1, Ellipse(np.zeros(2), (1.0, 1.0), 0.0), path)
    half = TwoFaceObject(ends, ends + 4, arcs=(arc,))
    assert half.outlines("f1")[0].tolist() == [[0, 0], [5, -3], [10, 0]]
    assert half.outlines("f2")[0].tolist() == (ends + 4).tolist()
    assert TwoFaceObject(np.eye(3)[:, :2], [[9, 9]]).outlines("f2") == ()
