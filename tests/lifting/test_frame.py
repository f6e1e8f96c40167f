import numpy as np
import pytest

from sketch2shape.lifting.frame import own_axes, upright

PARALLELOGRAM = np.array([[0, 0], [4, 0], [5, -2], [1, -2.0]])


def flat(ring):
    return np.c_[ring, np.zeros(len(ring))]


@pytest.mark.parametrize("degrees", [0.0, 20.0, -30.0])
def test_width_follows_the_longest_edges(degrees):
    t = np.deg2rad(degrees)
    ring = PARALLELOGRAM @ np.array([[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]])
    axes = own_axes(flat(ring), np.array([0.0, 0.0, 3.0]), [4])
    assert axes[0] == pytest.approx([np.cos(t), np.sin(t), 0.0])
    assert axes[2] == pytest.approx([0.0, 0.0, 1.0])
    assert np.linalg.det(axes) == pytest.approx(1.0)


def test_a_face_without_a_main_direction_is_level_as_seen():
    turn = np.arange(7) * 2 * np.pi / 7 + 0.3
    axes = own_axes(flat(np.c_[np.cos(turn), np.sin(turn)]), np.array([0.0, 0.0, 1.0]), [7])
    assert axes == pytest.approx(np.eye(3))


@pytest.mark.parametrize(("up", "axis"), [("y", 1), ("z", 2)])
def test_upright_rests_on_its_base(up, axis):
    vertices = np.concatenate([flat(PARALLELOGRAM), flat(PARALLELOGRAM) + [0, 0, 3]])
    axes = own_axes(vertices[:4], np.array([0.0, 0.0, 3.0]), [4])
    stood, turned = upright(vertices, axes, up)
    assert stood[[0, 1, 4, 5], axis] == pytest.approx(0.0)
    assert stood[[2, 3, 6, 7], axis] == pytest.approx(2.0)
    assert np.linalg.det(turned) == pytest.approx(1.0)


def test_a_face_without_any_extent_leans_nowhere():
    assert np.isfinite(own_axes(np.zeros((4, 3)), np.array([0.0, 0, 5]), [4])).all()
