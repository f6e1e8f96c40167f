"""STEP files read back by Open CASCADE, where it is installed (pip install sketch2shape[readback])."""

import re

import numpy as np
import pytest

from sketch2shape.export import encode
from sketch2shape.model import Projection, Solid, two_face_boundary
from tests.solids.round_bodies import KINDS, ROUND, SQUARE
from tests.solids.round_bodies import solid as body

L_SHAPE = np.array([[0, 0], [30, 0], [30, 10], [20, 10], [10, 10], [10, 20], [0, 20.0]])
HOLE = np.array([[2.5, 2.5], [7.5, 2.5], [7.5, 7.5], [2.5, 7.5]])


def prism(rings, depth=20.0, scale=1.0, unit="mm"):
    flat = np.concatenate(rings)
    turn = np.linalg.qr(np.array([[1, 2, 0.5], [0, 1, 3], [2, 0.1, 1.0]]))[0]
    vertices = np.concatenate([np.c_[flat, np.zeros(len(flat))], np.c_[flat * scale, np.full(len(flat), depth)]])
    return Solid(two_face_boundary(vertices @ turn, [len(r) for r in rings]), Projection("oblique"), unit)


def read_back(data, tmp_path):
    """Solids in a STEP file: (valid, volume, number of faces) of each."""
    return [(valid, volume, len(kinds)) for valid, volume, kinds in read_surfaces(data, tmp_path)]


def read_surfaces(data, tmp_path):
    """Solids in a STEP file: (valid, volume, names of the surfaces) of each."""
    pytest.importorskip(
        "OCP", exc_type=ImportError, reason="Open CASCADE (cadquery-ocp-novtk) reads STEP back and is not installed"
    )
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    path = tmp_path / "a.step"
    path.write_bytes(data)
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    found = []
    solids = TopExp_Explorer(reader.OneShape(), TopAbs_ShapeEnum.TopAbs_SOLID)
    while solids.More():
        body = solids.Current()
        properties = GProp_GProps()
        getattr(BRepGProp, "VolumeProperties_s", getattr(BRepGProp, "VolumeProperties", None))(body, properties)
        kinds, explorer = [], TopExp_Explorer(body, TopAbs_ShapeEnum.TopAbs_FACE)
        as_face = getattr(TopoDS, "Face_s", getattr(TopoDS, "Face", None))
        while explorer.More():
            kinds.append(str(BRepAdaptor_Surface(as_face(explorer.Current())).GetType()).rpartition("_")[2])
            explorer.Next()
        found.append((BRepCheck_Analyzer(body).IsValid(), properties.Mass(), kinds))
        solids.Next()
    return found


@pytest.mark.parametrize(
    ("solid", "volume", "faces"),
    [
        (prism([L_SHAPE]), 8000.0, 9),
        (prism([L_SHAPE[::-1], HOLE]), 7500.0, 13),
        (prism([L_SHAPE], scale=0.5), 20.0 / 3.0 * (400 + 200 + 100), 9),
        (prism([L_SHAPE / 10], depth=2.0, unit="cm"), 8000.0, 9),
    ],
    ids=["prism", "hole", "frustum", "centimetres"],
)
def test_open_cascade_reads_a_valid_solid(solid, volume, faces, tmp_path):
    ((valid, got, count),) = read_back(encode(solid, "step"), tmp_path)
    assert valid
    assert got == pytest.approx(volume, rel=1e-6)
    assert count == faces


@pytest.mark.parametrize("name", ROUND)
def test_round_sides_are_true_cylinders_and_cones(name, tmp_path):
    solid, volume, _, _, kinds = ROUND[name]
    ((valid, got, found),) = read_surfaces(encode(solid, "step"), tmp_path)
    assert valid
    assert got == pytest.approx(volume, rel=1e-9)
    assert sorted(found) == sorted(KINDS[kind] for kind in kinds)


def test_a_slanting_cone_is_an_exact_rational_surface(tmp_path):
    # the hole of a tapered plate does not run along the axis
    plate = body(SQUARE, [4, 0], [(1, None, 2, 2, 1, 1)], depth=1.0, scale=0.5)
    ((valid, got, found),) = read_surfaces(encode(plate, "step"), tmp_path)
    assert valid
    assert got == pytest.approx(plate.volume, rel=1e-5)  # Open CASCADE integrates these by a rule
    assert found[-1] == "BSplineSurface"


def test_several_solids_stay_apart(tmp_path):
    bodies = read_back(encode([prism([L_SHAPE]), prism([HOLE])], "step"), tmp_path)
    assert [round(volume) for _, volume, _ in bodies] == [8000, 500]


def test_every_reference_is_defined_and_every_edge_used_twice():
    text = encode(prism([L_SHAPE, HOLE]), "step").decode()
    defined = set(re.findall(r"^#(\d+)=", text, re.M))
    assert set(re.findall(r"#(\d+)", text)) == defined
    curves = re.findall(r"ORIENTED_EDGE\('',\*,\*,#(\d+),\.([TF])\.\)", text)
    assert len(curves) == 2 * 33
    assert len(set(curves)) == 2 * 33
    assert "E+" not in text
    numbers = re.findall(r"(?:POINT|DIRECTION)\('',\(([^)]*)\)\)", text)
    assert all("." in number for triple in numbers for number in triple.split(","))
