"""Hypotheses that differ from another by one vertex."""

import numpy as np
import pytest
from sketches import DEPTH, L_SHAPE, SQUARE, line, prism, sheet_of

from sketch2shape.evidence import judge
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.search.neighbours import LARGEST, MOST_VERTICES, _completed, climbed, grown, neighbours

CORNERS = np.concatenate([SQUARE, SQUARE + DEPTH, [[200.0, 200]]])
REMOVED = sheet_of(prism(SQUARE, SQUARE + DEPTH, "removed"), reach=3.0)
ALL = np.ones(4, bool)


def moved(ring, k, by):
    other = ring.copy()
    other[k] += by
    return other


def climb(rings, sheet=REMOVED, corners=CORNERS):
    return climbed([(rings, judge(rings, sheet))], sheet, corners)


@pytest.mark.parametrize(
    ("front", "back"),
    [
        (moved(SQUARE, 1, [-40.0, 25]), SQUARE + DEPTH),
        (SQUARE, moved(SQUARE + DEPTH, 1, [30.0, 40])),
        (moved(SQUARE, 1, [-40.0, 25]), moved(SQUARE + DEPTH, 1, [-40.0, 25])),
        (np.insert(SQUARE, 1, [190.0, 175], 0), np.insert(SQUARE + DEPTH, 1, [280.0, 115], 0)),
        (np.delete(SQUARE, 1, 0), np.delete(SQUARE + DEPTH, 1, 0)),
    ],
    ids=["front", "back", "both", "one too many", "one too few"],
)
def test_the_box_is_reached_from_a_hypothesis_with_one_vertex_wrong(front, back):
    top = climb(Rings((front,), (back,)))
    assert len(top) == 1
    found = top[0][0]
    seen = top[0][1].drawn
    assert np.abs(found.front[0] - SQUARE).max() < 1
    assert np.abs(found.back[0] - SQUARE - DEPTH)[seen].max() < 1
    assert seen.sum() == 3


def test_what_is_best_already_has_nothing_above_it():
    assert climb(Rings((SQUARE,), (SQUARE + DEPTH,))) == []


def test_the_best_is_climbed_from_and_faces_with_holes_are_left_alone():
    near, far = moved(SQUARE, 1, [-40.0, 25]), moved(moved(SQUARE, 1, [-40.0, 25]), 3, [30.0, -60])
    starts = [Rings((f,), (f + DEPTH,)) for f in (near, far)]
    judged = [(r, judge(r, REMOVED)) for r in starts]
    (top,) = climbed(judged, REMOVED, CORNERS)
    assert np.abs(top[0].front[0] - SQUARE).max() < 1
    assert climbed([], REMOVED, CORNERS) == []
    hole = 0.5 * SQUARE + 0.5 * SQUARE.mean(axis=0)
    assert climb(Rings((near, hole), (near + DEPTH, hole + DEPTH))) == []
    assert climb(starts[0], corners=np.zeros((0, 2))) == []


def test_neighbours_differ_by_one_vertex_of_the_front():
    box = Rings((SQUARE,), (SQUARE + DEPTH,))
    elsewhere, fewer, more = neighbours(box, judge(box, REMOVED), CORNERS, REMOVED)
    front = elsewhere.vertices[:, :4]
    assert ((front != SQUARE).any(axis=2).sum(axis=1) <= 1).all()
    assert fewer.sizes == (3,)
    assert len(fewer) == 4
    assert more.sizes == (5,)
    ring = np.concatenate([L_SHAPE, L_SHAPE * 0.5, L_SHAPE * 0.25])[:MOST_VERTICES]
    full = Rings((ring,), (ring + DEPTH,))
    assert [s.sizes for s in neighbours(full, judge(full, REMOVED), CORNERS, REMOVED)] == [(12,), (11,)]


def test_a_chamfer_is_found_and_a_vertex_on_an_edge_is_none():
    cut = np.array([[120.0, 140], [250, 140], [270, 165], [270, 290], [120, 290]])
    sheet = sheet_of(prism(cut, cut + DEPTH), reach=3.0)
    start = Rings((SQUARE,), (SQUARE + DEPTH,))
    ((found, _),) = grown((start, judge(start, sheet)), sheet, cut)
    assert np.array_equal(found.front[0], cut)
    assert np.allclose(found.back[0], cut + DEPTH)
    # a line from edge to edge along the others
    lined = line(prism(SQUARE, SQUARE + DEPTH), [195, 140], np.array([195, 140]) + DEPTH)
    assert grown((start, judge(start, sheet_of(lined))), sheet_of(lined), np.array([[195.0, 140]])) == []


def test_hidden_vertices_follow_those_that_are_seen():
    back = 0.5 * SQUARE + 100
    lost = moved(back, 2, [50.0, 50])
    seen = ALL.copy()
    seen[2] = False
    assert np.allclose(_completed(SQUARE[None], lost[None], seen[None])[0], back)
    one = np.array([True, False, False, False])
    assert np.allclose(_completed(SQUARE[None], (SQUARE + DEPTH)[None], one[None])[0], SQUARE + DEPTH)
    none = np.zeros(4, bool)
    assert np.array_equal(_completed(SQUARE[None], lost[None], none[None])[0], lost)
    huge = LARGEST * 2 * SQUARE
    placed = _completed(SQUARE[None], moved(huge, 0, 0.0)[None], seen[None])[0]
    assert np.hypot(*(placed[2] - placed[1:2][0])) < np.hypot(*(huge[2] - huge[1]))
