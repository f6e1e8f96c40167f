"""Drawings that the border of the picture cuts off."""

from dataclasses import replace

import numpy as np
import pytest
from sketches import DEPTH, SQUARE, ink_of, line, paper, prism

from sketch2shape.evidence import REFUSE_BELOW
from sketch2shape.ink import closed_at_border
from sketch2shape.ink.cropped import cut_off
from sketch2shape.search import find_all

BOX = prism(SQUARE, SQUARE + DEPTH, "removed", 4)


def confidence_of(found):
    return max((f.confidence for f in found), default=0.0)


@pytest.mark.parametrize("turns", range(4))
def test_a_line_closes_what_runs_into_a_side_of_the_picture(turns):
    picture = paper()
    for x in (100, 300):
        line(picture, [x, 150], [x, 400], 4)
    ink = ink_of(np.ascontiguousarray(np.rot90(picture, turns)))
    closed = closed_at_border(ink)
    new = np.rot90(closed.mask & ~ink.mask, -turns)
    pen = round(ink.pen_width)
    assert new[-pen:, 110:290].all()
    assert not new[:-pen].any()
    assert not new[:, :97].any()
    assert not new[:, 304:].any()
    # the ink given stays as it was
    assert not ink.mask[np.rot90(new, turns)].any()


def test_one_end_two_that_lie_close_and_a_page_seen_whole_close_nothing():
    one, close = line(paper(), [100, 150], [100, 400], 4), line(paper(), [100, 150], [100, 400], 4)
    line(close, [112, 150], [112, 400], 4)
    line(close, [10, 60], [440, 60], 4)
    assert closed_at_border(ink_of(one)) is None
    assert closed_at_border(ink_of(close)) is None
    assert closed_at_border(ink_of(paper())) is None
    both = ink_of(BOX[:290])
    assert closed_at_border(both) is not None
    assert closed_at_border(replace(both, page=np.eye(3))) is None
    assert closed_at_border(ink_of(BOX)) is None


def test_a_box_whose_lowest_edge_is_cut_off_is_read():
    (found,) = find_all(ink_of(BOX[:287]))
    assert found.confidence > 0.5
    gap = np.linalg.norm(found.rings.vertices[:, None] - np.concatenate([SQUARE, SQUARE + DEPTH]), axis=2)
    assert gap.min(axis=0).max() < 8


def test_lines_are_seen_up_to_the_sides_that_cut_ink_off_and_no_others():
    cut = cut_off(ink_of(BOX[:290]))
    assert cut[0].tolist() == [-np.inf, -np.inf]
    assert cut[1, 0] == np.inf
    assert cut[1, 1] == 289
    turned = cut_off(ink_of(np.ascontiguousarray(np.rot90(BOX[:290], -1))))
    assert turned.tolist() == [[0.0, -np.inf], [np.inf, np.inf]]
    assert cut_off(ink_of(BOX)) is None
    assert cut_off(ink_of(paper())) is None
    assert cut_off(replace(ink_of(BOX[:290]), page=np.eye(3))) is None


@pytest.mark.parametrize("lines", ["wire", "dashed"])
def test_corners_beyond_the_border_are_where_the_other_face_tells(lines):
    picture = prism(SQUARE, SQUARE + DEPTH, lines, 3)[:, :330]  # the back face ends at 360
    (found,) = find_all(ink_of(np.ascontiguousarray(picture)))
    assert found.confidence > 0.9
    gap = np.linalg.norm(found.rings.vertices[:, None] - np.concatenate([SQUARE, SQUARE + DEPTH]), axis=2)
    assert gap.min(axis=0).max() < 3


def test_what_is_no_object_stays_none():
    lines = paper()
    for x in (100, 300):
        line(lines, [x, 150], [x, 400], 4)
    assert confidence_of(find_all(ink_of(lines))) < REFUSE_BELOW
