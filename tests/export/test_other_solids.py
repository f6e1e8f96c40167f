"""Solids that are no two-face objects go through every format: writers read nothing but the boundary."""

import io

import numpy as np
import pytest
import trimesh
from solids.bodies import BODIES

from sketch2shape.export import MESH_FORMATS, encode, to_trimesh
from sketch2shape.pictures.preview import preview

each = pytest.mark.parametrize(("solid", "volume", "faces"), BODIES.values(), ids=BODIES)


@each
def test_boundary_measures_itself(solid, volume, faces):
    assert solid.volume == pytest.approx(volume)
    assert len(solid.faces) == faces
    assert len(solid.vertices) - len(solid.edges) + faces == 2 + sum(len(f.loops) - 1 for f in solid.faces)


@each
@pytest.mark.parametrize("format", [f for f in MESH_FORMATS if f != "step"])
def test_mesh_is_watertight_and_has_the_volume(solid, volume, faces, format):
    scene = trimesh.load(io.BytesIO(encode(solid, format)), file_type=format.split("-")[0], force="scene")
    (mesh,) = scene.geometry.values()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(volume * (1e-9 if format == "glb" else 1.0), rel=1e-5)
    assert len(mesh.vertices) == len(solid.vertices)


@each
def test_polygons_of_obj_are_the_faces(solid, volume, faces):
    rows = [line.split() for line in encode(solid, "obj", ngons=True).decode().splitlines()]
    sizes = [len(row) - 1 for row in rows if row[0] == "f"]
    whole = [len(f.loops[0]) for f in solid.faces if len(f.loops) == 1]
    assert sorted(s for s in sizes if s > 3) == sorted(n for n in whole if n > 3)


@each
def test_open_cascade_reads_a_valid_solid(solid, volume, faces, tmp_path):
    from export.test_step import read_back

    ((valid, got, count),) = read_back(encode(solid, "step"), tmp_path)
    assert valid
    assert got == pytest.approx(volume)
    assert count == faces


@each
def test_preview_shows_it(solid, volume, faces):
    shown, empty = preview([solid], (160, 120)), preview([], (160, 120))
    assert (np.abs(shown.astype(int) - empty).max(axis=2) > 20).mean() > 0.1


def test_bodies_of_several_kinds_share_a_file():
    solids = [solid for solid, _, _ in BODIES.values()]
    assert to_trimesh(solids).volume == pytest.approx(sum(volume for _, volume, _ in BODIES.values()))
