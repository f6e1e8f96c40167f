"""Solids are called what a person would call them."""

import numpy as np
import pytest

from sketch2shape.model import Projection, Solid, two_face_boundary
from sketch2shape.solids import shape_name
from tests.solids.round_bodies import ROUND, SQUARE, solid

FACE = np.array([[100, 100], [300, 100], [300, 250], [100, 250.0]])


@pytest.mark.parametrize(
    ("lean", "taper", "name"),
    [(0, 1, "box"), (0.5, 1, "prism with 4 sides"), (0, 0.5, "tapered object with 4 sides")],
)
def test_a_box_is_square_and_straight(lean, taper, name):
    front = np.c_[FACE, np.zeros(4)]
    back = np.c_[FACE * taper + [lean * 100, 0], np.full(4, 100.0)]
    boundary = two_face_boundary(np.concatenate([front, back]), (4,))
    assert shape_name(Solid(boundary, Projection("oblique"))) == name


@pytest.mark.parametrize(
    ("n", "name"),
    [(3, "triangular prism"), (6, "hexagonal prism"), (8, "octagonal prism"), (11, "prism with 11 sides")],
)
def test_many_sided_prisms_are_called_by_their_sides(n, name):
    turn = 2 * np.pi * np.arange(n) / n
    ring = np.c_[np.cos(turn), np.sin(turn)]
    assert shape_name(solid(ring, [n], [])) == name


def test_an_l_is_no_hexagonal_prism():
    ring = np.array([[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2.0]])
    assert shape_name(solid(ring, [6], [])) == "prism with 6 sides"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("cylinder", "cylinder"),
        ("tube", "cylinder with a round hole"),  # beside its axis
        ("cone", "cone"),
        ("truncated cone", "truncated cone"),
        ("half cylinder", "half cylinder"),
        ("half cone", "half cone"),
        ("plate with two holes", "plate with 2 round holes"),
        ("groove", "arched prism"),
        ("slot", "slot prism"),
    ],
)
def test_round_solids(name, words):
    assert shape_name(ROUND[name][0]) == words


def test_an_arc_in_two_pieces_is_one():
    half = solid([[2, 0], [0, 2], [-2, 0]], [3], [(0, 0, 0, 0, 2, 1), (0, 1, 0, 0, 2, 1)])
    assert shape_name(half) == "half cylinder"


@pytest.mark.parametrize(
    ("base", "name"),
    [
        (SQUARE, "square pyramid"),
        (SQUARE * [1, 0.5], "rectangular pyramid"),
        (SQUARE[:3], "triangular pyramid"),
        (np.vstack([SQUARE, [[-5, 0]]]), "pentagonal pyramid"),
    ],
)
def test_pyramids(base, name):
    assert shape_name(solid(base, [len(base)], [], apex=[0, 0, 5])) == name
