"""Which ink belongs together."""

from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from sketches import DEPTH, SQUARE, ink_of, line, outline, paper, prism

from sketch2shape.ink.groups import ENCLOSED, FEW, WHOLE, _meet, split_groups
from sketch2shape.model import ring_edges


def boxes(groups):
    """Where each group's ink lies on the sheet: x0, y0, x1, y1."""
    found = []
    for g in groups:
        ys, xs = np.nonzero(g.ink.mask)
        found.append([*(np.array([xs.min(), ys.min()]) + g.offset), *(np.array([xs.max(), ys.max()]) + g.offset)])
    return np.array(found)


def test_two_objects_on_a_sheet_are_two_groups_the_larger_first():
    picture = paper(400, 900)
    small = SQUARE * 0.6 + [480, 60]
    prism(SQUARE, SQUARE + DEPTH, picture=picture)
    prism(small, small + DEPTH * 0.6, picture=picture)
    groups = split_groups(ink_of(picture))
    assert len(groups) == 2
    large = np.r_[SQUARE, SQUARE + DEPTH]
    assert np.abs(boxes(groups)[0] - [*large.min(axis=0), *large.max(axis=0)]).max() < 4


def test_strokes_that_do_not_meet_are_one_group_however_far_they_stop_short():
    picture = paper()
    vertices = np.concatenate([SQUARE, SQUARE + DEPTH])
    for i, j in ring_edges([4]):
        way = (vertices[j] - vertices[i]) / np.linalg.norm(vertices[j] - vertices[i])
        line(picture, vertices[i] + 14.0 * way, vertices[j] - 14.0 * way)
    assert len(split_groups(ink_of(picture))) == 1


def test_objects_whose_strokes_meet_are_apart_where_such_strokes_would_not_be():
    picture = paper(400, 900)
    beside = SQUARE + [np.ptp(SQUARE[:, 0]) + 18.0, 0.0]
    outline(SQUARE, picture=picture)
    outline(beside, picture=picture)
    assert len(split_groups(ink_of(picture))) == 2


def test_a_hole_belongs_to_the_object_around_it():
    picture = prism(SQUARE, SQUARE + DEPTH, "removed")
    hole = SQUARE.mean(axis=0) + 0.3 * (SQUARE - SQUARE.mean(axis=0))
    outline(hole, picture=picture)
    assert len(split_groups(ink_of(picture))) == 1


def test_dashes_belong_to_their_object_but_are_not_solid():
    groups = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH, "dashed")))
    assert len(groups) == 1
    group = groups[0]
    x, y = np.rint((SQUARE[3] + SQUARE[2]) / 2 - group.offset).astype(int)
    assert group.solid[y - 2 : y + 3, x - 2 : x + 3].any()
    dashes = group.ink.mask & ~group.solid
    assert dashes.sum() > 50


def test_a_lone_letter_beside_an_object_is_no_group():
    picture = prism(SQUARE, SQUARE + DEPTH)
    cv2.putText(picture, "b", (420, 380), cv2.FONT_HERSHEY_SIMPLEX, 0.7, 0, 2, cv2.LINE_AA)
    assert len(split_groups(ink_of(picture))) == 1


def test_blank_paper_has_no_groups():
    assert split_groups(ink_of(paper())) == []


@pytest.mark.parametrize(
    ("enclosing", "lines", "specks", "meet"),
    [
        (100.0, [50.0] * 4, [], True),
        (100.0, [90.0] * 8, [], False),
        (100.0, [], [9.0] * 100, True),
        (40.0, [100.0], [], False),
    ],
    ids=["an outline and arrows", "strokes of which some cross", "an outline and letters", "one small loop"],
)
def test_strokes_meet_where_most_of_them_are_one_piece(enclosing, lines, specks, meet):
    assert 100 / 820 < FEW < 100 / 300
    assert 0.4 < WHOLE < 1.0
    extent = np.array([0.0, enclosing, *lines, *specks])
    holes = np.zeros(len(extent))
    holes[1] = 2 * ENCLOSED * 4
    pieces = SimpleNamespace(holes=holes, extent=extent)
    assert _meet(pieces, 2.0, 10.0) is meet
