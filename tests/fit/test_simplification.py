"""Vertices that the drawing does not need."""

import numpy as np
from sketches import DEPTH, HEXAGON, SQUARE, prism, sheet_of

from sketch2shape.evidence.score import judge
from sketch2shape.fit.simplification import simplified
from sketch2shape.hypotheses.hypothesis import Rings


def counted(f1, drawn, noise=0.3):
    """Vertices of a face that are left of the hypothesis f1 on a drawing of the prism over `drawn`."""
    sheet = sheet_of(prism(drawn, drawn + DEPTH))
    rings = Rings((f1,), (f1 + DEPTH,))
    left, evidence = simplified(rings, judge(rings, sheet), sheet, noise, sheet.points)
    assert evidence.score > 0.95
    return len(left.front[0])


def test_a_vertex_on_a_straight_edge_goes():
    extra = np.insert(SQUARE, 1, (SQUARE[0] + SQUARE[1]) / 2 + [0.0, 1.0], axis=0)
    assert counted(extra, SQUARE) == 4


def test_two_vertices_at_one_corner_become_one():
    cut = np.insert(SQUARE, 1, SQUARE[1] + 0.04 * (SQUARE[0] - SQUARE[1]), axis=0)
    cut[2] = SQUARE[1] + 0.04 * (SQUARE[2] - SQUARE[1])
    assert counted(cut, SQUARE) == 4


def test_vertices_that_are_drawn_stay():
    assert counted(SQUARE, SQUARE) == 4
    assert counted(HEXAGON, HEXAGON) == 6
