"""Lifting by hand, and what can be done with a solid."""

import numpy as np
import pytest
import trimesh
from sketches import DEPTH, L_SHAPE, SQUARE

import sketch2shape as s2s
from sketch2shape import Solid, UsageError, lifting, model
from tests.solids.round_bodies import ROUND

BOX = s2s.TwoFaceObject(SQUARE, SQUARE + DEPTH)


def test_what_lift_returns_can_be_meshed_and_written(tmp_path):
    solid = s2s.lift(BOX, options=s2s.LiftOptions(width="40mm"))
    assert isinstance(solid, s2s.Solid)
    assert isinstance(solid, model.Solid)
    assert solid.mesh.is_watertight
    assert solid.mesh.volume == pytest.approx(solid.volume)
    path = solid.export(tmp_path / "a.stl")
    assert trimesh.load(path).volume == pytest.approx(solid.volume, rel=1e-5)
    assert b"40" in solid.export(tmp_path / "a.txt", "face.svg").read_bytes()
    with pytest.raises(s2s.UsageError):
        solid.export(tmp_path / "a.svg")


def test_it_is_the_solid_that_the_stage_gives():
    plain = lifting.lift(BOX)
    solid = s2s.Solid.of(plain)
    assert np.array_equal(solid.vertices, plain.vertices)
    assert (solid.projection, solid.warnings, solid.unit) == (plain.projection, plain.warnings, plain.unit)
    assert s2s.Solid.of(solid) is solid


def test_stages_chain_from_corners_to_a_file(tmp_path):
    from sketches import prism

    picture = prism(L_SHAPE, L_SHAPE + DEPTH)
    corners = s2s.detect_corners(picture)
    best = s2s.separate_faces(picture, corners=corners)[0]
    assert sorted(s2s.connect(best.f1)) == list(range(6))
    solid = s2s.lift(best, picture_size=(480, 400))
    assert trimesh.load(solid.export(tmp_path / "l.obj")).is_watertight


def test_options_by_name_and_what_is_wrong_with_them():
    assert s2s.lift(BOX, options={"width": "40mm"}).unit == "mm"
    for wrong, match in (({"widht": 3}, "widht"), ({"width": -1}, "not a length"), (3, "LiftOptions")):
        with pytest.raises(s2s.UsageError, match=match):
            s2s.lift(BOX, options=wrong)
    with pytest.raises(s2s.UsageError, match="TwoFaceObject"):
        s2s.lift(SQUARE)


def test_a_tolerance_is_a_length(tmp_path):
    solid = Solid.of(ROUND["cylinder"][0])
    rough, fine = (solid.export(tmp_path / f"{k}.obj", tolerance=t) for k, t in enumerate(("0.2mm", "0.0001cm")))
    assert rough.stat().st_size < 0.2 * fine.stat().st_size
    with pytest.raises(UsageError, match="tolerance"):
        solid.export(tmp_path / "a.obj", tolerance="fine")
