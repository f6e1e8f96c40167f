from dataclasses import replace
from typing import Literal

import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, lift
from sketch2shape.model.drawing import TwoFaceObject
from sketch2shape.pictures.facets import stand, surface
from sketch2shape.pipeline.result import Result


@pytest.mark.parametrize(("name", "volume"), [("box", 200 * 180 * 150), ("tube", (280 * 240 - 120 * 120) * 150)])
def test_the_surface_is_closed_and_outward(name: str, volume: float, request: pytest.FixtureRequest) -> None:
    form = surface(request.getfixturevalue(name).solids)
    a, b, c = form.vertices[form.triangles].transpose(1, 0, 2)
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(volume)
    directed = {(int(t[i]), int(t[(i + 1) % 3])) for t in form.triangles for i in range(3)}
    assert {(j, i) for i, j in directed} == directed


def test_solids_side_by_side_share_no_vertex(box: Result, notched: Result) -> None:
    form = surface((box.solids[0], notched.solids[0]))
    assert form.vertices.shape == (8 + 16, 3)
    assert form.edges.shape == (12 + 24, 2)
    crossing = (form.triangles < 8).any(axis=1) & (form.triangles >= 8).any(axis=1)
    assert not crossing.any()


def test_no_solids_have_an_empty_surface() -> None:
    assert surface(()).vertices.shape == (0, 3)


def test_a_solid_is_looked_at_from_the_side_that_its_drawing_shows(box: Result) -> None:
    solid, drawing = box.solids[0], box.objects[0]  # the back goes right and up
    yaw, pitch = stand(solid, drawing).view
    assert yaw > 0
    assert pitch > 0
    other = replace(drawing, f1=drawing.f2, f2=drawing.f1)
    assert stand(solid, other).view == (-yaw, -pitch)


@pytest.mark.parametrize("up", ["camera", "y", "z"])
def test_a_solid_stands_as_it_is_drawn_whatever_its_coordinates(box: Result, up: Literal["y", "z", "camera"]) -> None:
    drawing = box.objects[0]
    solid = lift(drawing, options=LiftOptions(projection="oblique", up=up))
    shown = surface([solid], stand(solid, drawing).rotation).vertices
    front = shown[:4]
    assert np.ptp(front[:, 2]) < 1e-6 * np.ptp(front[:, 0])  # the front face looks at the viewer
    assert front[0, 1] < front[3, 1]  # its upper left corner is above its lower left one
    assert front[0, 0] < front[1, 0]
    assert front[0, 2] < shown[4, 2]


def test_a_box_stands_the_same_way_when_its_side_is_called_the_front(box: Result) -> None:
    f1, f2 = box.objects[0].f1, box.objects[0].f2
    side = TwoFaceObject(np.array([f1[1], f2[1], f2[2], f1[2]]), np.array([f1[0], f2[0], f2[3], f1[3]]))
    solid = lift(side)
    assert min(solid.dimensions) > 100
    shown = surface([solid], stand(solid, side).rotation).vertices
    assert np.ptp(shown, axis=0) == pytest.approx([200, 180, solid.volume / 36000], rel=0.02)


def test_a_solid_without_its_drawing_stands_as_its_camera_sees_it(notched: Result) -> None:
    solid = notched.solids[0]
    with_drawing, alone = stand(solid, notched.objects[0]), stand(solid, None)
    assert np.allclose(with_drawing.rotation, alone.rotation)
