"""Sweeps held against a drawing."""

from dataclasses import replace

import numpy as np
import pytest
from round_sketches import ARCH, CYLINDER, TUBE, drawn
from sketches import ink_of

from sketch2shape.evidence import compare_sweep, observe
from sketch2shape.evidence.redrawing import DASHES_APART
from sketch2shape.ink import split_groups
from sketch2shape.strokes import thin


def energy(sweep, picture):
    (group,) = split_groups(ink_of(picture))
    view = observe(group, thin(group.ink))
    return compare_sweep(sweep.shifted(-group.offset), view, 3.0).energy(np.inf)


def test_what_is_drawn_leaves_nothing_over():
    for lines in ("wire", "removed"):
        told = energy(ARCH, drawn(ARCH, lines))
        assert told.lines == lines
        assert told.unexplained < 10


def test_a_line_that_is_not_there_costs_and_so_does_one_too_many():
    whole, tube = energy(CYLINDER, drawn(CYLINDER)), energy(TUBE, drawn(CYLINDER))
    assert tube.missing > whole.missing + 30
    assert energy(CYLINDER, drawn(TUBE)).foreign > 20


def test_the_wrong_depth_costs():
    deeper = replace(ARCH, way=replace(ARCH.way, shift=1.3 * ARCH.way.shift))
    assert energy(deeper, drawn(ARCH, "removed")).total > energy(ARCH, drawn(ARCH, "removed")).total + 30


@pytest.mark.parametrize(("pens", "counts"), [(0.8, False), (1.2, True)])
def test_what_is_seen_needs_a_solid_line_near_it_and_what_is_hidden_does_not(pens, counts):
    (group,) = split_groups(ink_of(drawn(ARCH, width=4)))
    view = observe(group, thin(group.ink))
    sweep, apart = ARCH.shifted(-group.offset), pens * DASHES_APART * view.pen
    solid = np.full(group.ink.mask.shape, apart, np.float32)
    plain, told = compare_sweep(sweep, view, 3.0), compare_sweep(sweep, view, 3.0, solid)
    hidden = plain.hidden > 0
    assert hidden.any()
    assert np.array_equal(told.off[hidden], plain.off[hidden])
    assert (told.off[~hidden] >= 0.99 * apart).all() == counts
    assert np.array_equal(told.off, plain.off) != counts
