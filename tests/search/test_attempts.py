"""What each round makes of a drawing, and in which order rounds are asked."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from sketches import DEPTH, L_SHAPE, SQUARE, ink_of, prism
from solid_lines import prism_lines

from sketch2shape.ink import find_ink
from sketch2shape.ink.groups import split_groups
from sketch2shape.model import VectorLine
from sketch2shape.reading.sheet import picture_of
from sketch2shape.search import tolerances
from sketch2shape.search.attempts import (
    GOOD,
    SEE_THROUGH,
    Looks,
    _early,
    _likely_first,
    attempts,
    second_attempts,
)
from sketch2shape.strokes.skeleton import thin


def attempts_at(picture):
    group = split_groups(ink_of(picture))[0]
    return attempts(Looks(group, thin(group.ink)))


@pytest.mark.parametrize("face", [SQUARE, L_SHAPE], ids=["box", "L"])
def test_the_first_round_explains_a_ruled_wireframe(face):
    first = next(attempts_at(prism(face, face + DEPTH)))
    assert first.number == 0
    assert first.score >= GOOD
    assert first.is_sound
    assert first.shortlist[0][1].lines == "wire"
    assert first.best.sizes == (len(face),)


def test_a_drawing_that_can_be_seen_through_is_taken_for_a_wireframe_before_anything_else():
    """Until the rounds that look for wireframes have been asked, no shortlist holds faces with a hidden back."""
    early = [a for a, _ in zip(attempts_at(prism(SQUARE, SQUARE + DEPTH)), range(3), strict=False)]
    assert [a.number for a in early] == [0, 1, 2]
    assert all(evidence.lines == "wire" for a in early for _, evidence in a.shortlist)


def test_no_wireframe_is_looked_for_first_where_edges_are_dashed():
    group = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))[0]
    dashed = replace(group, solid=group.solid & (np.arange(group.solid.shape[1]) > 0.4 * group.solid.shape[1]))
    for drawn, early in ((group, 4), (dashed, 0)):
        assert len(_early([*_crossed(Looks(drawn, thin(drawn.ink)).rounds)])) == early


def _crossed(looks):
    """The same, told that their strokes cross."""
    for look in looks:
        look.__dict__["crossed"] = SEE_THROUGH
    return looks


def test_a_drawing_without_crossing_strokes_is_asked_round_by_round():
    numbers = [a.number for a in attempts_at(prism(SQUARE, SQUARE + DEPTH, "removed"))]
    assert len(numbers) > 1
    assert numbers == sorted(set(numbers))  # none comes back, as it would after a first look for wireframes
    first = next(attempts_at(prism(SQUARE, SQUARE + DEPTH, "removed")))
    assert first.shortlist[0][1].lines == "removed"


def test_of_a_wavy_hand_whose_lines_are_known_coarser_rounds_come_first():
    t = np.linspace(0, 1, 60)[:, None]

    def numbers(amplitude):
        lines = []
        for line in prism_lines(SQUARE, SQUARE + DEPTH):
            a, b = line.points
            side = np.array([a[1] - b[1], b[0] - a[0]]) / np.linalg.norm(b - a)
            lines.append(VectorLine(a + t * (b - a) + amplitude * np.sin(9 * t) * side))
        (group,) = split_groups(find_ink(picture_of(lines)))
        looks = Looks(group, thin(group.ink)).rounds
        return [look.number for look in looks], [look.number for look in _likely_first(looks)]

    ruled, in_order = numbers(0.0)
    assert in_order == ruled
    wavy, in_order = numbers(1.3)
    assert in_order[0] == 3
    assert sorted(in_order) == wavy
    assert in_order[-1] == wavy[-1]


def test_a_second_look_traces_nothing_anew(monkeypatch):
    """Strokes, regions and corner graphs are worked out once for all passes over a drawing."""
    group = split_groups(ink_of(prism(L_SHAPE, L_SHAPE + DEPTH, "removed")))[0]
    looks, calls = Looks(group, thin(group.ink)), []
    list(attempts(looks))
    trace, regions = tolerances.trace_skeleton, tolerances.enclosed_regions
    monkeypatch.setattr(tolerances, "trace_skeleton", lambda *how: calls.append(how) or trace(*how))
    monkeypatch.setattr(tolerances, "enclosed_regions", lambda *how: calls.append(how) or regions(*how))
    assert list(second_attempts(looks))
    assert calls == []
    assert list(second_attempts(Looks(group, thin(group.ink))))
    assert calls


def test_strokes_of_a_hand_that_trembles_are_counted_coarsely():
    def look(number, strokes, *, steady):
        traced = SimpleNamespace(strokes=SimpleNamespace(ends=[0] * strokes))
        return SimpleNamespace(number=number, is_steady=steady, traced=traced)

    def counted(*looks):
        return Looks.strokes.func(SimpleNamespace(rounds=looks, close=look(6, 90, steady=True)))

    assert counted(look(0, 70, steady=True), look(3, 12, steady=True)) == 70
    assert counted(look(1, 70, steady=False), look(2, 70, steady=False), look(3, 12, steady=False)) == 12
    assert counted(look(1, 70, steady=False)) == 70
    assert counted() == 90
