import numpy as np
import pytest

from sketch2shape.connectors import connect, connect_detailed
from sketch2shape.connectors.auto import straight_pairings
from sketch2shape.connectors.polygon import canonical, ring_is_simple
from sketch2shape.connectors.ring_search import Energy, all_rings, edge_index, gains, improve, relocations, reversals
from sketch2shape.connectors.symmetry import symmetries

VIEWS = (np.eye(2), np.array([[0.8, -0.6], [0.6, 0.8]]), np.array([[0.9, 0.35], [-0.2, 0.7]]))


@pytest.mark.parametrize("view", range(3))
@pytest.mark.parametrize("noise", [0.0, 0.003])
def test_made_faces_in_parallel_views(shape, view, noise, shapes, shuffle, same_ring):
    points, order = shuffle(shapes[shape] @ VIEWS[view])
    size = np.ptp(points, axis=0).max()
    points = points + np.random.default_rng(view).normal(0, noise * size, points.shape)
    found = connect_detailed(points)
    assert same_ring(found.order, order)
    assert found.simple
    assert found.complete


def test_sureness_is_high_for_a_plain_face_and_low_for_scatter(shapes):
    assert connect_detailed(shapes["L"]).sureness > 0.95
    assert connect_detailed(np.random.default_rng(8).uniform(0, 1, (14, 2))).sureness < 0.6


def test_equally_good_orders_are_named():
    # a square with a point in its middle: four equal ways to dent it
    points = np.array([(0, 0), (4, 0), (4, 4), (0, 4), (2, 2)], float)
    found = connect_detailed(points)
    assert len(found.alternatives) == 3
    assert found.tied
    assert found.sureness <= 0.25 + 1e-9
    assert all(ring_is_simple(points[order]) for order in found.alternatives)


def test_the_answer_does_not_depend_on_the_order_given(shapes):
    points = shapes["I"] @ VIEWS[2]
    for seed in range(5):
        shuffled = np.random.default_rng(seed).permutation(12)
        assert canonical(shuffled[connect(points[shuffled])]) == tuple(range(12))


@pytest.mark.parametrize("factor", [1e-6, 1.0, 1e6])
def test_the_answer_does_not_depend_on_the_unit_or_the_place(factor, shapes):
    assert canonical(connect(shapes["T"] * factor + 1e4 * factor)) == tuple(range(8))


@pytest.mark.parametrize("n", [30, 90])
def test_many_points_give_a_simple_complete_ring(n):
    found = connect_detailed(np.random.default_rng(n).uniform(0, 1, (n, 2)))
    assert found.complete
    assert found.simple


def random_energy(n: int) -> Energy:
    rng = np.random.default_rng(n)
    _, at = edge_index(n)
    m = n * (n - 1) // 2
    pair = rng.normal(size=(m, m))
    pair += pair.T
    np.fill_diagonal(pair, 0)
    return Energy(rng.normal(size=m), pair, at)


@pytest.mark.parametrize("moves", [reversals, relocations])
def test_gains_are_differences_of_energy(moves):
    energy, order = random_energy(9), np.random.default_rng(1).permutation(9)
    after = order[moves(9).order]
    assert gains(energy, order[None], moves(9))[0] == pytest.approx(energy.of(after) - energy.of(order[None]))
    assert (np.sort(after, axis=1) == np.arange(9)).all()


def test_improvement_never_loses_and_ends_where_no_move_helps():
    energy = random_energy(10)
    starts = np.array([np.random.default_rng(s).permutation(10) for s in range(4)])
    ends = improve(energy, starts)
    assert energy.of(ends).min() <= energy.of(starts).min()
    for moves in (reversals(10), relocations(10)):
        assert gains(energy, ends, moves).min() >= -1e-9


def test_all_rings_are_all_and_different():
    rings = all_rings(6)
    assert len(rings) == 60
    assert len({canonical(ring) for ring in rings}) == 60


def test_symmetries_of_a_skewed_square_and_of_none():
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
    found = symmetries(square @ VIEWS[2])
    assert len(found) == 7  # the eight of the square without the identity
    assert all(strength > 0.99 for _, strength in found)
    assert symmetries(np.array([(0, 0), (5, 0), (6, 2), (1, 3), (2, 9)], float)) == []


def test_a_sheared_comb_of_equal_teeth():
    # many equal parallel edges in wrong rings too; only one ring pairs up along two directions
    teeth = [(x, y) for k in range(4) for x, y in ((2 * k, 0), (2 * k, 3), (2 * k + 1, 3), (2 * k + 1, 0))]
    ring = np.array([(0, -1), *teeth[1:-1], (7, -1)], float) @ [[1.0, 0.0], [0.3, 1.0]]
    shuffled = np.random.default_rng(6).permutation(len(ring))
    assert canonical(shuffled[connect(ring[shuffled])]) == tuple(range(len(ring)))


def test_straight_pairings_count_more_the_straighter_they_are(shapes):
    rings, exact = straight_pairings(shapes["T"])
    assert [canonical(ring) for ring in rings] == [tuple(range(8))]
    _, rough = straight_pairings(shapes["T"] + np.random.default_rng(0).uniform(-0.004, 0.004, (8, 2)))
    assert exact > rough > 0
    assert straight_pairings(shapes["house"])[1] == 0.0
