import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [300, 100], [300, 200], [100, 200.0]])
BOX = TwoFaceObject(FACE, FACE + [30, -40])


def sizes(**options):
    solid = lift(BOX, options=LiftOptions(**options))
    return solid.dimensions, solid.unit, solid.warnings


def test_width_sets_the_scale():
    dimensions, unit, _ = sizes(width="40mm")
    assert dimensions == pytest.approx((40.0, 20.0, 20.0))
    assert unit == "mm"


def test_height_sets_the_scale_and_depth_is_free():
    dimensions, _, warnings = sizes(height="20mm", depth="1cm")
    assert dimensions == pytest.approx((40.0, 20.0, 10.0))
    assert not warnings


def test_depth_alone_sets_the_scale_in_a_real_unit_but_not_in_pixels():
    assert sizes(depth="50mm")[0] == pytest.approx((100.0, 50.0, 50.0))
    assert sizes(depth=70)[0] == pytest.approx((200.0, 100.0, 70.0))


def test_what_is_assumed_is_said():
    assert any("depth free" in w for w in sizes()[2])
    assert any("one pixel" in w for w in sizes(unit="mm")[2])
    assert any("together" in w for w in sizes(width="40mm", height="40mm")[2])


@pytest.mark.parametrize(("up", "axis"), [("y", 1), ("z", 2)])
def test_upright_solid_stands_on_the_ground(up, axis):
    solid = lift(BOX, options=LiftOptions(up=up))
    assert solid.vertices[:, axis].min() == pytest.approx(0.0)
    assert np.ptp(solid.vertices[:, axis]) == pytest.approx(100.0)
    top_of_drawing = BOX.f1[:, 1].argmin()
    assert solid.vertices[top_of_drawing, axis] == pytest.approx(100.0)
    assert solid.volume == pytest.approx(lift(BOX).volume)


def test_upright_turns_but_never_mirrors():
    flat, stood = lift(BOX).vertices, lift(BOX, options=LiftOptions(up="z")).vertices
    frame = np.linalg.lstsq(flat - flat.mean(axis=0), stood - stood.mean(axis=0), rcond=None)[0]
    assert np.linalg.det(frame) == pytest.approx(1.0)
