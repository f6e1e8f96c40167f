"""The separator for drawings with all edges drawn, on graphs that are known exactly."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, shrunk

from sketch2shape.geometry import homology
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.hypotheses.wireframe import (
    CornerGraph,
    Ladder,
    _chains,
    _from_two,
    _links,
    _refitted,
    _runs_through,
    cycles,
    ladders,
    likely_cycles,
    ring_pair,
    with_holes,
)
from sketch2shape.model.drawing import ring_edges


def graph_of(*pairs, extra=()):
    """The corners and inked edges of the objects with these faces, in a mixed order."""
    points, edges, start = [], [], 0
    for f1, f2 in pairs:
        points += [f1, f2]
        edges += (ring_edges([len(f1)]) + start).tolist()
        start += 2 * len(f1)
    points = np.concatenate(points)
    mixed = np.random.default_rng(1).permutation(len(points))
    inked = np.zeros((len(points), len(points)), bool)
    for i, j in [*edges, *extra]:
        inked[mixed[i], mixed[j]] = inked[mixed[j], mixed[i]] = True
    shuffled = np.empty_like(points)
    shuffled[mixed] = points
    return CornerGraph(shuffled, inked, 5.0)


def readings(graph):
    """Every pair of faces that the separator finds, as two sets of points."""
    found = set()
    for ladder in ladders(graph):
        for cycle in cycles(ladder, iter(range(4000))):
            rings = ring_pair(ladder, graph, cycle)
            found.add(frozenset(frozenset(map(tuple, r.round().tolist())) for r in (rings.front[0], rings.back[0])))
    return found


def faces(f1, f2):
    return frozenset(frozenset(map(tuple, np.round(r).tolist())) for r in (f1, f2))


BACKS = {
    "oblique": lambda ring: ring + DEPTH,
    "frustum": lambda ring: shrunk(ring, 0.6, np.array([420.0, 20])),
    "perspective": lambda ring: homology.apply(
        np.eye(3) + np.outer([700.0, -250, 1], [-2e-4, 3e-4, 0.25]), ring
    ),
}  # fmt: skip


@pytest.mark.parametrize("back", BACKS)
@pytest.mark.parametrize("f1", [SQUARE, L_SHAPE, HEXAGON], ids=["box", "L", "hexagon"])
def test_the_faces_are_among_the_readings_whatever_the_projection(f1, back):
    f2 = BACKS[back](f1)
    assert faces(f1, f2) in readings(graph_of((f1, f2)))


def test_a_box_has_three_readings_and_an_l_one():
    assert len(readings(graph_of((SQUARE, SQUARE + DEPTH)))) == 3
    assert len([r for r in readings(graph_of((L_SHAPE, L_SHAPE + DEPTH))) if len(next(iter(r))) == 6]) == 1


def test_rungs_obey_the_ladders_map():
    graph = graph_of((L_SHAPE, L_SHAPE + DEPTH))
    richest = max(ladders(graph), key=lambda x: len(x.rungs))
    a, b = graph.points[richest.rungs.T]
    assert np.linalg.norm(homology.apply(richest.map, a) - b, axis=1).max() <= graph.tolerance
    assert (richest.links == richest.links.T).all()
    assert (richest.links.sum(axis=1) >= 2).all()


def test_a_corner_may_serve_in_both_faces():
    # the true isometric cube: the nearest corner of one face hides the farthest of the other
    turn = np.arange(6) * np.pi / 3
    ring = np.array([240.0, 200]) + 120 * np.c_[np.sin(turn), -np.cos(turn)]
    middle = np.array([240.0, 200])
    points = np.r_[ring, [middle]]
    inked = np.zeros((7, 7), bool)
    for k in range(6):
        inked[k, (k + 1) % 6] = inked[(k + 1) % 6, k] = inked[k, 6] = inked[6, k] = True
    front = np.array([ring[5], middle, ring[3], ring[4]])
    back = np.array([ring[0], ring[1], ring[2], middle])
    assert faces(front, back) in readings(CornerGraph(points, inked, 5.0))


def test_no_ladder_without_a_second_face():
    edges = [(k, (k + 1) % 6) for k in range(6)]
    inked = np.zeros((6, 6), bool)
    for i, j in edges:
        inked[i, j] = inked[j, i] = True
    assert list(ladders(CornerGraph(L_SHAPE, inked, 5.0))) == []
    assert list(ladders(CornerGraph(np.zeros((0, 2)), np.zeros((0, 0), bool), 5.0))) == []


def test_what_lies_inside_both_rings_becomes_a_hole():
    outer = Rings((SQUARE,), (SQUARE + DEPTH,))
    hole = SQUARE.mean(axis=0) + 0.4 * (SQUARE - SQUARE.mean(axis=0))
    inner, beside = Rings((hole,), (hole + DEPTH,)), Rings((hole + [160, 0],), (hole + [160, 0] + DEPTH,))
    both = with_holes(outer, [beside, inner])
    assert [len(r) for r in both.front] == [4, 4]
    assert np.array_equal(both.back[1], hole + DEPTH)
    assert with_holes(outer, [beside]) is None
    # a hole within a hole is none
    smaller = SQUARE.mean(axis=0) + 0.2 * (SQUARE - SQUARE.mean(axis=0))
    assert len(with_holes(outer, [Rings((smaller,), (smaller + DEPTH,)), inner]).front) == 2


def test_a_link_past_a_corner_of_both_faces_runs_through_and_is_left_for_later():
    front = np.array([[0.0, 0], [100, 0], [200, 1], [100, 150]])
    back = front + [60, -40]
    points = np.concatenate([front, back])
    inked = ~np.eye(8, dtype=bool)
    rungs = np.stack([np.arange(4), np.arange(4) + 4], axis=1)
    ladder = Ladder(homology.translation(np.array([[60.0, -40]]))[0], rungs, ~np.eye(4, dtype=bool))
    graph = CornerGraph(points, inked, 5.0)
    through = _runs_through(ladder, graph)
    assert [tuple(p) for p in np.argwhere(np.triu(through))] == [(0, 2)]
    found = [sorted(c.tolist()) for c in likely_cycles(ladder, graph, 100, iter(range(1000)))]
    assert found.index([0, 1, 2, 3]) < found.index([0, 2, 3])
    bent = CornerGraph(points + np.where(np.arange(8)[:, None] == 5, [0.0, 30.0], 0.0), inked, 5.0)
    assert not _runs_through(ladder, bent).any()


@pytest.mark.parametrize("ring", [SQUARE[:3], SQUARE, HEXAGON], ids=["wedge", "box", "hexagon"])
def test_chains_are_of_linked_rungs_and_of_six_corners(ring):
    graph = graph_of((ring, ring + DEPTH))
    rungs = np.argwhere(graph.inked)
    links = _links(graph, rungs)
    chains = _chains(rungs, links)
    assert len(chains) >= len(ring)
    assert links[chains[:, 0], chains[:, 1]].all()
    assert links[chains[:, 1], chains[:, 2]].all()
    for face in (0, 1):
        assert all(len(set(corners)) == 3 for corners in rungs[chains, face].tolist())
    assert len({frozenset((a, c)) | {(b,)} for a, b, c in chains.tolist()}) == len(chains)


def rungs_between(graph, front, back):
    """The rungs from each vertex of the front to the one behind it."""
    place = {tuple(p): k for k, p in enumerate(graph.points.tolist())}
    return np.array([[place[tuple(a)], place[tuple(b)]] for a, b in zip(front.tolist(), back.tolist(), strict=True)])


def test_two_rungs_of_a_frustum_tell_its_similarity():
    back = shrunk(L_SHAPE, 0.6, np.array([420.0, 40]))
    graph = graph_of((L_SHAPE, back))
    maps = _from_two(graph, rungs := np.argwhere(graph.inked), _links(graph, rungs))
    missed = np.abs(homology.apply(maps, L_SHAPE) - back).max(axis=(1, 2))
    other = np.abs(homology.apply(maps, back) - L_SHAPE).max(axis=(1, 2))
    assert min(missed.min(), other.min()) < 1e-6


@pytest.mark.parametrize(
    ("front", "back", "scale"),
    [(L_SHAPE, L_SHAPE + DEPTH, 1.0), (L_SHAPE, shrunk(L_SHAPE, 0.6, np.array([420.0, 40])), 0.6)],
    ids=["prism", "frustum"],
)
def test_rungs_are_fitted_by_the_simplest_map_that_carries_them(front, back, scale):
    graph = graph_of((front, back))
    rungs = rungs_between(graph, front, back)
    rough = homology.translation(np.array([[70.0, -50]]))
    fitted = _refitted(graph, rungs, np.ones((1, len(rungs)), bool), rough)
    assert np.abs(homology.apply(fitted, front)[0] - back).max() < 1e-6
    assert np.allclose(fitted[0, :2, :2], scale * np.eye(2))
    assert np.allclose(fitted[0, 2], [0, 0, 1])
