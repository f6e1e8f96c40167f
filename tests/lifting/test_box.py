import numpy as np
import pytest

from sketch2shape.lifting import lift
from sketch2shape.lifting.projection import prepare
from sketch2shape.model.drawing import TwoFaceObject

PAIRS = [[0, 1, 2, 3, 4, 5, 6, 7], [0, 1, 5, 4, 3, 2, 6, 7], [1, 2, 6, 5, 0, 3, 7, 4]]
TRAPEZOID = np.array([[0, 0], [180, 0], [140, 90], [30, 90.0]]) + 200


def volume_and_family(points, pair):
    solid = lift(TwoFaceObject(points[pair][:4], points[pair][4:]))
    vertices = np.empty((8, 3))
    vertices[pair] = solid.vertices
    return solid, vertices


@pytest.mark.parametrize("pair", PAIRS)
def test_a_trapezoid_prism_is_the_same_from_every_pair_of_sides(pair):
    points = np.concatenate([TRAPEZOID, TRAPEZOID + [60, -60]])
    solid, vertices = volume_and_family(points, pair)
    assert solid.projection.family == "oblique"
    face = vertices[:4] - vertices[0]
    want = np.c_[TRAPEZOID - TRAPEZOID[0], np.zeros(4)]
    assert face @ face.T == pytest.approx(want @ want.T, abs=1.0)


@pytest.mark.parametrize("pair", PAIRS)
def test_a_square_frustum_is_the_same_from_every_pair_of_sides(pair):
    base = np.array([[0, 0], [120, 0], [120, 120], [0, 120.0]]) + 200
    points = np.concatenate([base, 0.5 * base + [180, 60]])
    solid, vertices = volume_and_family(points, pair)
    assert np.linalg.norm(vertices[1] - vertices[0]) == pytest.approx(120, rel=0.01)
    assert np.linalg.norm(vertices[5] - vertices[4]) == pytest.approx(60, rel=0.01)
    assert solid.volume > 0


@pytest.mark.parametrize("pair", PAIRS)
def test_a_leaning_oblique_prism_keeps_its_level_face(pair):
    leaning = np.array([[0, 0], [150, 0], [190, -80], [40, -80.0]]) + 300
    points = np.concatenate([leaning, leaning + [50, -50]])
    _, vertices = volume_and_family(points, pair)
    assert abs((vertices[1] - vertices[0]) @ (vertices[3] - vertices[0])) == pytest.approx(150 * 40, rel=0.02)


@pytest.mark.parametrize("pair", PAIRS)
def test_a_low_box_seen_from_above_is_the_same_from_every_pair_of_sides(pair):
    """Two of its axes are drawn twelve degrees apart: about the third, its sides are seen almost from the edge."""
    up, right, deep = np.array([[0.0, -43.6], [225, 35], [-32, 151]])
    face = np.array([[0.0, 0], right, right + up, up]) + [150, 100]
    solid, vertices = volume_and_family(np.concatenate([face, face + deep]), pair)
    sizes = [np.linalg.norm(vertices[k] - vertices[0]) for k in (1, 4, 3)]
    assert sizes == pytest.approx(np.array([183.0, 143, 68]) * sizes[0] / 183, rel=0.03)
    assert solid.confidence > 0.85


def test_no_pair_of_sides_that_cross_themselves_is_tried():
    """Four-sided rings that are no solid's picture: the faces given are kept, and the solid is not inside out."""
    face = np.array([[369, 329], [326, 401], [256, 439], [409, 231.0]])
    back = np.array([[291, 134], [223, 242], [171, 240], [279, 78.0]])
    assert lift(TwoFaceObject(face, back)).volume > 0
    bow = np.array([[200, 200], [300, 200], [310, 120], [290, 260.0]])
    assert len(prepare(TwoFaceObject(face, face + [60, -60])).pairs) == 3
    assert len(prepare(TwoFaceObject(face, bow)).pairs) == 1
