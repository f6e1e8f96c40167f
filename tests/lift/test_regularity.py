import numpy as np
import pytest

from sketch2shape.lift.regularity import find_relations, parallel_classes, score

SQUARE = np.array([[0, 0], [100, 0], [100, 100], [0, 100.0]])
ARROW = np.array([[0, 30], [60, 30], [60, 0], [110, 50], [60, 100], [60, 70], [0, 70.0]])
PENTAGON = 100 * np.array([[np.sin(t), -np.cos(t)] for t in np.arange(5) * 2 * np.pi / 5])


def odds(shape, stretches, noise=0.5):
    """Scores of the shape stretched along an odd direction, with the drawing as found at stretch 1."""
    t = np.array([np.cos(0.6), np.sin(0.6)])
    maps = np.eye(2) + (np.array(stretches)[:, None, None] - 1.0) * np.outer(t, t)
    relations = find_relations(shape, [len(shape)], shape, noise)
    return score(relations, np.einsum("mi,gij->gmj", shape, maps), maps, noise)


@pytest.mark.parametrize("shape", [SQUARE, ARROW, PENTAGON])
def test_the_regular_shape_scores_best(shape):
    got = odds(shape, [0.6, 0.8, 1.0, 1.25, 1.6])
    assert got.argmax() == 2
    assert got[2] > 2.0 + max(np.delete(got, 2))


def test_more_noise_says_less():
    assert odds(SQUARE, [1.0], noise=0.3)[0] > odds(SQUARE, [1.0], noise=3.0)[0]


def test_parallel_edges_are_one_class_whatever_their_sense():
    vectors = np.array([[10, 0.1], [0, 7], [-20, 0], [0.05, -9], [5, 5.0]])
    label, sign = parallel_classes(vectors, np.hypot(*vectors.T), 0.2)
    assert label[0] == label[2]
    assert label[1] == label[3]
    assert len(set(label.tolist())) == 3
    assert sign[0] == -sign[2]
    assert sign[1] == -sign[3]
