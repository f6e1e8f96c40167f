import json

import numpy as np
import pytest
import trimesh

from sketch2shape.errors import UsageError, WriteError
from sketch2shape.lifting import lift
from sketch2shape.model.drawing import TwoFaceObject
from sketch2shape.model.picture import Picture
from sketch2shape.pipeline.result import Result

F1 = np.array([[100, 100], [200, 100], [200, 160], [100, 160.0]])


@pytest.fixture
def result():
    objects = tuple(TwoFaceObject(F1 + shift, F1 + shift + [40, -40]) for shift in (0.0, 300.0))
    return Result(objects, tuple(lift(o) for o in objects), Picture(np.zeros((600, 600, 3), np.uint8)))


def test_mesh_has_a_body_for_each_object(result):
    assert len(result.mesh.vertices) == 16
    assert len(result.mesh.split()) == 2


def test_export_writes_one_file_and_nothing_else(result, tmp_path):
    path = result.export(tmp_path / "box.stl")
    assert [p.name for p in tmp_path.iterdir()] == ["box.stl"]
    assert trimesh.load(path).volume == pytest.approx(result.mesh.volume, rel=1e-5)


def test_export_that_fails_leaves_nothing(result, tmp_path):
    (tmp_path / "dir.obj").mkdir()
    for path in (tmp_path / "dir.obj", tmp_path / "dir.obj" / "file" / ".." / "..", tmp_path / "null\0.obj"):
        with pytest.raises(WriteError):
            result.export(path, "obj")
    with pytest.raises(UsageError):
        result.export(tmp_path / "box.xyz")
    assert [p.name for p in tmp_path.iterdir()] == ["dir.obj"]


def test_the_report_and_pictures_are_formats_too(result, tmp_path):
    assert json.loads(result.export(tmp_path / "a.json").read_text())["schema"] == "sketch2shape/1"
    for name in ("a.overlay.png", "a.stages.png", "a.preview.png"):
        assert result.export(tmp_path / name).read_bytes().startswith(b"\x89PNG")
    assert result.export(tmp_path / "b.png", "overlay").read_bytes() == (tmp_path / "a.overlay.png").read_bytes()
    assert "<html" in result.export(tmp_path / "a.html").read_text()


def test_each_solid_can_be_written_alone(result, tmp_path):
    volumes = [trimesh.load(solid.export(tmp_path / f"{k}.off")).volume for k, solid in enumerate(result.solids)]
    assert sum(volumes) == pytest.approx(result.mesh.volume)
