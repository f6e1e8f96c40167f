"""Solids told as an outline drawn out, or refused."""

from __future__ import annotations

import numpy as np
import pytest
from export.test_step import prism as leaning_prism
from export.upright import BOX, HOUSE, NOTCH, L, facing
from hypothesis import given
from hypothesis import strategies as st
from solids.bodies import block_with_boss, hip_roof, pyramid

from sketch2shape.geometry import signed_area
from sketch2shape.model import Projection, Solid, two_face_boundary
from sketch2shape.solids import extrusion_of


def rebuilt(extrusion):
    """The vertices that the extrusion stands for."""
    found = []
    for outline in extrusion.outlines:
        far = extrusion.foot + extrusion.scale * (outline.points - extrusion.foot)
        for flat, level in ((outline.points, 0.0), (far, extrusion.length)):
            found.append(extrusion.origin + np.c_[flat, np.full(len(flat), level)] @ extrusion.axes)
    return np.concatenate(found)


def same_points(a, b):
    return all(np.linalg.norm(b - p, axis=1).min() < 1e-9 * np.ptp(b) for p in a)


@pytest.mark.parametrize(
    "solid",
    [facing([L, NOTCH]), facing([HOUSE[::-1]], scale=0.5), facing([BOX], scale=1.5, foot=(3, 4)), pyramid()]
    + [facing([L], along="up"), leaning_prism([HOUSE, NOTCH + 12]), leaning_prism([L], scale=2.0)],
)
def test_it_stands_for_the_same_vertices(solid):
    extrusion = extrusion_of(solid)
    assert same_points(rebuilt(extrusion), solid.vertices)
    assert same_points(solid.vertices, rebuilt(extrusion))
    np.testing.assert_allclose(np.linalg.det(extrusion.axes), 1.0)
    assert 0.0 <= extrusion.scale <= 1.0
    assert [signed_area(o.points) > 0 for o in extrusion.outlines] == [True] + [False] * (len(extrusion.outlines) - 1)


def test_sizes_are_called_as_those_of_the_upright_solid():
    assert extrusion_of(facing([L])).names == ("width", "height", "depth")
    assert extrusion_of(facing([L])).sides == (("left", "right"), ("bottom", "top"))
    assert extrusion_of(facing([L], along="up")).names == ("width", "depth", "height")
    assert extrusion_of(facing([L], scale=0.5)).sides == (("right", "left"), ("bottom", "top"))


def test_what_is_none_is_refused():
    assert extrusion_of(hip_roof()) is None
    assert extrusion_of(block_with_boss()) is None
    leaning = facing([BOX]).vertices.copy()
    leaning[4:] += [5, 0, 0]
    assert extrusion_of(Solid(two_face_boundary(leaning, [4]), Projection("oblique"))) is None
    twisted = facing([BOX]).vertices.copy()
    twisted[4] += [0, 0, 7.0]
    assert extrusion_of(Solid(two_face_boundary(twisted, [4]), Projection("oblique"))) is None


@given(st.integers(3, 9), st.floats(0.05, 3.0), st.floats(-50, 50), st.floats(1, 80))
def test_any_frustum_is_found(n, scale, lean, depth):
    ring = 30 * np.array([[np.cos(a), np.sin(a)] for a in 2 * np.pi * np.arange(n) / n])
    solid = facing([ring], depth=depth, scale=scale, foot=(lean, 0.0))
    extrusion = extrusion_of(solid)
    if extrusion is None:  # the axis leans: nothing is scaled, yet the far end is moved
        assert abs(scale - 1.0) < 1e-5
    else:
        assert same_points(rebuilt(extrusion), solid.vertices)
