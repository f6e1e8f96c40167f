import io
import zipfile
from dataclasses import replace

import manifold3d
import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.errors import NoObjectError, UsageError
from sketch2shape.export import encode, format_of, note_of, to_trimesh
from sketch2shape.export.mesh import settled
from sketch2shape.export.units import in_millimetres
from sketch2shape.model import Projection, Solid, two_face_boundary
from tests.solids.round_bodies import ROUND

L_SHAPE = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2.0]])
HOLE = np.array([[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]])


def prism(rings, depth=2.0, scale=1.0):
    flat = np.concatenate(rings)
    front = np.c_[flat, np.zeros(len(flat))]
    back = np.c_[flat * scale, np.full(len(flat), depth)]
    return Solid(two_face_boundary(np.concatenate([front, back]), [len(r) for r in rings]), Projection("oblique"))


def manifold_volume(mesh):
    body = manifold3d.Manifold(
        manifold3d.Mesh(np.asarray(mesh.vertices, np.float32), np.asarray(mesh.faces, np.uint32))
    )
    assert body.status() == manifold3d.Error.NoError
    return body.volume()


@pytest.mark.parametrize("ring", [L_SHAPE, L_SHAPE[::-1]], ids=["one way", "other way"])
@pytest.mark.parametrize("depth", [2.0, -2.0])
def test_prism_is_a_solid_of_the_right_volume(ring, depth):
    solid = prism([ring], depth)
    mesh = to_trimesh(solid)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(8.0)
    assert manifold_volume(mesh) == pytest.approx(8.0, rel=1e-5)
    assert (solid.volume, solid.area) == pytest.approx((mesh.volume, mesh.area))


def test_hole_goes_through():
    mesh = to_trimesh(prism([L_SHAPE, HOLE]))
    assert mesh.volume == pytest.approx(8.0 - 0.5)
    assert mesh.euler_number == 0
    assert manifold_volume(mesh) == pytest.approx(7.5, rel=1e-5)


def test_vertex_on_a_straight_edge_stays():
    ring = np.array([[0, 0], [1, 0], [2, 0], [2, 1], [0, 1.0]])
    mesh = to_trimesh(prism([ring]))
    assert len(mesh.vertices) == 10
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(4.0)


def test_faces_of_a_frustum_point_outward():
    solid = prism([np.array([[-1, -1], [1, -1], [1, 1], [-1, 1.0]])], depth=3.0, scale=0.5)
    assert solid.volume == pytest.approx(3.0 / 3.0 * (4 + 1 + 2))
    assert len(solid.faces) == 6
    assert to_trimesh(solid).volume == pytest.approx(7.0)
    assert solid.dimensions == pytest.approx((2.0, 2.0, 3.0))


@pytest.mark.parametrize("format", ["obj", "stl", "stl-ascii", "ply", "glb", "off"])
@pytest.mark.parametrize("count", [1, 2])
def test_formats_give_the_solid_back(format, count):
    solids = [prism([L_SHAPE + 10.0 * k, HOLE + 10.0 * k]) for k in range(count)]
    data = encode(solids, format)
    mesh = trimesh.load(io.BytesIO(data), file_type=format.split("-")[0], force="mesh")
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert len(mesh.vertices) == 20 * count
    assert mesh.volume == pytest.approx(7.5 * count * (1e-9 if format == "glb" else 1.0), rel=1e-4)
    assert len(mesh.split()) == count


def test_obj_keeps_the_order_of_vertices_and_can_hold_polygons():
    solid = prism([L_SHAPE])
    text = encode(solid, "obj", ngons=True).decode()
    rows = [line.split() for line in text.splitlines()]
    assert np.allclose([[float(x) for x in r[1:]] for r in rows if r[0] == "v"], solid.vertices)
    assert sorted(len(r) - 1 for r in rows if r[0] == "f") == [4] * 6 + [6, 6]


def test_format_is_known_by_its_extension():
    assert format_of("a/b.STL") == "stl"
    with pytest.raises(UsageError, match=r"\.?xyz"):
        format_of("a.xyz")
    with pytest.raises(UsageError, match="unknown format"):
        encode([], "xyz")


@pytest.mark.parametrize("format", ["obj", "stl", "3mf", "step"])
def test_nothing_is_not_written(format):
    with pytest.raises(NoObjectError):
        encode([], format)


@pytest.mark.parametrize("format", ["obj", "stl", "stl-ascii", "ply", "off"])
@pytest.mark.parametrize(("unit", "millimetres"), [("px", 1.0), ("mm", 1.0), ("cm", 10.0), ("in", 25.4), ("m", 1000.0)])
def test_formats_without_units_are_in_millimetres(format, unit, millimetres):
    data = encode(replace(prism([L_SHAPE]), unit=unit), format)
    mesh = trimesh.load(io.BytesIO(data), file_type=format.split("-")[0], force="mesh")
    assert np.ptp(mesh.vertices, axis=0) == pytest.approx(millimetres * np.ptp(prism([L_SHAPE]).vertices, axis=0))


@pytest.mark.parametrize(
    ("unit", "format", "note"),
    [
        ("cm", "stl", "millimetres"),
        ("in", "obj", "millimetres"),
        ("mm", "stl", ""),
        ("px", "stl", ""),
        ("cm", "3mf", ""),
    ],
)
def test_and_this_is_said_where_another_unit_was_asked_for(unit, format, note):
    assert note in (note_of(replace(prism([L_SHAPE]), unit=unit), format) or "")
    assert bool(note) == bool(note_of(replace(prism([L_SHAPE]), unit=unit), format))


@pytest.mark.parametrize(
    ("up", "turned"),
    [("z", lambda v: v[:, [0, 2, 1]] * [1, 1, -1]), ("y", lambda v: v), ("camera", lambda v: v * [1, -1, -1])],
)
def test_gltf_is_in_metres_with_y_upward(up, turned):
    solid = replace(prism([L_SHAPE]), unit="cm", up=up)
    mesh = trimesh.load(io.BytesIO(encode(solid, "glb")), file_type="glb", force="mesh")
    order = np.lexsort(np.round(mesh.vertices, 6).T)
    want = turned(solid.vertices) / 100.0
    assert np.asarray(mesh.vertices)[order] == pytest.approx(want[np.lexsort(np.round(want, 6).T)], abs=1e-6)
    assert mesh.volume > 0


def test_rounding_errors_are_written_as_zero():
    solid = prism([L_SHAPE])
    moved = replace(solid.boundary, vertices=solid.vertices + [[1.1e-13, -1.1e-13, 0.0]])
    tiny = replace(solid, boundary=moved)
    for format in ("obj", "stl-ascii", "off"):
        text = encode(tiny, format).decode()
        assert "e-" not in text
        assert "-0 " not in text
    with zipfile.ZipFile(io.BytesIO(encode(tiny, "3mf"))) as archive:
        assert b"e-1" not in archive.read("3D/3dmodel.model")


@given(st.floats(1e-6, 1e6), st.integers(0, 2**32 - 1))
def test_settled_points_stay_where_they_are(extent, seed):
    points = extent * np.random.default_rng(seed).uniform(-1, 1, (8, 3))
    assert np.abs(settled(points) - points).max() <= 1e-9 * extent
    assert (settled(settled(points)) == settled(points)).all()


def test_text_stl_is_one_named_solid_without_empty_lines():
    lines = encode(prism([L_SHAPE]), "stl-ascii").decode().split("\n")
    assert lines[0] == "solid sketch2shape"
    assert lines[-2:] == ["endsolid sketch2shape", ""]
    assert all(line.strip() for line in lines[:-1])
    assert lines.count("endfacet") == len(to_trimesh(prism([L_SHAPE])).faces)


@pytest.mark.parametrize("format", ["obj", "stl", "stl-ascii", "ply", "glb", "3mf", "off"])
def test_meshes_of_round_solids_keep_to_the_tolerance(format):
    cylinder = ROUND["cylinder"][0]
    fine, coarse = (len(encode(cylinder, format, tolerance=t)) for t in (0.001, 0.2))
    assert fine > 1.8 * coarse


def test_a_tolerance_is_in_the_unit_of_the_solid():
    inches = replace(ROUND["cylinder"][0], unit="in")
    millimetres = in_millimetres([inches])[0]
    assert encode(inches, "stl", tolerance=0.01) == encode(millimetres, "stl", tolerance=0.254)


@pytest.mark.parametrize("name", ROUND)
def test_obj_with_whole_faces_has_flat_ones_only(name):
    solid, volume, *_ = ROUND[name]
    rows = [row.split() for row in encode(solid, "obj", ngons=True).decode().splitlines()]
    vertices = np.array([row[1:] for row in rows if row[0] == "v"], float)
    total = 0.0
    for face in ([int(i) - 1 for i in row[1:]] for row in rows if row[0] == "f"):
        corners = vertices[face]
        normal = np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
        assert (corners - corners[0]) @ normal == pytest.approx(0.0, abs=1e-6)
        total += float(corners[0] @ normal) / 6
    assert total == pytest.approx(volume, rel=5e-3)
    own = solid.vertices
    assert vertices[: len(own)] == pytest.approx(own)
