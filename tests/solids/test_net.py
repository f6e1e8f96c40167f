"""Paper nets: every face once and true to size, no overlaps, and folded they close to the solid again."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from export.upright import BOX, CURVED, HOUSE, NOTCH, STAR, WINDOW, L, facing
from hypothesis import given, settings
from hypothesis import strategies as st
from solids.bodies import BODIES
from solids.round_bodies import ROUND

from sketch2shape.model import Plane
from sketch2shape.solids.development import developed
from sketch2shape.solids.net import open_edges, polygon, unfolded
from sketch2shape.solids.tabs import joints

STRAIGHT = {
    "box": facing([BOX]),
    "L with a hole": facing([L, NOTCH]),
    "frame": facing([BOX, WINDOW]),
    "star": facing([STAR]),
    "frustum": facing([HOUSE], scale=0.5),
    "frustum of a star": facing([STAR], scale=0.4),
    "pyramid": facing([HOUSE], scale=0.0, along="up", depth=40.0),
    **{name: solid for name, (solid, _, _) in BODIES.items()},
}
ALL = {**STRAIGHT, **CURVED, **{f"book's {name}": solid for name, (solid, *_) in ROUND.items()}}
each = pytest.mark.parametrize("solid", ALL.values(), ids=ALL)


def flat(points):
    return np.asarray(points, float)


def fold(solid, piece):
    """The piece folded up: for each face the map of the plane into space, (2, 3) axes and (3,) origin.

    The first face is laid onto the solid. Each other one turns about its fold, out of the plane of the one before it,
    by the angle between the solid's faces.
    """
    boundary = solid.boundary
    normals = [face.surface.normal for face in boundary.faces]
    placed = {piece.faces[0].number: first_pose(solid, piece.faces[0])}
    for hinge in piece.folds:
        known, new = hinge.faces
        axes, origin = placed[known]
        a, b = (origin + point @ axes for point in hinge.points)
        axis = (b - a) / np.linalg.norm(b - a)
        turn = np.arctan2(np.cross(normals[known], normals[new]) @ axis, normals[known] @ normals[new])
        turned = np.array([rotated(v, axis, turn) for v in axes])
        placed[new] = turned, a - hinge.points[0] @ turned
    return placed


def rotated(v, axis, angle):
    return v * np.cos(angle) + np.cross(axis, v) * np.sin(angle) + axis * (axis @ v) * (1 - np.cos(angle))


def first_pose(solid, face):
    """Where a face lies in space, told by one of its edges and its normal alone."""
    edge = face.loops[0][0]
    step = solid.faces[face.number].loops[0][0]
    known = solid.edges[step.edge]
    p, q = solid.vertices[[known.start, known.end] if step.forward else [known.end, known.start]]
    along = (edge.points[-1] - edge.points[0]) / np.linalg.norm(edge.points[-1] - edge.points[0])
    right = (q - p) / np.linalg.norm(q - p)
    up = np.cross(solid.faces[face.number].surface.normal, right)
    axes = np.array([along[0] * right - along[1] * up, along[1] * right + along[0] * up])
    return axes, p - edge.points[0] @ axes


def glued(solid):
    """Fold all pieces of the net and check that every vertex of every face comes to its place on the solid."""
    pieces = unfolded(solid.boundary)
    size = np.ptp(solid.vertices, axis=0).max()
    for piece in pieces:
        placed = fold(solid, piece)
        assert set(placed) == {face.number for face in piece.faces}
        for face in piece.faces:
            axes, origin = placed[face.number]
            for loop, walk in zip(face.loops, solid.faces[face.number].loops, strict=True):
                for edge, step in zip(loop, walk, strict=True):
                    known = solid.edges[step.edge]
                    start = solid.vertices[known.start if step.forward else known.end]
                    assert np.linalg.norm(origin + edge.points[0] @ axes - start) < 1e-9 * size


@pytest.mark.parametrize("solid", STRAIGHT.values(), ids=STRAIGHT)
def test_the_net_folds_back_into_the_solid(solid):
    glued(solid)


@settings(max_examples=40, deadline=None)
@given(st.integers(3, 8), st.sampled_from([0.0, 0.3, 0.8, 1.0, 1.6]), st.floats(3, 80), st.integers(0, 10**6))
def test_any_prism_frustum_or_pyramid_folds_back(n, scale, depth, seed):
    random = np.random.default_rng(seed)
    angles = np.sort(random.uniform(0, 2 * np.pi, n)) + np.linspace(0, 0.3, n)
    radii = random.uniform(15, 40, n)
    ring = radii[:, None] * np.c_[np.cos(angles), np.sin(angles)]
    if not shapely.Polygon(ring).is_valid or shapely.Polygon(ring).area < 50:
        return
    ring = ring if shapely.LinearRing(ring).is_ccw else ring[::-1]
    solid = facing([ring], depth=depth, scale=scale, foot=(0, 0), along="up")
    glued(solid)
    whole(solid)


def whole(solid):
    pieces = unfolded(solid.boundary)
    numbers = sorted(face.number for piece in pieces for face in piece.faces)
    assert numbers == list(range(len(solid.faces)))
    for piece in pieces:
        assert len(piece.folds) == len(piece.faces) - 1
        sum_of_faces = sum(polygon(face).area for face in piece.faces)
        assert piece.outline.area == pytest.approx(sum_of_faces, rel=1e-6)
    assert sum(piece.outline.area for piece in pieces) == pytest.approx(solid.area, rel=3e-4)


@each
def test_every_face_is_there_once_true_to_size_and_nothing_overlaps(solid):
    whole(solid)


@each
def test_edges_that_are_glued_are_as_long_as_each_other(solid):
    pieces = unfolded(solid.boundary)
    size = max(solid.dimensions)
    for joint in joints(pieces, 0.1 * size):
        one, other = (edge for _, _, edge in joint.sides)
        assert one.length == pytest.approx(other.length, rel=3e-4)
        assert one.edge == other.edge
    folded = sum(len(piece.folds) for piece in pieces)
    seams = sum(edge.edge is None for _, _, edge in open_edges(pieces)) // 2
    assert len(joints(pieces, 1.0)) + folded == len(solid.edges) + seams


@each
def test_tabs_lie_free(solid):
    pieces = unfolded(solid.boundary)
    covers = [piece.outline for piece in pieces]
    found = joints(pieces, 0.1 * max(solid.dimensions))
    assert sum(joint.tab is None for joint in found) <= 0.2 * len(found)
    tabs = [[] for _ in pieces]
    for joint in found:
        if joint.tab is not None:
            (piece, face, _), (_, target, _) = joint.sides
            assert (joint.tab.face, joint.tab.target) == (face.number, target.number)
            shapes = [s for s in shapely.get_parts(joint.tab.shape) if s.area]
            assert all(shapely.intersection(covers[piece], s).area <= 0.11 * s.area for s in shapes)
            assert not any(shapely.intersection(other, s).area > 0.01 * s.area for other in tabs[piece] for s in shapes)
            tabs[piece] += shapes


def test_faces_turn_as_seen_from_outside():
    for solid in ALL.values():
        for face, known in zip(developed(solid.boundary), solid.faces, strict=True):
            assert shapely.LinearRing(face.ring()).is_ccw
            if isinstance(known.surface, Plane):
                assert polygon(face).area == pytest.approx(np.linalg.norm(solid.boundary.area_vector(known)), rel=1e-3)


def test_pieces_are_no_larger_than_the_paper_allows():
    def fits(outline):
        return np.ptp(shapely.get_coordinates(shapely.minimum_rotated_rectangle(outline)), axis=0).max() < 90

    pieces = unfolded(facing([BOX]).boundary, fits)
    assert len(pieces) > 1
    assert all(fits(piece.outline) for piece in pieces)
    assert len(unfolded(facing([BOX]).boundary)) == 1


def test_an_inner_corner_is_folded_the_other_way():
    pieces = unfolded(facing([L]).boundary)
    folds = [fold for piece in pieces for fold in piece.folds]
    assert sum(fold.back for fold in folds) <= 1
    assert not any(fold.back for piece in unfolded(facing([HOUSE]).boundary) for fold in piece.folds)
    window = unfolded(facing([BOX, WINDOW]).boundary)
    walls = next(piece for piece in window if all(face.number > 5 for face in piece.faces))
    assert all(fold.back for fold in walls.folds)
