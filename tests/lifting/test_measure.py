import numpy as np
import pytest

from sketch2shape.errors import UsageError
from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [300, 100], [300, 200], [100, 200.0]])
BOX = TwoFaceObject(FACE, FACE + [30, -40])


def axonometric(size, azimuth=35.0, elevation=28.0):
    """A box of this width, height and depth, seen from its front, the left and above."""
    w, h, d = np.asarray(size, float) * 60.0
    front = np.array([[0, 0, 0], [w, 0, 0], [w, -h, 0], [0, -h, 0]])
    solid = np.concatenate([front, front + [0, 0, d]])
    a, e = np.deg2rad([azimuth, elevation])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    view = (solid @ yaw.T @ pitch)[:, :2] + 300
    return TwoFaceObject(view[:4], view[4:])


def sizes(obj=BOX, **options):
    solid = lift(obj, options=LiftOptions(**options))
    return solid.dimensions, solid.unit, solid.warnings


def test_width_sets_the_scale():
    dimensions, unit, _ = sizes(width="40mm")
    assert dimensions == pytest.approx((40.0, 20.0, 20.0))
    assert unit == "mm"


def test_a_depth_that_the_drawing_leaves_free_is_taken():
    dimensions, _, warnings = sizes(height="20mm", depth="1cm")
    assert dimensions == pytest.approx((40.0, 20.0, 10.0))
    assert not warnings


def test_depth_alone_sets_the_scale_in_a_real_unit_but_not_in_pixels():
    assert sizes(depth="50mm")[0] == pytest.approx((100.0, 50.0, 50.0))
    assert sizes(depth=70)[0] == pytest.approx((200.0, 100.0, 70.0))


def test_sizes_against_the_drawing_win_and_it_is_said_by_how_much():
    dimensions, _, warnings = sizes(width="40mm", height="30mm")
    assert dimensions == pytest.approx((40.0, 30.0, 20.0))
    assert any("together" in w and "+50%" in w for w in warnings)


def test_all_three_can_be_given():
    dimensions, _, warnings = sizes(axonometric([2, 1, 1.5]), width="40mm", height="20mm", depth="15mm")
    assert dimensions == pytest.approx((40.0, 20.0, 15.0))
    assert len(warnings) == 1
    assert "depth was changed by -50%" in warnings[0]


def test_fit_scales_the_largest():
    dimensions, unit, _ = sizes(axonometric([2, 1, 1.5]), fit="50mm")
    assert dimensions == pytest.approx((50.0, 25.0, 37.5), rel=0.01)
    assert unit == "mm"
    with pytest.raises(UsageError):
        LiftOptions(fit="50mm", width="20mm")


def test_what_is_assumed_is_said():
    assert any("depth free" in w for w in sizes()[2])
    assert any("one pixel" in w for w in sizes(unit="mm")[2])


def test_sizes_are_those_of_the_upright_solid_where_it_stands_on_its_face():
    """A hexagonal prism on end: its height is the distance between its faces."""
    t = 0.3 + np.arange(6) * np.pi / 3
    top = np.c_[400 + 180 * np.cos(t), 180 + 70 * np.sin(t)]
    obj = TwoFaceObject(top, top + [0, 350.0])
    solid = lift(obj, options=LiftOptions(height="50mm"))
    assert solid.dimensions[1] == pytest.approx(50.0)
    assert np.ptp(solid.vertices[:, 2]) == pytest.approx(50.0)
    assert solid.vertices[:6, 2] == pytest.approx(50.0)
    assert solid.vertices[6:, 2] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(("up", "axis"), [("y", 1), ("z", 2)])
def test_upright_solid_stands_on_the_ground_centred(up, axis):
    solid = lift(BOX, options=LiftOptions(up=up))
    assert solid.vertices[:, axis].min() == pytest.approx(0.0)
    assert np.ptp(solid.vertices[:, axis]) == pytest.approx(100.0)
    top_of_drawing = BOX.f1[:, 1].argmin()
    assert solid.vertices[top_of_drawing, axis] == pytest.approx(100.0)
    assert solid.volume == pytest.approx(lift(BOX).volume)
    middle = 0.5 * (solid.vertices.min(axis=0) + solid.vertices.max(axis=0))
    assert np.delete(middle, axis) == pytest.approx(0.0, abs=1e-9)


def test_front_is_before_back_in_the_upright_frame():
    vertices = lift(BOX).vertices
    assert (vertices[:4, 1] < vertices[4:, 1]).all()
    assert vertices[1, 0] > vertices[0, 0]


def test_upright_turns_but_never_mirrors():
    flat, stood = lift(BOX, options=LiftOptions(up="camera")).vertices, lift(BOX).vertices
    frame = np.linalg.lstsq(flat - flat.mean(axis=0), stood - stood.mean(axis=0), rcond=None)[0]
    assert np.linalg.det(frame) == pytest.approx(1.0)
