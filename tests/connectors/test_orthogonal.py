import numpy as np
import pytest

from sketch2shape.connectors import connect, connect_detailed
from sketch2shape.errors import PointsError

VIEWS = {
    "as drawn": np.eye(2),
    "turned": np.array([[0.8, -0.6], [0.6, 0.8]]),
    "sheared": np.array([[1.0, 0.4], [0.0, 1.0]]),
    "isometric": np.array([[0.866, 0.5], [-0.866, 0.5]]),
}


@pytest.mark.parametrize("view", VIEWS)
def test_rectilinear_faces_in_any_parallel_view(view, rectilinear, shapes, shuffle, same_ring):
    points, order = shuffle(shapes[rectilinear] @ VIEWS[view])
    assert same_ring(connect(points, "orthogonal"), order)


def test_axes_only_is_orourkes_form(shapes, shuffle, same_ring):
    points, order = shuffle(shapes["comb"])
    assert same_ring(connect(points, "orthogonal", directions="axes", tolerance=0.0), order)
    with pytest.raises(PointsError, match="along the axes"):
        connect(points @ VIEWS["turned"], "orthogonal", directions="axes")


def test_noise_within_the_tolerance(rectilinear, shapes, shuffle, same_ring):
    points, order = shuffle(shapes[rectilinear] @ VIEWS["turned"])
    noise = np.random.default_rng(3).uniform(-0.02, 0.02, points.shape)
    assert same_ring(connect(points + noise, "orthogonal"), order)


@pytest.mark.parametrize("shape_name", ["triangle", "house"])
def test_no_pairing_is_said(shapes, shape_name):
    with pytest.raises(PointsError, match="pair up"):
        connect(shapes[shape_name], "orthogonal")


def test_four_on_a_line_pair_up_from_the_end(shapes):
    # the feet of the U: 0-1 and 2-3 along the top line, not 1-2
    found = connect_detailed(shapes["U"], "orthogonal")
    top = [i for i, (_, y) in enumerate(shapes["U"]) if y == 5]
    edges = {frozenset((int(a), int(b))) for a, b in zip(found.order, np.roll(found.order, -1), strict=True)}
    assert {frozenset(top[:2]), frozenset(top[2:])} <= edges
