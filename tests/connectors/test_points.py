import numpy as np
import pytest

from sketch2shape.connectors import connect, methods
from sketch2shape.connectors.points import check_points
from sketch2shape.errors import LimitError, PointsError, UsageError

BAD = {
    "two points": ([(0, 0), (1, 1)], r"at least 3 points, got 2"),
    "none": (np.empty((0, 2)), r"at least 3 points, got 0"),
    "three columns": (np.zeros((5, 3)), r"\(n, 2\), got \(5, 3\)"),
    "flat": ([1.0, 2.0, 3.0], r"\(n, 2\), got \(3,\)"),
    "ragged": ([(0, 0), (1,), (2, 2)], "different lengths|elements of type"),
    "text": ([("a", "b"), ("c", "d"), ("e", "f")], "elements of type"),
    "complex": (np.zeros((4, 2), complex), "elements of type complex128"),
    "NaN": ([(0, 0), (1, 0), (np.nan, 1)], r"finite coordinates, got \[nan, 1.0\] at row 2"),
    "infinite": ([(0, 0), (1, 0), (1, np.inf)], r"finite coordinates, got \[1.0, inf\] at row 2"),
    "huge": ([(0, 0), (1e300, 0), (0, 1e300)], r"within \+-1e\+12, got 1e\+300"),
    "duplicates": ([(0, 0), (1, 0), (0, 1), (1, 0)], r"distinct points, got \[1.0, 0.0\] at rows 1 and 3"),
    "collinear": ([(0, 0), (0.1, 0.1), (0.3, 0.3), (0.7, 0.7)], "4 points on one line"),
    "collinear far off": ([(1e6, 1e6), (1e6 + 1 / 3, 1e6 + 1 / 9), (1e6 + 3, 1e6 + 1)], "3 points on one line"),
}


def test_points_in_opencvs_shape():
    square = np.array([[0, 0], [2, 2], [2, 0], [0, 2]], np.int32)
    assert connect(square[:, None]).tolist() == connect(square).tolist()


@pytest.mark.parametrize("method", methods())
@pytest.mark.parametrize("case", BAD)
def test_bad_points_get_a_typed_error_that_says_expected_and_actual(method, case):
    points, words = BAD[case]
    with pytest.raises(PointsError, match=words) as caught:
        connect(points, method)
    assert "expected" in str(caught.value)


@pytest.mark.parametrize("method", [name for name in methods() if name != "split-walk"])
def test_too_many_points_for_a_slow_method(method):
    many = np.broadcast_to(np.zeros(2), (10_000_000, 2))
    with pytest.raises(LimitError, match=r"at most .* got 10,000,000") as caught:
        connect(many, method)
    assert "split-walk" in caught.value.advice


def test_unknown_method_and_parameter():
    points = [(0, 0), (1, 0), (0, 1)]
    with pytest.raises(UsageError, match=r"did you mean 'jarvis'"):
        connect(points, "jarvi")
    with pytest.raises(UsageError, match="'park-oh' expected N, got M"):
        connect(points, "park-oh", M=2)


def test_good_points_are_left_alone():
    points = [[0, 0], [1, 0], [0, 1]]
    assert check_points(points).tolist() == points
    array = np.array(points, float)
    array.flags.writeable = False
    for method in methods():
        if method != "orthogonal":  # which has no answer for three points
            connect(array, method)


def test_thin_shapes_are_not_on_one_line():
    assert len(check_points([(0, 0), (1000, 0), (1000, 1e-3), (0, 1e-3)])) == 4


def test_a_late_corner_among_many_on_a_line():
    line = np.c_[np.arange(1000.0), np.zeros(1000)]
    assert len(check_points(np.r_[line, [[500.0, 1.0]]])) == 1001
