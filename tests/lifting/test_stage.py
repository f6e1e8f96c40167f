"""Drawings made here from known solids, lifted and compared with them."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sketch2shape.errors import PointsError
from sketch2shape.export import to_trimesh
from sketch2shape.lifting import OTHER_PAIRS, LiftOptions, lift
from sketch2shape.lifting.measure import free_size
from sketch2shape.model.drawing import FacePair, TwoFaceObject

SQUARE = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1.0]])
L_SHAPE = np.array([[-1, -1], [0, -1], [0, 0.4], [1, 0.4], [1, 1], [-1, 1.0]])
HOUSE = np.array([[-1, 1], [-1, -0.2], [0, -1.2], [1, -0.2], [1, 1.0]])
PENTAGON = np.array([[np.sin(t), -np.cos(t)] for t in np.arange(5) * 2 * np.pi / 5])
HOLE = np.array([[-0.8, 0.5], [-0.2, 0.5], [-0.2, 0.9], [-0.8, 0.9]])


def solid(profile, depth, scale=1.0):
    back = profile * scale
    return np.concatenate([np.c_[profile, np.zeros(len(profile))], np.c_[back, np.full(len(back), depth)]])


def turned(points, azimuth, elevation):
    a, e = np.deg2rad([azimuth, elevation])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), -np.sin(e)], [0, np.sin(e), np.cos(e)]])
    return (points - points.mean(axis=0)) @ yaw.T @ pitch.T


def drawn(view, m=None, focal=None):
    flat = view[:, :2] * 100 + 300 if focal is None else view[:, :2] / (view[:, 2:] + focal) * focal * 100 + 300
    m = len(view) // 2 if m is None else m
    return TwoFaceObject(flat[:m], flat[len(flat) // 2 : len(flat) // 2 + m])


def misfit(got, want):
    """Relative rms distance after the best similarity without mirror."""
    a, b = got - got.mean(axis=0), want - want.mean(axis=0)
    u, s, vt = np.linalg.svd(a.T @ b)
    sign = np.array([1, 1, np.sign(np.linalg.det(u @ vt))])
    return np.linalg.norm((s @ sign) / (a**2).sum() * a @ (u * sign) @ vt - b) / np.linalg.norm(b)


@pytest.mark.parametrize("profile", [SQUARE, L_SHAPE, HOUSE, PENTAGON])
@pytest.mark.parametrize(("azimuth", "elevation"), [(45.0, 35.264), (-30.0, 25.0), (60.0, 40.0)])
def test_orthographic_view_gives_the_true_solid(profile, azimuth, elevation):
    true = solid(profile, 1.5)
    got = lift(drawn(turned(true, azimuth, -elevation)))
    assert got.projection.family == "axonometric"
    assert misfit(got.vertices, true) < 0.01


@pytest.mark.parametrize("profile", [SQUARE, L_SHAPE, HOUSE, PENTAGON])
@pytest.mark.parametrize(("azimuth", "elevation"), [(35.0, 25.0), (-50.0, 35.0), (40.0, 0.0)])
def test_perspective_gives_the_true_solid(profile, azimuth, elevation):
    true = solid(profile, 1.5)
    view = turned(true, azimuth, -elevation) + [0, 2.0 * (elevation == 0), 0]
    got = lift(drawn(view, focal=8.0))
    assert got.projection.family == "perspective"
    assert misfit(got.vertices, true) < 0.03


def test_one_point_perspective_says_what_it_assumes():
    view = solid(HOUSE, 1.5) + [2.0, 1.5, 0.0]
    got = lift(drawn(view, focal=6.0))
    assert got.projection.family == "perspective"
    assert misfit(got.vertices[:5], solid(HOUSE, 1.5)[:5]) < 1e-6
    assert any("focal length" in w for w in got.warnings)


@pytest.mark.parametrize("ratio", [None, 0.5, 1.0])
def test_oblique_face_is_true_and_its_depth_a_stated_default(ratio):
    face = HOUSE * 100 + 300
    got = lift(TwoFaceObject(face, face + [60, -45]), options=LiftOptions(depth_ratio=ratio, up="camera"))
    assert got.projection.family == "oblique"
    assert got.vertices[:5, :2] == pytest.approx(face)
    assert got.dimensions[2] == pytest.approx(75.0 / (ratio or 0.5))
    assert bool(got.warnings) == (ratio is None)


@pytest.mark.parametrize("order", [[0, 1, 5, 4, 3, 2, 6, 7], [1, 2, 6, 5, 0, 3, 7, 4]])
def test_box_is_the_same_whichever_sides_are_called_faces(order):
    face = SQUARE * [120, 80] + 300
    obj = TwoFaceObject(face, face + [60, -45])
    points = obj.vertices[order]
    got = lift(TwoFaceObject(points[:4], points[4:])).vertices
    want = lift(obj).vertices[order]
    assert misfit(got, want) < 1e-6


def test_back_face_of_another_size_is_a_frustum_with_a_straight_axis():
    face = HOUSE * 100 + 300
    got = lift(TwoFaceObject(face, face * 0.5 + [230.0, 90.0]))
    assert np.linalg.norm(got.vertices[6] - got.vertices[5]) == pytest.approx(0.5 * np.linalg.norm(face[1] - face[0]))
    assert np.abs(np.ptp(got.vertices[5:, 1])) < 1e-9
    assert any("tapered" in w for w in got.warnings)


def test_hole_and_outline_share_a_plane_and_make_a_closed_solid():
    true = np.concatenate([L_SHAPE, HOLE])
    view = turned(solid(true, 1.5), 40.0, -30.0)
    flat = view[:, :2] * 100 + 300
    obj = TwoFaceObject(flat[:6], flat[10:16], (FacePair(flat[6:10], flat[16:]),))
    got = lift(obj)
    assert misfit(got.vertices, solid(true, 1.5)) < 0.01
    mesh = to_trimesh(got)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(got.volume)
    assert mesh.euler_number == 0


def test_mirrored_reading_has_the_same_drawing_and_the_opposite_depths():
    obj = drawn(turned(solid(L_SHAPE, 1.5), 40.0, -30.0))
    near, far = (lift(obj, options=LiftOptions(necker=n, up="camera")).vertices for n in (False, True))
    assert far == pytest.approx(near * [1, 1, -1])
    assert to_trimesh(lift(obj, options=LiftOptions(necker=True))).volume > 0


def test_projection_can_be_imposed():
    obj = drawn(turned(solid(L_SHAPE, 1.5), 40.0, -30.0))
    oblique = lift(obj, options=LiftOptions(projection="oblique", up="camera"))
    assert oblique.projection.family == "oblique"
    assert oblique.vertices[:6, :2] == pytest.approx(obj.f1)
    parallel = lift(obj, options=LiftOptions(projection="perspective"))
    assert any("parallel" in w for w in parallel.warnings)


CAMERA_CASES = {
    "oblique": TwoFaceObject(HOUSE * 100 + 300, HOUSE * 100 + 300 + [60, -45]),
    "axonometric": drawn(turned(solid(L_SHAPE, 1.5), 40.0, -30.0)),
    "standing": drawn(turned(solid(L_SHAPE, 1.5)[:, [0, 2, 1]], 40.0, -30.0)),
    "one-point": drawn(solid(HOUSE, 1.5) + [2.0, 1.5, 0.0], focal=6.0),
    "perspective": drawn(turned(solid(L_SHAPE, 1.5), 35.0, -25.0), focal=8.0),
    "tapered": TwoFaceObject(HOUSE * 100 + 300, HOUSE * 50 + [380, 240]),
    "default": TwoFaceObject(SQUARE * 100 + 300, SQUARE * 100 + 300.001),
}


@pytest.mark.parametrize("name", CAMERA_CASES)
@pytest.mark.parametrize("options", [{}, {"up": "camera"}, {"up": "y", "width": "40mm"}, {"necker": True}])
def test_the_camera_takes_every_vertex_back_onto_the_found_one(name, options):
    obj = CAMERA_CASES[name]
    got = lift(obj, options=LiftOptions(**options))
    seen = np.c_[got.vertices, np.ones(len(got.vertices))] @ got.camera.T
    limit = 1.0 if got.projection.family == "perspective" else 0.1
    assert np.abs(seen[:, :2] / seen[:, 2:] - obj.vertices).max() < limit
    if got.projection.family != "perspective":
        assert got.camera[2] == pytest.approx([0, 0, 0, 1])


def test_the_camera_sees_through_a_tilted_page():
    tilt = np.array([[1.0, 0.1, 5.0], [0.05, 1.1, -8.0], [2e-4, 3e-4, 1.0]])
    flat = np.c_[CAMERA_CASES["oblique"].vertices, np.ones(10)] @ np.linalg.inv(tilt).T
    points = flat[:, :2] / flat[:, 2:]
    got = lift(TwoFaceObject(points[:5], points[5:], page=tilt))
    seen = np.c_[got.vertices, np.ones(10)] @ got.camera.T
    assert np.abs(seen[:, :2] / seen[:, 2:] - points).max() < 0.1


def test_sizes_against_the_drawing_still_project_back():
    obj = CAMERA_CASES["axonometric"]
    got = lift(obj, options=LiftOptions(width="40mm", height="50mm", depth="10mm"))
    seen = np.c_[got.vertices, np.ones(len(got.vertices))] @ got.camera.T
    assert np.abs(seen[:, :2] - obj.vertices).max() < 0.1


def test_an_isometric_cube_forty_wide_is_a_cube_on_the_table():
    cube = solid(SQUARE, 2.0)
    got = lift(drawn(turned(cube, 45.0, -35.264)), options=LiftOptions(width="40mm"))
    assert got.dimensions == pytest.approx((40.0, 40.0, 40.0))
    assert np.ptp(got.vertices, axis=0) == pytest.approx(40.0)
    assert got.vertices[:, 2].min() == pytest.approx(0.0)


def test_no_depth_at_all_gets_a_default_and_a_warning():
    face = SQUARE * 100 + 300
    got = lift(TwoFaceObject(face, face + 1e-3))
    assert np.isfinite(got.vertices).all()
    assert got.dimensions == pytest.approx((200.0, 200.0, 100.0))
    assert any("coincide" in w for w in got.warnings)


def test_face_seen_from_its_edge_gets_a_default_and_a_warning():
    face = SQUARE * [100, 0.1] + 300
    got = lift(TwoFaceObject(face, face + [50, -50]))
    assert np.isfinite(got.vertices).all()
    assert any("edge" in w for w in got.warnings)


def test_coordinates_that_are_no_numbers_are_refused():
    with pytest.raises(PointsError):
        lift(TwoFaceObject(SQUARE * np.nan, SQUARE))


@settings(deadline=None, max_examples=80)
@example(4, 400, 1.0)
@given(st.integers(3, 12), st.integers(0, 10_000), st.floats(0.0, 1.0))
def test_any_two_faces_give_a_finite_closed_solid(n, seed, mix):
    rng = np.random.default_rng(seed)
    turn = np.sort(rng.uniform(0, 2 * np.pi, n))
    face = 300 + rng.uniform(40, 150, (n, 1)) * np.c_[np.cos(turn), np.sin(turn)]
    back = face + rng.uniform(-200, 200, 2) + mix * rng.normal(0, 30, (n, 2))
    got = lift(TwoFaceObject(face, back))
    assert got.vertices.shape == (2 * n, 3)
    assert np.abs(got.vertices).max() < 1e5
    mesh = to_trimesh(got)
    assert mesh.is_watertight
    assert mesh.volume > 0


@pytest.mark.parametrize("order", OTHER_PAIRS)
def test_an_oblique_box_leaves_its_depth_free_whatever_sides_are_its_faces(order):
    front = np.array([(100, 200), (300, 200), (300, 380), (100, 380.0)])
    points = np.concatenate([front, front + (120, -90)])[order]
    solid = lift(TwoFaceObject(points[:4], points[4:]))
    assert free_size(solid.warnings) == "depth"
    sized = lift(TwoFaceObject(points[:4], points[4:]), options=LiftOptions(width="40mm", depth="90mm"))
    assert sized.dimensions == pytest.approx((40, 36, 90), rel=0.01)
    assert not sized.warnings
