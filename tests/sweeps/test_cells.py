"""What outlines and ways explain at a glance."""

import numpy as np
from round_sketches import CONE, CYLINDER, TUBE, drawn
from sketches import ink_of

from sketch2shape.search.sweep_pairs import evenly
from sketch2shape.strokes import thin
from sketch2shape.sweeps import Cells, Loop, Way


def cells_of(sweep, lines):
    skeleton = thin(ink_of(drawn(sweep, lines)))
    size = float(np.hypot(*np.ptp(skeleton.points, axis=0)))
    return Cells.of(skeleton, size, np.ones(skeleton.mask.shape, bool))


def test_the_true_way_explains_nearly_all():
    assert cells_of(CYLINDER, "removed").value(Loop(evenly(CYLINDER.rings[0].line)), CYLINDER.way) > 0.9


def test_a_way_to_nothing_explains_less():
    cells, loop = cells_of(CYLINDER, "removed"), Loop(evenly(CYLINDER.rings[0].line))
    assert cells.value(loop, Way(np.array([120.0, 60]))) < 0.5 * cells.value(loop, CYLINDER.way)


def test_a_cone_explains_its_sides():
    cells, loop = cells_of(CONE, "removed"), Loop(evenly(CONE.rings[0].line))
    assert cells.value(loop, CONE.way, is_near=CONE.is_near) > 0.9
    assert cells.value(loop, Way(np.zeros(2), CONE.way.centre + [90, 0], 0.0), is_near=CONE.is_near) < 0.7


def test_lines_that_have_ink_explain_more_than_they_lack():
    cells = cells_of(CYLINDER, "removed")
    sides = CYLINDER.rings[0].line[[CYLINDER.rings[0].line[:, 0].argmin(), CYLINDER.rings[0].line[:, 0].argmax()]]
    drawn_lines = np.stack([sides, sides + CYLINDER.way.shift], axis=1)
    assert cells.value_of_lines(drawn_lines) > 0.15
    assert cells.value_of_lines(drawn_lines + [300.0, 0]) < 0


def test_a_wireframe_is_explained_with_its_holes():
    cells = cells_of(TUBE, "wire")
    outer, inner = (Loop(evenly(ring.line)) for ring in TUBE.rings)
    assert cells.value_of_wire((outer, inner), TUBE.way) > 0.9
    assert cells.value_of_wire((outer,), TUBE.way) < 0.8
