"""Climbing by the energy from a hypothesis to cheaper ones around it."""

from dataclasses import replace

import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, SQUARE, ink_of, prism

from sketch2shape.evidence import judge
from sketch2shape.hypotheses import Rings
from sketch2shape.hypotheses.hypothesis import stack
from sketch2shape.ink import split_groups
from sketch2shape.search.attempts import Looks
from sketch2shape.search.climbing import (
    FOLDED,
    MOST_VERTICES,
    WOBBLES,
    _corners,
    _exchanged,
    _fold_back,
    _Ground,
    _is_possible,
    _least_gain,
    _likely,
    climb,
)
from sketch2shape.search.found import TIE, total
from sketch2shape.search.observed import observed
from sketch2shape.search.refining import compared_with
from sketch2shape.search.search import find

TALL = np.array([[60.0, 90], [200, 60], [330, 130], [205, 180]])
"""The upper face of a box whose near and far vertical edges lie close to each other."""
DOWN = np.array([0.0, 260])
CUT = np.array([[120.0, 140], [262, 140], [270, 148], [270, 290], [120, 290]])
"""A square with a corner cut off."""


def seen_in(picture):
    (group,) = split_groups(ink_of(picture))
    return observed(group)


def start_at(seen, front, back, picture):
    """A hypothesis as the search holds it, vertices given in pixels of the picture."""
    (group,) = split_groups(ink_of(picture))
    best = find(seen)
    rings = Rings((front - group.offset,), (back - group.offset,))
    evidence = replace(judge(rings, best.sheet), drawn=np.ones(len(front), bool))
    return compared_with(replace(best, rings=rings, evidence=evidence), seen.view)


def top_of(picture, front, back, **how):
    seen = seen_in(picture)
    start = start_at(seen, front, back, picture)
    steps = climb([start], Looks(seen.group, seen.skeleton), seen.view, 1, **how)
    (group,) = split_groups(ink_of(picture))
    return [step.shifted(group.offset) for step in steps]


def near(a, b):
    """Whether each vertex of one ring is one of the other's."""
    return len(a) == len(b) and all(np.hypot(*(b - p).T).min() < 1.5 for p in a)


def is_at(found, front, back):
    """Whether the faces are these, in any order and from any vertex on."""
    a, b = found.rings.front[0], found.rings.back[0]
    return (near(a, front) and near(b, back)) or (near(a, back) and near(b, front))


def moved(ring, k, by):
    other = ring.copy()
    other[k] += by
    return other


@pytest.mark.parametrize(
    ("front", "back"),
    [
        (moved(SQUARE, 1, [-40.0, 25]), moved(SQUARE + DEPTH, 1, [-40.0, 25])),
        (np.insert(SQUARE, 1, [190.0, 175], 0), np.insert(SQUARE + DEPTH, 1, [280.0, 115], 0)),
    ],
    ids=["elsewhere", "one too many"],
)
def test_the_box_is_reached_from_a_hypothesis_with_one_vertex_wrong(front, back):
    steps = top_of(prism(SQUARE, SQUARE + DEPTH), front, back)
    assert is_at(steps[-1], SQUARE, SQUARE + DEPTH)
    assert [total(s) for s in steps] == sorted((total(s) for s in steps), reverse=True)


def test_a_small_cut_that_no_tolerant_score_tells_is_found():
    steps = top_of(prism(CUT, CUT + DEPTH), SQUARE, SQUARE + DEPTH)
    assert is_at(steps[-1], CUT, CUT + DEPTH)
    assert top_of(prism(CUT, CUT + DEPTH), CUT, CUT + DEPTH) == []


def test_vertices_taken_for_each_other_are_exchanged_back():
    rings = Rings((TALL,), (TALL + DOWN,))
    apart = np.hypot(*(TALL[1] - TALL[3]))
    assert [len(s) for s in _exchanged(rings, apart + 1)] == [2]
    assert list(_exchanged(rings, apart - 1)) == []
    close = TALL.copy()
    close[3] = close[1] + [6.0, 30]
    picture = prism(close, close + DOWN)
    front, back = close.copy(), close + DOWN
    back[[1, 3]] = back[[3, 1]]
    steps = top_of(picture, front, back, closely=True)
    assert is_at(steps[-1], close, close + DOWN)


def test_a_flat_vertex_that_the_hand_made_is_left_out_of_a_trusted_answer_and_a_corner_is_not():
    bend = SQUARE[0] + 0.5 * (SQUARE[1] - SQUARE[0]) + [0.0, -1.5]
    picture = prism(SQUARE, SQUARE + DEPTH)
    front = np.insert(SQUARE, 1, bend, 0)
    steps = top_of(picture, front, front + DEPTH, closely=True)
    assert is_at(steps[-1], SQUARE, SQUARE + DEPTH)
    assert top_of(picture, SQUARE, SQUARE + DEPTH, closely=True) == []
    cut = moved(CUT, 2, [0.0, 6.0])  # so blunt a corner is no bend
    assert top_of(prism(cut, cut + DEPTH), cut, cut + DEPTH, closely=True) == []


def test_faces_with_holes_and_of_very_many_vertices_stay_as_they_are():
    picture = prism(SQUARE, SQUARE + DEPTH)
    seen = seen_in(picture)
    looks = Looks(seen.group, seen.skeleton)
    start = start_at(seen, np.delete(SQUARE, 1, 0), np.delete(SQUARE + DEPTH, 1, 0), picture)
    assert climb([start], looks, seen.view, 1)
    hole = 0.5 * SQUARE + 0.5 * SQUARE.mean(axis=0)
    holed = replace(start, rings=Rings((start.rings.front[0], hole), (start.rings.back[0], hole + DEPTH)))
    assert climb([holed], looks, seen.view, 1) == []
    angle = np.linspace(0, 2 * np.pi, MOST_VERTICES + 1, endpoint=False)
    many = 80 * np.column_stack([np.cos(angle), np.sin(angle)]) + 200
    drawn = np.ones(len(many), bool)
    round_ = replace(start, rings=Rings((many,), (many + DEPTH,)), evidence=replace(start.evidence, drawn=drawn))
    assert climb([compared_with(round_, seen.view)], looks, seen.view, 1) == []
    assert climb([], looks, seen.view, 1) == []


def test_an_added_edge_is_longer_than_a_wobble_and_a_vertex_has_to_save_its_price_again():
    picture = prism(SQUARE, SQUARE + DEPTH)
    seen = seen_in(picture)
    best = find(seen)
    looks = Looks(seen.group, seen.skeleton)
    ground = _Ground(seen.view, looks.rounds[0].traced, np.zeros((0, 2)), 1.0, True)
    noise = 3.0
    top = replace(best, energy=best.energy._replace(noise=noise))

    short = np.insert(SQUARE, 1, SQUARE[0] + [WOBBLES * noise - 2, 5], 0)
    long = np.insert(SQUARE, 1, SQUARE[0] + [WOBBLES * noise + 2, 5], 0)
    few = [stack([Rings((r,), (r + DEPTH,))]) for r in (short, long)]
    assert [bool(_is_possible(moves, top, ground)[0]) for moves in few] == [False, True]
    more = replace(best, rings=Rings((long,), (long + DEPTH,)))
    assert _least_gain(best, more) == best.energy.vertex
    assert _least_gain(best, best) == TIE


@pytest.mark.parametrize("steady", [True, False])
def test_where_lines_are_not_straight_a_vertex_has_to_be_seen_in_the_score(steady):
    picture = prism(CUT, CUT + DEPTH)
    seen = seen_in(picture)
    start = start_at(seen, SQUARE, SQUARE + DEPTH, picture)
    looks = Looks(seen.group, seen.skeleton)
    # a reach that takes the cut for the corner
    tolerant = replace(start.sheet, reach=10.0)
    top = replace(start, sheet=tolerant, evidence=judge(start.rings, tolerant), energy=start.compared.energy(1.0))
    ground = _Ground(seen.view, looks.rounds[0].traced, _corners(looks, seen.view), 1.0, steady)
    assert (5 in {rings.sizes[0] for rings, _ in _likely(top, ground)}) == steady


def test_an_edge_that_turns_back_on_the_one_before_it_is_told():
    spike = np.insert(SQUARE, 2, SQUARE[1] + [40, 0], 0)
    spike[1], spike[2] = spike[2].copy(), spike[1].copy()
    wide = moved(spike, 1, [0.0, 3 * FOLDED])
    faces = np.stack([np.concatenate([r, r + DEPTH]) for r in (spike, wide)])
    assert _fold_back(faces).tolist() == [True, False]
    assert not _fold_back(np.concatenate([HEXAGON, HEXAGON + DEPTH])[None])[0]


def test_what_is_best_already_stays():
    picture = prism(SQUARE, SQUARE + DEPTH)
    assert top_of(picture, SQUARE, SQUARE + DEPTH) == []
