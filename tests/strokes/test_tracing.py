"""From ink to straight strokes."""

from itertools import pairwise

import numpy as np
import pytest
from sketches import DEPTH, SQUARE, ink_of, line, paper, prism

from sketch2shape.geometry.lines import fit_lines, moments
from sketch2shape.strokes.skeleton import are_covered, thin
from sketch2shape.strokes.tracing import trace_skeleton


def traced(picture, tolerance=1.5):
    return trace_skeleton(thin(ink_of(picture)), tolerance)


def along(strokes, direction, within=3.0):
    """How many strokes run in a direction, to so many degrees."""
    span = strokes.ends[:, 1] - strokes.ends[:, 0]
    turn = np.arctan2(span[:, 1], span[:, 0]) - np.arctan2(direction[1], direction[0])
    return int((np.abs(np.sin(turn)) < np.sin(np.radians(within)))[strokes.lengths > 20].sum())


def test_crossing_strokes_of_a_box_stay_whole():
    strokes = traced(prism(SQUARE, SQUARE + DEPTH))
    assert [along(strokes, d) for d in ((1, 0), (0, 1), DEPTH)] == [4, 4, 4]
    assert (strokes.lengths > 20).sum() == 12
    assert strokes.lengths[:8] == pytest.approx([150] * 8, abs=10)
    assert (np.diff(strokes.lengths) <= 0).all()


def test_dashes_are_one_stroke_with_the_ink_of_dashes():
    strokes = traced(line(line(paper(), [50, 80], [430, 80]), [50, 300], [430, 250], dashed=True))
    assert len(strokes.ends) == 2
    dashed = int(strokes.ends[:, :, 1].mean(axis=1).argmax())
    assert strokes.inked[1 - dashed] > 0.95
    assert 0.4 < strokes.inked[dashed] < 0.9


def test_strokes_of_one_line_far_apart_stay_two():
    strokes = traced(line(line(paper(), [30, 200], [140, 200]), [330, 200], [440, 200]))
    assert sorted(strokes.lengths) == pytest.approx([110, 110], abs=4)


def test_a_wobbly_line_is_one_stroke_at_the_tolerance_of_the_hand():
    x = np.linspace(40, 440, 60)
    points = np.c_[x, 200 + 5 * np.sin(x / 40)]
    picture = paper()
    for a, b in pairwise(points):
        line(picture, a, b)
    assert len(traced(picture, 1.5).ends) > 1
    assert len(traced(picture, 8.0).ends) == 1


def test_only_ink_that_is_asked_for_is_traced():
    ink = ink_of(line(line(paper(), [50, 80], [430, 80]), [50, 300], [430, 300]))
    upper = np.zeros_like(ink.mask)
    upper[:200] = True
    strokes = trace_skeleton(thin(ink), 1.5, upper)
    assert len(strokes.ends) == 1
    assert strokes.ends[0, :, 1] == pytest.approx([80, 80], abs=1)


def test_the_skeleton_is_thin_whole_and_knows_how_far_everything_is():
    skeleton = thin(ink_of(line(paper(), [50, 80], [430, 80], width=7)))
    assert len(skeleton.paths) == 1
    assert len(skeleton.points) == pytest.approx(380, abs=12)
    assert skeleton.distance[180, 200] == pytest.approx(100, abs=1.5)


def test_a_line_is_fitted_across_not_along():
    points = np.array([[10.0, 10], [20, 30.1], [30, 49.9], [40, 70]])
    (centre,), (direction,), _ = fit_lines(moments(points)[None])
    assert centre == pytest.approx([25, 40])
    assert abs(direction @ np.array([1, 2]) / np.sqrt(5)) == pytest.approx(1, abs=1e-4)
    _, (upright,), (spread,) = fit_lines(moments(np.array([[5.0, 0], [5, 9], [5, 20]]))[None])
    assert abs(upright[1]) == pytest.approx(1)
    assert spread == pytest.approx(0, abs=1e-6)


def test_segments_are_covered_as_far_as_they_are_drawn():
    near = thin(ink_of(line(paper(), [50, 80], [250, 80]))).near(2.0)
    a = np.array([[50.0, 80], [50, 80], [50, 200], [-500, -500]])
    b = np.array([[250.0, 80], [450, 80], [250, 200], [-400, -500]])
    assert are_covered(near, a, b, 0.9).tolist() == [True, False, False, False]
    assert are_covered(near, a, b, 0.4).tolist() == [True, True, False, False]
    assert are_covered(near, a, b, 0.6).tolist() == [True, False, False, False]


@pytest.mark.parametrize("reach", [0.5, 2.0, 3.3, 5.0])
def test_what_is_near_the_skeleton_is_told_by_distance(reach):
    skeleton = thin(ink_of(line(line(paper(), [50, 80], [250, 180]), [30, 300], [430, 90])))
    assert np.array_equal(skeleton.near(reach), skeleton.distance <= reach)


def test_blank_paper_has_no_strokes():
    assert traced(paper()).ends.shape == (0, 2, 2)
