"""The separator for drawings without solid hidden edges."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, ink_of, outline, prism, shrunk

from sketch2shape.hypotheses.opaque import PULL, Rungs, _swept, _with_tips, caps
from sketch2shape.hypotheses.regions import Region, enclosed_regions
from sketch2shape.hypotheses.wireframe import CornerGraph
from sketch2shape.search.tolerances import Round, corner_graph, vertex_candidates
from sketch2shape.strokes.junctions import join_ends
from sketch2shape.strokes.skeleton import thin
from sketch2shape.strokes.tracing import trace_skeleton


def graph_of(ink):
    skeleton = thin(ink)
    strokes = trace_skeleton(skeleton, 1.5)
    points = vertex_candidates(strokes, join_ends(strokes, ink.pen_width), Round(1.5, 2.0), ink.pen_width)
    return corner_graph(skeleton, points, 2.0)


def hypotheses(picture):
    ink = ink_of(picture)
    graph = graph_of(ink)
    return list(caps(graph, enclosed_regions(ink.mask, ink.pen_width, 1.5), ink.pen_width))


def near(a, b, within):
    if len(a) != len(b):
        return False
    gap = np.linalg.norm(a[:, None] - b[None], axis=2)
    return max(gap.min(axis=0).max(), gap.min(axis=1).max()) <= within


@pytest.mark.parametrize("lines", ["removed", "dashed"])
@pytest.mark.parametrize("f1", [SQUARE, HEXAGON], ids=["box", "hexagon"])
def test_the_visible_cap_and_the_face_behind_it_are_proposed(f1, lines):
    found = hypotheses(prism(f1, f1 + DEPTH, lines))
    assert any(near(r.front[0], f1, 4) and near(r.back[0], f1 + DEPTH, 8) for r in found)
    assert all(len(r.front) == len(r.back) for r in found)


def test_a_tapered_back_face_is_completed_at_its_own_size():
    f2 = shrunk(SQUARE, 0.6, np.array([460.0, 60]))
    found = hypotheses(prism(SQUARE, f2, "removed"))
    assert any(near(r.front[0], SQUARE, 4) and near(r.back[0], f2, 8) for r in found)


def test_a_hole_in_the_cap_comes_with_its_back():
    hole = SQUARE.mean(axis=0) + 0.4 * (SQUARE - SQUARE.mean(axis=0))
    picture = prism(SQUARE, SQUARE + DEPTH, "removed")
    outline(hole, picture=picture)
    holed = [r for r in hypotheses(picture) if len(r.front) == 2]
    assert any(near(r.front[1], hole, 4) and near(r.back[1], hole + DEPTH, 8) for r in holed)


def test_rungs_leave_the_cap_so_a_lone_polygon_gives_nothing():
    picture = outline(L_SHAPE)
    assert hypotheses(picture) == []


def test_a_speck_on_a_corner_is_no_hole():
    ink = ink_of(prism(SQUARE, SQUARE + DEPTH, "removed"))
    graph = graph_of(ink)
    speck = Region(SQUARE, (SQUARE[0] + [[1.0, 0], [1, 1], [0, 1]],))
    found = list(caps(graph, [speck], ink.pen_width))
    assert found
    assert all(len(ring) >= 3 for r in found for ring in r.front)


@pytest.mark.parametrize(("tolerances", "pulls"), [(0.9 * PULL, True), (1.1 * PULL, False)])
def test_the_end_of_a_rung_near_its_place_pulls_the_back_vertex_there(tolerances, pulls):
    graph = CornerGraph(np.zeros((0, 2)), np.zeros((0, 0), bool), 8.0)
    ends = SQUARE + DEPTH
    ends[2] += [8.0 * tolerances, 0.0]
    found = [r.back[0] for r in _swept(SQUARE, (), Rungs(np.arange(4), ends), graph, 1)]
    assert np.allclose(found[0], SQUARE + DEPTH)
    assert any(np.allclose(back, ends) for back in found) == pulls


def test_a_sharp_corner_is_found_ahead_of_where_its_strokes_run_into_one():
    f1 = np.array([[60.0, 300], [400, 220], [400, 300]])
    depth = np.array([-20.0, -150])
    ring = f1.copy()
    ring[0] += [30.0, -3]
    points = np.concatenate([ring, f1[:1], f1 + depth])
    graph = CornerGraph(points, np.ones((7, 7), bool), 5.0)
    corner, sharp = _with_tips(np.arange(3), ring, graph, 6.0)
    assert corner.tolist() == [3, 1, 2]
    assert np.array_equal(sharp, f1)
    assert _with_tips(np.arange(3), ring, graph, 2.0)[0].tolist() == [0, 1, 2]
    # its own vertex lies on no corner
    assert _with_tips(np.array([-1, 1, 2]), ring, graph, 6.0)[0].tolist() == [3, 1, 2]
    square = CornerGraph(np.concatenate([SQUARE, SQUARE[:1] - 20]), np.ones((5, 5), bool), 5.0)
    assert _with_tips(np.arange(4), SQUARE, square, 30.0)[0].tolist() == [0, 1, 2, 3]


def test_a_thin_wedge_is_proposed_though_its_tip_is_cut_off():
    f1 = np.array([[125.0, 222], [469, 221], [468, 141]])
    back = f1 + [-115, -120]
    picture = prism(f1, back, "removed", width=5)
    assert any(near(r.front[0], f1, 7) and near(r.back[0], back, 12) for r in hypotheses(picture))
