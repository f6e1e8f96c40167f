import numpy as np
import pytest

from sketch2shape.connectors import connect_faces, connect_faces_detailed
from sketch2shape.errors import PointsError
from sketch2shape.model.drawing import ring_edges


def edge_set(edges, names=None):
    names = np.arange(1 + int(np.max(edges))) if names is None else names
    return {frozenset((int(names[a]), int(names[b]))) for a, b in edges}


def solid(ring, scale=1.0, shift=(1.3, 0.9)):
    """Vertices and true edges of the object between a ring and its copy."""
    centre = ring.mean(axis=0)
    size = np.ptp(ring, axis=0).max()
    back = centre + scale * (ring - centre) + size * np.array(shift)
    return np.concatenate((ring, back)), edge_set(ring_edges([len(ring)]))


@pytest.mark.parametrize("method", ["auto", "tour", "split-walk"])
def test_faces_given_apart(method, shapes):
    ring = shapes["hexagon"]
    points, truth = solid(ring)
    rng = np.random.default_rng(2)
    a, b = rng.permutation(6), rng.permutation(6)
    edges = connect_faces(points[:6][a], points[6:][b], method)
    assert edges.shape == (18, 2)
    assert edge_set(edges, np.r_[a, b + 6]) == truth


@pytest.mark.parametrize("scale", [1.0, 0.6, 1.7])
def test_unlabelled_vertices_split_and_connect(scale, shape, shapes):
    if scale == 1.0 and shape == "square":
        pytest.skip("a box splits three ways, all right")
    points, truth = solid(shapes[shape], scale, (0.43, 0.31))
    shuffled = np.random.default_rng(7).permutation(len(points))
    found = connect_faces_detailed(points[shuffled])
    answers = [found.edges]
    if found.alternatives:
        assert any("other splits" in word for word in found.violated)
        answers += [np.column_stack(pair) for pair in found.alternatives]
    assert edge_set(found.edges, shuffled) == truth
    assert min(found.scale, 1 / found.scale) == pytest.approx(min(scale, 1 / scale), abs=1e-6)


def test_a_box_has_three_splits_and_one_set_of_edges():
    points, truth = solid(np.array([(0, 0), (4, 0), (4, 3), (0, 3)], float), shift=(0.4, 0.3))
    found = connect_faces_detailed(points)
    assert edge_set(found.edges) == truth
    assert len(found.alternatives) == 2


def test_noise_on_both_faces(shapes):
    points, truth = solid(shapes["T"], shift=(0.37, 0.29))
    noisy = points + np.random.default_rng(1).normal(0, 0.02, points.shape)
    assert edge_set(connect_faces(noisy)) == truth


def test_faces_of_different_size(shapes):
    with pytest.raises(PointsError, match="same number of vertices, got 6 and 8"):
        connect_faces(shapes["L"], shapes["T"])


@pytest.mark.parametrize(
    ("points", "words"),
    [
        (np.random.default_rng(0).uniform(0, 1, (7, 2)), "even number of unlabelled points, got 7"),
        ([(0, 0), (1, 0), (1, 1), (0, 1)], "at least 6 unlabelled points"),
        (np.random.default_rng(0).uniform(0, 1, (12, 2)), "two copies of one face"),
    ],
)
def test_unlabelled_points_that_cannot_be_two_faces(points, words):
    with pytest.raises(PointsError, match=words):
        connect_faces(points)


def test_step_five_of_the_paper_joins_by_rank():
    # a second face that is no copy of the first: ranks still join, and that they do not fit is said
    first = np.array([(0, 0), (4, 0), (4, 3), (0, 3)], float)
    second = np.array([(10, 0), (14, 2), (13, 6), (9, 4)], float)
    found = connect_faces_detailed(first, second, "split-walk")
    assert found.second.tolist() == [int(i) for i in found.second]
    assert len(found.edges) == 12


def test_methods_that_disagree_between_the_faces_say_so(shapes):
    ring = shapes["U"]
    points, _ = solid(ring)
    bent = points.copy()
    bent[8:] += np.random.default_rng(4).normal(0, 0.3, (8, 2))
    found = connect_faces_detailed(bent[:8], bent[8:], "tour")
    assert len(found.edges) == 24
