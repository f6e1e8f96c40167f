"""Points of arcs that are the same ones on both faces, and what is known of them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.lifting.bent import bent_faces
from sketch2shape.model import DrawnArc, Ellipse, TwoFaceObject
from tests.lifting.round_views import CIRCLE, HALF, HOLE, SLOT, SQUARE, Drawer, axonometric


def drawn(rings, scale=1.0):
    return Drawer(axonometric()).draw(rings, 1.0, scale)


@pytest.mark.parametrize("rings", [[CIRCLE], [CIRCLE, HOLE], [HALF], [SLOT, HOLE], [SQUARE, HOLE]])
def test_points_of_the_back_face_are_those_of_the_front_face_moved(rings):
    first, second, bent = bent_faces(drawn(rings))
    shift = second - first
    assert np.ptp(shift, axis=0).max() < 0.2
    assert bent.vertices == sum(len(points) for points, _ in rings)
    assert len(bent.arcs) == sum(len(arcs) for _, arcs in rings)
    assert bent.middle.sum() == pytest.approx(1.0)


def test_a_tapered_back_face_is_the_front_face_drawn_together():
    first, second, _ = bent_faces(drawn([CIRCLE], 0.5))
    small, large = (p - p.mean(axis=0) for p in (second, first))
    assert small == pytest.approx(0.5 * large, abs=0.2)


@given(st.floats(0, 180), st.floats(0.1, 1.0))
def test_the_order_of_an_ellipses_axes_does_not_matter(angle, ratio):
    faces = []
    for axes, turn in (((80.0, 80.0 * ratio), angle), ((80.0 * ratio, 80.0), angle + 90.0)):
        ellipse = Ellipse(np.array([200.0, 100.0]), axes, turn)
        arcs = tuple(DrawnArc(face, None, None, None, ellipse, np.zeros((9, 2))) for face in ("f1", "f2"))
        faces.append(bent_faces(TwoFaceObject([], [], arcs=arcs))[0])
    assert faces[0] == pytest.approx(faces[1], abs=1e-6)


def test_the_middle_is_the_centroid_in_every_affine_view():
    drawer = Drawer(axonometric())
    first, _, bent = bent_faces(drawer.draw([HALF], 1.0))
    # of a half disc: 4 / (3 pi) of the radius from the diameter
    (true,) = drawer.at(np.array([[0.0, 4 / (3 * np.pi)]]), 0.0)
    assert bent.middle @ first == pytest.approx(true, abs=3.0)
    turned = first @ np.array([[0.3, 1.2], [-0.9, 0.4]]) + 7
    assert bent.middle @ turned == pytest.approx((bent.middle @ first) @ np.array([[0.3, 1.2], [-0.9, 0.4]]) + 7)


def test_lengths_are_of_straight_edges_and_then_of_arcs():
    first, _, bent = bent_faces(drawn([SLOT]))
    assert len(bent.ends) == 2
    assert len(bent.lengths(first)) == 2 + 2 * 3
    assert bent.lengths(2 * first) == pytest.approx(2 * bent.lengths(first))
