"""Strokes that stop short of their corners are drawn on to them; others are left alone."""

import numpy as np
from sketches import DEPTH, SQUARE, ink_of, line, paper, prism, same_object

import sketch2shape as s2s
from sketch2shape.model import ring_edges
from sketch2shape.strokes.bridging import bridged
from sketch2shape.strokes.skeleton import thin


def short_of_corners(f1, f2, gap):
    picture, v = paper(), np.concatenate([f1, f2])
    for i, j in ring_edges([len(f1)]):
        way = (v[j] - v[i]) / np.linalg.norm(v[j] - v[i])
        line(picture, v[i] + gap * way, v[j] - gap * way)
    return picture


def bridges(picture):
    ink = ink_of(picture)
    whole = bridged(thin(ink), ink.mask, 1.5)
    return None if whole is None else whole & ~ink.mask


def test_gaps_at_every_vertex_are_closed_to_the_vertex():
    drawn = bridges(short_of_corners(SQUARE, SQUARE + DEPTH, 10.0))
    assert drawn is not None
    for x, y in np.concatenate([SQUARE, SQUARE + DEPTH]).astype(int):
        assert drawn[y - 2 : y + 3, x - 2 : x + 3].any()


def test_a_drawing_whose_strokes_meet_gets_no_bridges():
    assert bridges(prism(SQUARE, SQUARE + DEPTH)) is None
    assert bridges(line(paper(), [40, 40], [300, 200])) is None


def test_a_box_with_gaps_is_found():
    picture = short_of_corners(SQUARE, SQUARE + DEPTH, 10.0)
    assert same_object(s2s.reconstruct(picture).objects[0], SQUARE, SQUARE + DEPTH, 5.0)


def test_gaps_that_corners_bridge_are_closed_all_the_same():
    """Ends so close to each other that they make a corner, with no ink between."""
    picture = short_of_corners(SQUARE, SQUARE + DEPTH, 6.0)
    assert bridges(picture) is not None
    assert same_object(s2s.reconstruct(picture).objects[0], SQUARE, SQUARE + DEPTH, 5.0)


def test_wider_gaps_are_closed_where_most_ends_meet_nothing():
    """Seven pens at every end of every stroke, in a drawing that falls apart into pieces."""
    picture = short_of_corners(SQUARE, SQUARE + DEPTH, 14.0)
    assert same_object(s2s.reconstruct(picture).objects[0], SQUARE, SQUARE + DEPTH, 5.0)


def test_strokes_that_run_on_past_their_corners_are_not_short():
    assert bridges(short_of_corners(SQUARE, SQUARE + DEPTH, -14.0)) is None
