"""Rings alone and in stacks, and which of them could be the faces of an object."""

import numpy as np
from sketches import DEPTH, L_SHAPE, SQUARE, shrunk

from sketch2shape.hypotheses.hypothesis import Rings, frame, has_edges, plausible, split, stack, which_plausible

BOX = Rings((SQUARE,), (SQUARE + DEPTH,))
HOLE = shrunk(SQUARE, 0.4, SQUARE.mean(axis=0))


def test_vertices_split_into_the_rings_they_came_from():
    for rings in (BOX, Rings((SQUARE, HOLE, L_SHAPE), (SQUARE + 1, HOLE + 2, L_SHAPE + 3))):
        again = split(rings.vertices, rings.sizes)
        assert all(
            np.array_equal(a, b) for a, b in zip(again.front + again.back, rings.front + rings.back, strict=True)
        )


def test_after_and_the_backs_edges_follow_each_ring():
    two = frame((4, 3))
    assert two.after.tolist() == [1, 2, 3, 0, 5, 6, 4]
    assert two.spans == ((0, 4), (4, 7))
    # edges among the last seven vertices are the back's, and nothing else is
    assert np.flatnonzero((two.edges >= 7).all(axis=1)).tolist() == two.backs.tolist()


def test_what_cannot_be_the_faces_of_an_object():
    assert plausible(BOX, 3.0)
    crossed = SQUARE[[0, 2, 1, 3]]
    assert not plausible(Rings((crossed,), (crossed + DEPTH,)), 3.0)
    assert not plausible(Rings((SQUARE,), (shrunk(SQUARE, 0.05, SQUARE[0]),)), 3.0)  # a pyramid
    assert not plausible(Rings((SQUARE,), (SQUARE + 1.0,)), 3.0)  # no depth
    assert not plausible(Rings((SQUARE,), (SQUARE * [-1, 1] + [500, 0],)), 3.0)  # turned over
    assert not plausible(Rings((SQUARE,), (np.full((4, 2), np.inf),)), 3.0)


def test_a_stack_is_checked_as_each_alone():
    crossed = SQUARE[[0, 2, 1, 3]]
    some = [BOX, Rings((crossed,), (crossed + DEPTH,)), Rings((SQUARE,), (SQUARE + 1.0,)), BOX.swapped()]
    assert which_plausible(stack(some), 3.0).tolist() == [plausible(r, 3.0) for r in some] == [True, False, False, True]


def test_a_crossed_hole_is_found_out():
    crossed = HOLE[[0, 2, 1, 3]]
    assert plausible(Rings((SQUARE, HOLE), (SQUARE + DEPTH, HOLE + DEPTH)), 3.0)
    assert not plausible(Rings((SQUARE, crossed), (SQUARE + DEPTH, crossed + DEPTH)), 3.0)


def test_the_same_box_has_the_same_edges_whatever_it_calls_its_faces():
    drawn = np.ones(4, bool)
    sides = split(BOX.vertices[[0, 1, 5, 4, 3, 2, 6, 7]], (4,))
    for other in (BOX.swapped(), sides):
        assert has_edges(other, BOX, drawn, 1.0)
    assert not has_edges(Rings((SQUARE + 5.0,), (SQUARE + DEPTH,)), BOX, drawn, 1.0)
    assert has_edges(Rings((SQUARE + 5.0,), (SQUARE + DEPTH,)), BOX, drawn, 6.0)
    assert not has_edges(Rings((L_SHAPE,), (L_SHAPE + DEPTH,)), BOX, drawn, 500.0)
    # the same vertices joined crosswise
    assert not has_edges(Rings((SQUARE[[0, 2, 1, 3]],), ((SQUARE + DEPTH)[[0, 2, 1, 3]],)), BOX, drawn, 1.0)


def test_where_a_hidden_vertex_lies_makes_no_other_object():
    vertices = BOX.vertices
    vertices[7] += 40.0
    other = split(vertices, (4,))
    assert not has_edges(other, BOX, np.ones(4, bool), 1.0)
    assert has_edges(other, BOX, np.array([True, True, True, False]), 1.0)
