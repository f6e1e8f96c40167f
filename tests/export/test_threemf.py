import io
import zipfile

import numpy as np
import pytest
import trimesh

from sketch2shape.export import encode
from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model.drawing import TwoFaceObject

FACE = np.array([[100, 100], [300, 100], [300, 200], [100, 200.0]])
SOLIDS = [lift(TwoFaceObject(FACE + s, FACE + s + [30, -40]), options=LiftOptions(width="4cm")) for s in (0, 400)]


def test_trimesh_reads_every_body_back_with_its_unit():
    scene = trimesh.load(io.BytesIO(encode(SOLIDS, "3mf")), file_type="3mf", force="scene")
    assert len(scene.geometry) == 2
    for mesh in scene.geometry.values():
        assert mesh.is_watertight
        assert mesh.volume == pytest.approx(4.0 * 2.0 * 2.0)
        assert len(mesh.vertices) == 8
    model = zipfile.ZipFile(io.BytesIO(encode(SOLIDS, "3mf"))).read("3D/3dmodel.model").decode()
    assert 'unit="centimeter"' in model


def test_same_solids_give_the_same_bytes():
    for format in ("3mf", "glb", "stl", "step", "obj"):
        assert encode(SOLIDS, format) == encode(SOLIDS, format)


def test_glb_is_in_metres():
    mesh = trimesh.load(io.BytesIO(encode(SOLIDS, "glb")), file_type="glb", force="mesh")
    assert mesh.volume == pytest.approx(2 * 16e-6, rel=1e-4)
    assert len(mesh.vertices) == 16
