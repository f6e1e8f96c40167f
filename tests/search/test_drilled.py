"""Straight objects with round holes: the straight search tells the outline, its leftover ink the holes."""

import numpy as np
import pytest
from round_sketches import drawn, ellipse
from sketches import DEPTH, SQUARE, ink_of, line, prism

import sketch2shape as s2s
from sketch2shape.ink import split_groups
from sketch2shape.search.drilled import find_drilled
from sketch2shape.search.observed import observed
from sketch2shape.search.search import find
from sketch2shape.sweeps import Frame, Sweep, Way
from sketch2shape.sweeps.outlines import polygon

FACE = np.array([[100.0, 160], [290, 214], [290, 374], [100, 320]])
ALONG = np.array([150.0, -58])
FRAME = Frame(np.array([0.93, -0.36]), 0.55)
"""Of circles on that face."""


def box_with(*holes):
    return Sweep((polygon(FACE), *holes), Way(ALONG))


def hole_at(x, y, radius=18.0):
    return ellipse(x, y, radius, FRAME)


def drilled(picture):
    (group,) = split_groups(ink_of(picture))
    seen = observed(group)
    found = find_drilled(seen, find(seen))
    return found if found is None else found.shifted(group.offset)


@pytest.mark.parametrize("holes", [[(195.0, 267.0)], [(150.0, 230.0), (240.0, 300.0)]])
def test_narrow_holes_are_found_though_edges_cross_them(holes):
    found = drilled(drawn(box_with(*(hole_at(*h) for h in holes))))
    assert len(found.sweep.rings) == 1 + len(holes)
    middles = [ring.middle for ring in found.sweep.rings[1:]]
    for place in holes:
        ends = [np.array(place), np.array(place) + ALONG]
        assert min(np.hypot(*(m - e)) for m in middles for e in ends) < 4.0


def test_a_hole_may_go_through_any_two_sides_of_a_box():
    """The straight search names the faces as it likes; the hole tells which two they are."""
    top = np.array([FACE[0], FACE[0] + ALONG, FACE[1] + ALONG, FACE[1]])
    down = FACE[3] - FACE[0]
    sweep = Sweep((polygon(top), ellipse(*top.mean(axis=0), 40.0, Frame(np.array([0.0, 1.0]), 0.35))), Way(down))
    found = drilled(drawn(sweep))
    assert len(found.sweep.rings) == 2
    assert np.abs(np.abs(found.sweep.way.shift) - np.abs(down)).max() < 3.0


def test_a_hole_may_come_close_to_the_edge_of_its_face():
    near = FACE[0] + [24.0, 80.0]
    found = drilled(drawn(box_with(hole_at(*near, 40.0))))
    assert found is not None
    assert len(found.sweep.rings) == 2


def test_nothing_is_drilled_where_no_ink_is_left():
    assert drilled(prism(SQUARE, SQUARE + DEPTH)) is None


def test_what_lies_around_the_object_is_no_hole(monkeypatch):
    def looked(*_):
        raise AssertionError

    monkeypatch.setattr("sketch2shape.search.drilled.coherent_loops", looked)
    picture = prism(SQUARE, SQUARE + DEPTH)
    line(picture, SQUARE[0], SQUARE[0] - [50, 50])
    line(picture, SQUARE[3], SQUARE[3] + [-50, 50])
    assert drilled(picture) is None


def test_the_answer_has_the_holes():
    obj = s2s.reconstruct(drawn(box_with(hole_at(150, 230), hole_at(240, 300)))).objects[0]
    assert len(obj.f1) == 4
    assert len(obj.holes) == 2
