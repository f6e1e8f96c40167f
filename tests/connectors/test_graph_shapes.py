"""alpha-shape and a-shape, and rings out of graphs."""

import numpy as np
import pytest

from sketch2shape.connectors import connect, connect_detailed
from sketch2shape.connectors.graph import single_cycle, widest_ring
from sketch2shape.connectors.polygon import canonical


def circle(n: int):
    angle = 2 * np.pi * np.arange(n) / n
    return np.column_stack((np.cos(angle), np.sin(angle)))


def test_alpha_zero_is_the_convex_hull():
    points = np.random.default_rng(1).uniform(0, 1, (50, 2))
    assert canonical(connect(points, "alpha-shape", alpha=0)) == canonical(connect(points, "graham"))


def test_alpha_shape_of_a_worked_example():
    # two unit squares side by side and a far point: triangles to the far point have circumradius > 3
    points = np.array([(0, 0), (1, 0.01), (2, 0), (2, 1), (1, 0.99), (0, 1), (8, 0.5)], float)
    found = connect_detailed(points, "alpha-shape", alpha=1.0)
    assert canonical(found.order) == (0, 1, 2, 3, 4, 5)
    assert any("1 points were left out" in word for word in found.violated)


def test_default_alpha_finds_the_ring_through_all(shapes):
    found = connect_detailed(shapes["hexagon"], "alpha-shape")
    assert found.complete
    assert canonical(found.order) == tuple(range(6))


def test_the_crust_follows_a_dense_curve():
    # the crust is right where the curve is sampled densely against its distance from the medial axis
    curve = circle(40) * (1 + 0.2 * np.cos(3 * 2 * np.pi * np.arange(40) / 40))[:, None]
    shuffled = np.random.default_rng(4).permutation(40)
    found = connect_detailed(curve[shuffled], "a-shape")
    assert canonical(shuffled[found.order]) == tuple(range(40))


def test_a_shape_keeps_the_edges_that_markers_see():
    # the marker in the mouth of the V takes away the lid, so the V's inner edges stay
    v = np.array([(0, 4), (3, 0), (6, 4), (3, 2)], float)
    around = [(-20, -20), (26, -20), (26, 24), (-20, 24)]
    assert canonical(connect(v, "a-shape", A=[*around, (3, 4.5)])) == (0, 1, 2, 3)
    assert len(connect(v, "a-shape", A=around)) == 3


@pytest.mark.parametrize(
    ("edges", "ring"),
    [
        ([(0, 1), (1, 2), (2, 0)], [0, 1, 2]),
        ([(0, 1), (1, 2), (2, 0), (2, 3)], None),
        ([(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)], None),
    ],
)
def test_single_cycle(edges, ring):
    found = single_cycle(np.array(edges))
    assert (None if found is None else list(canonical(found))) == ring


def test_widest_ring_cuts_dangling_edges_and_names_what_is_left():
    points = np.array([(0, 0), (2, 0), (2, 2), (0, 2), (5, 5)], float)
    ring, said = widest_ring(points, np.array([(0, 1), (1, 2), (2, 3), (3, 0), (2, 4)]))
    assert canonical(ring) == (0, 1, 2, 3)
    assert said == ("some edges dangle", "1 points were left out")


def test_widest_ring_walks_around_branches():
    points = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], float)
    ring, said = widest_ring(points, np.array([(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)]))
    assert canonical(ring) == (0, 1, 2, 3)
    assert said == ("the edges branch",)


def test_nothing_enclosed():
    ring, said = widest_ring(np.zeros((3, 2)), np.array([(0, 1), (1, 2)]))
    assert len(ring) == 0
    assert said == ("the edges enclose nothing",)
