import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.lifting.parallel import axonometric_maps, axonometric_shape
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [260, 100], [260, 200], [180, 240], [100, 200.0]])
D = np.array([60.0, -80.0])


def test_an_axonometric_solid_projects_back_onto_its_drawing():
    shape = axonometric_shape(FACE, [5], D, np.deg2rad(40.0))
    assert shape.vertices[:5, :2] == pytest.approx(FACE)
    assert shape.vertices[5:, :2] == pytest.approx(FACE + D)
    assert (shape.vertices[5:, 2] > shape.vertices[:5, 2]).all()
    assert shape.depth == pytest.approx(100.0 / np.sin(np.deg2rad(40.0)))
    assert shape.pose @ shape.pose.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(shape.pose) == pytest.approx(1.0)


def test_the_map_stretches_along_d_only():
    (stretch,) = axonometric_maps(np.array([np.pi / 3]), D)
    t, n = D / 100.0, np.array([80.0, 60.0]) / 100.0
    assert t @ stretch == pytest.approx(2.0 * t)
    assert n @ stretch == pytest.approx(n)


def test_receding_edges_as_long_as_a_face_edge_are_cavalier():
    square = np.array([[0, 0], [100, 0], [100, 100], [0, 100.0]]) + 200
    assert lift(TwoFaceObject(square, square + D)).dimensions == pytest.approx((100, 100, 100))
    assert lift(TwoFaceObject(square, square + D / 2)).dimensions == pytest.approx((100, 100, 100))
    assert lift(TwoFaceObject(square, square + 0.7 * D)).dimensions == pytest.approx((100, 100, 140))


def test_a_view_straight_down_the_edges_is_not_oblique():
    """Receding edges drawn along the face's own would hide the sides."""
    ell = np.array([[0, 0], [0, 54], [60, 54], [60, 162], [120, 162], [120, 0.0]]) + 200
    assert lift(TwoFaceObject(ell, ell + [0, -30])).projection.family == "axonometric"
    assert lift(TwoFaceObject(ell, ell + [21, -21])).projection.family == "oblique"


def test_a_frustum_in_an_orthographic_view_has_its_true_face():
    base = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1.0]])
    solid = np.concatenate([np.c_[base, np.zeros(4)], np.c_[0.5 * base, np.full(4, 1.5)]])
    a, e = np.deg2rad([40.0, 30.0])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    view = (solid @ yaw.T @ pitch.T)[:, :2] * 100 + 300
    got = lift(TwoFaceObject(view[:4], view[4:]), options=LiftOptions(beautify=False))
    assert got.projection.family == "axonometric"
    assert got.dimensions == pytest.approx((200, 200, 150), rel=0.02)
