import numpy as np
import pytest

from sketch2shape.lifting.regularity import bearings, candidates, find_relations, score

SQUARE = np.array([[0, 0], [100, 0], [100, 100], [0, 100.0]])
ARROW = np.array([[0, 30], [60, 30], [60, 0], [110, 50], [60, 100], [60, 70], [0, 70.0]])
PENTAGON = 100 * np.array([[np.sin(t), -np.cos(t)] for t in np.arange(5) * 2 * np.pi / 5])


def odds(shape, stretches, noise=0.5):
    """Scores of the shape stretched along an odd direction, with the drawing as found at stretch 1."""
    t = np.array([np.cos(0.6), np.sin(0.6)])
    maps = np.eye(2) + (np.array(stretches)[:, None, None] - 1.0) * np.outer(t, t)
    relations = find_relations(shape, [len(shape)], shape, noise)
    found = candidates(relations, shape @ maps, maps)
    return score(relations, found, bearings(relations, found, noise), noise)


@pytest.mark.parametrize("shape", [SQUARE, ARROW, PENTAGON])
def test_the_regular_shape_scores_best(shape):
    got = odds(shape, [0.6, 0.8, 1.0, 1.25, 1.6])
    assert got.argmax() == 2
    assert got[2] > 2.0 + max(np.delete(got, 2))


def test_more_noise_says_less():
    assert odds(SQUARE, [1.0], noise=0.3)[0] > odds(SQUARE, [1.0], noise=3.0)[0]


def test_the_spread_of_a_bearing_is_what_shaking_the_drawing_gives():
    relations = find_relations(ARROW, [7], ARROW, 0.5)
    maps = np.array([[[1.8, 0.3], [-0.2, 0.7]]])
    rng = np.random.default_rng(0)
    shaken = (ARROW + rng.normal(0, 0.5, (4000, 7, 2))) @ maps[0]
    angle = bearings(relations, candidates(relations, shaken, np.repeat(maps, 4000, axis=0)), 0.5).angle
    (spread,) = bearings(relations, candidates(relations, ARROW @ maps, maps), 0.5).spread
    k = len(relations.edges)
    wobble = np.unwrap(angle[:, :k] - angle[0, :k], axis=0)
    assert spread[:k] == pytest.approx(wobble.std(axis=0), rel=0.1)


def test_a_symmetric_face_shows_its_axis():
    relations = find_relations(ARROW, [7], ARROW, 0.5)
    assert len(relations.belief) == 1
    axis, chord = (relations.rows @ ARROW)[len(relations.edges) :][:2]
    assert axis[1] == pytest.approx(0.0, abs=1e-9)
    assert chord[0] == pytest.approx(0.0, abs=1e-9)
