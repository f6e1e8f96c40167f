"""Lines of round solids as they are drawn: seen, hidden, and the outlines of curved sides."""

import numpy as np
import pytest

from sketch2shape.lifting import lift
from sketch2shape.solids import contour_candidates, drawn_lines, smooth_edges, tessellated
from tests.lifting.round_views import CIRCLE, GROOVE, HALF, HOLE, ROUNDED, SLOT, SQUARE, STANDING, Drawer, axonometric


def lines_of(rings, depth=1.5, scale=1.0, standing=True):
    obj = Drawer(axonometric(), STANDING if standing else None).draw(rings, depth, scale)
    solid = lift(obj)
    return obj, solid, drawn_lines(obj, solid)


def length(line):
    return float(np.linalg.norm(np.diff(line.points, axis=0), axis=1).sum())


def test_a_standing_cylinder_shows_its_top_half_its_bottom_and_two_outlines():
    obj, solid, lines = lines_of([CIRCLE])
    top, bottom = ([line for line in lines if line.edge == k] for k in (0, 1))
    assert [line.visible for line in top] == [True]
    seen, gone = (sum(length(line) for line in bottom if line.visible == way) for way in (True, False))
    assert seen == pytest.approx(gone, rel=0.1)
    sides = [line for line in lines if line.edge is None]
    assert [line.visible for line in sides] == [True, True]
    # tangent to the rims: they stand as far apart as the ellipse is wide, and are plumb as the axis is
    x = np.sort([line.points[:, 0].mean() for line in sides])
    assert x[1] - x[0] == pytest.approx(2 * obj.arcs[0].ellipse.axes[0], rel=0.01)
    assert all(abs(line.end[0] - line.start[0]) < 1.0 for line in sides)
    assert solid.boundary.is_round


def test_a_cone_shows_its_outlines_from_the_rim_to_the_apex():
    obj, _, lines = lines_of([CIRCLE], -1.5, 0.0)
    sides = [line for line in lines if line.edge is None]
    assert len(sides) == 2
    for line in sides:
        assert min(np.linalg.norm(line.points - obj.f2[0], axis=1)) < 1.0
    assert sum(not line.visible for line in lines) >= 1


def test_smooth_joints_have_no_line_and_sharp_ones_do():
    for rings, smooth in (([ROUNDED], 8), ([SLOT], 4), ([HALF], 0), ([GROOVE], 0), ([SQUARE, HOLE], 0)):
        _, solid, lines = lines_of(rings, 0.8)
        left_out = smooth_edges(solid.boundary)
        assert len(left_out) == smooth
        assert left_out.isdisjoint({line.edge for line in lines})
        shown = {line.edge for line in lines} - {None}
        assert len(shown) == len(solid.edges) - smooth


def test_a_straight_solid_has_no_outlines():
    _, solid, lines = lines_of([SQUARE])
    assert not len(contour_candidates(tessellated(solid.boundary), frozenset()))
    assert all(line.edge is not None for line in lines)
    assert sum(not line.visible for line in lines) == 3


def test_the_far_rim_of_a_through_hole_is_seen_in_part():
    _, solid, lines = lines_of([SQUARE, HOLE], 0.3, standing=False)
    far = [line for line in lines if line.edge == 13]
    assert {line.visible for line in far} == {True, False}
    assert len(solid.edges) == 14


def test_arcs_are_drawn_where_they_were_read():
    obj, _, lines = lines_of([HALF], 0.8)
    for line in lines:
        if line.edge in (0, 2):
            arc = obj.arcs[0 if line.edge == 0 else 1]
            gaps = np.linalg.norm(line.points[:, None] - arc.points[None], axis=2).min(axis=1)
            assert gaps.max() < 12.0
