"""Views straight from before, above and the sides."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from export.upright import BOX, CURVED, HOUSE, NOTCH, STAR, L, facing
from hypothesis import given, settings
from hypothesis import strategies as st
from solids.bodies import BODIES

from sketch2shape.solids.views import VIEWS, _joined, view_of

SOLIDS = {
    "box": facing([BOX]),
    "L": facing([L]),
    "hole": facing([L, NOTCH]),
    "star frustum": facing([STAR], scale=0.5),
    **{name: solid for name, (solid, _, _) in BODIES.items()},
    **CURVED,
}


def length(lines):
    return sum(shapely.LineString(line).length for line in lines)


def points(lines):
    return np.concatenate(lines)


@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
@pytest.mark.parametrize("name", VIEWS)
def test_a_view_shows_the_solid_in_its_size_and_no_line_twice(solid, name):
    view = view_of(solid, name)
    sizes = dict(zip(("width", "height", "depth"), solid.dimensions, strict=True))
    if solid.axes is not None:
        np.testing.assert_allclose(view.size, [sizes[s] for s in view.sizes])
    np.testing.assert_allclose(points(view.visible).min(axis=0), 0, atol=1e-3 * view.size.max())
    np.testing.assert_allclose(points(view.visible).max(axis=0), view.size, atol=1e-3 * view.size.max())
    everything = [*view.visible, *view.hidden]
    covered = shapely.union_all([shapely.LineString(line) for line in everything], grid_size=1e-6).length
    assert covered == pytest.approx(length(everything), rel=1e-3)


def test_an_l_shows_its_step_from_the_right_alone():
    right, left = view_of(facing([L]), "right"), view_of(facing([L]), "left")
    assert length(right.visible) == pytest.approx(2 * (25 + 40) + 25, rel=1e-4)
    assert length(right.hidden) == 0
    assert length(left.visible) == pytest.approx(2 * (25 + 40), rel=1e-4)
    assert length(left.hidden) == pytest.approx(25, rel=1e-4)


def test_a_hole_is_hidden_from_above():
    view = view_of(facing([BOX, NOTCH]), "top")
    assert {round(float(x), 3) for line in view.hidden for x in line[:, 0]} == {5.0, 10.0}
    assert length(view.hidden) == pytest.approx(50, rel=1e-4)


def test_the_views_of_either_side_are_each_other_mirrored():
    right, left = view_of(facing([L, NOTCH]), "right"), view_of(facing([L, NOTCH]), "left")
    assert right.size == pytest.approx(left.size)
    assert length([*right.visible, *right.hidden]) == pytest.approx(length([*left.visible, *left.hidden]), rel=1e-4)


def test_circles_are_known_as_such():
    ((center, radius, turn, _),) = view_of(CURVED["cylinder"], "top").circles
    assert (radius, turn) == (pytest.approx(20), pytest.approx(2 * np.pi))
    assert center == pytest.approx([20, 20])
    assert view_of(CURVED["cylinder"], "front").circles == ()
    assert len(view_of(CURVED["rounded plate"], "front").circles) == 6
    assert len(view_of(CURVED["tube"], "top").circles) == 2


def test_a_hidden_rim_of_a_bucket():
    view = view_of(CURVED["bucket"], "top")
    assert length(view.hidden) == pytest.approx(2 * np.pi * 20, rel=1e-3)
    assert length(view.visible) == pytest.approx(2 * np.pi * 30, rel=1e-3)


@settings(max_examples=30, deadline=None)
@given(st.integers(3, 9), st.floats(0.2, 0.99) | st.just(1.0), st.floats(0, 6))
def test_from_before_a_prism_shows_its_face(n, part, turn):
    angles = turn + np.arange(n) * 2 * np.pi / n
    ring = 30 * np.c_[np.cos(angles), np.sin(angles)]
    view = view_of(facing([ring], scale=part), "front")
    around = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1).sum()
    assert length(view.visible) == pytest.approx(around, rel=1e-4)
    hidden = 0 if part == 1.0 else around * part + n * 30 * (1 - part)
    assert length(view.hidden) == pytest.approx(hidden, rel=2e-2, abs=0.5)


def test_a_house_from_the_side():
    view = view_of(facing([HOUSE]), "right")
    assert {round(float(y), 3) for line in view.visible for y in line[:, 1]} == {0.0, 30.0, 50.0}


def test_half_a_line_that_rounding_moved_off_the_whole_is_no_second_line():
    grid = 1e-6
    whole, half = np.array([[0.0, 0.0], [1.0, 0.7]]), np.array([[0.5, 0.35 + grid], [1.0, 0.7]])
    assert _joined([whole, half], grid).length == pytest.approx(np.hypot(1.0, 0.7))
