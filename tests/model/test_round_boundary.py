import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.errors import PointsError
from sketch2shape.model import ArcPlace, Circle, arc_between, two_face_boundary
from tests.solids.round_bodies import KINDS, ROUND, disc


@pytest.mark.parametrize("name", ROUND)
def test_measures_are_those_of_the_geometry_book(name):
    solid, volume, area, _, kinds = ROUND[name]
    assert solid.volume == pytest.approx(volume)
    assert solid.area == pytest.approx(area)
    assert sorted(type(f.surface).__name__ for f in solid.faces) == sorted(KINDS[k] for k in kinds)
    larger = solid.boundary.scaled(2.0)
    assert (larger.volume, larger.area) == (pytest.approx(8 * volume), pytest.approx(4 * area))


@pytest.mark.parametrize("name", ROUND)
def test_every_edge_is_walked_once_each_way(name):
    boundary = ROUND[name][0].boundary
    steps = [step for face in boundary.faces for loop in face.loops for step in loop]
    assert sorted(steps) == sorted((e, way) for e in range(len(boundary.edges)) for way in (False, True))


def test_vertices_and_edges_keep_the_order_of_the_drawing():
    plate = ROUND["plate with two holes"][0]
    assert plate.ring_sizes == (4, 0, 0)
    assert len(plate.edge_ends) == 12
    assert [e.start for e in plate.edges[12:]] == [None] * 4
    cone = ROUND["cone"][0]
    assert cone.vertices.tolist() == [[0, 0, 3]]
    assert cone.dimensions == pytest.approx((4, 4, 3))


def test_a_half_cylinder_is_as_deep_as_its_radius():
    assert ROUND["half cylinder"][0].dimensions == pytest.approx((4, 2, 3))


def test_two_vertices_need_an_arc():
    ends = np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1], [1, 0, 1.0]])
    with pytest.raises(PointsError):
        two_face_boundary(ends, [2])
    with pytest.raises(PointsError):
        two_face_boundary(ends[:0], [0])


@settings(deadline=None, max_examples=50)
@given(st.floats(0.05, 6.2), st.integers(0, 2**32 - 1))
def test_an_arc_runs_from_its_start_to_its_end_about_the_normal(sweep, seed):
    rng = np.random.default_rng(seed)
    frame = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    frame *= np.linalg.det(frame)
    circle = Circle(rng.normal(size=3), frame[2], 2.5)
    end = circle.center + 2.5 * (np.cos(sweep) * frame[0] + np.sin(sweep) * frame[1])
    arc = arc_between(circle, circle.center + 2.5 * frame[0], end)
    assert arc.sweep == pytest.approx(sweep)
    points = arc.at(np.linspace(0, 1, 400))
    assert points[-1] == pytest.approx(end)
    direction = rng.normal(size=3)
    reach = np.concatenate([points[[0, -1]], arc.farthest(direction)]) @ direction
    assert reach.max() >= (points @ direction).max() - 1e-9
    assert reach.max() <= (points @ direction).max() + 1e-3 * np.linalg.norm(direction)


def test_the_sense_of_the_ring_does_not_matter():
    for turn in (1.0, -1.0):
        circles = {ArcPlace("f1", 0, None): disc(0, 2, turn=turn), ArcPlace("f2", 0, None): disc(-3, 2, turn=turn)}
        boundary = two_face_boundary(np.zeros((0, 3)), [0], circles)
        assert boundary.volume == pytest.approx(12 * np.pi)
