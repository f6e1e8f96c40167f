import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model.drawing import TwoFaceObject

STAIRS = np.array([[0, 0], [3, 0], [3, 1], [2, 1], [2, 2], [1, 2], [1, 3], [0, 3.0]]) * 60 + 200
HEXAGON = np.array([[np.cos(t), np.sin(t)] for t in np.arange(6) * np.pi / 3]) * 100 + 300


def shaky(face, noise, seed=0, d=(70.0, -50.0)):
    rng = np.random.default_rng(seed)
    return TwoFaceObject(
        face + rng.normal(0, noise, face.shape), face + d + rng.normal(0, noise, face.shape), noise=noise
    )


def edges(solid, n):
    ring = solid.vertices[:n]
    return np.roll(ring, -1, axis=0) - ring


def test_nearly_right_angles_and_equal_steps_become_exact():
    e = edges(lift(shaky(STAIRS, 0.7), options=LiftOptions(up="camera")), 8)
    turn = (e * np.roll(e, -1, axis=0)).sum(axis=1) / np.linalg.norm(e, axis=1) ** 2
    assert turn == pytest.approx(0.0, abs=1e-9)
    length = np.linalg.norm(e, axis=1)
    assert length[1:7] == pytest.approx(length[1])
    assert length[[0, 7]] == pytest.approx(length[0])
    assert e[0, 1] == pytest.approx(0.0, abs=1e-9)


def test_nearly_regular_polygon_becomes_regular():
    e = edges(lift(shaky(HEXAGON, 0.7)), 6)
    length = np.linalg.norm(e, axis=1)
    assert length == pytest.approx(length[0])


def test_it_can_be_switched_off():
    obj = shaky(STAIRS, 0.7)
    plain = lift(obj, options=LiftOptions(beautify=False, up="camera"))
    assert plain.vertices[:8, :2] == pytest.approx(0.5 * (obj.f1 + obj.f2 - (obj.f2 - obj.f1).mean(axis=0)))


def test_a_clear_slope_stays():
    trapezoid = np.array([[0, 0], [200, 12], [200, 100], [0, 100.0]]) + 200
    got = lift(shaky(trapezoid, 0.3), options=LiftOptions(up="camera")).vertices[:4, :2]
    assert got[1, 1] - got[0, 1] == pytest.approx(12, abs=1.0)


@settings(deadline=None, max_examples=50)
@given(st.integers(3, 12), st.integers(0, 10_000), st.sampled_from([0.3, 1.0, 3.0]))
def test_no_vertex_moves_further_than_the_noise_allows(n, seed, noise):
    rng = np.random.default_rng(seed)
    turn = np.sort(rng.uniform(0, 2 * np.pi, n))
    face = 300 + rng.uniform(40, 150, (n, 1)) * np.c_[np.cos(turn), np.sin(turn)]
    obj = TwoFaceObject(face, face + [80.0, -37.0], noise=noise)
    options = {"projection": "oblique", "up": "camera"}
    fine = lift(obj, options=LiftOptions(**options)).vertices
    plain = lift(obj, options=LiftOptions(**options, beautify=False)).vertices
    # 3.5 standard deviations of the mean of two vertices, each half as shaky again as was told
    assert np.linalg.norm((fine - plain)[:n, :2], axis=1).max() <= 3.5 * 1.5 * noise * np.sqrt(0.5) + 1e-6


def test_nearly_a_cube_becomes_one_but_an_oblique_depth_is_left_alone():
    corners = np.array([[x, y, z] for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], float)
    a, e = np.deg2rad([45.0, 35.264])
    yaw = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    pitch = np.array([[1, 0, 0], [0, np.cos(e), np.sin(e)], [0, -np.sin(e), np.cos(e)]])
    view = (corners @ yaw.T @ pitch.T)[:, :2] * 70 + 300 + np.random.default_rng(1).normal(0, 0.4, (8, 2))
    cube = lift(TwoFaceObject(view[:4], view[4:], noise=0.4))
    assert cube.projection.family == "axonometric"
    assert cube.dimensions == pytest.approx([cube.dimensions[0]] * 3)
    square = np.array([[0, 0], [100, 0], [100, 100], [0, 100.0]]) + 200
    flat = lift(TwoFaceObject(square, square + [60, -45]), options=LiftOptions(depth_ratio=0.7))
    assert flat.dimensions[2] == pytest.approx(75 / 0.7)


def test_lengths_known_only_roughly_stay_as_they_are():
    """Three pixels in a hundred are nothing to a shaky hand, but a very shaky one says nothing about lengths at all."""
    near = np.array([[0, 0], [100, 0], [100, 30], [40, 30], [40, 103], [0, 103.0]]) + 200
    exact = lift(TwoFaceObject(near, near + [70, -50], noise=1.8)).dimensions
    assert exact[0] == pytest.approx(exact[1])
    apart = near + [0, 57] * (near[:, 1:] > 300)
    rough = lift(TwoFaceObject(apart, apart + [70, -50], noise=8.0)).dimensions
    assert rough[1] - rough[0] == pytest.approx(60.0)
