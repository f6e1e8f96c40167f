"""Vertices moved to the ink."""

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, ink_of, prism, shrunk

from sketch2shape.fit.refinement import on_map, refine
from sketch2shape.geometry.homology import apply
from sketch2shape.geometry.plane_maps import plane_map
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.strokes.skeleton import thin

TAPERED = shrunk(SQUARE, 0.6, np.array([420.0, 40]))


def pulled(f1, f2, lines="wire", drawn=None, off=2.0, seed=0):
    """Largest distance of the refined vertices from the true ones, f1's and f2's, and the noise."""
    points = thin(ink_of(prism(f1, f2, lines))).points
    rng = np.random.default_rng(seed)
    angle = rng.uniform(0, 2 * np.pi, 2 * len(f1))
    start = np.r_[f1, f2] + off * np.c_[np.cos(angle), np.sin(angle)]
    drawn = np.ones(len(f1), bool) if drawn is None else drawn
    rings, noise = refine(Rings((start[: len(f1)],), (start[len(f1) :],)), points, 5.0, drawn)
    gap = np.linalg.norm(rings.vertices - np.r_[f1, f2], axis=1)
    return gap[: len(f1)].max(), gap[len(f1) :].max(), noise


@pytest.mark.parametrize("f1", [SQUARE, L_SHAPE], ids=["box", "L"])
@pytest.mark.parametrize("seed", [0, 1])
def test_vertices_two_pixels_off_come_back_within_half_a_pixel(f1, seed):
    front, back, noise = pulled(f1, f1 + DEPTH, seed=seed)
    assert front < 0.5
    assert back < 0.5
    assert noise < 0.6


def test_edges_that_meet_at_fifteen_degrees_are_told_apart_nearly_as_well():
    front, back, _ = pulled(HEXAGON, HEXAGON + DEPTH)
    assert max(front, back) < 0.8


def test_a_tapered_back_face_keeps_its_size():
    front, back, _ = pulled(SQUARE, TAPERED)
    assert front < 0.5
    assert back < 0.5


def test_a_vertex_nobody_drew_follows_from_the_others():
    drawn = np.array([True, True, True, False])
    front, back, _ = pulled(SQUARE, SQUARE + DEPTH, "removed", drawn)
    assert front < 0.7
    assert back < 1.0


def test_without_ink_nothing_moves_far():
    rings = Rings((SQUARE,), (SQUARE + DEPTH,))
    moved, noise = refine(rings, np.zeros((0, 2)), 5.0, np.ones(4, bool))
    assert np.abs(moved.vertices - rings.vertices).max() < 0.1
    assert noise == 0


def test_a_hole_is_refined_with_its_face():
    hole = SQUARE.mean(axis=0) + 0.35 * (SQUARE - SQUARE.mean(axis=0))
    picture = prism(hole, hole + DEPTH, picture=prism(SQUARE, SQUARE + DEPTH))
    points = thin(ink_of(picture)).points
    truth = Rings((SQUARE, hole), (SQUARE + DEPTH, hole + DEPTH))
    rng = np.random.default_rng(3)
    rough = Rings(*(tuple(r + rng.normal(0, 1, r.shape) for r in rings) for rings in truth))
    rings, _ = refine(rough, points, 5.0, np.ones(8, bool))
    assert [len(r) for r in (*rings.front, *rings.back)] == [4, 4, 4, 4]
    assert np.linalg.norm(rings.vertices - truth.vertices, axis=1).max() < 0.7


def test_the_plane_map_is_no_richer_than_the_drawing_needs():
    seen = np.ones(4, bool)
    shaken = SQUARE + DEPTH + np.array([[0.4, 0], [0, -0.4], [-0.3, 0.2], [0, 0.3]])
    assert plane_map(SQUARE, shaken, seen)[[0, 1], [0, 1]].tolist() == [1, 1]
    similar = plane_map(SQUARE, TAPERED, seen)
    assert similar[0, 0] == pytest.approx(0.6)
    assert similar[2].tolist() == [0, 0, 1]
    towards, axis = np.array([600.0, -150, 1]), np.array([-4e-4, 3e-4, 0.35])
    tilted = apply(np.eye(3) + np.outer(towards, axis), SQUARE)
    found = plane_map(SQUARE, tilted, seen)
    assert np.abs(found[2, :2]).max() > 1e-5
    assert apply(found, SQUARE) == pytest.approx(tilted, abs=1e-6)


def test_a_vertex_that_was_caught_by_the_wrong_ink_is_put_where_the_others_say():
    back = HEXAGON + DEPTH
    caught = back.copy()
    caught[2] += [18.0, -14]
    ways = on_map(Rings((HEXAGON,), (caught,)), np.ones(6, bool), 6.0)
    assert any(np.abs(way.back[0] - back).max() < 1e-6 and np.array_equal(way.front[0], HEXAGON) for way in ways)
    assert on_map(Rings((HEXAGON,), (back + 0.5,)), np.ones(6, bool), 6.0) == []
