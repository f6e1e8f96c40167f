"""Exact answers: what ruled lines say to the last one needs no search; anything else is left to it."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, shrunk
from solid_lines import prism_lines

from sketch2shape.hypotheses import coincide
from sketch2shape.ink import find_ink, split_groups
from sketch2shape.model import TRUSTED, VectorLine
from sketch2shape.reading.sheet import picture_of
from sketch2shape.search.exact import find_exact
from sketch2shape.search.objects import find_one


def ink_of(lines):
    return find_ink(picture_of(lines, page=(480, 400)))


CONVEX = [(face, style) for face in (SQUARE, HEXAGON) for style in ("wire", "dashed", "removed")]


@pytest.mark.parametrize(("face", "style"), [*CONVEX, (L_SHAPE, "wire")])
@pytest.mark.parametrize("by", [1.0, 0.8])
def test_the_answer_is_that_of_the_search(style, face, by):
    back = shrunk(face, by, face.mean(axis=0)) + DEPTH
    ink = ink_of(prism_lines(face, back, style))
    exact = find_exact(ink)
    (group,) = split_groups(ink)
    searched = find_one(group).shifted(group.offset)
    assert coincide(exact.rings.vertices, searched.rings.vertices, 1.0)
    assert exact.evidence.lines == searched.evidence.lines == style
    # the search has weighed the answer against none at all
    assert exact.confidence == pytest.approx(searched.confidence, abs=0.01)
    assert exact.confidence > TRUSTED


def test_a_hole_is_read_too():
    hole = shrunk(SQUARE, 0.4, SQUARE.mean(axis=0))
    found = find_exact(ink_of([*prism_lines(SQUARE, SQUARE + DEPTH), *prism_lines(hole, hole + DEPTH)]))
    assert found.rings.sizes == (4, 4)


@pytest.mark.parametrize("more", [[(20.0, 20), (90, 60)], [(120.0, 140), (270, 290)]], ids=["beside", "diagonal"])
def test_anything_else_on_the_sheet_is_left_to_the_search(more):
    lines = [*prism_lines(SQUARE, SQUARE + DEPTH), VectorLine(np.array(more))]
    assert find_exact(ink_of(lines)) is None


def test_a_hand_and_pixels_are_left_to_the_search():
    rng = np.random.default_rng(3)
    lines = [
        VectorLine(np.linspace(*line.points, 30) + rng.normal(0, 0.6, (30, 2)))
        for line in prism_lines(HEXAGON, HEXAGON + DEPTH)
    ]
    assert find_exact(ink_of(lines)) is None


def test_what_two_fronts_would_hide_differently_is_left_to_the_search():
    # of a block that narrows two sides are seen: either may be the front, and the vertex behind them be elsewhere
    front = np.array([[100.0, 100], [200, 100], [200, 300], [100, 300]])
    side = np.array([[200.0, 100], [330, 130], [330, 250], [200, 300]])
    lines = [VectorLine(np.array([ring[k - 1], ring[k]])) for ring in (front, side) for k in range(4)]
    assert find_exact(ink_of(lines)) is None
