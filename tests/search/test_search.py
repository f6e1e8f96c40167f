"""From the ink to the best verified hypothesis, drawing by drawing."""

from dataclasses import replace
from importlib import import_module
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from sketches import DEPTH, HEXAGON, L_SHAPE, SQUARE, ink_of, outline, paper, prism, same_object, shrunk

from sketch2shape.evidence import REFUSE_BELOW
from sketch2shape.geometry.homology import apply
from sketch2shape.hypotheses import Rings
from sketch2shape.hypotheses.hypothesis import split
from sketch2shape.ink import split_groups
from sketch2shape.model import TRUSTED
from sketch2shape.search import FoundSweep, as_object, find_all, sweep_as_object
from sketch2shape.search.found import TIE
from sketch2shape.search.observed import observed
from sketch2shape.search.search import (
    LAID,
    LOG_ODDS,
    WITNESSED,
    _against,
    _doubted,
    _gap,
    _likelier,
    _likeliest,
    _search,
    _told,
    find,
)

search = import_module("sketch2shape.search.search")
TAPERED = shrunk(SQUARE, 0.6, np.array([440.0, 40]))
TWO_POINT = apply(np.eye(3) + np.outer([900.0, -200, 1], [-2e-4, 2e-4, 0.12]), SQUARE)
PLUS = np.array(
    [[2, 1], [3, 1], [3, 2], [4, 2], [4, 3], [3, 3], [3, 4], [2, 4], [2, 3], [1, 3], [1, 2], [2, 2.0]]
) * 60 + [40, 60]  # fmt: skip
COMB = np.array(
    [[0, 0], [1, 0], [1, 2], [2, 2], [2, 0], [3, 0], [3, 2], [4, 2], [4, 0], [5, 0], [5, 3], [0, 3.0]]
) * 55 + [60, 150]  # fmt: skip


def found_in(picture):
    ink = ink_of(picture)
    return [
        sweep_as_object(f, ink) if isinstance(f, FoundSweep) else as_object(f.rings, f.evidence, ink)
        for f in find_all(ink)
    ]


@pytest.mark.parametrize(
    ("f1", "f2"),
    [
        (SQUARE, SQUARE + DEPTH),
        (L_SHAPE, L_SHAPE + DEPTH),
        (HEXAGON, HEXAGON + [110, -20]),
        (SQUARE[:3], SQUARE[:3] + DEPTH),
        (SQUARE, TAPERED),
        (SQUARE, TWO_POINT),
        (PLUS, PLUS + [45, -28]),
        (COMB, COMB + [70, -45]),
    ],
    ids=["box", "L", "hexagon", "wedge", "frustum", "perspective", "plus", "comb"],
)
def test_wireframes(f1, f2):
    found = found_in(prism(f1, f2))
    assert len(found) == 1
    assert found[0].confidence > 0.95
    assert found[0].lines == "wire"
    assert same_object(found[0], f1, f2)


@pytest.mark.parametrize("lines", ["dashed", "removed"])
@pytest.mark.parametrize(
    ("f1", "f2"),
    [(SQUARE, SQUARE + DEPTH), (HEXAGON, HEXAGON + [110, -20]), (SQUARE, TAPERED)],
    ids=["box", "hexagon", "frustum"],
)
def test_hidden_edges_dashed_or_left_out(f1, f2, lines):
    found = found_in(prism(f1, f2, lines))
    assert len(found) == 1
    assert found[0].confidence > 0.9
    assert same_object(found[0], f1, f2, 3.0)
    if lines == "removed":
        assert not found[0].f2_drawn.all()


def test_a_vertex_on_another_edge_and_edges_along_each_other():
    # the back's lower left corner lies on the front's top edge, and its left side runs on from a connecting edge
    lower = SQUARE + [0, 60]
    on_edge = lower + [75, -150]
    assert same_object(found_in(prism(lower, on_edge))[0], lower, on_edge)
    upright = L_SHAPE + [0, -50]
    upright[:, 0] += 40
    assert same_object(found_in(prism(L_SHAPE, upright))[0], L_SHAPE, upright)


def test_a_true_isometric_cube_has_two_vertices_in_one_place():
    turn = np.arange(6) * np.pi / 3
    ring = np.array([240.0, 200]) + 130 * np.c_[np.sin(turn), -np.cos(turn)]
    middle = np.array([240.0, 200])
    f1, f2 = np.array([ring[5], middle, ring[3], ring[4]]), np.array([ring[0], ring[1], ring[2], middle])
    found = found_in(prism(f1, f2))
    assert len(found) == 1
    assert same_object(found[0], f1, f2)


def test_a_plate_with_a_hole():
    hole = SQUARE.mean(axis=0) + 0.4 * (SQUARE - SQUARE.mean(axis=0))
    picture = prism(hole, hole + DEPTH, picture=prism(SQUARE, SQUARE + DEPTH))
    found = found_in(picture)
    assert len(found) == 1
    assert len(found[0].holes) == 1
    pairs = [(found[0].f1, SQUARE), (found[0].holes[0].f1, hole)]
    for ring, true in pairs:
        gap = np.linalg.norm(ring[:, None] - np.r_[true, true + DEPTH][None], axis=2)
        assert gap.min(axis=1).max() < 2


def test_two_objects_on_a_sheet():
    picture = paper(420, 960)
    other = HEXAGON + [450, 30]
    prism(SQUARE, SQUARE + DEPTH, picture=picture)
    prism(other, other + [80, -40], picture=picture)
    found = sorted(found_in(picture), key=lambda o: o.f1[:, 0].mean())
    assert len(found) == 2
    assert same_object(found[0], SQUARE, SQUARE + DEPTH)
    assert same_object(found[1], other, other + [80, -40])


def test_the_pen_and_the_size_of_the_drawing_do_not_matter():
    for factor, width in ((0.35, 1), (1.0, 6), (2.4, 5)):
        f1, f2 = SQUARE * factor, (SQUARE + DEPTH) * factor
        picture = prism(f1, f2, width=width, picture=paper(int(400 * factor) + 20, int(480 * factor) + 20))
        assert same_object(found_in(picture)[0], f1, f2, 1.5 + 0.3 * width)


@pytest.mark.parametrize(
    "picture",
    [paper(), outline(L_SHAPE), outline(HEXAGON - [80, 0], picture=outline(SQUARE[:3] + [170, 60]))],
    ids=["blank", "a lone polygon", "two unrelated polygons"],
)
def test_what_is_no_object_gets_no_confidence(picture):
    assert all(o.confidence < 0.5 for o in found_in(picture))


@pytest.mark.parametrize(("dense", "score", "looks"), [(True, 0.0, 1), (False, 0.0, 3), (True, 0.5, 3)])
def test_a_scribble_is_not_looked_at_again(monkeypatch, dense, score, looks):
    monkeypatch.setattr("sketch2shape.search.search._refined_of", lambda *_: [])
    tries = [SimpleNamespace(number=n, score=score, is_whole=True) for n in (1, 2, 3)]
    taken, found = [], []
    _search((taken.append(t) or t for t in tries), None, found, is_dense=dense)
    assert found == []
    assert len(taken) == looks


@pytest.mark.parametrize(("good", "refined"), [(0.99, [2]), (0.0, [2, 1])], ids=["explained", "not explained"])
def test_what_explains_little_is_refined_last_and_only_where_nothing_explains_more(monkeypatch, good, refined):
    done = []
    monkeypatch.setattr(search, "_refined_of", lambda attempt, *_: done.append(attempt.number) or [])
    monkeypatch.setattr(search, "best_of", lambda _: "best" if good and 2 in done else None)
    monkeypatch.setattr(search, "_leaves_nothing", lambda _: True)
    monkeypatch.setattr(search, "_is_scribble", lambda _: False)
    _search([SimpleNamespace(number=n, score=score, is_whole=True) for n, score in ((1, 0.4), (2, good))], None, [])
    assert done == refined


def _priced_at(nats, confidence):
    return SimpleNamespace(energy=SimpleNamespace(total=nats), confidence=confidence)


def test_what_witnesses_speak_for_may_cost_a_little_more_and_no_tie_is_broken(monkeypatch):
    monkeypatch.setattr(search, "priced", lambda found: found)
    monkeypatch.setattr(search, "_told", lambda found: found)
    best = _priced_at(100.0, 0.2)
    # log odds of 1.4 for it and 1.4 against the best one are worth 28 nats
    likely, dear, alike = _priced_at(120.0, 0.8), _priced_at(126.0, 0.8), _priced_at(100.0, 0.25)
    assert _likeliest(best, [best, likely]) is likely
    assert _likeliest(best, [dear, best]) is best
    assert _likeliest(best, [alike, best]) is best
    # however sure, nothing is worth more than so much
    sure, hopeless = _priced_at(100.0 + 2 * WITNESSED * LOG_ODDS - TIE, 1.0), _priced_at(100.0, 0.0)
    assert _doubted(sure) < _doubted(hopeless)
    assert _likeliest(hopeless, [hopeless, sure]) is hopeless


def _counted(monkeypatch, name):
    """The arguments of each call of a function of the search, from now on."""
    calls, function = [], getattr(search, name)

    def counting(*args):
        calls.append(args)
        return function(*args)

    monkeypatch.setattr(search, name, counting)
    return calls


def test_of_a_plain_wireframe_one_hypothesis_is_moved_to_the_ink(monkeypatch):
    refined = _counted(monkeypatch, "refined")
    assert same_object(found_in(prism(HEXAGON, HEXAGON + [110, -20]))[0], HEXAGON, HEXAGON + [110, -20])
    assert len(refined) == 1


@pytest.mark.parametrize(("strokes", "looks"), [(0, 0), (3, 1)])
def test_only_an_answer_that_leaves_ink_and_is_not_trusted_gets_a_second_look(monkeypatch, strokes, looks):
    monkeypatch.setattr(search, "TRUSTED", 1.0)
    again = _counted(monkeypatch, "second_attempts")
    picture = prism(SQUARE, SQUARE + DEPTH)
    x, y = SQUARE.mean(axis=0).astype(int).tolist()
    for k in range(strokes):
        cv2.line(picture, (x - 40, y - 20 + 20 * k), (x + 40, y - 10 + 15 * k), 0, 2)
    assert found_in(picture)
    assert len(again) == looks
    monkeypatch.setattr(search, "TRUSTED", 0.0)
    again.clear()
    assert found_in(picture)
    assert not again


@pytest.mark.parametrize(("most", "is_none", "looks"), [(0, True, 0), (0, False, 1), (1000, True, 1)])
@pytest.mark.parametrize("dear", [True, False])
def test_a_tangle_that_the_first_look_cannot_explain_is_not_looked_at_again(monkeypatch, most, is_none, looks, dear):
    monkeypatch.setattr(search, "TANGLE", most)
    monkeypatch.setattr(search, "_is_dear", lambda _: dear)
    monkeypatch.setattr(search, "_leaves_nothing", lambda _: False)
    monkeypatch.setattr(search, "_told", lambda best: best and replace(best, confidence=0.1, is_none=is_none))
    again = _counted(monkeypatch, "second_attempts")
    found_in(prism(SQUARE, SQUARE + DEPTH))
    assert len(again) == (looks if dear else 1)


def test_what_a_climb_finds_where_nothing_was_has_to_be_likelier_right(monkeypatch):
    monkeypatch.setattr(search, "_likeliest", lambda best, _: best)
    none, some = _priced_at(100.0, 0.1), _priced_at(100.0, 0.3)
    low, even = _priced_at(90.0, 0.49), _priced_at(90.0, 0.5)
    assert _likelier(none, low, []) is none
    assert _likelier(None, low, []) is None
    assert _likelier(none, even, []) is even
    assert _likelier(some, low, []) is low
    assert _likelier(some, None, []) is some


def _found(rings, nats, drawn=(True,) * 4):
    energy = SimpleNamespace(total=nats, noise=0.5)
    view = SimpleNamespace(size=300.0, pen=2.0, all_foreign=400.0)
    evidence = SimpleNamespace(drawn=np.array(drawn))
    return SimpleNamespace(rings=rings, energy=energy, compared=SimpleNamespace(view=view), evidence=evidence)


def test_an_object_where_none_was_has_to_be_likely_beside_all_rivals(monkeypatch):
    none, some, climbed, sure = (SimpleNamespace(confidence=c) for c in (0.05, 0.5, 0.6, 0.8))
    for name in ("_told", "best_of"):
        monkeypatch.setattr(search, name, lambda found: found)
    monkeypatch.setattr(search, "climb", lambda *_: [])
    monkeypatch.setattr(search, "_against", lambda best, _: best)
    for best, known, answer in (
        (climbed, none, none),
        (climbed, None, None),
        (sure, none, sure),
        (sure, None, sure),
        (climbed, some, climbed),
    ):
        monkeypatch.setattr(search, "_likelier", lambda *_, best=best: best)
        assert search._above(known, None, None, []) is answer


def test_the_gap_is_to_the_next_object_and_to_none(monkeypatch):
    monkeypatch.setattr(search, "priced", lambda found: found)
    box = Rings((SQUARE,), (SQUARE + DEPTH,))
    best, same, other = (
        _found(box, 100.0),
        _found(box.swapped(), 101.0),
        _found(Rings((SQUARE,), (SQUARE - 80,)), 130.0),
    )
    assert _gap(best, [best, same]) == 300.0
    assert _gap(best, [best, same, other]) == 30.0
    assert _gap(best, [_found(Rings((SQUARE,), (SQUARE - 80,)), 90.0)]) == -10.0


def test_a_face_with_nothing_behind_it_is_no_object():
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH, "removed")))
    box = find(observed(group))
    assert _told(box).confidence > TRUSTED
    seen = box.evidence.drawn.copy()
    for k in np.flatnonzero(seen)[:-1]:
        seen[k] = False
    face = replace(box, evidence=replace(box.evidence, drawn=seen))
    assert _told(face).confidence < REFUSE_BELOW


def test_a_face_drawn_twice_is_no_object_unless_all_of_it_is_drawn(monkeypatch):
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))
    box = find(observed(group))
    told = np.where(np.array(search.WITNESSES) == "doubled", LAID + 0.01, box.witnesses)
    monkeypatch.setattr(search, "witnesses", lambda *_: told)
    monkeypatch.setattr(search, "confidence", lambda _: 0.6)
    assert _told(box).confidence == 0.6
    hidden = replace(box, evidence=replace(box.evidence, drawn=np.array([True, True, True, False])))
    assert _told(hidden).confidence < REFUSE_BELOW
    told[search.WITNESSES.index("doubled")] = LAID - 0.01
    assert _told(hidden).confidence == 0.6


def test_a_table_is_no_object_however_well_it_is_explained(monkeypatch):
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))
    box = find(observed(group))
    assert _told(box).confidence > TRUSTED
    asked = []
    monkeypatch.setattr(
        search, "is_table", lambda rings, noise, *, is_all: asked.append((rings, noise, is_all)) or True
    )
    assert _told(box).confidence < REFUSE_BELOW
    monkeypatch.setattr(search, "_leaves_nothing", lambda _: False)
    _told(box)
    assert [a[2] for a in asked] == [True, False]
    assert asked[0][0] is box.rings
    assert asked[0][1] == box.energy.noise


def test_what_is_none_stays_none_without_a_rival():
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))
    box = replace(find(observed(group)), confidence=0.1)
    assert _against(box, [box]).confidence > 0.1
    assert _against(replace(box, is_none=True), [box]).confidence == 0.1


def test_what_explains_anything_is_no_object(monkeypatch):
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))
    box = find(observed(group))
    monkeypatch.setattr(search, "is_crowded", lambda *given: given[2] == box.energy.noise and len(given[0]) == 12)
    assert _told(box).confidence < REFUSE_BELOW


@pytest.mark.parametrize(
    ("sure", "little", "nothing", "is_none"),
    [
        (0.9, False, 1e9, False),
        (0.9, True, 1e9, False),
        (0.4, True, 1e9, True),
        (0.4, False, 1e9, False),
        (0.9, False, 0.0, False),
        (0.9, True, 0.0, True),
        (0.6, False, 0.0, True),
    ],
)
def test_a_doubtful_face_alone_or_what_costs_more_than_no_object_is_none(monkeypatch, sure, little, nothing, is_none):
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))
    box = find(observed(group))
    monkeypatch.setattr(search, "shows_little", lambda *_: little)
    view = SimpleNamespace(all_foreign=nothing)
    assert search._is_vague(replace(box, compared=replace(box.compared, view=view)), sure) == is_none


def test_rivals_make_an_answer_doubtful_but_not_none(monkeypatch):
    (group,) = split_groups(ink_of(prism(SQUARE, SQUARE + DEPTH)))
    box = find(observed(group))
    monkeypatch.setattr(search, "priced", lambda found: found)
    other = replace(box, rings=split(box.rings.vertices + 60.0, (4,)))
    plain = replace(box, confidence=0.96)
    assert _against(plain, [box]).confidence > TRUSTED
    assert REFUSE_BELOW <= _against(plain, [box, other]).confidence < TRUSTED
    assert _against(replace(box, confidence=0.25), [box, other]).confidence >= REFUSE_BELOW
    assert _against(replace(box, confidence=0.05), [box, other]).confidence < REFUSE_BELOW
    assert _against(plain, [box, other]).alone == 0.96
