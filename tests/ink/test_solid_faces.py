"""Solid faces: hollow where the ink is deeper than a stroke is wide, and left alone elsewhere."""

import cv2
from sketches import DEPTH, SQUARE, ink_of, prism, same_object

from sketch2shape.ink.solid_faces import without_solid_faces
from sketch2shape.search import as_object, find_all

PEN = 24


def icon(*, filled):
    """A box of thick lines, its front face filled with their colour."""
    picture = prism(SQUARE, SQUARE + DEPTH, "removed", PEN)
    if filled:
        cv2.fillPoly(picture, [SQUARE.astype(int)], 0)
    return picture


def test_a_filled_face_becomes_its_outline():
    mask = icon(filled=True) < 128
    left = without_solid_faces(mask, float(PEN), 600.0)
    assert not left[215, 195]
    assert not (left & ~mask).any()
    # what is left of the sides of the face is about as wide as the pen
    assert abs(int(left[215, 100:195].sum()) - PEN) <= 3


def test_thick_strokes_and_their_corners_stay():
    mask = icon(filled=False) < 128
    assert without_solid_faces(mask, float(PEN), 600.0) is mask


def test_a_box_with_a_filled_face_is_read_as_one_without():
    (found,) = find_all(ink := ink_of(icon(filled=True)))
    assert found.confidence > 0.9
    assert same_object(as_object(found.rings, found.evidence, ink), SQUARE, SQUARE + DEPTH, 6.0)
