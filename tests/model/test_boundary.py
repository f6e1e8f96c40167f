import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sketch2shape.errors import PointsError
from sketch2shape.model import Plane, Projection, Solid, TwoFaceObject, polyhedron, two_face_boundary

SQUARE = np.array([[0, 0], [2, 0], [2, 2], [0, 2.0]])
HOLE = SQUARE * 0.5 + 0.5

PYRAMID = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 3.0]])
PYRAMID_FACES = [[(0, 3, 2, 1)], [(0, 1, 4)], [(1, 2, 4)], [(2, 3, 4)], [(3, 0, 4)]]


def prism(rings, depth=3.0):
    flat = np.concatenate(rings)
    vertices = np.concatenate([np.c_[flat, np.zeros(len(flat))], np.c_[flat, np.full(len(flat), depth)]])
    return two_face_boundary(vertices, [len(r) for r in rings])


def walks(boundary):
    """All steps from vertex to vertex that the loops take, in the order of faces."""
    steps = [boundary.edges[e] for face in boundary.faces for loop in face.loops for e, _ in loop]
    ways = [forward for face in boundary.faces for loop in face.loops for _, forward in loop]
    return [(s.start, s.end) if w else (s.end, s.start) for s, w in zip(steps, ways, strict=True)]


@pytest.mark.parametrize("turn", [1, -1], ids=["one way", "other way"])
@pytest.mark.parametrize("depth", [3.0, -3.0])
def test_two_face_boundary_keeps_the_order_of_the_drawing(turn, depth):
    boundary = prism([SQUARE[::turn], HOLE], depth)
    flat = TwoFaceObject(SQUARE, SQUARE + 1, ())
    assert len(boundary.faces) == 10
    assert boundary.edge_ends[:12].tolist() == [[i + 4 * (i > 3), j + 4 * (j > 3)] for i, j in flat.edges.tolist()]
    assert boundary.volume == pytest.approx(9.0)
    assert boundary.area == pytest.approx(2 * 3.0 + 3.0 * (8 + 4))
    assert Solid(boundary, Projection("oblique")).ring_sizes == (4, 4)


def test_every_loop_is_closed_and_every_edge_walked_once_each_way():
    boundary = prism([SQUARE, HOLE])
    steps = walks(boundary)
    assert len(set(steps)) == len(steps) == 2 * len(boundary.edges)
    for face in boundary.faces:
        for loop, ring in zip(face.loops, boundary.rings(face), strict=True):
            assert len(loop) == len(ring) == len(set(ring))


def test_normals_point_out_of_the_solid():
    boundary = polyhedron(PYRAMID, PYRAMID_FACES)
    middle = PYRAMID.mean(axis=0)
    assert all(isinstance(face.surface, Plane) for face in boundary.faces)
    assert all((face.surface.origin - middle) @ face.surface.normal > 0 for face in boundary.faces)
    assert boundary.volume == pytest.approx(4.0)
    assert boundary.area == pytest.approx(4.0 + 4 * np.sqrt(10.0))
    assert len(boundary.edges) == 8


def test_scaled_takes_the_surfaces_along():
    boundary = polyhedron(PYRAMID, PYRAMID_FACES)
    large = boundary.scaled(10.0)
    assert large.volume == pytest.approx(4000.0)
    for face in large.faces:
        corners = large.vertices[list(large.rings(face)[0])]
        assert (corners - face.surface.origin) @ face.surface.normal == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    "faces",
    [PYRAMID_FACES[:-1], [*PYRAMID_FACES, PYRAMID_FACES[0]], [[(0, 1, 2, 3)], *PYRAMID_FACES[1:]]],
    ids=["a face missing", "a face twice", "a face inside out"],
)
def test_faces_that_do_not_close_are_refused(faces):
    with pytest.raises(ValueError, match="do not close"):
        polyhedron(PYRAMID, faces)


def test_a_face_of_two_vertices_is_refused():
    with pytest.raises(PointsError, match="at least 3"):
        prism([SQUARE[:2]])


def test_edges_keep_the_order_given():
    given = polyhedron(PYRAMID, PYRAMID_FACES).edge_ends[::-1, ::-1]
    assert polyhedron(PYRAMID, PYRAMID_FACES, given).edge_ends.tolist() == given.tolist()
    with pytest.raises(ValueError, match="same edges"):
        polyhedron(PYRAMID, PYRAMID_FACES, given[1:])


@settings(deadline=None, max_examples=50)
@given(
    st.lists(st.floats(0.5, 2.0), min_size=3, max_size=12),
    st.floats(0.1, 5.0),
    st.floats(0.2, 2.0),
    st.booleans(),
    st.floats(0.01, 100.0),
)
def test_volume_of_a_frustum_whatever_its_turning(radii, depth, taper, mirrored, factor):
    turn = np.linspace(0, 2 * np.pi, len(radii), endpoint=False)
    ring = np.array(radii)[:, None] * np.c_[np.cos(turn), np.sin(turn)]
    if mirrored:
        ring = ring[::-1]
    vertices = np.concatenate([np.c_[ring, np.zeros(len(ring))], np.c_[ring * taper, np.full(len(ring), depth)]])
    boundary = two_face_boundary(vertices, [len(ring)])
    x, y = ring.T
    base = abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2
    assert boundary.volume == pytest.approx(depth * base * (1 + taper + taper**2) / 3)
    assert boundary.scaled(factor).volume == pytest.approx(boundary.volume * factor**3)
