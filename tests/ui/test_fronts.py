"""The front of a box is the side that stands in front."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sketch2shape.lifting import OTHER_PAIRS, lift
from sketch2shape.model import Answer, Ints, Picture, TwoFaceObject
from sketch2shape.ui.fronts import faced

FRONT = np.array([(100, 200), (300, 200), (300, 380), (100, 380.0)])
BACK = FRONT + (120, -90)
POINTS = np.concatenate([FRONT, BACK])
SHEET = Picture(np.full((9, 9, 3), 255, np.uint8))


def answer(obj: TwoFaceObject) -> Answer:
    return Answer((obj,), (lift(obj),), SHEET)


@pytest.mark.parametrize("order", [np.arange(8), *OTHER_PAIRS])
def test_whatever_sides_were_found_the_square_one_is_the_front(order: Ints) -> None:
    before = answer(TwoFaceObject(POINTS[order[:4]], POINTS[order[4:]]))
    after = faced(before)
    assert {tuple(p) for p in after.objects[0].f1.tolist()} == {tuple(p) for p in FRONT.tolist()}
    assert after.solids[0].dimensions == pytest.approx(before.solids[0].dimensions, rel=0.01)
    assert after.solids[0].dimensions[:2] == pytest.approx((200, 180), rel=0.02)


def test_a_side_that_was_inferred_is_not_called_the_front() -> None:
    order = OTHER_PAIRS[1]
    drawn = np.isin(order[4:], [4, 5, 6, 7])
    found = TwoFaceObject(POINTS[order[:4]], POINTS[order[4:]], f2_drawn=drawn)
    assert faced(answer(found)).objects[0] is found


def test_what_is_no_box_stays() -> None:
    house = np.array([(60, 320), (60, 110), (185, 0), (310, 110), (310, 320.0)])
    found = answer(TwoFaceObject(house, house + (90, -40)))
    assert faced(found).objects[0] is found.objects[0]


def test_how_sure_it_is_stays() -> None:
    order = OTHER_PAIRS[0]
    before = answer(TwoFaceObject(POINTS[order[:4]], POINTS[order[4:]]))
    sure = replace(before, solids=(replace(before.solids[0], confidence=0.61),))
    assert faced(sure).solids[0].confidence == 0.61
