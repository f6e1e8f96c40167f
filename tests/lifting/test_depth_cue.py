import numpy as np

from sketch2shape.lifting.depth_cue import depth_odds
from sketch2shape.lifting.regularity import candidates, find_relations

SQUARE = 100.0 * np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])


def odds(length, noise=1.0, slant=0.5 * np.pi):
    """Log odds of a square of 100 pixels being this deep."""
    relations = find_relations(SQUARE, [4], SQUARE, noise)
    found = candidates(relations, SQUARE[None], np.eye(2)[None])
    return float(depth_odds(relations, found, np.array([slant]), length, (noise, noise / length))[0])


def test_a_depth_of_one_edge_is_likelier_than_twice_or_half_and_these_than_any_other():
    assert odds(100.0) > odds(200.0) > odds(50.0) > 0.5 > 0.0 > odds(140.0)


def test_the_depth_is_the_drawn_length_over_the_sine_of_the_slant():
    assert odds(50.0 * np.sqrt(2.0), slant=np.pi / 4) == np.float64(odds(50.0 * np.sqrt(2.0), slant=0.75 * np.pi))
    assert odds(100.0 / np.sqrt(2.0), slant=np.pi / 4) > 1.0


def test_the_shakier_the_less_it_says():
    assert odds(100.0, noise=0.5) > odds(100.0, noise=4.0) > odds(100.0, noise=20.0)
    assert odds(140.0, noise=20.0) > odds(140.0, noise=0.5)


def test_a_face_without_edges_says_nothing():
    relations = find_relations(SQUARE, [4], SQUARE, 1.0)
    found = candidates(relations, SQUARE[None], np.eye(2)[None])
    without = np.delete(found.x, np.s_[len(relations.weight) :], 1)
    assert (
        depth_odds(
            relations, type(found)(without, without, found.area, found.stretch, found.step), np.ones(1), 9.0, (1.0, 0.1)
        )
        == 0.0
    )
