import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.lifting.perspective import facing_shape, perspective_shape
from sketch2shape.lifting.projection import prepare
from sketch2shape.model.drawing import TwoFaceObject

HOUSE = np.array([[-1, 1], [-1, -0.2], [0, -1.2], [1, -0.2], [1, 1.0]])


def seen(azimuth, elevation, focal, shift=(0.0, 0.0)):
    solid = np.concatenate([np.c_[HOUSE, np.full(5, -0.75)], np.c_[HOUSE, np.full(5, 0.75)]])
    a, e = np.deg2rad([azimuth, elevation])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    view = solid @ yaw.T @ pitch.T + [*shift, 7.0]
    flat = view[:, :2] / view[:, 2:] * focal + [320, 240]
    return prepare(TwoFaceObject(flat[:5], flat[5:])), view


def test_the_camera_is_found():
    drawing, _ = seen(35.0, 25.0, 900.0)
    shape = perspective_shape(drawing)
    assert shape.evidence["focal_px"] == pytest.approx(900.0, rel=0.1)
    assert shape.evidence["fit_rms_px"] < 0.3
    assert not shape.evidence["level_line_of_sight"]


def test_a_level_line_of_sight_is_told_by_its_horizon():
    drawing, _ = seen(40.0, 0.0, 900.0, shift=(0.0, 1.8))
    shape = perspective_shape(drawing)
    assert shape.evidence["level_line_of_sight"]
    assert shape.evidence["principal_point"][1] == pytest.approx(240.0, abs=1.0)


def test_the_solid_projects_back_onto_the_drawing():
    drawing, _ = seen(35.0, 25.0, 900.0)
    shape = perspective_shape(drawing)
    v = shape.vertices
    flat = v[:, :2] / v[:, 2:] * shape.evidence["focal_px"] + shape.evidence["principal_point"]
    assert np.abs(flat - np.concatenate([drawing.first, drawing.second])).max() < 0.5


def test_faces_exchanged_give_a_negative_depth():
    drawing, _ = seen(35.0, 25.0, 900.0)
    turned = prepare(TwoFaceObject(drawing.second, drawing.first))
    assert perspective_shape(drawing).depth > 0 > perspective_shape(turned).depth


def test_a_facing_prism_keeps_its_face_and_its_vanishing_point():
    drawing, view = seen(0.0, 0.0, 900.0, shift=(1.5, -1.0))
    shape = facing_shape(drawing, drawing.first)
    assert shape.flat == pytest.approx(drawing.first)
    assert shape.evidence["vanishing_point"] == pytest.approx([320, 240], abs=0.5)
    assert shape.depth > 0
    assert view[0, 2] < view[5, 2]


def test_a_prism_turned_a_little_is_no_frustum():
    """Its faces are nearly alike but for size, yet square corners tell the perspective."""
    drawing, view = seen(8.0, 6.0, 900.0, shift=(1.2, 1.0))
    loose = TwoFaceObject(drawing.first, drawing.second, noise=3.0)
    got = lift(loose, options=LiftOptions(beautify=False))
    assert got.projection.family == "perspective"
    assert got.dimensions[0] / got.dimensions[1] == pytest.approx(2.0 / 2.2, rel=0.1)
    assert view.shape == (10, 3)
