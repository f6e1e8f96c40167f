"""galton-duckham, moreira-santos, tour and angular on worked examples."""

from itertools import permutations

import numpy as np
import pytest

from sketch2shape.connectors import connect, connect_detailed
from sketch2shape.connectors.polygon import canonical
from sketch2shape.geometry import inside

TWO_GROUPS = np.array([(0, 0), (2, 0), (1, 2), (20, 0), (22, 0), (21, 2)], float)


def test_a_short_arm_gives_one_polygon_for_each_group():
    found = connect_detailed(TWO_GROUPS, "galton-duckham", r=3.0)
    assert [sorted(ring.tolist()) for ring in found.rings] == [[0, 1, 2], [3, 4, 5]]
    assert any("2 polygons" in word for word in found.violated)


def test_a_long_arm_gives_the_convex_hull():
    points = np.random.default_rng(5).uniform(0, 1, (40, 2))
    assert canonical(connect(points, "galton-duckham", r=10.0)) == canonical(connect(points, "graham"))


def test_the_arm_cannot_jump_a_gap_wider_than_itself():
    # the notch of a plus is 2.83 wide and its arms 2 long: r = 2.5 follows the outline, r = 2.9 skips the notches
    plus = np.array(
        [(2, 0), (4, 0), (4, 2), (6, 2), (6, 4), (4, 4), (4, 6), (2, 6), (2, 4), (0, 4), (0, 2), (2, 2)], float
    )
    assert canonical(connect(plus, "galton-duckham", r=2.5)) == tuple(range(12))
    assert len(connect(plus, "galton-duckham", r=2.9)) == 8


def test_default_arm_is_the_shortest_that_encloses_all(shapes, same_ring):
    found = connect_detailed(shapes["plus"], "galton-duckham")
    assert same_ring(found.order, np.arange(12))
    assert found.parameters["r"] == pytest.approx(2.0)


def test_nearest_neighbours_walk_a_dense_outline():
    angle = 2 * np.pi * np.arange(40) / 40
    outline = np.column_stack((2 * np.cos(angle), np.sin(angle)))
    shuffled = np.random.default_rng(2).permutation(40)
    found = connect_detailed(outline[shuffled], "moreira-santos", k=3)
    assert canonical(shuffled[found.order]) == tuple(range(40))
    assert found.parameters["k"] == 3


def test_nearest_neighbours_cut_inner_corners():
    # a plus with a point every unit: with 3 neighbours each inner corner is cut across
    plus = [(2, 0), (3, 0), (4, 0), (4, 1), (4, 2), (5, 2), (6, 2), (6, 3), (6, 4), (5, 4), (4, 4), (4, 5)]
    points = np.array(plus + [(6 - x, 6 - y) for x, y in plus], float)
    assert set(range(24)) - set(connect(points, "moreira-santos", k=3).tolist()) == {3, 4, 9, 10, 15, 16, 21, 22}


def test_nearest_neighbours_enclose_every_point():
    points = np.random.default_rng(3).uniform(0, 1, (60, 2))
    found = connect_detailed(points, "moreira-santos")
    assert found.simple
    rest = np.setdiff1d(np.arange(60), found.order)
    assert inside(points[rest], found.ring).all()


def test_tour_is_the_shortest_of_all_rings():
    for seed in range(6):
        points = np.random.default_rng(seed).uniform(0, 1, (7, 2))

        def length(order, points=points):
            ring = points[list(order)]
            return np.hypot(*(ring - np.roll(ring, 1, axis=0)).T).sum()

        best = min(length((0, *rest)) for rest in permutations(range(1, 7)))
        found = connect_detailed(points, "tour")
        assert found.simple
        assert length(found.order) == pytest.approx(best)


def test_angular_is_exact_for_a_star():
    angle = np.pi * np.arange(10) / 5
    star = np.where(np.arange(10) % 2, 0.4, 1.0)[:, None] * np.column_stack((np.cos(angle), np.sin(angle)))
    shuffled = np.random.default_rng(0).permutation(10)
    assert canonical(shuffled[connect(star[shuffled], "angular")]) == tuple(range(10))
