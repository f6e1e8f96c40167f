"""Which connector gives a face its order."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.connectors import connect
from sketch2shape.connectors.ordering import by_method, by_pairing, by_split_walk, connector_of, levelled
from sketch2shape.connectors.polygon import canonical
from sketch2shape.errors import UsageError

SQUARE = np.array([[0, 0], [100, 0], [100, 100], [0, 100.0]])
L = np.array([[0, 0], [100, 0], [100, 40], [40, 40], [40, 100], [0, 100.0]])
U = np.array([[0, 0], [30, 0], [30, 70], [70, 70], [70, 0], [100, 0], [100, 100], [0, 100.0]])
HEXAGON = np.array([[np.cos(t), np.sin(t)] for t in np.arange(6) * np.pi / 3]) * 50 + 100
# a star of five points, tilted: its chains turn back in x and in y, but it can be seen whole from its mean
STAR = np.array([[np.cos(t), np.sin(t)] for t in np.arange(10) * np.pi / 5 + 0.3]) * ([[95], [35]] * 5)
SPIRAL = np.array(
    [[0, 0], [90, 5], [95, 100], [10, 96], [14, 33], [60, 35], [57, 62], [38, 60], [37, 50], [26, 51], [25, 80],
     [81, 83], [76, 18], [3, 15.0]]
)  # fmt: skip


def same_ring(ring, order):
    return canonical(np.asarray(order)) == tuple(range(len(ring)))


@pytest.mark.parametrize(
    ("ring", "name"),
    [(SQUARE, "split-walk"), (HEXAGON, "split-walk"), (U, "orthogonal"), (STAR, "angular")],
)
def test_the_first_connector_that_finds_the_ring_is_named_and_does_find_it(ring, name):
    assert connector_of(ring) == name
    assert connector_of(ring[::-1]) == name
    shuffled = np.random.default_rng(1).permutation(len(ring))
    assert same_ring(ring, shuffled[connect(ring[shuffled], name)])


def test_a_spiral_is_for_the_ink():
    assert connector_of(SPIRAL) == "ink"


def test_the_split_may_be_at_the_mean_x():
    # notches on the left and on the right: upwards each side is monotone, sideways neither half is
    ring = np.array([[30, 0], [70, 0], [60, 30], [75, 60], [68, 100], [32, 100], [25, 60], [40, 30.0]])
    ring[:, 1] *= 3
    shuffled = ring[[3, 0, 5, 6, 1, 7, 2, 4]]
    back = [3, 0, 5, 6, 1, 7, 2, 4]
    assert not same_ring(ring, np.array(back)[connect(shuffled, "split-walk")])
    assert same_ring(ring, np.array(back)[connect(shuffled, "split-walk", axis="x")])
    assert connector_of(ring) == "split-walk"


def test_upright_lines_drawn_by_hand_count_as_upright():
    # the paper's rule goes up the right side of this step; a hand that strays by half a pixel must not change that
    step = np.array([[0, 0], [60, 0], [60, 20], [100, 20], [100, 100], [0, 100.0]])
    shaken = step + np.array([[0.3, 0], [0.4, 0.2], [-0.4, 0], [0.2, -0.3], [-0.3, 0.1], [-0.2, 0]])
    assert by_split_walk(step) == by_split_walk(shaken)
    assert np.array_equal(levelled(step), step)


@given(st.integers(0, 10**6), st.integers(2, 6), st.floats(0, 3.1), st.floats(-0.5, 0.5))
def test_a_rectilinear_face_pairs_up_in_every_parallel_view(seed, steps, turn, shear):
    rng = np.random.default_rng(seed)
    x, y = np.cumsum(rng.uniform(10, 30, steps)), np.cumsum(rng.uniform(10, 30, steps))[::-1]
    ring = [[0.0, 0.0]]
    for k in range(steps):
        ring += [[0.0 if k == 0 else x[k - 1], y[k]], [x[k], y[k]]]
    ring = np.array([*ring, [x[-1], 0.0]])
    view = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ [[1, shear], [0, 0.8]]
    seen = ring @ view.T + rng.normal(0, 0.05, ring.shape)
    assert by_pairing(seen)
    assert by_method(seen, "orthogonal")


def test_pairing_needs_edges_of_two_directions_in_turn():
    assert not by_pairing(HEXAGON)
    assert not by_pairing(HEXAGON[:5])
    assert not by_pairing(np.array([[0, 0], [100, 0], [130, 50], [20, 100.0]]))


def test_a_named_connector_counts_only_where_the_ink_agrees():
    assert connector_of(U, "graham") == "ink"
    assert connector_of(HEXAGON, "graham") == "graham"
    assert connector_of(SQUARE, "ink") == "ink"
    assert connector_of(SPIRAL, "split-walk") == "ink"


def test_coincident_vertices_are_for_the_ink():
    assert connector_of(np.r_[L[:3], L[2:]], "tour") == "ink"


def test_an_unknown_connector_is_refused_with_its_neighbour():
    with pytest.raises(UsageError, match="split-walk"):
        connector_of(SQUARE, "splitwalk")


@pytest.mark.parametrize("ring", [np.zeros((0, 2)), np.array([[0.0, 0], [9, 0]])])
def test_rings_that_arcs_close_keep_the_order_of_the_ink(ring):
    assert connector_of(ring) == "ink"
    assert connector_of(ring, "angular") == "ink"
