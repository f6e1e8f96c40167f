"""Programs make the solid: OpenSCAD, build123d and CadQuery run them where they are installed."""

from __future__ import annotations

import io
import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
import trimesh
from export.test_step import prism as leaning_prism
from export.upright import BOX, CURVED, HOUSE, NOTCH, STAR, WINDOW, L, facing
from solids.bodies import BODIES
from solids.round_bodies import ROUND

from sketch2shape.export import encode

SOLIDS = {
    "L": facing([L]),
    "hole": facing([L, NOTCH]),
    "frame": facing([BOX, WINDOW]),
    "house in pixels": facing([HOUSE], unit="px"),
    "star in centimetres": facing([STAR], unit="cm"),
    "clockwise": facing([HOUSE[::-1]]),
    "lying": facing([L], along="up"),
    "frustum": facing([L, NOTCH], scale=0.5),
    "frustum that grows": facing([BOX], scale=1.7, foot=(0, 0)),
    "frustum upward": facing([HOUSE], scale=0.3, along="up"),
    "turned": leaning_prism([HOUSE, NOTCH + 12]),
    "turned frustum": leaning_prism([L], scale=0.5),
    **{name: solid for name, (solid, _, _) in BODIES.items()},
    **CURVED,
    **{f"book's {name}": solid for name, (solid, *_) in ROUND.items()},
}
each = pytest.mark.parametrize("name", SOLIDS)

#: what is written has so many digits: relative to the volume, and to the largest coordinate
CLOSE = 2e-4


#: a circle of 180 chords lacks this part of its area
CHORDS = 1 - np.sin(2 * np.pi / 180) / (2 * np.pi / 180)


def agree(measured, solid, volume_close=CLOSE):
    mesh = trimesh.load(io.BytesIO(encode(solid, "stl")), file_type="stl")
    factor = mesh.extents[0] / solid.dimensions[0] if solid.unit == "cm" else 1.0
    assert measured[0] == pytest.approx(solid.volume * factor**3, rel=volume_close)
    np.testing.assert_allclose(np.array(measured[1]), mesh.bounds, atol=2 * CLOSE * np.abs(mesh.bounds).max())


def openscad(text, folder):
    """Volume and bounds of what OpenSCAD makes of a program."""
    if shutil.which("openscad") is None:
        pytest.skip("OpenSCAD is not installed (Debian: openscad)")
    (folder / "a.scad").write_bytes(text)
    command = ["openscad", "--hardwarnings", "-o", str(folder / "a.stl"), str(folder / "a.scad")]
    subprocess.run(command, check=True, capture_output=True, timeout=60)
    mesh = trimesh.load(folder / "a.stl")
    return mesh.volume, mesh.bounds


@each
def test_openscad_makes_the_solid(name, tmp_path):
    solid = SOLIDS[name]
    agree(openscad(encode(solid, "scad"), tmp_path), solid, CLOSE + 6 * CHORDS * solid.boundary.is_round)


def test_openscad_follows_a_number_that_is_changed(tmp_path):
    text = encode(SOLIDS["frame"], "scad").replace(b"wall = 5;", b"wall = 10;")
    volume, _ = openscad(text, tmp_path)
    assert volume == pytest.approx(25 * (60 * 40 - 40 * 20))


def test_openscad_takes_several_solids(tmp_path):
    far = BODIES["pyramid"][0]
    text = encode([SOLIDS["L"], far], "scad").replace(b"translate([width_2", b"translate([200 + width_2")
    volume, bounds = openscad(text, tmp_path)
    assert volume == pytest.approx(SOLIDS["L"].volume + far.volume, rel=CLOSE)
    assert bounds[1, 0] == pytest.approx(202.0)


MEASURE = """
import json, runpy, sys
def measure(part):
    if hasattr(part, "bounding_box"):
        box, faces = part.bounding_box(), [face.geom_type.name for face in part.faces()]
        return part.volume, [tuple(box.min), tuple(box.max)], faces, part.is_valid
    shape = part.val()
    box = shape.BoundingBox()
    bounds = [(box.xmin, box.ymin, box.zmin), (box.xmax, box.ymax, box.zmax)]
    return shape.Volume(), bounds, [face.geomType() for face in shape.Faces()], shape.isValid()
print(json.dumps({name: measure(runpy.run_path(name)["part"]) for name in sys.argv[1:]}))
"""


def python_of(library):
    """A Python that has the library: the one that the environment names, or this one. Skips where there is none."""
    named = os.environ.get(f"{library.upper()}_PYTHON", sys.executable)
    code = f"import importlib.util, sys; sys.exit(importlib.util.find_spec({library!r}) is None)"
    if subprocess.run([named, "-c", code], check=False, timeout=60).returncode:
        pytest.skip(f"{library} is not installed, and {library.upper()}_PYTHON names no Python that has it")
    return named


@pytest.fixture(scope="module", params=["build123d", "cadquery"])
def measured(request, tmp_path_factory):
    """What the library makes of all programs at once, as loading it takes seconds: volume, bounds, kinds of faces."""
    python, folder = python_of(request.param), tmp_path_factory.mktemp(request.param)
    texts = {name: encode(solid, request.param) for name, solid in SOLIDS.items()}
    texts["two"] = encode([SOLIDS["L"], BODIES["pyramid"][0]], request.param)
    texts["wider"] = texts["frame"].replace(b"width = 60", b"width = 90")
    for number, text in enumerate(texts.values()):
        (folder / f"{number}.py").write_bytes(text)
    files = [f"{number}.py" for number in range(len(texts))]
    environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    done = subprocess.run(
        [python, "-c", MEASURE, *files], cwd=folder, env=environment, capture_output=True, text=True, timeout=240
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return dict(zip(texts, json.loads(done.stdout.splitlines()[-1]).values(), strict=True))


@each
def test_python_programs_make_the_solid(measured, name):
    volume, bounds, faces, valid = measured[name]
    agree((volume, bounds), SOLIDS[name])
    assert valid
    kinds = [type(face.surface).__name__.upper() for face in SOLIDS[name].faces]
    assert sorted(faces) == sorted(kinds)


def test_python_programs_take_several_solids_and_other_numbers(measured):
    assert measured["two"][0] == pytest.approx(SOLIDS["L"].volume + 4.0, rel=CLOSE)
    assert measured["wider"][0] == pytest.approx(25 * (90 * 40 - 80 * 30), rel=CLOSE)


@pytest.mark.parametrize("format", ["build123d", "cadquery"])
@each
def test_python_programs_are_python(name, format):
    compile(encode(SOLIDS[name], format), name, "exec")


@pytest.mark.parametrize("format", ["scad", "build123d", "cadquery"])
def test_the_unit_is_told(format):
    assert b"Lengths are in millimetres." in encode(SOLIDS["star in centimetres"], format)
    assert b"no real size was given" in encode(SOLIDS["house in pixels"], format)
    assert max(map(len, encode(SOLIDS["L"], format).decode().splitlines())) <= 120
