import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.geometry import (
    are_simple,
    cross,
    inside,
    line_crossings,
    segment_distance,
    segments_meet,
    signed_area,
    size_of,
)

SQUARE = np.array([(0, 0), (4, 0), (4, 3), (0, 3)], float)

number = st.floats(-100, 100).map(lambda x: round(x, 2))
points = st.lists(st.tuples(number, number), min_size=4, max_size=4, unique=True).map(lambda p: np.array(p, float))


def test_signed_area_and_size():
    assert signed_area(SQUARE) == 12.0
    assert signed_area(SQUARE[::-1]) == -12.0
    assert size_of(SQUARE) == 5.0


def test_inside_counts_crossings():
    some = np.array([(1, 1), (5, 1), (-1, 1), (1, 5)], float)
    assert inside(some, SQUARE).tolist() == [True, False, False, False]


def test_a_ring_whose_edges_cross_is_not_simple():
    square = np.array([[0.0, 0], [4, 0], [4, 4], [0, 4]])
    bow = square[[0, 2, 1, 3]]
    dart = np.array([[0.0, 0], [4, 0], [1, 1], [0, 4]])
    assert are_simple(np.array([square, bow, dart, square[::-1]])).tolist() == [True, False, True, True]
    assert are_simple(square)
    assert not are_simple(bow)
    # a vertex on another edge touches it
    assert are_simple(np.array([[0.0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]))


def test_segments_meet_in_a_crossing_a_touch_and_not():
    a, b = np.array([0.0, 0.0]), np.array([4.0, 0.0])
    others = np.array(
        [[(2, -1), (2, 1)], [(2, 0), (2, 1)], [(2, 1), (2, 2)], [(5, 0), (6, 0)], [(3, 0), (6, 0)]], float
    )
    assert segments_meet(a, b, others[:, 0], others[:, 1]).tolist() == [True, True, False, False, True]


def test_parallel_lines_cross_nowhere():
    at, other = line_crossings(np.zeros(2), np.array([1.0, 0]), np.array([[0, 1.0], [0, 0]]), np.array([2.0, 0]))
    assert not np.isfinite(at).any()
    assert not np.isfinite(other).any()


@given(points)
def test_lines_cross_where_both_say(p):
    along, across = p[1] - p[0], p[3] - p[2]
    if abs(cross(along, across)) < 1e-3 * np.hypot(*along) * np.hypot(*across):
        return
    s, t = line_crossings(p[0], along, p[2], across)
    assert p[0] + s * along == pytest.approx(p[2] + t * across, abs=1e-6)


@given(points)
def test_segments_meet_and_keep_their_distance_as_in_geos(p):
    first, second = shapely.LineString(p[:2]), shapely.LineString(p[2:])
    if not 0 < first.distance(second) < 1e-9:
        assert bool(segments_meet(*p)) == first.intersects(second)
    assert segment_distance(p[0], p[2], p[3]) == pytest.approx(second.distance(shapely.Point(p[0])), abs=1e-9)


@given(points, st.tuples(number, number))
def test_inside_as_in_geos(p, q):
    hull = np.array(shapely.MultiPoint(p).convex_hull.exterior.coords[:-1]) if signed_area(p) else SQUARE
    polygon, point = shapely.Polygon(hull), shapely.Point(q)
    if polygon.exterior.distance(point) > 1e-9:
        assert bool(inside(np.array([q]), hull)[0]) == polygon.contains(point)
