"""Lines of bodies as seen, on bodies whose lines are known."""

import numpy as np
import pytest

from synthetic.bodies import convex, cubes, drawn_lines, turned
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


@pytest.mark.parametrize(("top", "silhouettes"), [(0.5, 2), (0.3, 2), (0.0, 2)])
def test_a_round_body_has_two_outlines_and_its_rims(top, silhouettes):
    lines = drawn_lines(turned((0.5, top), 1.4, 64), VIEW)
    straight = [line for line in lines if len(line.path) == 2 and np.ptp(line.path[:, 1]) > 0.5]
    assert len(straight) == silhouettes
    curved = [line for line in lines if len(line.path) > 4]
    assert any(line.hidden for line in curved)
    # The rim above is seen whole, the one below in half.
    assert len(curved) == (2 if top == 0 else 3)
