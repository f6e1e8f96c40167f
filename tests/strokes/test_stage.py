"""Strokes as a stage of its own."""

import cv2
import numpy as np
import pytest
from sketches import DEPTH, SQUARE, line, paper, prism

import sketch2shape as s2s
from sketch2shape.errors import UnreadableError


def test_a_wireframe_box_is_twelve_solid_strokes():
    strokes = s2s.trace_strokes(prism(SQUARE, SQUARE + DEPTH))  # they end a little short of sharp corners
    assert len(strokes.ends) == 12
    assert (strokes.inked > 0.85).all()
    assert np.allclose(sorted(strokes.lengths), [np.hypot(*DEPTH)] * 4 + [150] * 8, atol=10)


def test_a_dashed_line_is_one_stroke_that_is_partly_inked():
    strokes = s2s.trace_strokes(line(paper(), [60, 100], [420, 180], dashed=True))
    assert len(strokes.ends) == 1
    assert 0.4 < strokes.inked[0] < 0.9
    assert strokes.lengths[0] == pytest.approx(np.hypot(360, 80), abs=8)


def test_strokes_are_in_the_pixels_of_the_picture():
    big = cv2.resize(line(paper(), [60, 100], [420, 180]), None, fx=6, fy=6)
    ink = s2s.find_ink(s2s.read_picture(big))
    assert ink.scale < 1
    strokes = s2s.trace_strokes(ink)
    ends = strokes.ends[0][np.argsort(strokes.ends[0][:, 0])]
    assert np.abs(ends - (np.array([[60, 100], [420, 180]]) + 0.5) * 6).max() < 12
    assert strokes.tolerance == pytest.approx(1.5 / ink.scale, rel=0.5)


def test_a_larger_tolerance_takes_a_bent_line_for_a_straight_one():
    picture = line(line(paper(), [60, 200], [240, 212]), [240, 212], [420, 200])
    assert len(s2s.trace_strokes(picture).ends) == 2
    assert len(s2s.trace_strokes(picture, tolerance=12).ends) == 1


def test_nothing_is_traced_on_blank_paper_and_no_picture_is_an_error():
    assert s2s.trace_strokes(paper()).ends.shape == (0, 2, 2)
    with pytest.raises(UnreadableError):
        s2s.trace_strokes(b"")
