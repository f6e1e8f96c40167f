"""Blots: what is wider than a thick pen, and what that says of lines."""

import cv2
import numpy as np
from sketches import DEPTH, SQUARE, ink_of, prism

from sketch2shape.strokes.blots import blots_of
from sketch2shape.strokes.skeleton import thin

PEN = 14


def filled_corner(width=PEN):
    """A box drawn with a thick pen, one of its corners blotted."""
    picture = prism(SQUARE, SQUARE + DEPTH, "removed", width)
    cv2.circle(picture, (270, 140), 24, 0, -1)
    return picture


def test_blots_lie_at_corners_and_the_filled_one_is_the_widest():
    blots = blots_of(ink_of(filled_corner()))
    assert blots is not None
    y, x = np.nonzero(blots)
    vertices = np.concatenate([SQUARE, SQUARE + DEPTH])
    assert np.linalg.norm(np.stack([x, y], axis=1)[:, None] - vertices, axis=2).min(axis=1).max() < 28
    assert blots[140, 270] > 24 - PEN / 2 - 3
    assert blots[140, 270] > blots.max() - 2


def test_a_fine_pen_makes_no_blots():
    picture = prism(SQUARE, SQUARE + DEPTH, "removed", 2)
    cv2.circle(picture, (270, 140), 10, 0, -1)
    assert blots_of(ink_of(picture)) is None


def test_what_runs_through_a_blot_runs_on_ink():
    skeleton = thin(ink_of(filled_corner()))
    beside = skeleton.points[np.abs(skeleton.points - [270, 140]).max(axis=1) < 8]
    assert skeleton.distance[148, 262] == 0
    assert skeleton.near(1.0)[149, 261]
    assert (skeleton.slack(beside) > 3).all()
    # the middle of an edge
    far = skeleton.points[np.abs(skeleton.points - [195, 290]).max(axis=1) < 40]
    assert (skeleton.slack(far) == 0).all()
    assert len(skeleton.outside_blots) < len(skeleton.points)
    assert {tuple(p) for p in far.tolist()} <= {tuple(p) for p in skeleton.outside_blots.tolist()}
