"""Faces that foreign lines have cut in pieces are put together again."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, SQUARE, ink_of, line, prism, same_object

import sketch2shape as s2s
from sketch2shape.hypotheses.hypothesis import coincide
from sketch2shape.hypotheses.regions import enclosed_regions
from sketch2shape.hypotheses.unions import united


def unions_of(picture):
    ink = ink_of(picture)
    return list(united(enclosed_regions(ink.mask, ink.pen_width, 1.5), ink.pen_width, 1.5))


def test_two_triangles_make_the_square_that_a_diagonal_has_cut():
    picture = line(prism(SQUARE, SQUARE + DEPTH, "removed"), SQUARE[0], SQUARE[2])
    assert any(len(u.outline) == 4 and coincide(u.outline, SQUARE, 5) for u in unions_of(picture))


def test_six_triangles_make_the_hexagon_that_its_spokes_have_cut():
    picture = prism(HEXAGON, HEXAGON + [110, -20], "removed")
    for k in range(3):
        line(picture, HEXAGON[k], HEXAGON[k + 3])
    assert any(len(u.outline) == 6 and coincide(u.outline, HEXAGON, 5) for u in unions_of(picture))


def test_each_union_is_given_once_and_regions_alone_are_none():
    picture = prism(SQUARE, SQUARE + DEPTH, "removed")
    found = unions_of(picture)
    keys = [np.rint(np.sort(u.outline, axis=0)).tobytes() for u in found]
    assert len(set(keys)) == len(keys)
    assert not any(coincide(u.outline, SQUARE, 5) for u in found)


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_drawing_with_a_diagonal_is_read_as_without(lines):
    picture = line(prism(SQUARE, SQUARE + DEPTH, lines), SQUARE[0], SQUARE[2])
    assert same_object(s2s.reconstruct(picture).objects[0], SQUARE, SQUARE + DEPTH, 4.0)
