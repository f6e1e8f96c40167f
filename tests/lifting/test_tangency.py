"""Faces with arcs are made exact where the drawing nearly is, and no further."""

import numpy as np
import pytest

from sketch2shape.lifting.bent import bent_faces
from sketch2shape.lifting.profile import profile_of
from sketch2shape.lifting.shape import Shape
from sketch2shape.lifting.tangency import exact_arcs
from tests.lifting.round_views import CIRCLE, GROOVE, HALF, HOLE, ROUNDED, SLOT, SQUARE, Drawer

FLAT = np.array([[1.0, 0, 0.4], [0, 1.0, -0.4]])


def shape_of(rings, noise=0.0, seed=0):
    """The face as drawn from before, so that it is nearly true."""
    obj = Drawer(FLAT, noise=noise, seed=seed).draw(rings, 1.0)
    first, _, bent = bent_faces(obj)
    sizes = [len(pair.f1) for pair in obj.rings]
    eye = np.eye(3)
    return Shape("oblique", first, eye, np.zeros(3), 50.0, np.eye(3, 4), np.eye(2), sizes, noise=noise, bent=bent)


@pytest.mark.parametrize("rings", [[CIRCLE], [HALF], [SLOT], [ROUNDED], [GROOVE], [SQUARE, HOLE]])
def test_unknowns_taken_from_an_exact_face_leave_it_as_it_is(rings):
    shape = shape_of(rings)
    profile = profile_of(shape, shape.bent)
    assert np.abs(profile.moved(profile.start())).max() < 0.6  # the path is drawn by chords
    exact = exact_arcs(shape, regular=True)
    assert np.abs(exact.flat - shape.flat).max() < 0.6
    assert len(exact.arcs) == len(shape.bent.arcs)


@pytest.mark.parametrize("turn", [0.5, 1.5, np.pi, 4.5])
@pytest.mark.parametrize("way", [1, -1])
def test_the_turn_of_an_arc_is_told_either_way(turn, way):
    # a segment: its chord and one arc, whose centre lies above or below
    half = turn / 2
    ends = np.array([[-np.sin(half), 0], [np.sin(half), 0]])
    shape = shape_of([(ends, {0: ((0, way * np.cos(half)), way * turn)})])
    (arc,) = exact_arcs(shape, regular=False).arcs
    assert arc.radius == pytest.approx(100.0, rel=0.02)
    assert arc.turn == way


@pytest.mark.parametrize("seed", range(5))
def test_a_shaken_slot_gets_half_turns_and_smooth_joints(seed):
    shape = exact_arcs(shape_of([SLOT], noise=1.5, seed=seed), regular=True)
    first, second = shape.arcs
    assert first.radius == pytest.approx(second.radius, rel=1e-6)
    assert first.radius == pytest.approx(50.0, abs=3.0)
    sides = np.roll(shape.flat[:4], -1, axis=0) - shape.flat[:4]
    for arc, side in ((first, sides[0]), (second, sides[2])):
        start = shape.flat[arc.start]
        # the radius to a smooth joint stands at right angles on the straight edge
        assert (start - arc.center) @ side == pytest.approx(0.0, abs=1e-3 * np.linalg.norm(side))
    assert "joints" in shape.evidence["beautified"]["by"]


def test_a_hole_nearly_in_the_middle_gets_there_and_one_beside_it_stays():
    shape = exact_arcs(shape_of([SQUARE, HOLE], noise=1.0), regular=True)
    assert shape.arcs[0].center == pytest.approx(shape.flat[:4].mean(axis=0), abs=1e-4)
    beside = ([], {None: ((0.35, 0.2), 0.3)})
    off = exact_arcs(shape_of([SQUARE, beside], noise=1.0), regular=True)
    gap = off.arcs[0].center - off.flat[:4].mean(axis=0)
    assert gap == pytest.approx([35.0, 20.0], abs=3.0)


def test_corners_that_are_meant_stay_corners():
    # an arc over a chord that meets the sides at 40 degrees
    bulge = ([[-1, 0], [1, 0], [1, 1], [-1, 1]], {0: ((0, 1.19), np.radians(80))})
    shape = exact_arcs(shape_of([bulge], noise=0.5), regular=True)
    (arc,) = shape.arcs
    sweep = 2 * np.arcsin(np.linalg.norm(shape.flat[1] - shape.flat[0]) / (2 * arc.radius))
    assert np.degrees(sweep) == pytest.approx(80.0, abs=4.0)
