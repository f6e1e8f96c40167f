"""The paper's algorithm against a literal reading of it."""

from math import atan2, degrees

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.connectors import connect, connect_detailed, sorting, split_walk_preconditions
from sketch2shape.errors import PointsError, UsageError


def literal(points):
    """Section III of the paper, one step after the other."""
    rows = [(x, y, i) for i, (x, y) in enumerate(points)]
    rows.sort()
    seed = rows[0]
    middle = sum(y for _, y, _ in rows) / len(rows)
    r1 = [row for row in rows if row is seed or row[1] <= middle]
    r2 = [row for row in rows if row not in r1]
    return walk(r1[1:], seed, [seed[2]]) + walk(r2, seed, [])[::-1]


def walk(rest, current, chain):
    rest = list(rest)
    while rest:

        def rule(row):
            return row[0], abs(degrees(atan2(row[1] - current[1], row[0] - current[0])))  # noqa: B023

        current = min(rest, key=rule)
        rest.remove(current)
        chain.append(current[2])
    return chain


grid = st.lists(st.tuples(st.integers(0, 6), st.integers(0, 12)), min_size=3, max_size=40, unique=True)


def spans(points):
    a = np.array(points, float)
    return np.linalg.matrix_rank(a - a[0]) == 2


@settings(max_examples=300)
@given(grid.filter(spans))
def test_vector_form_is_the_literal_walk(points):
    # columns of three and more vertices on a small grid: entries, exits and order of every column count
    assert connect(points, "split-walk").tolist() == literal(points)


@settings(max_examples=60)
@given(grid.filter(spans))
def test_the_x_split_is_the_y_split_of_exchanged_axes(points):
    exchanged = [(y, x) for x, y in points]
    assert connect(points, "split-walk", axis="x").tolist() == connect(exchanged, "split-walk").tolist()


def test_worked_example():
    # mean y = 2.0: r1 = a(0,1) b(2,0) c(5,1), r2 = d(1,4) e(4,4); ring a b c e d
    points = [(5, 1), (1, 4), (0, 1), (4, 4), (2, 0)]
    assert connect(points, "split-walk").tolist() == [2, 4, 0, 3, 1]


def test_the_seed_is_in_r1_even_above_the_centroid():
    # the leftmost vertex (0, 9) lies above the mean y of 4.0, and still begins the lower chain
    points = [(0, 9), (2, 0), (5, 1), (4, 6)]
    assert connect(points, "split-walk").tolist() == [0, 1, 2, 3]


def test_equal_x_takes_the_smaller_angle_first():
    # from (0, 0) the vertices (3, 0) and (3, -5) share x: (3, 0) is at 0 degrees, (3, -5) at 59
    points = [(0, 0), (3, -5), (3, 0), (1, 9), (2, 9)]
    assert connect(points, "split-walk").tolist()[:3] == [0, 2, 1]


def test_the_vector_form_on_more_points_than_fit_one_register():
    rng = np.random.default_rng(9)
    points = np.unique(rng.integers(0, 60, (1500, 2)), axis=0)
    points = points[rng.permutation(len(points))]
    for moved in (points, points - 30, points + 0.25, points * 0.1):
        rows = [tuple(row) for row in moved.tolist()]
        assert connect(moved, "split-walk").tolist() == literal(rows)


@pytest.mark.parametrize("size", [1, 7, 64])
def test_a_walk_goes_on_from_piece_to_piece(monkeypatch, size):
    monkeypatch.setattr(sorting, "PIECE", size)
    rng = np.random.default_rng(size)
    for high in (8, 40):
        points = np.unique(rng.integers(0, (60, high), (400, 2)), axis=0)
        for moved in (points, points * 0.1):
            shuffled = rng.permutation(moved)
            assert connect(shuffled, "split-walk").tolist() == literal([tuple(row) for row in shuffled.tolist()])


def test_duplicates_among_many_are_found():
    points = np.random.default_rng(1).permutation(np.arange(6000).reshape(-1, 2) % 971).astype(float)
    points = np.unique(points, axis=0)
    points[17] = points[400]
    with pytest.raises(PointsError, match="distinct"):
        connect(points, "split-walk")


def test_another_axis_is_refused():
    with pytest.raises(UsageError, match="'z'"):
        connect([(0, 0), (1, 0), (0, 1)], "split-walk", axis="z")


def test_ties_are_reported(shapes):
    assert any("angle rule" in word for word in connect_detailed(shapes["T"], "split-walk").violated)


# ---------------------------------------------------------------- preconditions


def ring_strategy():
    return grid.filter(spans)


@settings(max_examples=300)
@given(ring_strategy(), st.randoms(use_true_random=False))
def test_preconditions_hold_exactly_when_the_walk_gives_the_ring(points, random):
    array = np.array(points, float)
    ring = list(range(len(points)))
    random.shuffle(ring)
    walked = connect(array, "split-walk")
    for order in (np.array(ring), walked, walked[::-1], np.roll(walked, 3)):
        same = edge_set(order) == edge_set(walked)
        assert split_walk_preconditions(array, order).hold == same


def edge_set(order):
    return {frozenset(map(int, pair)) for pair in zip(order, np.roll(order, -1), strict=True)}


def test_preconditions_say_what_fails(shapes):
    house = split_walk_preconditions(shapes["hexagon"], np.arange(6))
    assert house.hold
    assert house.words == ()
    comb = split_walk_preconditions(shapes["comb"] @ [[1.0, 0.02], [0.3, 1.0]], np.arange(12))
    assert not comb.monotone
    assert not comb.hold
    assert "turns back" in comb.words[0]


def test_monotone_chains_that_the_centroid_line_cuts():
    # a slanted bar: both chains rise in x, but mean y crosses both
    ring = np.array([(0, 0), (5, 4), (10, 8), (10.5, 10), (5.5, 6), (1, 2)], float)
    found = split_walk_preconditions(ring, np.arange(6))
    assert found.monotone
    assert not found.separated
