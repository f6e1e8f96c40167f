"""Pyramids over four sides as textbooks draw them: base level and receding, height plumb."""

import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.lifting.standing import standing_odds
from sketch2shape.model import TwoFaceObject
from sketch2shape.solids import shape_name

BASE = np.array([[100, 400], [300, 400], [370, 330], [170, 330.0]])
APEX = np.array([[235, 130.0]])


@pytest.mark.parametrize("turn", range(4))
@pytest.mark.parametrize("mirror", [1, -1])
def test_base_is_a_rectangle_and_the_height_as_drawn(turn, mirror):
    base = np.roll(BASE, turn, axis=0)[::mirror]
    solid = lift(TwoFaceObject(base, APEX, noise=1.0))
    assert solid.projection.evidence["reading"].startswith("standing")
    depth = 2 * float(np.hypot(70, 70))
    assert solid.dimensions == pytest.approx((200, 235, depth), rel=0.01)
    assert solid.vertices[-1, 2] == pytest.approx(235, rel=0.01)
    assert shape_name(solid).endswith("pyramid")
    seen = np.c_[solid.vertices, np.ones(5)] @ solid.camera.T
    assert seen[:, :2] == pytest.approx(np.vstack([base, APEX]), abs=1.0)
    assert any("depth free" in warning for warning in solid.warnings)


def test_the_ratio_and_the_depth_can_be_told():
    obj = TwoFaceObject(BASE, APEX, noise=1.0)
    cavalier = lift(obj, options=LiftOptions(depth_ratio=1.0))
    assert cavalier.dimensions[2] == pytest.approx(np.hypot(70, 70), rel=0.01)
    assert lift(obj, options=LiftOptions(depth="50mm", width="200mm")).dimensions == pytest.approx(
        (200, 235, 50), rel=0.01
    )


def test_it_needs_a_level_edge_a_plumb_height_and_a_base_aslant():
    d = np.array([0, -200.0])
    assert standing_odds(BASE, d, 1.0) is not None
    assert standing_odds(BASE, np.array([80, -200.0]), 1.0) is None
    turn = np.array([[np.cos(0.3), np.sin(0.3)], [-np.sin(0.3), np.cos(0.3)]])
    assert standing_odds(BASE @ turn, d, 1.0) is None
    assert standing_odds(np.array([[0, 0], [100, 0], [100, 80], [0, 80.0]]), d, 1.0) is None


def test_an_axonometric_pyramid_is_not_taken_for_one():
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1.0]])
    a, e = np.radians([25, 30])
    turned = square @ np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]])
    base = 100 * turned * [1, np.sin(e)] + [320, 300]
    solid = lift(TwoFaceObject(base, [[320, 300 - 150 * np.cos(e)]], noise=1.0))
    assert solid.projection.family == "axonometric"
    assert shape_name(solid) == "square pyramid"


def test_a_pyramid_seen_from_its_point_gets_a_height_and_a_warning():
    square = np.array([[100, 100], [200, 100], [200, 200], [100, 200.0]])
    solid = lift(TwoFaceObject(square, [[150, 150.0]]))
    assert any("over the middle of its base" in warning for warning in solid.warnings)
    assert solid.volume > 0
    assert shape_name(solid) == "square pyramid"


@pytest.mark.parametrize("corner", range(4))
def test_the_point_may_stand_over_a_corner(corner):
    apex = BASE[corner] + [0.5, -200.0]
    solid = lift(TwoFaceObject(BASE, [apex], noise=1.0))
    assert solid.dimensions == pytest.approx((200, 200, 2 * np.hypot(70, 70)), rel=0.01)
    assert solid.vertices[-1, :2] == pytest.approx(solid.vertices[corner, :2])
    seen = np.c_[solid.vertices, np.ones(5)] @ solid.camera.T
    assert seen[:, :2] == pytest.approx(np.vstack([BASE, apex]), abs=1.0)
    assert solid.volume == pytest.approx(np.prod(solid.dimensions) / 3, rel=1e-6)


def test_or_over_the_middle_of_an_edge():
    apex = BASE[:2].mean(axis=0) + [0, -200.0]
    solid = lift(TwoFaceObject(BASE, [apex], noise=1.0))
    assert solid.vertices[-1, :2] == pytest.approx(solid.vertices[:2, :2].mean(axis=0))
