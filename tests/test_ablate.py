"""The script that switches mechanisms off: each is where the table says, and the table counts what each earns."""

import pkgutil
from dataclasses import replace

import pytest
from loaded import loaded

from evaluation.cases import Case, case_of
from evaluation.outcome import Outcome
from sketch2shape.search import sweeping
from synthetic.drawing import draw

ablate = loaded("ablate")


@pytest.mark.parametrize("dotted", sorted({d for m in ablate.MECHANISMS for d in m.off}))
def test_what_is_switched_off_is_there_and_differs(dotted):
    place, name = dotted.rsplit(".", 1)
    now = getattr(pkgutil.resolve_name(place), name)
    for mechanism in ablate.MECHANISMS:
        if dotted in mechanism.off:
            instead = mechanism.off[dotted]
            assert callable(instead) == callable(now)
            assert instead is not now
            assert callable(now) or instead != now


def test_mechanisms_have_names_of_their_own_and_lie_in_the_heart():
    names = [m.name for m in ablate.MECHANISMS]
    assert len(set(names)) == len(names)
    assert {m.room for m in ablate.MECHANISMS if m.off} == {"search", "evidence", "hypotheses", "fit", "sweeps"}


def test_a_mechanism_is_off_for_a_while_only():
    before = sweeping.SIDE
    (one,) = [m for m in ablate.MECHANISMS if m.name == "sides of a base cost"]
    with ablate.switched_off(one):
        assert sweeping.SIDE == 0.0
    assert before == sweeping.SIDE > 0


def test_a_drawing_is_measured_without_its_source_and_once_for_those_that_are_not_asked(tmp_path):
    case = case_of(draw("cylinder_wire", 3, 0).save(tmp_path))
    whole, without, unasked = ablate.compared(case, ["sweeps", "sweeps: pyramids"])
    assert whole.right
    assert not without.right
    assert unasked is whole
    assert min(whole.ms, without.ms) > 0


def outcome(right, confidence=None, ms=100.0):
    answers = () if confidence is None else ({"confidence": confidence},)
    return Outcome(Case("drawings", "some/0", "", {}), answers=answers, right=right, ms=ms)


def test_an_effect_counts_what_is_so_with_the_mechanism_alone():
    right, wrong, sure = outcome(True, 0.95), outcome(False, 0.3), outcome(False, 0.95)
    on = [right, right, right, wrong, wrong, sure]
    off = [right, wrong, sure, right, sure, right]
    effect = ablate.Effect.of(on, [replace(o, ms=200.0) for o in off])
    assert effect == (2, 2, 2, 1, 0.5)
    assert effect.cells == ["+2 -2", "+1 -2", "0.50"]
    assert effect.is_earning
    assert not ablate.Effect(0, 1, 0, 1, 1.2).is_earning


def test_what_earns_nothing_on_any_set_is_named():
    idle, busy = ablate.Effect(0, 2, 0, 0, 1.1), ablate.Effect(1, 0, 0, 0, 1.1)
    effects = {"wireframes": {"hard": busy, "real": idle}, "sweeps": {"hard": idle, "real": idle}}
    assert ablate.idle(effects) == "Earn nothing on these drawings: sweeps.\n"
    head, _, first, second = ablate.effect_table(effects).splitlines()
    assert head == "| mechanism | room | hard | sure errors | time | real | sure errors | time |"
    assert first == "| wireframes | search | +1 |  | 1.10 | -2 |  | 1.10 |"
    assert second.startswith("| sweeps | search |")
