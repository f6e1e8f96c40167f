import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.geometry import signed_area
from sketch2shape.model import Projection, Solid, polyhedron, two_face_boundary
from sketch2shape.solids import tessellated
from sketch2shape.solids.triangles import triangulate

OUTER = np.array([[0, 0], [4, 0], [4, 4], [0, 4.0]])


def area(points, triangles):
    return sum(signed_area(points[t]) for t in triangles)


def border_of(triangles):
    edges = [(t[i], t[(i + 1) % 3]) for t in triangles.tolist() for i in range(3)]
    return {e for e in edges if e[::-1] not in edges}


def test_square_keeps_its_turning():
    assert area(OUTER, triangulate(OUTER, [4])) == pytest.approx(16.0)
    assert area(OUTER[::-1], triangulate(OUTER[::-1].copy(), [4])) == pytest.approx(-16.0)


def test_vertices_on_straight_edges_are_used():
    ring = np.array([[0, 0], [1, 0], [2, 0], [3, 0], [3, 1], [3, 2], [0, 2], [0, 1.0]])
    triangles = triangulate(ring, [8])
    assert set(triangles.ravel().tolist()) == set(range(8))
    assert len(triangles) == 6
    assert area(ring, triangles) == pytest.approx(6.0)


def test_hole_is_left_open_whatever_its_turning():
    hole = np.array([[1, 1], [3, 1], [3, 3], [1, 3.0]])
    for ring in (hole, hole[::-1]):
        points = np.concatenate([OUTER, ring])
        assert area(points, triangulate(points, [4, 4])) == pytest.approx(12.0)


@pytest.mark.parametrize(
    ("ring", "left"),
    [
        ([[0, 2], [3, 1], [3, 3], [1, 3]], 12.0),
        ([[0, 0], [3, 1], [3, 3], [1, 3]], 10.0),
        ([[0, 0], [2, 1], [2, 2], [1, 2]], 14.0),
    ],
    ids=["an edge", "a corner", "a corner aslant"],
)
def test_hole_may_touch_the_outline(ring, left):
    points = np.concatenate([OUTER, np.array(ring, float)])
    triangles = triangulate(points, [4, 4])
    assert len(border_of(triangles)) == 8
    assert area(points, triangles) == pytest.approx(left)


def test_ring_may_touch_itself():
    ring = np.array([[0, 0], [4, 0], [4, 4], [2, 0], [0, 4.0]])
    assert area(ring, triangulate(ring, [5])) == pytest.approx(8.0)


def test_ring_that_crosses_itself_still_closes():
    bow = np.array([[0, 0], [2, 2], [2, 0], [0, 2.0]])
    assert border_of(triangulate(bow, [4])) in (
        {(0, 1), (1, 2), (2, 3), (3, 0)},
        {(1, 0), (2, 1), (3, 2), (0, 3)},
    )


@settings(deadline=None, max_examples=60)
@given(st.lists(st.floats(0.2, 3.0), min_size=3, max_size=24), st.booleans())
def test_star_shaped_rings_are_filled_exactly(radii, clockwise):
    turn = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    ring = np.array(radii)[:, None] * np.c_[np.cos(turn), np.sin(turn)]
    ring = ring[::-1].copy() if clockwise else ring
    assert area(ring, triangulate(ring, [len(ring)])) == pytest.approx(signed_area(ring), rel=1e-3)


@st.composite
def holed(draw):
    """The rings of a face: a star with vertices on its straight edges, and perhaps a hole like it."""
    rings = []
    for low, high in ((2.0, 4.0), (0.3, 1.0))[: draw(st.integers(1, 2))]:
        radii = np.array(draw(st.lists(st.floats(low, high), min_size=5, max_size=12)))
        turn = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
        ring = radii[:, None] * np.c_[np.cos(turn), np.sin(turn)]
        parts = draw(st.lists(st.floats(0.1, 0.9), min_size=len(ring), max_size=len(ring)))
        split = draw(st.lists(st.booleans(), min_size=len(ring), max_size=len(ring)))
        after = np.roll(ring, -1, axis=0)
        points = [
            [p, p + t * (q - p)] if more else [p] for p, q, t, more in zip(ring, after, parts, split, strict=True)
        ]
        rings.append(np.concatenate(points))
    return rings


@settings(deadline=None, max_examples=80)
@given(holed(), st.floats(0.2, 1.5), st.integers(0, 2**32 - 1))
def test_solid_is_closed_and_keeps_its_volume_however_it_lies(rings, taper, seed):
    flat, sizes = np.concatenate(rings), [len(r) for r in rings]
    if not shapely.Polygon(rings[0], rings[1:]).is_valid:
        return
    upright = np.concatenate([np.c_[flat, np.zeros(len(flat))], np.c_[taper * flat, np.full(len(flat), 2.0)]])
    rng = np.random.default_rng(seed)
    vertices = 100 * upright @ np.linalg.qr(rng.normal(size=(3, 3)))[0] + rng.normal(size=3) * 1000
    solid = Solid(two_face_boundary(vertices, sizes), Projection("oblique"))
    triangles = tessellated(solid.boundary).triangles
    assert border_of(triangles) == set()
    assert set(triangles.ravel().tolist()) == set(range(len(vertices)))
    assert len(triangles) == 2 * len(vertices) + 4 * (len(rings) - 1) - 4
    a, b, c = (vertices[triangles] - vertices.mean(axis=0)).swapaxes(0, 1)
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(solid.volume)


@settings(deadline=None, max_examples=40)
@given(holed(), st.floats(0.2, 1.5))
def test_both_bases_have_the_same_triangles(rings, taper):
    flat, half = np.concatenate(rings), sum(len(r) for r in rings)
    vertices = np.concatenate([np.c_[flat, np.zeros(half)], np.c_[taper * flat, np.full(half, 2.0)]])
    front, back, *_ = tessellated(two_face_boundary(vertices, [len(r) for r in rings])).face_triangles
    assert {frozenset(t) for t in front.tolist()} == {frozenset(i - half for i in t) for t in back.tolist()}


def test_side_with_a_notch_is_split_within():
    # a wedge whose four-cornered bases are not convex: the diagonal from the first corner would lie outside
    dart = np.array([[0, 0], [4, 4], [0, 1], [-4, 4.0]])
    for start in range(4):
        ring = np.roll(dart, start, axis=0)
        vertices = np.concatenate([np.c_[ring, np.zeros(4)], np.c_[ring, np.ones(4)]])
        sides = [[(i, 4 + i, 4 + (i + 1) % 4, (i + 1) % 4)] for i in range(4)]
        boundary = polyhedron(vertices, [[(0, 1, 2, 3)], [(7, 6, 5, 4)], *sides])
        corners = vertices[tessellated(boundary).face_triangles[0]]
        assert sum(abs(signed_area(c[:, :2])) for c in corners) == pytest.approx(abs(signed_area(ring)))
