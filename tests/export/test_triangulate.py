import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.export.triangulate import signed_area, triangulate


def area(points, triangles):
    return sum(signed_area(points[t]) for t in triangles)


def test_square_keeps_its_turning():
    square = np.array([[0, 0], [2, 0], [2, 2], [0, 2.0]])
    assert area(square, triangulate(square, [4])) == pytest.approx(4.0)
    assert area(square[::-1], triangulate(square[::-1].copy(), [4])) == pytest.approx(-4.0)


def test_vertices_on_straight_edges_are_used():
    ring = np.array([[0, 0], [1, 0], [2, 0], [3, 0], [3, 1], [3, 2], [0, 2], [0, 1.0]])
    triangles = triangulate(ring, [8])
    assert set(triangles.ravel().tolist()) == set(range(8))
    assert len(triangles) == 6
    assert area(ring, triangles) == pytest.approx(6.0)


def test_hole_is_left_open_whatever_its_turning():
    outer = np.array([[0, 0], [4, 0], [4, 4], [0, 4.0]])
    hole = np.array([[1, 1], [3, 1], [3, 3], [1, 3.0]])
    for ring in (hole, hole[::-1]):
        points = np.concatenate([outer, ring])
        assert area(points, triangulate(points, [4, 4])) == pytest.approx(12.0)


def test_ring_that_crosses_itself_still_closes():
    bow = np.array([[0, 0], [2, 2], [2, 0], [0, 2.0]])
    triangles = triangulate(bow, [4])
    edges = [(t[i], t[(i + 1) % 3]) for t in triangles.tolist() for i in range(3)]
    border = {e for e in edges if e[::-1] not in edges}
    assert border in ({(0, 1), (1, 2), (2, 3), (3, 0)}, {(1, 0), (2, 1), (3, 2), (0, 3)})


@settings(deadline=None, max_examples=60)
@given(st.lists(st.floats(0.2, 3.0), min_size=3, max_size=24), st.booleans())
def test_star_shaped_rings_are_filled_exactly(radii, clockwise):
    turn = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    ring = np.array(radii)[:, None] * np.c_[np.cos(turn), np.sin(turn)]
    ring = ring[::-1].copy() if clockwise else ring
    assert area(ring, triangulate(ring, [len(ring)])) == pytest.approx(signed_area(ring), rel=1e-3)
