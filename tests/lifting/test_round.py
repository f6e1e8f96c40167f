"""Drawings with arcs, and those that come to a point, become the solids that were drawn."""

from dataclasses import replace

import numpy as np
import pytest

from sketch2shape.lifting import LiftOptions, choose_front, lift
from sketch2shape.model import Circle, Cone, Cylinder, TwoFaceObject
from sketch2shape.solids import shape_name, tessellated
from tests.lifting.round_views import (
    CIRCLE,
    GROOVE,
    HALF,
    HOLE,
    ROUNDED,
    SLOT,
    SQUARE,
    STANDING,
    Drawer,
    Photographer,
    axonometric,
    oblique,
)

#: rings, depth, scale of the back face, sorted sizes, name
CASES = {
    "cylinder": ([CIRCLE], 1.5, 1.0, (1.6, 1.6, 1.5), "cylinder"),
    "tube": ([CIRCLE, HOLE], 1.5, 1.0, (1.6, 1.6, 1.5), "tube"),
    "plate": ([SQUARE, HOLE], 0.5, 1.0, (2, 2, 0.5), "plate with a round hole"),
    "half": ([HALF], 1.5, 1.0, (2, 1.5, 1), "half cylinder"),
    "slot": ([SLOT], 0.7, 1.0, (3, 1, 0.7), "slot prism"),
    "rounded": ([ROUNDED], 0.7, 1.0, (2, 1.4, 0.7), "rounded rectangle prism"),
    "groove": ([GROOVE], 0.9, 1.0, (2, 1, 0.9), "arched prism"),
    "frustum": ([CIRCLE], 1.5, 0.5, (1.6, 1.6, 1.5), "truncated cone"),
    "cone": ([CIRCLE], 1.5, 0.0, (1.6, 1.6, 1.5), "cone"),
    "pyramid": ([SQUARE], 1.5, 0.0, (2, 2, 1.5), "square pyramid"),
}


def sizes_over_largest(solid):
    return np.sort(solid.dimensions) / max(solid.dimensions)


@pytest.mark.parametrize("noise", [0.0, 1.0])
@pytest.mark.parametrize("standing", [False, True], ids=["lying", "standing"])
@pytest.mark.parametrize("name", CASES)
def test_axonometric_drawings_give_the_true_proportions(name, standing, noise):
    rings, depth, scale, want, words = CASES[name]
    drawer = Drawer(axonometric(), STANDING if standing else None, noise=noise)
    solid = lift(drawer.draw(rings, depth, scale))
    assert sizes_over_largest(solid) == pytest.approx(np.sort(want) / max(want), abs=0.05 if noise else 0.01)
    assert shape_name(solid) == words
    assert tessellated(solid.boundary).triangles.max() < 2000
    assert solid.volume > 0


@pytest.mark.parametrize("standing", [False, True], ids=["lying", "standing"])
@pytest.mark.parametrize("name", ["cylinder", "tube", "half", "slot", "rounded"])
def test_drawings_in_perspective_give_the_true_proportions(name, standing):
    rings, depth, _, want, words = CASES[name]
    drawn = Photographer(axonometric(elevation=25.0), STANDING if standing else None, away=6.0).draw(rings, depth)
    solid = lift(drawn)
    assert solid.projection.family == "perspective"
    assert sizes_over_largest(solid) == pytest.approx(np.sort(want) / max(want), abs=0.08)
    assert shape_name(solid) == words
    # the camera shows its vertices where they were drawn
    seen = np.c_[solid.vertices, np.ones(len(solid.vertices))] @ solid.camera.T
    if len(drawn.f1):
        assert seen[: len(drawn.f1), :2] / seen[: len(drawn.f1), 2:] == pytest.approx(drawn.f1, abs=5.0)


def test_a_tapered_round_object_in_a_parallel_view_is_in_no_perspective():
    rings, depth, scale, *_ = CASES["frustum"]
    assert lift(Drawer(axonometric()).draw(rings, depth, scale)).projection.family == "axonometric"


@pytest.mark.parametrize("name", [name for name, case in CASES.items() if case[2] == 1.0])
def test_circles_of_an_oblique_front_stay_circles(name):
    rings, _, _, want, _ = CASES[name]
    solid = lift(Drawer(oblique(), noise=0.7).draw(rings, 1.0))
    assert solid.projection.family == "oblique"
    assert np.array(solid.dimensions)[[0, 2] if solid.up == "z" else [0, 1]].max() > 0
    face = sorted(want)[-2:] if name != "half" else [1, 2]
    got = sorted(np.ptp(solid.boundary.extremes(np.eye(3)), axis=0)[[0, 2]])
    assert got[0] / got[1] == pytest.approx(min(face) / max(face), abs=0.03)


def test_arcs_are_exact_circles_and_joints_smooth():
    solid = lift(Drawer(axonometric(), noise=1.0).draw([ROUNDED], 0.7))
    radii = [e.curve.radius for e in solid.edges if isinstance(e.curve, Circle)]
    assert radii == pytest.approx([radii[0]] * 8, rel=1e-6)
    for face in solid.faces:
        if isinstance(face.surface, Cylinder):
            for arc, _ in solid.boundary.arcs(face):
                assert np.degrees(arc.sweep) == pytest.approx(90.0, abs=1e-4)
                ends = arc.at(np.array([0.0, 1.0]))
                assert min(np.linalg.norm(solid.vertices - ends[0], axis=1)) < 1e-6 * radii[0]


def test_camera_shows_the_solid_where_it_was_drawn():
    for rings, scale in (([CIRCLE], 1.0), ([CIRCLE], 0.0), ([HALF], 1.0), ([SQUARE], 0.0)):
        obj = Drawer(axonometric(), STANDING).draw(rings, 1.5, scale)
        solid = lift(obj)
        for arc in solid.edges:
            if not isinstance(arc.curve, Circle):
                continue
            seen = np.c_[solid.boundary.arc(arc).at(np.linspace(0, 1, 64)), np.ones(64)] @ solid.camera.T
            drawn = np.concatenate([a.points for a in obj.arcs])
            gaps = np.linalg.norm(seen[:, None, :2] - drawn[None], axis=2)
            assert gaps.min(axis=0).min() < 2.0
            assert gaps.min(axis=1).max() < 20.0
        seen = np.c_[solid.vertices, np.ones(len(solid.vertices))] @ solid.camera.T
        assert seen[:, :2] == pytest.approx(obj.vertices, abs=0.5)


def test_standing_and_lying_are_told():
    up = lift(Drawer(axonometric(), STANDING).draw([CIRCLE], 3.0))
    assert up.dimensions[1] == pytest.approx(max(up.dimensions))
    lying = lift(Drawer(axonometric()).draw([CIRCLE], 3.0))
    assert lying.dimensions[1] == pytest.approx(min(lying.dimensions), rel=1e-6)


@pytest.mark.parametrize("tip", [-1.5, 1.5], ids=["up", "down"])
def test_a_cone_stands_as_it_is_drawn(tip):
    obj = Drawer(axonometric(0, 25), STANDING).draw([CIRCLE], tip, 0.0)
    solid = lift(obj)
    assert isinstance(solid.faces[-1].surface, Cone)
    apex = solid.vertices[-1]
    assert apex[2] == pytest.approx(solid.dimensions[1] if tip < 0 else 0.0, rel=1e-6, abs=1e-9)
    assert apex[:2] == pytest.approx(0.0, abs=1e-6)


def test_sizes_are_taken_and_circles_stay_circles():
    obj = Drawer(axonometric(), STANDING).draw([CIRCLE], 1.5)
    solid = lift(obj, options=LiftOptions(width="40mm", depth="60mm", height="10mm"))
    assert solid.dimensions == pytest.approx((40, 10, 40))
    assert any("circles stay circles" in warning for warning in solid.warnings)
    assert max(lift(obj, options=LiftOptions(fit="50mm")).dimensions) == pytest.approx(50)


def test_without_beautifying_arcs_are_circles_all_the_same():
    solid = lift(Drawer(axonometric(), noise=1.0).draw([SLOT], 0.7), options=LiftOptions(beautify=False))
    assert sum(isinstance(f.surface, Cylinder) for f in solid.faces) == 2
    assert solid.volume > 0


def test_a_face_of_very_many_arcs_is_lifted_in_time():
    n = 40
    turn = 2 * np.pi * np.arange(n) / n
    ring = np.c_[np.cos(turn), np.sin(turn)]
    # scallops: each arc is a half circle over its chord
    arcs = {k: (0.5 * (ring[k] + ring[(k + 1) % n]), np.pi) for k in range(n)}
    solid = lift(Drawer(axonometric(), STANDING, noise=0.3).draw([(ring, arcs)], 0.5))
    assert sum(isinstance(f.surface, Cylinder) for f in solid.faces) == n
    assert sizes_over_largest(solid) == pytest.approx([0.5 / 2.15, 1, 1], abs=0.05)


def test_the_top_of_a_wire_cylinder_is_in_front_and_a_point_never_is():
    up = Drawer(axonometric(), STANDING).draw([CIRCLE], 1.5, lines="wire")
    assert choose_front(up) is up
    assert choose_front(up.swapped()).arcs[0].face == "f1"
    cone = Drawer(axonometric(), STANDING).draw([CIRCLE], -1.5, 0.0, lines="wire")
    assert choose_front(cone) is cone


def test_an_edge_on_circle_gets_a_warning():
    flat = np.array([[1.0, 0, 0], [0, 1e-4, 0.5]])
    solid = lift(Drawer(flat).draw([CIRCLE], 1.0))
    assert solid.warnings
    assert solid.confidence < 0.5


def test_a_straight_object_is_none_the_worse():
    square = np.array([[100, 100], [200, 100], [200, 200], [100, 200.0]])
    assert lift(TwoFaceObject(square, square + [40, -40])).boundary.is_round is False


@pytest.mark.parametrize("name", ["cone", "frustum"])
def test_the_face_that_hidden_lines_show_in_front_is_the_nearer_one(name):
    """The picture is the same: of a thing seen from above or from below."""
    rings, depth, scale, *_ = CASES[name]
    obj = Drawer(axonometric(), STANDING).draw(rings, depth, scale)
    assert [is_base_near(lift(replace(obj, front=front))) for front in ("f1", "f2")] == [True, False]


def is_base_near(solid):
    """Whether the largest circle lies nearer to the viewer than the middle of the solid."""
    base = max((e.curve for e in solid.edges if isinstance(e.curve, Circle)), key=lambda c: c.radius)
    inwards = np.cross(solid.camera[0, :3], solid.camera[1, :3])
    return base.center @ inwards < solid.boundary.extremes(np.eye(3)).mean(axis=0) @ inwards
