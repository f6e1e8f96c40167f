from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from solids.bodies import BODIES

from sketch2shape.lifting import lift
from sketch2shape.model import FacePair, Projection, Solid, TwoFaceObject, two_face_boundary
from sketch2shape.solids import edge_runs, tessellated
from sketch2shape.solids.hidden import _cuts

BOX = np.array([[100, 160], [300, 160], [300, 340], [100, 340.0]])
NOTCHED = np.array([[100, 150], [180, 150], [180, 260], [300, 260], [300, 150], [380, 150], [380, 380], [100, 380.0]])
HOLE = np.array([[150, 220], [150, 300], [250, 300], [250, 220.0]])
#: an oblique view: right, down, and how depth is drawn
VIEW = np.array([[1.0, 0.0], [0.0, 1.0], [0.45, -0.3]])


def runs_of(obj):
    return edge_runs(lift(obj), obj.vertices)


def hidden_pairs(obj):
    """The edges of an object that are hidden from end to end."""
    runs = zip(obj.edges.tolist(), runs_of(obj), strict=True)
    return {tuple(sorted(e)) for e, pieces in runs if not any(p.visible for p in pieces)}


def test_a_box_hides_the_three_edges_of_its_far_lower_left_corner():
    # f1 is 0 1 2 3 from the upper left, f2 is 4 5 6 7; the back goes right and up, so 7 is hidden
    assert hidden_pairs(TwoFaceObject(BOX, BOX + [90, -60])) == {(4, 7), (6, 7), (3, 7)}


def test_the_mirrored_box_hides_the_opposite_corner():
    # now the back goes left and down, so that its upper right corner, 5, is hidden
    assert hidden_pairs(TwoFaceObject(BOX + [90, -60], BOX)) == {(4, 5), (5, 6), (1, 5)}


def test_an_edge_is_seen_in_part_through_a_hole():
    obj = TwoFaceObject(BOX, BOX + [40, -30], (FacePair(HOLE, HOLE + [40, -30]),))
    runs = runs_of(obj)
    assert any(len(pieces) > 1 for pieces in runs)
    for pieces in runs:
        assert (pieces[0].start, pieces[-1].stop) == (0.0, 1.0)
        assert all(a.stop == b.start and a.visible != b.visible for a, b in pairwise(pieces))


def test_the_front_face_is_always_in_view():
    obj = TwoFaceObject(NOTCHED, NOTCHED + [120, -80])
    front = (obj.edges < len(obj.f1)).all(axis=1)
    assert all(run.visible for k in np.flatnonzero(front) for run in runs_of(obj)[k])


def test_a_tapering_object_hides_what_its_near_end_covers():
    near = np.array([[0.0, 0.0], [100, 0], [100, 100], [0, 100]])
    for far, hidden in ((near * 2 - 50, 0), (near * 0.5 + 25, 8)):
        points = np.concatenate([near, far])
        solid = Solid(two_face_boundary(np.c_[points, np.repeat([0.0, 50.0], 4)], (4,)), Projection("axonometric"))
        assert sum(not any(run.visible for run in pieces) for pieces in edge_runs(solid, points)) == hidden


@pytest.mark.parametrize(("name", "hidden"), [("pyramid", 3), ("boss", 6)])
def test_other_solids_hide_their_far_edges(name, hidden):
    # seen from the right and above: a pyramid hides its far left corner, each block of the other its own
    solid = BODIES[name][0]
    turned = solid.vertices @ np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0.0]])  # up is -y
    points = turned @ VIEW
    stands = Solid(solid.boundary, Projection("oblique"))
    runs = edge_runs(stands, points)
    assert sum(not any(run.visible for run in pieces) for pieces in runs) == hidden


def covered(point, depth, vertices, triangles, slack):
    """Is the point of the drawing at this depth behind a triangle, by ray casting?"""
    corners = vertices[triangles]
    flat = corners @ VIEW
    a, b, c = flat.swapaxes(0, 1)
    area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    safe = np.where(np.abs(area) > 1e-9, area, np.inf)
    u = ((point - a)[:, 0] * (c - a)[:, 1] - (point - a)[:, 1] * (c - a)[:, 0]) / safe
    v = ((b - a)[:, 0] * (point - a)[:, 1] - (b - a)[:, 1] * (point - a)[:, 0]) / safe
    z = corners[:, 0, 2] + u * (corners[:, 1, 2] - corners[:, 0, 2]) + v * (corners[:, 2, 2] - corners[:, 0, 2])
    within = (np.abs(area) > 1e-9) & (u > 1e-6) & (v > 1e-6) & (u + v < 1 - 1e-6)
    return bool((within & (z < depth - slack)).any())


@settings(deadline=None, max_examples=40)
@given(st.lists(st.floats(0.4, 1.6), min_size=3, max_size=9), st.floats(0.3, 3.0), st.floats(0.5, 1.4))
def test_runs_agree_with_casting_rays_at_the_triangles(radii, depth, taper):
    turn = np.linspace(0, 2 * np.pi, len(radii), endpoint=False) + 0.1
    ring = np.array(radii)[:, None] * np.c_[np.cos(turn), np.sin(turn)]
    vertices = np.concatenate([np.c_[ring, np.zeros(len(ring))], np.c_[ring * taper, np.full(len(ring), depth)]])
    solid = Solid(two_face_boundary(vertices, [len(ring)]), Projection("oblique"))
    triangles = tessellated(solid.boundary).triangles
    for (a, b), pieces in zip(vertices[solid.edge_ends], edge_runs(solid, vertices @ VIEW), strict=True):
        for start, stop, visible in pieces:
            if stop - start < 1e-3:
                continue
            # a little off the exact middle, where no diagonal of a face runs through it by chance
            p = a + (0.517 * start + 0.483 * stop) * (b - a)
            assert covered(p @ VIEW, p[2], vertices, triangles, 1e-4 * depth) == (not visible)


def test_an_edge_seen_as_a_point_cuts_only_lines_that_it_lies_on():
    points = np.array([[0.0, 0.0], [10.0, 0.0], [5.0, 8.0], [5.0, 8.0], [3.0, 0.0], [3.0, 0.0]])
    assert _cuts(points, np.array([[0, 1], [2, 3], [4, 5]]), 0).tolist() == [0.0, 0.3, 1.0]
