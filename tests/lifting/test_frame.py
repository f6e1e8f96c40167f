import numpy as np
import pytest

from sketch2shape.lifting.face import edge_vectors
from sketch2shape.lifting.frame import frame, own_axes, standing

PARALLELOGRAM = np.array([[0, 0], [4, 0], [5, -2], [1, -2.0]])


def flat(ring):
    return np.c_[ring, np.zeros(len(ring))]


@pytest.mark.parametrize("degrees", [0.0, 20.0, -30.0])
def test_width_follows_the_longest_edges(degrees):
    t = np.deg2rad(degrees)
    ring = PARALLELOGRAM @ np.array([[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]])
    axes = own_axes(edge_vectors(flat(ring), [4]), np.array([0.0, 0.0, 3.0]))
    assert axes[0] == pytest.approx([np.cos(t), np.sin(t), 0.0])
    assert axes[2] == pytest.approx([0.0, 0.0, 1.0])
    assert np.linalg.det(axes) == pytest.approx(1.0)


def test_a_face_without_a_main_direction_is_level_as_seen():
    turn = np.arange(7) * 2 * np.pi / 7 + 0.3
    axes = own_axes(edge_vectors(flat(np.c_[np.cos(turn), np.sin(turn)]), [7]), np.array([0.0, 0.0, 1.0]))
    assert axes == pytest.approx(np.eye(3))


def test_an_upright_object_looks_as_it_is_seen():
    """Own axes in any order and sense: up is the one seen most nearly vertical, away the one most along the view."""
    seen = np.array([[0.8, 0.1, 0.6], [-0.6, 0.0, 0.8], [0.08, -0.995, 0.06]])
    looks = standing(seen[[2, 0, 1]] * [[-1], [-1], [1]])
    assert looks[1, 1] < -0.9
    assert looks[2, 2] > 0.7
    assert looks[0, 0] > 0.7


@pytest.mark.parametrize("up", ["z", "y", "camera"])
def test_frames_are_right_handed(up):
    looks = standing(np.eye(3))
    assert np.linalg.det(frame(looks, up)) == pytest.approx(1.0)
    if up != "camera":
        assert frame(looks, up)["xyz".index(up)] == pytest.approx(looks[1])


def test_a_face_without_any_extent_leans_nowhere():
    assert np.isfinite(own_axes(np.zeros((4, 3)), np.array([0.0, 0, 5]))).all()


@pytest.mark.parametrize("seed", range(8))
def test_a_right_triangle_rests_on_a_leg_not_on_its_longest_side(seed):
    """By Pythagoras the squares of its legs are those of its longest side: noise must not choose."""
    ring = np.array([[0, 0], [260, 0], [260, -215.0]]) + np.random.default_rng(seed).normal(0, 2, (3, 2))
    axes = own_axes(edge_vectors(flat(ring), [3]), np.array([0.0, 0.0, 300.0]))
    assert abs(axes[0, 0]) > 0.999
