"""Closed lines that may be outlines."""

import numpy as np
from round_sketches import ARCH, CONE, CYLINDER, TUBE, drawn
from sketches import ink_of

from sketch2shape.strokes import thin
from sketch2shape.sweeps import coherent_loops, ellipses, enclosed_loops


def box(loop):
    return [*loop.min(axis=0), *loop.max(axis=0)]


def nearest(loops, line):
    return min(np.abs(np.subtract(box(loop), box(line))).max() for loop in loops)


def test_the_near_rim_of_a_cylinder_is_enclosed():
    ink = ink_of(drawn(CYLINDER, "removed"))
    assert nearest(enclosed_loops(ink.mask, ink.pen_width), CYLINDER.rings[0].line) < 3


def test_an_ellipse_half_hidden_is_found():
    ink = ink_of(drawn(CONE, "removed"))
    assert nearest(ellipses(thin(ink), 300.0), CONE.rings[0].line) < 4


def test_ink_that_lies_on_ink_when_moved_is_the_front():
    for sweep in (ARCH, TUBE):
        ink = ink_of(drawn(sweep, "wire"))
        loops = coherent_loops(thin(ink), sweep.way.shift, 3.0, 350.0)
        assert len(loops) == len(sweep.rings)
        for loop, ring in zip(loops, sweep.rings, strict=True):
            assert np.abs(np.subtract(box(loop), box(ring.line))).max() < 3
