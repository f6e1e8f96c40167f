"""How much of an object is seen behind its front face."""

import numpy as np
import pytest
from sketches import DEPTH, SQUARE, ink_of, prism

from sketch2shape.evidence import compare, observe, shown_behind, shows_little
from sketch2shape.hypotheses import Rings
from sketch2shape.ink import split_groups
from sketch2shape.strokes import thin


def held_against(rings, picture):
    (group,) = split_groups(ink_of(picture))
    own = rings.shifted(-group.offset)
    return own, compare(own, observe(group, thin(group.ink)), np.ones(4, bool), 4.0)


BOX = Rings((SQUARE,), (SQUARE + DEPTH,))


def test_of_a_box_two_edges_and_three_sides_are_seen_behind_a_face():
    seen = shown_behind(*held_against(BOX, prism(SQUARE, SQUARE + DEPTH, "removed")))
    assert seen == pytest.approx((2 * 150 + 3 * np.hypot(*DEPTH)) / 600, rel=0.05)
    assert not shows_little(*held_against(BOX, prism(SQUARE, SQUARE + DEPTH, "removed")))


@pytest.mark.parametrize("back", [SQUARE + [2.0, -1.5], (SQUARE - 195.0) * 0.5 + 195.0], ids=["along it", "inside it"])
def test_a_face_along_the_front_or_behind_it_is_not_seen(back):
    flat = held_against(Rings((SQUARE,), (back,)), prism(SQUARE, SQUARE + DEPTH, "removed"))
    assert shown_behind(*flat) < 0.05
    assert shows_little(*flat)
