"""Lines of bodies as seen, on bodies whose lines are known."""

import numpy as np
import pytest

from synthetic.bodies import convex, cubes, drawn_lines, stacked
from synthetic.profiles import regular
from synthetic.projecting import axonometric

VIEW = axonometric("trimetric", np.radians(35), np.radians(25))
BOX = np.array([[x, y, z] for x in (0, 1.2) for y in (0, 0.8) for z in (0, 1.0)])


def counted(lines):
    return sum(not line.hidden for line in lines), sum(line.hidden for line in lines)


def test_a_box_shows_nine_edges_and_hides_three():
    assert counted(drawn_lines(convex(BOX), VIEW)) == (9, 3)


def test_a_box_of_two_cubes_is_a_box():
    assert counted(drawn_lines(cubes({(0, 0, 0), (1, 0, 0)}, ruled=False), VIEW))[1] >= 3
    seen = [line.path for line in drawn_lines(cubes({(0, 0, 0), (1, 0, 0)}, ruled=False), VIEW) if not line.hidden]
    assert len(seen) == 9
    ruled = drawn_lines(cubes({(0, 0, 0), (1, 0, 0)}, ruled=True), VIEW)
    assert counted(ruled)[0] > 9


def test_a_cube_before_another_hides_a_part_of_it():
    alone = drawn_lines(cubes({(0, 0, 0)}, ruled=True), VIEW)
    both = drawn_lines(cubes({(0, 0, 0), (0, 0, 3)}, ruled=True), axonometric("trimetric", 0.1, 0.1))
    seen, hidden = (sum(np.linalg.norm(x.path[1] - x.path[0]) for x in both if x.hidden == k) for k in (False, True))
    assert counted(alone) == (9, 3)
    assert hidden > seen / 3


CIRCLE, SQUARE = 0.5 * regular(64), 0.5 * regular(4, np.pi / 4)


@pytest.mark.parametrize("ring", [CIRCLE, CIRCLE[::-1]])
def test_a_round_slab_has_two_outlines_and_its_rims(ring):
    lines = drawn_lines(stacked([(ring, 1.4)], [True]), VIEW)
    straight = [line for line in lines if len(line.path) == 2 and np.ptp(line.path[:, 1]) > 0.5]
    assert len(straight) == 2
    curved = [line for line in lines if len(line.path) > 4]
    # The rim above is seen whole, the one below in half.
    assert sorted(line.hidden for line in curved) == [False, False, True]


def test_a_wireframe_has_its_rims_in_one_pull():
    lines = drawn_lines(stacked([(CIRCLE, 1.4)], [True]), VIEW, wire=True)
    assert sorted(len(line.path) for line in lines) == [2, 2, 65, 65]
    assert not any(line.hidden for line in lines)


def test_a_slab_is_the_hull_of_its_corners():
    slab = stacked([(SQUARE, 0.7)], [False])
    assert counted(drawn_lines(slab, VIEW)) == counted(drawn_lines(convex(slab.vertices), VIEW)) == (9, 3)


@pytest.mark.parametrize("smaller_first", [True, False])
def test_slabs_of_a_stack_meet_in_a_ring_and_hide_each_other(smaller_first):
    parts = (0.4, 1.0) if smaller_first else (1.0, 0.4)
    stack = stacked([(part * SQUARE, 0.5) for part in parts], [False, False])
    assert len(stack.faces) == 11
    assert [len(rings) for rings in stack.faces].count(2) == 1
    seen, hidden = counted(drawn_lines(stack, VIEW))
    assert seen >= 14
    assert hidden >= 6
