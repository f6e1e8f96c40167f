"""Loose ends: strokes that thinning has cut short are drawn on to where others end, and nowhere else."""

from types import SimpleNamespace

import numpy as np
from sketches import ink_of, line, paper

from sketch2shape.strokes.junctions import join_ends
from sketch2shape.strokes.loose_ends import without_loose_ends
from sketch2shape.strokes.skeleton import thin
from sketch2shape.strokes.tracing import Strokes

CORNER = np.array([300.0, 300])


def drawn_on(ends, *lines):
    """Strokes between these ends on a drawing of these lines, with loose ends drawn on."""
    picture = paper()
    for a, b in lines:
        line(picture, a, b)
    skeleton = thin(ink_of(picture))
    strokes = Strokes(np.array(ends, float), np.ones(len(ends)), 1.5)
    return without_loose_ends(strokes, join_ends(strokes, skeleton.pen_width), skeleton).ends


def test_ends_that_stop_short_of_a_corner_meet_in_it():
    lines = [([100, 300], CORNER), (CORNER, [300, 80])]
    ends = drawn_on([[[100, 300], [286, 300]], [[300, 286], [300, 80]]], *lines)
    assert np.abs(ends[0, 1] - CORNER).max() < 3
    assert np.abs(ends[1, 0] - CORNER).max() < 3
    assert ends[0, 0].tolist() == [100, 300]


def test_without_ink_no_stroke_becomes_longer():
    given = [[[100, 300], [286, 300]], [[300, 286], [300, 80]]]
    assert drawn_on(given, ([100, 300], [286, 300]), ([300, 286], [300, 80])).tolist() == given


def test_an_end_that_meets_none_stays_where_it_was():
    given = [[[100, 300], [270, 300]]]
    assert drawn_on(given, ([100, 300], CORNER)).tolist() == given


def test_a_stroke_becomes_longer_by_half_at_most():
    given = [[[270, 300], [286, 300]], [[300, 296], [300, 80]]]
    (short, _) = drawn_on(given, ([100, 300], CORNER), (CORNER, [300, 80]))
    assert short[1, 0] <= 286 + 8


def test_without_loose_ends_nothing_is_asked_of_the_ink():
    strokes = Strokes(np.zeros((0, 2, 2)), np.zeros(0), 1.5)
    assert without_loose_ends(strokes, join_ends(strokes, 2.0), SimpleNamespace()) is strokes
