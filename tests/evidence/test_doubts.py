"""Doubts about answers that explain nearly all ink."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape import NoObjectError
from sketch2shape.evidence.doubts import DOUBLED, doubled, doubted, has_edge_left
from sketch2shape.evidence.score import judge
from sketch2shape.evidence.sheet import Sheet, skeleton_sheet
from sketch2shape.hypotheses.hypothesis import Rings, ring_edges
from sketch2shape.model.arrays import Floats
from sketch2shape.model.picture import Ink
from sketch2shape.pipeline import reconstruct
from sketch2shape.strokes.skeleton import thin

FLAT = np.array([[100.0, 80.0], [220.0, 70.0], [340.0, 80.0], [330.0, 260.0], [90.0, 250.0]])
"""A pentagon of which one vertex, the second, hardly turns."""
SHIFT = np.array([120.0, 90.0])


def prism(ring: Floats) -> Rings:
    return Rings((ring,), (ring + SHIFT,))


def drawn(rings: Rings) -> Sheet:
    """A sheet with all edges of an object on it."""
    canvas = np.zeros((400, 520), np.uint8)
    v = np.round(rings.vertices).astype(int)
    for i, j in ring_edges(list(rings.sizes)):
        cv2.line(canvas, v[i].tolist(), v[j].tolist(), 1, 2)
    skeleton = thin(Ink(canvas > 0, canvas.astype(np.float32), 2.0))
    return skeleton_sheet(skeleton, np.ones(len(skeleton.points)), 2.5)


def test_a_connecting_edge_that_the_answer_does_not_have_is_noticed() -> None:
    sheet = drawn(prism(FLAT))
    without = prism(np.delete(FLAT, 1, axis=0))
    assert has_edge_left(without, sheet)
    assert not has_edge_left(prism(FLAT), sheet)


def test_the_score_falls_with_a_doubt_alone() -> None:
    sheet = drawn(prism(FLAT))
    right, wrong = prism(FLAT), prism(np.delete(FLAT, 1, axis=0))
    assert doubted(right, judge(right, sheet), sheet).score == judge(right, sheet).score
    assert doubted(wrong, judge(wrong, sheet), sheet).score < 0.85 * judge(wrong, sheet).score


def test_a_stroke_across_the_connecting_edges_is_no_connecting_edge() -> None:
    rings = prism(FLAT)
    canvas = drawn(rings).skeleton.mask.copy()
    cv2.line(canvas, (150, 300), (330, 110), 1, 1)
    other = thin(Ink(canvas > 0, canvas.astype(np.float32), 2.0))
    assert not has_edge_left(rings, skeleton_sheet(other, np.ones(len(other.points)), 2.5))


def test_edges_on_edges_are_counted() -> None:
    assert doubled(prism(FLAT), 2.0) < 0.1
    steps = np.array([[0, 0], [200, 0], [200, 200], [100, 200], [100, 100], [0, 100]], float)
    assert doubled(Rings((steps,), (steps + [0, 100],)), 2.0) > DOUBLED


@pytest.mark.parametrize(("count", "columns"), [(4, 4), (5, 5), (8, 8), (5, 3)])
def test_a_table_is_no_object(count: int, columns: int) -> None:
    picture = np.full((480, 640), 255, np.uint8)
    for x in np.linspace(64, 576, columns).astype(int).tolist():
        cv2.line(picture, (x, 48), (x, 432), 0, 2)
    for y in np.linspace(48, 432, count).astype(int).tolist():
        cv2.line(picture, (64, y), (576, y), 0, 2)
    with pytest.raises(NoObjectError):
        reconstruct(picture)
