"""Ways from an outline to its image."""

from dataclasses import replace

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, drawn
from scipy.spatial import cKDTree
from sketches import ink_of

from sketch2shape.search.sweep_pairs import evenly
from sketch2shape.strokes import thin, trace_skeleton
from sketch2shape.sweeps import (
    Cells,
    Loop,
    Way,
    centres,
    directions,
    distinct_centres,
    distinct_directions,
    settled,
    settled_wire,
    shifts,
    ways_along,
)


def seen(sweep, lines):
    skeleton = thin(ink_of(drawn(sweep, lines)))
    size = float(np.hypot(*np.ptp(skeleton.points, axis=0)))
    return skeleton, size, trace_skeleton(skeleton, 1.5)


@pytest.mark.parametrize("sweep", [CYLINDER, ARCH], ids=["cylinder", "arch"])
def test_the_shift_is_among_the_ways_and_explains_the_ink(sweep):
    skeleton, size, strokes = seen(sweep, "removed")
    loop = Loop(evenly(sweep.rings[0].line))
    ways = ways_along(loop, skeleton, distinct_directions(directions(strokes, size)), size)
    cells = Cells.of(skeleton, size, np.ones(skeleton.mask.shape, bool))
    best = max(ways, key=lambda way: cells.value(loop, way))
    assert cells.value(loop, best) > 0.9
    best = settled(best, loop, skeleton, size)
    assert np.hypot(*(best.shift - sweep.way.shift)) < 4


def test_the_sides_of_a_cone_meet_in_its_point():
    _, size, strokes = seen(CONE, "removed")
    assert np.hypot(*(centres(strokes, size) - [240, 90]).T).min() < 4


@pytest.mark.parametrize("sweep", [ARCH, CYLINDER], ids=["arch", "cylinder"])
def test_the_shift_of_a_wireframe_lays_ink_on_ink(sweep):
    skeleton, size, _ = seen(sweep, "wire")
    found = shifts(skeleton, size)
    assert min(np.hypot(*(d - s * sweep.way.shift)) for d in found for s in (1, -1)) < 4


def settled_from(sweep, shift):
    skeleton, _, _ = seen(sweep, "wire")
    line = evenly(sweep.rings[0].line)
    return settled_wire(np.array(shift, float), line, cKDTree(skeleton.points), 6.0)


def test_a_shift_settles_on_the_image_of_the_outline():
    way = settled_from(ARCH, [87.0, -58.0])
    assert way.slope is None
    assert np.abs(way.shift - ARCH.way.shift).max() < 1.0


def test_a_shift_that_grows_over_the_face_is_in_perspective():
    origin = ARCH.rings[0].line.mean(axis=0)
    sweep = replace(ARCH, way=Way(ARCH.way.shift, slope=np.array([0.0, 8e-4]), origin=origin))
    way = settled_from(sweep, ARCH.way.shift)
    assert way.slope == pytest.approx([0.0, 8e-4], abs=3e-4)
    assert np.abs(way.of(sweep.rings[0].vertices) - sweep.way.of(sweep.rings[0].vertices)).max() < 1.5


def test_far_centres_are_one_where_they_lie_a_little_farther_apart():
    near, far = np.array([[50.0, 50], [53, 50], [60, 50]]), np.array([[5000.0, 50], [5080, 50], [5200, 50]])
    kept = distinct_centres(np.concatenate([near, far]), np.zeros(2), 300.0)
    assert kept.tolist() == [[50, 50], [60, 50], [5000, 50], [5200, 50]]
    assert distinct_centres(np.zeros((0, 2)), np.zeros(2), 300.0).shape == (0, 2)
