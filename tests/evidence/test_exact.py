"""Exact verification: every line on an edge, every edge that is seen with a line, nothing beside."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE
from solid_lines import prism_lines

from sketch2shape.evidence import exactly_drawn
from sketch2shape.hypotheses import Rings
from sketch2shape.strokes import ruled_lines

BACK = HEXAGON + DEPTH
PRISM = Rings((HEXAGON,), (BACK,))


def told(lines, rings=PRISM):
    ruled = ruled_lines(lines)
    return exactly_drawn(rings, ruled.pieces, ruled.dashed)


@pytest.mark.parametrize("style", ["wire", "dashed", "removed"])
def test_how_hidden_edges_are_drawn_is_told(style):
    evidence, noise = told(prism_lines(HEXAGON, BACK, style))
    assert evidence.lines == style
    assert evidence.score == 1.0
    assert noise < 1e-6
    assert evidence.drawn.all() == (style != "removed")
    assert evidence.drawn.sum() >= 3


def test_a_line_lacking_is_not_exact():
    for k in range(18):
        lines = prism_lines(HEXAGON, BACK)
        del lines[k]
        assert exactly_drawn(PRISM, np.array([line.points for line in lines]), np.zeros(17, bool)) is None


def test_a_line_more_is_not_exact():
    lines = [*prism_lines(HEXAGON, BACK), *prism_lines(HEXAGON[[0, 2, 4]], HEXAGON[[0, 2, 4]])[:1]]
    assert told(lines) is None


def test_a_vertex_off_its_place_is_not_exact():
    moved = HEXAGON.copy()
    moved[2] += 2.0
    assert told(prism_lines(HEXAGON, BACK), Rings((moved,), (BACK,))) is None


@pytest.mark.parametrize("style", ["dashed", "removed"])
def test_the_far_face_is_not_in_front(style):
    assert told(prism_lines(HEXAGON, BACK, style), PRISM.swapped()) is None


def test_dashes_where_edges_are_seen_are_not_exact():
    lines = prism_lines(HEXAGON, BACK, "dashed")
    wrong = [type(line)(line.points, dashed=not line.dashed) for line in lines]
    assert told(wrong) is None


def test_lines_in_pieces_and_drawn_twice_are_the_same():
    each = prism_lines(L_SHAPE, L_SHAPE + DEPTH)
    pieces = [line.points for line in each]
    halves = [p for a, b in pieces for p in ([a, (a + b) / 2], [(a + b) / 2, b])]
    ends = np.array([*pieces, *halves])
    evidence, _ = exactly_drawn(Rings((L_SHAPE,), (L_SHAPE + DEPTH,)), ends, np.zeros(len(ends), bool))
    assert evidence.lines == "wire"


def test_edges_along_edges_and_flat_figures_are_left_to_the_search():
    flat = Rings((SQUARE,), (SQUARE + [200.0, 0],))
    assert (
        exactly_drawn(
            flat,
            np.array([line.points for line in prism_lines(*map(np.asarray, flat.front + flat.back))]),
            np.zeros(12, bool),
        )
        is None
    )
