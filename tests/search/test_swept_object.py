"""A sweep as the object in the picture: arcs from vertex to vertex, in picture pixels."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, TUBE, drawn
from sketches import ink_of

from sketch2shape.search import sweep_as_object


def as_object(sweep, lines="wire"):
    """The object of a sweep, as if it had been found."""
    found = SimpleNamespace(sweep=sweep, confidence=0.7, energy=SimpleNamespace(lines=lines), noise=0.5)
    return sweep_as_object(found, ink_of(drawn(sweep, lines)))


def test_an_arc_runs_from_the_vertex_where_it_starts_to_the_next():
    obj = as_object(ARCH)
    assert [(arc.face, arc.start, arc.end) for arc in obj.arcs] == [("f1", 0, 1), ("f2", 0, 1)]
    for arc in obj.arcs:
        ring = obj.f1 if arc.face == "f1" else obj.f2
        assert np.allclose(arc.points[0], ring[0])
        assert np.allclose(arc.points[-1], ring[1])
        to = np.hypot(*(arc.points - arc.ellipse.center).T)
        assert to == pytest.approx(np.full(len(to), 60.0))


def test_a_whole_ellipse_joins_no_vertices_and_does_not_repeat_its_first_point():
    obj = as_object(CYLINDER)
    assert [(arc.start, arc.end, arc.hole) for arc in obj.arcs] == [(None, None, None)] * 2
    assert np.hypot(*(obj.arcs[0].points[0] - obj.arcs[0].points[-1])) > 0.5
    assert np.allclose(obj.arcs[1].points - obj.arcs[0].points, [0, 150])


def test_arcs_tell_the_hole_that_they_bound():
    assert [(arc.face, arc.hole) for arc in as_object(TUBE).arcs] == [("f1", None), ("f2", None), ("f1", 0), ("f2", 0)]


def test_a_cone_has_an_apex_and_one_rim():
    obj = as_object(CONE)
    assert np.allclose(obj.f2, [[240, 90]])
    assert [arc.face for arc in obj.arcs] == ["f1"]
    assert len(obj.silhouettes) == 2


def test_back_vertices_that_no_line_shows_are_told():
    assert as_object(ARCH).f2_drawn.all()
    shown = as_object(ARCH, "removed").f2_drawn
    assert shown.any()
    assert not shown.all()


@pytest.mark.parametrize(("near", "face"), [(True, "f1"), (False, "f2")])
def test_hidden_lines_tell_which_face_is_in_front(near, face):
    sweep = replace(CONE, is_near=near)
    assert as_object(sweep, "removed").front == face
    assert as_object(sweep, "dashed").front == face
    assert as_object(CYLINDER).front is None


def test_a_base_that_hides_nothing_is_in_front_unless_its_point_stands_above_it():
    up = CONE.way.centre - CONE.rings[0].middle
    for way, face in ((up, None), (-up, "f1"), (up[::-1] * [-1.0, 1.0], "f1")):
        sweep = replace(CONE, way=replace(CONE.way, centre=CONE.rings[0].middle + 1.5 * way), is_near=True)
        assert as_object(sweep).front == face
