"""Sweeps without what costs more than it explains."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from round_sketches import ARCH, FACING, UPRIGHT, arch, drawn, ellipse, slot
from sketches import ink_of

from sketch2shape.ink import split_groups
from sketch2shape.search import sweep_improvement
from sketch2shape.search.found_sweep import priced
from sketch2shape.search.observed import observed
from sketch2shape.search.scene import Scene
from sketch2shape.search.sweep_improvement import Begun, _at_rungs, _without_notches, finished, improved, with_holes
from sketch2shape.sweeps import Outline, Sweep, Way

WASHER = Sweep((ellipse(), ellipse(radius=40.0)), Way(np.array([0.0, 24.0])))
"""A plate that is thinner than its hole is wide: both rims of that are seen in each other."""
SLOT = slot(Way(np.array([70.0, 50.0])), tangents=True)


def put_on(picture, sweep):
    """A sweep of that picture held against it, and the scene."""
    (group,) = split_groups(ink_of(picture))
    seen = observed(group)
    scene = Scene(seen.drawn, seen.skeleton, seen.view)
    return priced(scene, sweep.shifted(-group.offset)), scene


def notched():
    """The arch with three vertices of a notch for one of its lower corners."""
    plain = arch()
    v = plain.vertices
    notch = v[2] + np.array([[0.0, -10.0], [-7.0, -5.0], [-9.0, 0.0]])
    vertices = np.concatenate([v[:2], notch, v[3:]])
    bulges = np.array([plain.bulges[0], 0.0, 0.0, 0.0, 0.0, 0.0])
    return Outline(plain.frame, vertices, bulges, np.array([True, True, False, False, False, False]))


def test_a_notch_is_drawn_together_to_a_smooth_vertex_or_a_corner():
    found = [o for o in _without_notches(notched(), 30.0) if len(o.vertices) == 4]
    assert {bool(o.smooth[2]) for o in found} == {True, False}
    for outline in found:
        assert np.abs(outline.vertices - arch().vertices).max() < 8.0
        assert outline.bulges == pytest.approx(arch().bulges)


def test_long_edges_are_no_notch_and_three_vertices_stay():
    assert list(_without_notches(arch(), 30.0)) == []
    triangle = replace(arch(), vertices=arch().vertices[:3], bulges=np.zeros(3), smooth=np.zeros(3, bool))
    assert list(_without_notches(triangle, 1000.0)) == []


def test_a_ring_of_arcs_may_be_a_circle():
    turn = np.tan(np.pi / 6)
    corners = np.array([[200.0, 100], [300, 100], [250, 186.6]])
    ring = Outline(FACING, corners, np.full(3, -turn), np.ones(3, bool))
    whole = next(_without_notches(ring, 30.0))
    assert whole.circle is not None
    assert whole.circle.radius == pytest.approx(57.7, abs=1.0)


def test_the_drawing_shows_that_the_notch_is_none():
    found = finished(*put_on(drawn(ARCH), replace(ARCH, rings=(notched(),))))
    assert len(found.sweep.rings[0].vertices) == 4
    assert found.sweep.rings[0].curved.sum() == 1


def test_the_far_rim_of_a_hole_is_no_hole():
    far = WASHER.rings[1].shifted(WASHER.way.shift)
    found = finished(*put_on(drawn(WASHER), replace(WASHER, rings=(*WASHER.rings, far))))
    assert [ring.circle is not None for ring in found.sweep.rings] == [True, True]


def test_a_hole_told_by_a_worse_line_gives_way_to_a_better_one():
    rim = WASHER.rings[1]
    ends = rim.middle + np.array([[-39.0, 0.0], [39.0, 0.0]])
    lens = Outline(UPRIGHT, ends, np.full(2, -0.85), np.zeros(2, bool))
    found, scene = put_on(drawn(WASHER), replace(WASHER, rings=(WASHER.rings[0], lens)))
    offset = WASHER.rings[0].middle - found.sweep.rings[0].middle
    better = with_holes(found, scene, [rim.line - offset])
    assert better.nats < found.nats
    assert [ring.circle is not None for ring in better.sweep.rings] == [True, True]


def test_lines_between_the_faces_tell_where_vertices_lie():
    (ring,) = SLOT.rings
    true, along = ring.vertices, np.array([9.0, 0.0])
    astray = replace(ring, vertices=true + [along, 0 * along, 0 * along, -along])
    found, scene = put_on(drawn(SLOT), replace(SLOT, rings=(astray,)))
    offset = astray.vertices[1] - found.sweep.rings[0].vertices[1]
    put = _at_rungs(found, scene)
    assert np.abs(put.sweep.rings[0].vertices + offset - true).max() < 3.0


@pytest.mark.parametrize(("left", "arcs", "leans"), [(True, True, True), (True, False, False), (False, True, False)])
def test_arcs_that_lean_are_taken_where_lines_are_left_and_they_stay(monkeypatch, left, arcs, leans):
    plain, leaning = object(), object()
    monkeypatch.setattr(sweep_improvement, "moved", lambda found, _: found)
    monkeypatch.setattr(sweep_improvement, "priced", lambda _, sweep: sweep)
    monkeypatch.setattr(sweep_improvement, "cheapest", lambda found: found[-1])
    monkeypatch.setattr(sweep_improvement, "_leaves_some", lambda _: left)
    monkeypatch.setattr(sweep_improvement, "_in_perspective", lambda found, _: found)
    done = {found: SimpleNamespace(sweep=SimpleNamespace(has_arcs=arcs)) for found in (plain, leaning)}
    monkeypatch.setattr(sweep_improvement, "_completed", lambda found, _: done[found])
    assert improved(Begun(plain, iter(()), iter([leaning])), None) is done[leaning if leans else plain]
