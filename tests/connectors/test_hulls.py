"""graham and jarvis against SciPy and each other; chi-shape against GEOS; digging methods on worked examples."""

import numpy as np
import pytest
import shapely
from scipy.spatial import ConvexHull, Delaunay

from sketch2shape.connectors import connect, connect_detailed
from sketch2shape.errors import MissingPackageError, UsageError


@pytest.mark.parametrize("method", ["graham", "jarvis"])
@pytest.mark.parametrize("n", [3, 10, 300])
def test_convex_hull_is_qhulls(method, n):
    points = np.random.default_rng(n).normal(size=(n, 2))
    hull = ConvexHull(points).vertices  # counter-clockwise
    got = connect(points, method)
    at = int(np.flatnonzero(hull == got[0])[0])
    assert got.tolist() == np.roll(hull, -at).tolist()


@pytest.mark.parametrize("method", ["graham", "jarvis"])
def test_points_on_hull_edges_are_left_out(method):
    grid = np.array([(x, y) for x in range(5) for y in range(4)], float)
    assert sorted(map(tuple, grid[connect(grid, method)].tolist())) == [(0, 0), (0, 3), (4, 0), (4, 3)]


def test_march_ends_among_points_in_line_but_for_rounding(shapes):
    for turn in np.linspace(0.01, 6.2, 60):
        view = np.array([[np.cos(turn), -np.sin(turn)], [0.4 * np.sin(turn), np.cos(turn)]])
        for name in ("U", "plus", "comb", "I"):
            points = shapes[name] @ view
            hull = shapely.convex_hull(shapely.multipoints(points))
            got = shapely.polygons(points[connect(points, "jarvis")])
            assert got.symmetric_difference(hull).area < 1e-9 * hull.area


def test_park_oh_digs_a_notch_and_not_above_its_threshold(shuffle, same_ring):
    # the hull's edge over the notch is 3.54 long, the notch 2.5 from its ends: ratio 1.414
    points, order = shuffle([(0, 0), (6, 0), (6, 3.5), (3.5, 3.5), (3.5, 6), (0, 6)])
    assert same_ring(connect(points, "park-oh", N=1.41), order)
    assert len(connect(points, "park-oh", N=1.42)) == 5


def test_park_oh_leaves_points_to_the_neighbouring_edge():
    # p is nearer to the right side than to the bottom, so the bottom must not dig to it
    points = np.array([(0, 0), (10, 0), (10, 4), (0, 4), (9, 2)], float)
    order = connect(points, "park-oh", N=1.5).tolist()
    at = order.index(4)
    assert {order[at - 1], order[(at + 1) % 5]} == {1, 2}


def test_park_oh_all_uses_every_point(shapes, shape, shuffle):
    points, _ = shuffle(shapes[shape])
    found = connect_detailed(points, "park-oh-all", N=3.0)
    assert found.complete
    assert found.simple


@pytest.mark.parametrize("ratio", [0.0, 0.2, 0.5, 0.9, 1.0])
@pytest.mark.parametrize("seed", range(4))
def test_chi_shape_equals_geos_at_the_same_ratio(ratio, seed):
    points = np.random.default_rng(seed).uniform(0, 10, (60, 2))
    lengths = Delaunay(points).simplices  # no triangle is degenerate for random points
    assert len(lengths)
    ours = shapely.polygons(points[connect(points, "chi-shape", ratio=ratio)])
    theirs = shapely.concave_hull(shapely.multipoints(points), ratio=ratio)
    assert ours.symmetric_difference(theirs).area < 1e-9 * theirs.area


def test_chi_shape_length_zero_digs_all_it_can_and_huge_is_the_hull(shapes, shuffle, same_ring):
    points, order = shuffle(shapes["plus"])
    assert same_ring(connect(points, "chi-shape"), order)
    assert sorted(connect(points, "chi-shape", length=100.0)) == sorted(connect(points, "graham"))


def test_shapely_form_is_shapelys(shapes):
    points = shapes["T"]
    theirs = shapely.get_coordinates(shapely.concave_hull(shapely.multipoints(points), ratio=0.4))[:-1]
    assert np.array_equal(points[connect(points, "chi-shape-shapely", ratio=0.4)], theirs)


def test_ec_shape_digs_a_notch_whose_apex_is_in_the_circle():
    # the apex (5, 1) is 1 from the middle of the bottom edge of length 10, well within 5
    points = np.array([(0, 0), (10, 0), (10, 8), (0, 8), (5, 1)], float)
    assert len(connect(points, "ec-shape")) == 5
    assert len(connect(points, "ec-shape", v=0.01)) == 4


def test_concave_hull_package_at_its_two_extremes(shapes, shuffle, same_ring):
    pytest.importorskip("concave_hull")
    points, order = shuffle(shapes["L"])
    assert len(connect(points, "concave-hull")) == 5  # the package's default is the convex hull of an L
    assert same_ring(connect(points, "concave-hull", concavity=1.0), order)


def test_concave_hull_without_its_package(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "concave_hull", None)
    with pytest.raises(MissingPackageError, match="concave-hull"):
        connect([(0, 0), (4, 0), (0, 3)], "concave-hull")


@pytest.mark.parametrize(
    ("method", "parameters"),
    [
        ("park-oh", {"N": 0}),
        ("park-oh-all", {"N": -1}),
        ("concave-hull", {"concavity": 0}),
        ("chi-shape", {"ratio": 1.5}),
        ("chi-shape", {"length": -1}),
        ("chi-shape", {"length": 1, "ratio": 0.5}),
        ("chi-shape-shapely", {"ratio": -0.1}),
        ("ec-shape", {"v": 0}),
        ("alpha-shape", {"alpha": -1}),
        ("galton-duckham", {"r": 0}),
        ("moreira-santos", {"k": 2}),
        ("orthogonal", {"tolerance": -1}),
        ("orthogonal", {"directions": "some"}),
    ],
)
def test_parameters_out_of_range(method, parameters):
    with pytest.raises(UsageError, match="expected"):
        connect([(0, 0), (4, 0), (4, 3), (0, 3)], method, **parameters)
