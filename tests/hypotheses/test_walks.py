"""Faces of wireframes walked edge by edge, on graphs that are known exactly."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, shrunk

from sketch2shape.hypotheses import CornerGraph, walked
from sketch2shape.hypotheses.walks import INK, VERTEX, _closed, _steps
from sketch2shape.model.drawing import ring_edges

SIZE, TOLERANCE = 400.0, 8.0


def graph_of(front, back, extra=(), without=()):
    """The corners of an object and the edges between them, some more and some less."""
    points = np.concatenate([front, back])
    inked = np.zeros((len(points), len(points)), bool)
    for i, j in [*ring_edges([len(front)]).tolist(), *extra]:
        inked[i, j] = inked[j, i] = True
    for i, j in without:
        inked[i, j] = inked[j, i] = False
    return CornerGraph(points, inked, TOLERANCE)


def faces(front, back):
    return frozenset(frozenset(map(tuple, np.round(r, 3).tolist())) for r in (front, back))


def found_in(graph, least=3.0):
    return [faces(r.front[0], r.back[0]) for r in walked(graph, SIZE, least)]


@pytest.mark.parametrize("ring", [SQUARE, L_SHAPE, HEXAGON], ids=["square", "l", "hexagon"])
def test_a_careless_hand_misses_every_map_and_is_read_all_the_same(ring):
    back = ring + DEPTH + np.random.default_rng(2).normal(0, 4, ring.shape)
    assert faces(ring, back) in found_in(graph_of(ring, back))


def test_a_tapered_object_is_read():
    back = shrunk(SQUARE, 0.8, SQUARE.mean(axis=0) + [420, -260])
    assert faces(SQUARE, back) in found_in(graph_of(SQUARE, back))


def test_what_explains_most_comes_first():
    back = L_SHAPE + DEPTH
    n = len(L_SHAPE)
    # a line across both faces makes smaller objects of the same edges
    graph = graph_of(L_SHAPE, back, extra=[(0, 3), (n, n + 3)])
    found = found_in(graph)
    assert found[0] == faces(L_SHAPE, back)
    assert len(found) > 1


def test_each_pair_of_faces_is_given_once():
    found = found_in(graph_of(L_SHAPE, L_SHAPE + DEPTH))
    assert len(found) == len(set(found))


def test_without_an_edge_there_is_no_walk_round():
    back = HEXAGON + DEPTH
    graph = graph_of(HEXAGON, back, without=[(0, 1)])
    assert faces(HEXAGON, back) not in found_in(graph)


def test_nothing_to_walk():
    assert found_in(CornerGraph(np.zeros((0, 2)), np.zeros((0, 0), bool), TOLERANCE)) == []
    assert found_in(CornerGraph(SQUARE, ~np.eye(4, dtype=bool), TOLERANCE)) == []


@given(st.integers(0, 10**6), st.floats(0.5, 3.0))
def test_shift_and_order_of_the_corners_change_nothing(seed, scale):
    rng = np.random.default_rng(seed)
    front, back = L_SHAPE * scale, (L_SHAPE + DEPTH) * scale
    plain = graph_of(front, back)
    order = rng.permutation(len(plain.points))
    mixed = CornerGraph(plain.points[order] + 50.0, plain.inked[np.ix_(order, order)], TOLERANCE * scale)
    moved = {faces(r.front[0] - 50.0, r.back[0] - 50.0) for r in walked(mixed, SIZE * scale, 3.0)}
    assert faces(front, back) in moved


@pytest.mark.parametrize(("tolerances", "price"), [(0.0, 0.0), (1.0, 0.5), (3.0, 4.5), (6.0, VERTEX)])
def test_a_step_saves_its_ink_less_a_vertex_and_what_neighbours_differ_by(tolerances, price):
    back = SQUARE + DEPTH
    back[1] += [tolerances * TOLERANCE, 0.0]
    graph = graph_of(SQUARE, back)
    steps = _steps(graph, SIZE)
    first, second = (steps.rungs.tolist().index([k, k + 4]) for k in (0, 1))
    (rank,) = np.flatnonzero((steps.near[first] == second) & np.isfinite(steps.gain[first]))
    ink = 150.0 + (back[1, 0] - back[0, 0]) + np.hypot(*(back[1] - SQUARE[1]))
    assert steps.gain[first, rank] == pytest.approx(100.0 * INK * ink / SIZE - VERTEX - price)


def test_no_walk_turns_back_along_the_edge_it_came_by():
    # a corner in the middle of the first edge, whose halves are edges too, and an edge from there across the face
    front = np.insert(SQUARE, 4, [[195.0, 140.0]], axis=0)
    points = np.concatenate([front, front + DEPTH])
    inked = np.zeros((10, 10), bool)
    for i, j in [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (4, 1), (4, 3)]:
        inked[[i, j, i + 5, j + 5], [j, i, j + 5, i + 5]] = True
    inked[np.arange(10), np.roll(np.arange(10), 5)] = True
    graph = CornerGraph(points, inked, TOLERANCE)
    steps = _steps(graph, SIZE)
    walks = [steps.rungs[path, 0].tolist() for _, path in _closed(steps, graph)]
    assert any({0, 1, 2, 3} == set(walk) for walk in walks)
    for walk in walks:
        corners = [k % 5 for k in walk]
        runs = zip(corners, corners[1:], corners[2:], strict=False)
        assert not [run for run in runs if run in ((0, 1, 4), (4, 1, 0), (1, 0, 4), (4, 0, 1))]
