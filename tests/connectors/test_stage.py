import subprocess
import sys

import numpy as np
import pytest

import sketch2shape
from sketch2shape.connectors import connect, connect_detailed, methods
from sketch2shape.connectors.polygon import blocked, canonical, ring_is_simple

SQUARE = np.array([(0, 0), (4, 0), (4, 3), (0, 3)], float)


@pytest.mark.parametrize("method", methods())
def test_every_method_connects_a_rectangle(method):
    if method == "concave-hull":
        pytest.importorskip("concave_hull")
    shuffled = np.array([2, 0, 3, 1])
    order = connect(SQUARE[shuffled], method)
    assert order.dtype == np.intp
    assert canonical(shuffled[order]) == (0, 1, 2, 3)


@pytest.mark.parametrize("method", methods())
def test_every_method_is_documented(method):
    from sketch2shape.connectors.registry import find_method

    entry = find_method(method)
    assert "O(" in entry.complexity
    assert entry.function.__doc__
    for name in entry.parameters:
        assert f"{name} " in entry.function.__doc__


def test_the_stage_and_its_methods_are_public():
    assert sketch2shape.connect(SQUARE, "graham").tolist() == connect(SQUARE, "graham").tolist()
    assert "split-walk" in methods()
    assert sketch2shape.connect_faces(SQUARE, SQUARE + 5).shape == (12, 2)


def test_details_judge_the_ring(shapes):
    found = connect_detailed(shapes["plus"], "graham")
    assert not found.complete
    assert found.simple
    assert np.array_equal(found.ring, shapes["plus"][found.order])
    crossed = connect_detailed(shapes["U"], "angular")
    assert crossed.complete


def test_a_crossing_ring_is_said():
    points = np.array([(0, 0), (1, 3), (2, 0.2), (3, 3.1), (4, 0), (2.1, 1.0), (0.1, 3)], float)
    found = connect_detailed(points, "split-walk")
    assert found.simple == ring_is_simple(points[found.order])
    assert found.simple or any("crosses" in word for word in found.violated)


def test_the_walks_path_imports_numpy_only():
    code = (
        "import sys; from sketch2shape.connectors import connect, split_walk_preconditions as p; import numpy as np;"
        "a = np.array([[0,0],[4,0],[4,3],[0,3]], float); p(a, connect(a, 'split-walk'));"
        "print([m for m in ('scipy', 'shapely', 'cv2', 'skimage', 'trimesh') if m in sys.modules])"
    )
    assert (
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"
    )


# ---------------------------------------------------------------- polygons


def test_blocked_ignores_a_shared_end_but_not_an_overlap():
    points = np.array([(0, 0), (4, 0), (2, 3), (2, 0)], float)
    assert not blocked(points, 0, 1, np.array([(1, 2)]))
    assert blocked(points, 0, 1, np.array([(0, 3)]))


@pytest.mark.parametrize("n", [8, 900])
def test_simple_rings(n):
    angle = 2 * np.pi * np.arange(n) / n
    ring = np.column_stack((np.cos(angle), np.sin(angle)))
    assert ring_is_simple(ring)
    ring[[1, 4]] = ring[[4, 1]]
    assert not ring_is_simple(ring)


def test_a_ring_that_touches_itself_is_not_simple():
    assert not ring_is_simple(np.array([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)], float))
