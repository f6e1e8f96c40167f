"""Wireframes put together from lines and arcs."""

from dataclasses import replace
from importlib import import_module

import cv2
import numpy as np
import pytest
from round_sketches import CONE, drawn, plate, slot
from sketches import ink_of

from sketch2shape.strokes import thin
from sketch2shape.sweeps import Way, joined, joints, shifts, wire_shifts

SLOT = slot(Way(np.array([60.0, 40.0])), tangents=True)
PLATE = replace(plate(Way(np.array([50.0, 30.0]))), tangents=True)


def joined_from(picture):
    skeleton = thin(ink_of(picture))
    size, at = float(np.hypot(*np.ptp(skeleton.points, axis=0))), joints(skeleton)
    return list(joined(skeleton, at, wire_shifts(skeleton, at, shifts(skeleton, size), size), size))


def off(found, sweep):
    """Pixels between the outline found and the true one, on whichever face it was found, both ways."""
    own, true = found.rings[0].line, sweep.rings[0].line
    apart = [np.hypot(*(own[:, None] - t).T) for t in (true, true + sweep.way.shift)]
    return min(max(a.min(axis=0).max(), a.min(axis=1).max()) for a in apart)


def test_a_slot_whose_arcs_cross_its_lines_is_put_together():
    best = joined_from(drawn(SLOT))[0]
    assert len(best.rings) == 1
    assert off(best, SLOT) < 5
    assert np.count_nonzero(~best.rings[0].curved) == 2


@pytest.mark.parametrize("stroke", [(100, 330, 380, 190), (90, 110, 430, 400)])
def test_a_line_across_it_changes_nothing(stroke):
    picture = drawn(SLOT)
    cv2.line(picture, stroke[:2], stroke[2:], 0, 2, cv2.LINE_AA)
    assert off(joined_from(picture)[0], SLOT) < 5


def test_holes_are_whole_circles_inside_the_outline():
    best = joined_from(drawn(PLATE))[0]
    assert off(best, PLATE) < 6
    assert [hole.circle is not None for hole in best.rings[1:]] == [True, True]


def test_a_cone_is_none():
    assert joined_from(drawn(CONE)) == []


@pytest.mark.parametrize(("module", "number"), [("joined", "MOST_SHARED"), ("spans", "MOST_LINES")])
def test_a_texture_is_not_put_together(monkeypatch, module, number):
    """Spans by the hundred on the same ink would keep a solver busy for hours."""
    picture = drawn(SLOT)
    assert joined_from(picture)
    monkeypatch.setattr(import_module(f"sketch2shape.sweeps.{module}"), number, 0)
    assert joined_from(picture) == []
