"""Which strokes an answer leaves out."""

import numpy as np
import pytest
from round_sketches import CYLINDER, drawn
from sketches import DEPTH, L_SHAPE, SQUARE, ink_of, line, paper, prism

import sketch2shape as s2s
from sketch2shape.evidence import unexplained_strokes
from sketch2shape.model import DrawnArc, Ellipse, TwoFaceObject
from sketch2shape.pictures import overlay
from sketch2shape.sweeps import redraw

BOX = s2s.TwoFaceObject(SQUARE, SQUARE + DEPTH)


@pytest.mark.parametrize("lines", ["wire", "dashed", "removed"])
def test_a_right_answer_leaves_nothing_out(lines):
    ink = ink_of(prism(SQUARE, SQUARE + DEPTH, lines))
    assert len(unexplained_strokes(ink, [BOX])) == 0
    assert len(unexplained_strokes(ink, [])) == len(s2s.trace_strokes(ink).ends)


def test_what_is_left_out_is_told_the_longest_first():
    picture = line(prism(SQUARE, SQUARE + DEPTH), [30, 30], [200, 50])
    found = unexplained_strokes(ink_of(line(picture, [30, 330], [90, 370])), [BOX])
    assert len(found) == 2
    assert np.abs(np.sort(found[0], axis=0) - [[30, 30], [200, 50]]).max() < 4


def test_blank_paper_leaves_nothing_out():
    assert unexplained_strokes(ink_of(paper()), [BOX]).shape == (0, 2, 2)


def test_a_refusal_names_a_stroke_and_carries_its_guess(monkeypatch):
    monkeypatch.setattr("sketch2shape.pipeline.reconstruction.REFUSE_BELOW", 1.1)
    with pytest.raises(s2s.NoObjectError, match="not explained: the stroke from") as caught:
        s2s.reconstruct(line(prism(L_SHAPE, L_SHAPE + DEPTH), [20, 30], [60, 350]))
    guess = caught.value.guess
    assert guess.error is caught.value
    assert len(guess.objects[0].f1) == 6
    marked = overlay(guess)
    red = (marked[..., 0].astype(int) - marked[..., 1] > 60)[: marked.shape[0] * 9 // 10, : marked.shape[1] // 8]
    assert red.any()


def test_arcs_and_outlines_of_curved_sides_explain_their_ink():
    (ring,), none = CYLINDER.rings, np.zeros((0, 2))
    ellipse = Ellipse(np.array([240.0, 120]), (90.0, 36.0), 0.0)
    ends = [("f1", ring.line), ("f2", ring.line + CYLINDER.way.of(ring.line))]
    arcs = tuple(DrawnArc(face, None, None, None, ellipse, points) for face, points in ends)
    outlines = redraw(CYLINDER, 4.0, 3.0).silhouettes
    ink = ink_of(drawn(CYLINDER))
    assert len(unexplained_strokes(ink, [TwoFaceObject(none, none, arcs=arcs, silhouettes=outlines)])) == 0
    assert len(unexplained_strokes(ink, [TwoFaceObject(none, none, arcs=arcs)])) == 2
    assert len(unexplained_strokes(ink, [TwoFaceObject(none, none, arcs=arcs[:1], silhouettes=outlines)])) > 2
