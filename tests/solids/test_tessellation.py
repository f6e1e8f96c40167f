import numpy as np
import pytest
import trimesh

from sketch2shape.model import Line
from sketch2shape.solids import tessellated
from tests.solids.round_bodies import ROUND


def mesh_of(form):
    return trimesh.Trimesh(form.vertices, form.triangles, process=False)


@pytest.mark.parametrize("tolerance", [None, 0.2, 0.003])
@pytest.mark.parametrize("name", ROUND)
def test_surface_is_closed_outward_and_within_the_tolerance(name, tolerance):
    solid, volume, area, holes, _ = ROUND[name]
    mesh = mesh_of(tessellated(solid.boundary, tolerance))
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2 - 2 * holes
    assert mesh.volume == pytest.approx(volume, abs=max(tolerance or 0.0, 5e-3) * area)


@pytest.mark.parametrize("name", ROUND)
def test_own_vertices_come_first_and_all_others_lie_on_the_true_circles(name):
    boundary = ROUND[name][0].boundary
    form = tessellated(boundary, 0.01)
    assert np.array_equal(form.vertices[: len(boundary.vertices)], boundary.vertices)
    for edge, path in zip(boundary.edges, form.paths, strict=True):
        if isinstance(edge.curve, Line):
            continue
        away = form.vertices[path] - edge.curve.center
        assert np.linalg.norm(away, axis=1) == pytest.approx(edge.curve.radius, rel=1e-12)
        assert away @ edge.curve.normal == pytest.approx(0.0, abs=1e-12)
        middles = 0.5 * (away[1:] + away[:-1])
        sag = edge.curve.radius - np.linalg.norm(middles, axis=1)
        assert sag.max() <= 0.01


def test_more_is_asked_of_finer_tolerances_and_never_without_end():
    boundary = ROUND["cylinder"][0].boundary
    counts = [len(tessellated(boundary, t).vertices) for t in (10.0, 0.1, 0.01, 0.0001, 1e-12)]
    assert counts == sorted(counts)
    assert counts[0] == 32
    assert counts[-1] == 2048


def test_extents_are_those_of_the_circle():
    form = tessellated(ROUND["cylinder"][0].boundary)
    assert np.ptp(form.vertices, axis=0) == pytest.approx([4, 4, 3])
