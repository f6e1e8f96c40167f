"""Chords: foreign lines between vertices that an object does not have and a flat figure does."""

from __future__ import annotations

import numpy as np
import pytest
from sketches import line as draw_line
from sketches import outline

from sketch2shape.errors import NoObjectError
from sketch2shape.evidence.chords import chords, faces_of
from sketch2shape.hypotheses import frame
from sketch2shape.pipeline import reconstruct

FRONT = np.array([[0.0, 100.0], [100.0, 100.0], [100.0, 0.0], [0.0, 0.0]])
BOX = np.concatenate([FRONT, FRONT + [40.0, -30.0]])
SIZE = 200.0


def line(a, b):
    return np.linspace(a, b, 60)


def of_box(*lines, reach=2.0):
    ink = np.concatenate([np.zeros((0, 2)), *lines])
    return chords(ink, BOX, frame((4,)).edges, lambda: faces_of(BOX[:4], BOX[4:]), reach, SIZE)


def test_a_drawing_without_foreign_ink_has_none():
    assert of_box() == 0.0


@pytest.mark.parametrize(("one", "other"), [(0, 2), (1, 3), (0, 6), (1, 7)])
def test_diagonals_of_faces_and_of_the_box_are_none(one, other):
    assert of_box(line(BOX[one], BOX[other])) == 0.0


NOTCH = np.array([[0.0, 0.0], [50.0, 60.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]])
NOTCHED = np.concatenate([NOTCH, NOTCH + [5.0, 15.0]])


def of_notched(ink):
    return chords(ink, NOTCHED, frame((5,)).edges, lambda: faces_of(NOTCHED[:5], NOTCHED[5:]), 2.0, SIZE)


def test_a_line_outside_the_silhouette_counts_by_its_length():
    assert of_notched(line(NOTCHED[0], NOTCHED[2])) == pytest.approx(100.0 / SIZE)


def test_a_line_that_ends_between_the_vertices_is_no_chord():
    assert of_notched(line(NOTCHED[0], 0.5 * (NOTCHED[0] + NOTCHED[2]))) == 0.0


def test_a_line_that_an_edge_is_a_part_of_counts():
    # the upper edge of the front ends at a vertex of the ring, and the ink goes on to the far corner
    front = np.array([[0.0, 0.0], [60.0, 0.0], [100.0, 100.0], [120.0, 0.0], [120.0, 150.0], [0.0, 150.0]])
    v = np.concatenate([front, front + [10.0, 12.0]])
    on = line(v[1] + [4.0, 0.0], v[3])
    told = chords(on, v, frame((6,)).edges, lambda: faces_of(v[:6], v[6:]), 2.0, SIZE)
    assert told == pytest.approx(60.0 / SIZE)


def test_an_answer_without_vertices_has_none():
    nothing = np.zeros((0, 2))
    assert chords(line((0, 0), (9, 9)), nothing, np.zeros((0, 2), int), list, 2.0, SIZE) == 0.0


def test_a_pentagon_with_two_diagonals_is_hardly_an_object():
    turn = 0.4 * np.pi * np.arange(5) - 0.5 * np.pi
    ring = np.array([200.0, 200.0]) + 130.0 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    picture = outline(ring)
    for one, other in ((0, 2), (2, 4)):
        draw_line(picture, ring[one], ring[other])
    try:
        sure = [found.confidence for found in reconstruct(picture).objects]
    except NoObjectError:
        sure = []
    assert all(confidence < 0.3 for confidence in sure)
