"""Hypotheses from ruled lines: regions between them as front faces, with the backs that lines leaving them tell of."""

import numpy as np
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, shrunk
from solid_lines import prism_lines

from sketch2shape.hypotheses import ruled_caps, ruled_graph
from sketch2shape.hypotheses.hypothesis import coincide
from sketch2shape.model import VectorLine
from sketch2shape.strokes import ruled_lines


def caps(f1, f2):
    return list(ruled_caps(ruled_lines(prism_lines(f1, f2, "removed"))))


def test_the_graph_joins_corners_on_one_segment():
    graph = ruled_graph(ruled_lines(prism_lines(HEXAGON, HEXAGON + DEPTH)))
    assert len(graph.points) == 12
    assert (graph.inked.sum(axis=1) == 3).all()


def test_the_largest_region_comes_first():
    first, *_ = caps(HEXAGON, HEXAGON + DEPTH)
    assert coincide(first.front[0], HEXAGON, 1e-6)
    assert coincide(first.back[0], HEXAGON + DEPTH, 1e-6)


def test_each_side_of_a_box_may_be_the_front():
    found = caps(SQUARE, SQUARE + DEPTH)
    assert len(found) == 3
    assert all(coincide(f.vertices, np.concatenate([SQUARE, SQUARE + DEPTH]), 1e-6) for f in found)


def test_a_smaller_back_follows_from_the_lines_that_lead_to_it():
    back = shrunk(HEXAGON, 0.8, np.array([420.0, 60]))
    assert any(coincide(f.back[0], back, 1e-6) for f in caps(HEXAGON, back) if f.sizes == (6,))


def test_lines_cut_off_by_the_object_lead_nowhere():
    back = L_SHAPE + [30.0, -70]
    seen = [(back[0], back[1]), (back[1], back[2]), ((180.0, 190.0), back[4])]
    rungs = [(L_SHAPE[k], back[k]) for k in (0, 1, 2, 4)]
    ring = [(L_SHAPE[k - 1], L_SHAPE[k]) for k in range(6)]
    found = ruled_caps(ruled_lines([VectorLine(np.array(ends)) for ends in (*ring, *rungs, *seen)]))
    assert any(coincide(f.vertices, np.concatenate([L_SHAPE, back]), 1e-6) for f in found)


def test_a_face_alone_has_no_back():
    ring = prism_lines(SQUARE, SQUARE + DEPTH)[:4]
    assert list(ruled_caps(ruled_lines(ring))) == []


def test_lines_hardly_beside_each_other_end_the_walk_round_all_the_same():
    beside = VectorLine(np.array([[120.0, 140.3], [270.0, 140.3]]))
    found = ruled_lines([*prism_lines(SQUARE, SQUARE + DEPTH, "removed"), beside])
    assert len(found.ends) == 10
    assert len(list(ruled_caps(found))) >= 3
