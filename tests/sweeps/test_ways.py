"""Ways from an outline to its image."""

import numpy as np
import pytest
from round_sketches import ARCH, CONE, CYLINDER, drawn
from sketches import ink_of

from sketch2shape.search.sweep_pairs import evenly
from sketch2shape.strokes import thin, trace_skeleton
from sketch2shape.sweeps import Cells, Loop, centres, directions, distinct_directions, settled, shifts, ways_along


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


def test_the_shift_of_a_wireframe_lays_ink_on_ink():
    skeleton, size, strokes = seen(ARCH, "wire")
    found = shifts(skeleton, distinct_directions(directions(strokes, size)), size)
    off = [min(np.hypot(*(d - s * ARCH.way.shift)) for s in (1, -1)) for d in found]
    assert min(off) < 6
