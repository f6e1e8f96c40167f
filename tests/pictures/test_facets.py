import numpy as np
import pytest

from sketch2shape.pictures.facets import surface
from sketch2shape.result import Result


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
