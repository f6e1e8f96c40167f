"""Holes whose rims are hardly more than dots."""

from dataclasses import replace

import cv2
import numpy as np
import pytest
from round_sketches import CONE, DOWN, UPRIGHT, drawn, ellipse
from sketches import ink_of

from sketch2shape.ink import split_groups
from sketch2shape.search.found_sweep import priced
from sketch2shape.search.observed import observed
from sketch2shape.search.scene import Scene
from sketch2shape.search.small_holes import small_holes
from sketch2shape.search.sweep_improvement import Begun, improved
from sketch2shape.sweeps import Sweep, Way

HOLE = ellipse(205.0, 118.0, 7.0)
DRILLED = Sweep((ellipse(), HOLE), Way(0.5 * DOWN))
"""A cylinder with a narrow hole."""


def left_by(sweep, shown):
    """A sweep held against the picture of another, with dots where a program draws vertices, and the scene."""
    picture = drawn(shown)
    for side in (-7.0, 7.0):
        for down in (0.0, 75.0):
            cv2.circle(picture, (round(205 + side), round(118 + down)), 3, 0, -1, cv2.LINE_AA)
    (group,) = split_groups(ink_of(picture))
    seen = observed(group)
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    return priced(scene, sweep.shifted(-group.offset)), scene, group.offset


def test_what_a_sweep_leaves_tells_where_its_hole_is_and_how_wide():
    found, scene, offset = left_by(replace(DRILLED, rings=DRILLED.rings[:1]), DRILLED)
    (line,) = small_holes(found, scene)
    assert line.mean(axis=0) + offset == pytest.approx([205.0, 118.0], abs=3.0)
    assert np.ptp(line, axis=0) == pytest.approx([14.0, 14.0 * UPRIGHT.ratio], abs=4.0)
    assert [ring.circle is not None for ring in improved(Begun(found), scene).sweep.rings] == [True, True]


def test_a_point_has_no_back_face_and_what_is_too_short_is_no_hole():
    found, scene, _ = left_by(replace(DRILLED, rings=DRILLED.rings[:1]), DRILLED)
    assert list(small_holes(replace(found, sweep=CONE), scene)) == []
    short = replace(found, sweep=replace(found.sweep, way=Way(DOWN)))
    assert list(small_holes(short, scene)) == []


def test_a_seam_between_the_faces_is_no_hole():
    picture = drawn(replace(DRILLED, rings=DRILLED.rings[:1]))
    x, y = (240 + 90 * np.cos(1.2), 120 + 36 * np.sin(1.2))
    cv2.line(picture, (round(x), round(y)), (round(x), round(y + 75)), 0, 2, cv2.LINE_AA)
    (group,) = split_groups(ink_of(picture))
    seen = observed(group)
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    found = priced(scene, replace(DRILLED, rings=DRILLED.rings[:1]).shifted(-group.offset))
    assert list(small_holes(found, scene)) == []
