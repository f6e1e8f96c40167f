"""Witnesses: each tells what it is named after."""

from itertools import pairwise

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, SQUARE, ink_of, line, outline, paper, prism, sheet_of

from sketch2shape.evidence import WITNESSES, compare, is_table, judge, observe, witnesses
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.ink import split_groups
from sketch2shape.model.drawing import ring_edges
from sketch2shape.strokes.skeleton import thin

BOX = Rings((SQUARE,), (SQUARE + DEPTH,))


def seen_in(picture, rings=BOX, hand=0.5):
    (group,) = split_groups(ink_of(picture))
    view = observe(group, thin(group.ink))
    evidence = judge(rings, sheet_of(picture))
    own = rings.shifted(-group.offset)
    compared = compare(own, view, evidence.drawn, 4.0)
    found = witnesses(own, compared.energy(hand), compared, evidence)
    return dict(zip(WITNESSES, found, strict=True))


def test_a_clean_box_has_nothing_against_it():
    seen = seen_in(prism(SQUARE, SQUARE + DEPTH))
    for name in ("unexplained", "attached", "closed", "loose", "flat", "doubled", "bend", "unseen"):
        assert seen[name] < 0.05, name
    assert seen["vertices"] == pytest.approx(np.log(4))


def test_a_line_past_the_object_from_vertex_to_vertex_is_a_chord():
    dart = np.array([[225.0, 100], [120, 280], [225, 200], [330, 290]])
    rings = Rings((dart,), (dart + [8, 20],))
    clean = prism(dart, dart + [8, 20])
    assert seen_in(clean, rings)["chords"] == 0.0
    assert seen_in(line(clean.copy(), dart[1], dart[3]), rings)["chords"] > 0.5


def test_foreign_ink_is_told_by_length_and_whether_it_touches():
    clean = prism(SQUARE, SQUARE + DEPTH)
    beside = seen_in(line(clean.copy(), [130, 302], [260, 302]))
    touching = seen_in(line(clean.copy(), SQUARE[3], [180, 370]))
    assert beside["unexplained"] > 0.05
    assert beside["attached"] < 0.02 < touching["attached"]


def test_ink_that_encloses_something_by_itself_is_told():
    picture = outline(148 + 0.35 * (SQUARE - 120), picture=prism(SQUARE, SQUARE + DEPTH))
    assert seen_in(picture)["closed"] > 0.1


def test_corners_of_lines_that_the_object_lacks_are_loose():
    clean = prism(SQUARE, SQUARE + DEPTH)
    beside = seen_in(outline(np.array([[140, 240], [140, 280], [190, 280]]), picture=clean.copy()))
    diagonal = seen_in(line(clean.copy(), SQUARE[0], SQUARE[2]))
    assert beside["loose"] >= np.log1p(2)
    # a line between corners of the object makes no corner of its own
    assert diagonal["loose"] == 0 < diagonal["unexplained"]


def test_bowed_edges_are_told_from_straight_ones():
    around = np.arange(0, 360, 60) * np.pi / 180
    six = np.array([200.0, 200]) + 90 * np.c_[np.cos(around), np.sin(around)]
    fine = np.arange(0, 360, 4) * np.pi / 180
    circle = np.array([200.0, 200]) + 90 * np.c_[np.cos(fine), np.sin(fine)]
    rings = Rings((six,), (six + [110, -20],))
    straight = seen_in(prism(six, six + [110, -20]), rings, hand=4.0)["bend"]
    bowed = seen_in(outline(circle + [110, -20], picture=outline(circle)), rings, hand=4.0)["bend"]
    assert straight < 0.02 < 0.08 < bowed


def test_a_table_has_two_directions_and_lies_on_itself():
    picture = outline(SQUARE + [0, 75], picture=outline(SQUARE))
    seen = seen_in(picture, Rings((SQUARE,), (SQUARE + [0, 75],)))
    assert seen["flat"] == 1
    assert seen["doubled"] > 0.2
    assert seen_in(prism(SQUARE, SQUARE + DEPTH))["flat"] == 0


def test_a_vertex_behind_that_nobody_sees_is_told():
    assert seen_in(prism(SQUARE, SQUARE + DEPTH, "removed"))["unseen"] == pytest.approx(0.25)


@pytest.mark.parametrize("scale", [0.7, 1.5])
def test_witnesses_do_not_depend_on_the_size_of_the_drawing(scale):
    big = Rings((HEXAGON * scale,), ((HEXAGON + [110, -20]) * scale,))
    width = max(1, round(2 * scale))
    paper = np.full((int(400 * scale), int(480 * scale)), 255, np.uint8)
    other = seen_in(prism(*big.front, *big.back, width=width, picture=paper), big)
    plain = seen_in(prism(HEXAGON, HEXAGON + [110, -20]), Rings((HEXAGON,), (HEXAGON + [110, -20],)))
    for name in ("unexplained", "attached", "closed", "weakest", "doubled", "flat", "vertices", "map"):
        assert other[name] == pytest.approx(plain[name], abs=0.1), name


def test_hidden_edges_along_visible_ones_are_no_doubt():
    c, s = 90 * np.cos(np.pi / 6), 45.0
    front = np.array([[200.0, 220], [200 + c, 220 - s], [200, 220 - 2 * s], [200 - c, 220 - s]])
    picture = prism(front, front + [0, 90.0], "removed")
    assert seen_in(picture, Rings((front,), (front + [0, 90.0],)))["doubled"] < 0.1


def bowed_box(*edges):
    """A box of which some edges are drawn as arcs, by the numbers of their ends."""
    vertices = np.concatenate([SQUARE, SQUARE + DEPTH])
    picture, t = paper(), np.linspace(0, 1, 30)[:, None]
    for i, j in ring_edges([4]).tolist():
        a, b = vertices[i], vertices[j]
        bow = 11.0 * (1 - (2 * t - 1) ** 2) * [0.0, 1.0] if (i, j) in edges else 0.0
        points = a + t * (b - a) + bow
        for p, q in pairwise(points):
            line(picture, p, q)
    return picture


def test_an_arc_bows_in_both_faces_and_a_hand_in_one():
    hand = seen_in(bowed_box((0, 1)), hand=6.0)["bend"]
    arc = seen_in(bowed_box((0, 1), (4, 5)), hand=6.0)["bend"]
    assert hand < 0.02 < 0.04 < arc


def test_a_table_runs_in_two_directions_and_a_box_seen_nearly_along_a_face_does_not():
    table = Rings((SQUARE,), (SQUARE + [0.0, 60],))
    assert is_table(table, 0.5, is_all=True)
    assert is_table(Rings((SQUARE + [[0.0, 0.5], [0, -0.5], [0, 0.5], [0, 0]],), table.back), 0.5, is_all=True)
    turn = np.array([[0.8, 0.6], [-0.6, 0.8]])
    assert is_table(Rings((SQUARE @ turn,), (table.back[0] @ turn,)), 0.5, is_all=True)
    assert not is_table(Rings((SQUARE,), (SQUARE + [6.0, 60],)), 0.5, is_all=True)
    assert not is_table(Rings((SQUARE,), (SQUARE + DEPTH,)), 0.5, is_all=True)


def test_a_table_of_many_cells_is_one_and_an_l_seen_along_its_arm_is_not():
    cells = np.array([[0.0, 0], [30, 0], [60, 0], [90, 0], [90, 50], [60, 50], [30, 50], [0, 50]])
    assert is_table(Rings((cells,), (cells + [0.0, 50],)), 0.5, is_all=True)
    ell = np.array([[0.0, 0], [60, 0], [60, 100], [30, 100], [30, 40], [0, 40]])
    along = Rings((ell,), (ell + [0.0, 20],))
    assert not is_table(along, 0.5, is_all=True)
    assert is_table(along, 0.5, is_all=False)
