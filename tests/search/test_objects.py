"""Objects of a sheet: which groups of ink are looked at, and what is given for them."""

from dataclasses import dataclass
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from sketches import DEPTH, SQUARE, ink_of, line, paper, prism

from sketch2shape.evidence import REFUSE_BELOW, WITNESSES
from sketch2shape.hypotheses import Rings
from sketch2shape.search import objects


@dataclass(frozen=True)
class Answer:
    """What `find_one` gives: the size of its group, and how sure it is."""

    size: float
    confidence: float

    def shifted(self, by):
        assert by.shape == (2,)
        return self


@pytest.fixture
def sheet(monkeypatch):
    """The confidences given for groups of these sizes, and those that were asked for."""

    def given(*groups):
        some = [SimpleNamespace(size=size, offset=np.zeros(2), sure=sure) for size, sure in groups]
        asked = []

        def find_one(group):
            asked.append(group.size)
            return None if group.sure is None else Answer(size=group.size, confidence=group.sure)

        monkeypatch.setattr(objects, "split_groups", lambda _: some)
        monkeypatch.setattr(objects, "find_one", find_one)
        return [f.confidence for f in objects.find_all(ink_of(paper()))], asked

    return given


LOW = REFUSE_BELOW / 2


@pytest.mark.parametrize("vain", range(objects.MOST_VAIN + 2))
def test_so_many_groups_without_an_object_make_a_sheet_of_writing(sheet, vain):
    found, asked = sheet(*[(100, None)] * vain, (100, 0.9))
    assert len(found) == (vain < objects.MOST_VAIN)
    assert len(asked) == min(vain + 1, objects.MOST_VAIN)


def test_each_group_without_an_object_before_it_makes_an_answer_less_likely():
    assert objects._among_writing(0.9, 0) == pytest.approx(0.9)
    assert objects._among_writing(10 / 11, 1) == pytest.approx(0.5)
    assert objects._among_writing(10 / 11, 2) == pytest.approx(1 / 11)
    assert objects._among_writing(1.0, 2) > 0.99


def test_writing_before_an_object_counts_and_after_it_does_not(sheet):
    assert sheet((100, None), (100, 0.9))[0] == pytest.approx([9 / 19])
    assert sheet((100, 0.9), (100, None), (100, 0.8))[0] == pytest.approx([0.9])
    assert sheet((100, 0.9), (100, None), (100, 0.99))[0] == pytest.approx([0.9, 9.9 / 10.9])


def test_an_answer_that_is_refused_is_in_vain_too_and_the_first_is_kept(sheet):
    found, asked = sheet(*[(100, LOW / k) for k in (1, 2, 3)], (100, 0.9))
    assert found == [LOW]
    assert len(asked) == objects.MOST_VAIN


def test_a_refused_answer_gives_way_to_one_that_is_not(sheet):
    assert sheet((100, LOW), (90, 0.9))[0] == pytest.approx([9 / 19])
    assert sheet((100, 0.9), (90, LOW))[0] == [0.9]


def test_beside_a_likely_object_an_unlikely_one_is_none(sheet):
    assert sheet((100, REFUSE_BELOW), (90, 0.9))[0] == [0.9]
    assert sheet((100, 0.9), (90, 0.4))[0] == [0.9]
    assert sheet((100, 0.9), (90, 0.6))[0] == [0.9, 0.6]
    assert sheet((100, 0.4), (90, 0.3))[0] == [0.4, 0.3]


@pytest.mark.parametrize(
    ("first", "closed", "taken"), [(0.3, 0.8, 0.8), (0.3, 0.4, 0.3), (0.7, 0.9, 0.7), (0.0, 0.6, 0.6)]
)
def test_where_no_answer_is_likely_the_border_is_drawn_too(monkeypatch, first, closed, taken):
    found = {"open": [SimpleNamespace(confidence=first)], "closed": [SimpleNamespace(confidence=closed)]}
    monkeypatch.setattr(objects, "find_exact", lambda _: None)
    monkeypatch.setattr(objects, "closed_at_border", lambda _: "closed")
    monkeypatch.setattr(objects, "_find_groups", lambda ink: found[ink])
    assert [f.confidence for f in objects.find_all("open")] == [taken]


def test_what_is_far_smaller_than_the_first_object_is_a_letter(sheet):
    least = 100 * objects.LEAST_COMPANION
    assert sheet((100, 0.9), (least, 0.8), (least - 1, 0.7)) == ([0.9, 0.8], [100, least])


def test_an_empty_sheet_has_none(sheet):
    assert sheet() == ([], [])


def test_letters_beside_a_box_are_passed_over():
    picture = prism(SQUARE, SQUARE + DEPTH)
    line(picture, [20, 20], [40, 40])
    line(picture, [40, 20], [20, 40])
    assert len(objects.find_all(ink_of(picture))) == 1
    assert objects.find_all(ink_of(line(paper(), [50, 50], [400, 60]))) == []


def test_an_arc_turns_to_one_side_and_a_trembling_hand_to_either():
    t = np.linspace(0.0, 1.0, 200)
    ways = {
        "arc": 60 * np.sin(np.pi * t),
        "trembling": 3.5 * np.sin(10 * np.pi * t),
        "straight": 0 * t,
    }
    bowed = {}
    for name, y in ways.items():
        path = np.stack([40 + 400 * t, 200 + y], axis=1)
        skeleton = SimpleNamespace(paths=[np.rint(path).astype(np.int32)], pen_width=2.0)
        bowed[name] = objects.bowed_part(skeleton, 500.0)
    assert bowed["arc"] > 0.9
    assert bowed["trembling"] == bowed["straight"] == 0.0


def test_a_silhouette_with_obtuse_corners_is_no_arc():
    """Its corners turn as little as the chords of an arc, but lie far apart."""
    turn = np.radians(28.0) * np.arange(4)
    ends = np.cumsum(np.concatenate([[[60.0, 60.0]], 110.0 * np.stack([np.cos(turn), np.sin(turn)], axis=1)]), axis=0)
    t = np.linspace(0.0, 1.0, 110, endpoint=False)[:, None]
    path = np.concatenate([a + t * (b - a) for a, b in pairwise(ends)])
    skeleton = SimpleNamespace(paths=[np.rint(path).astype(np.int32)], pen_width=2.0)
    assert objects.bowed_part(skeleton, 500.0) == 0.0


def test_a_flat_arc_perhaps_bows_and_not_plainly():
    t = np.linspace(0.0, 1.0, 200)
    path = np.stack([40 + 200 * t, 200 + 14 * np.sin(np.pi * t)], axis=1)
    skeleton = SimpleNamespace(paths=[np.rint(path).astype(np.int32)], pen_width=4.0)
    assert objects.bowed_part(skeleton, 500.0) == 0.0
    assert objects.bowed_part(skeleton, 500.0, objects.PERHAPS) > 0.9


@pytest.mark.parametrize(("lines", "foreign", "asked"), [("wire", 20.0, 1), ("removed", 20.0, 0), ("wire", 1.0, 0)])
def test_a_sure_wireframe_is_searched_for_narrow_holes_where_ink_is_left(monkeypatch, lines, foreign, asked):
    sure, calls = _sure(monkeypatch, lines, foreign), []
    monkeypatch.setattr(objects, "find_sweep", lambda *_, **how: calls.append(how))
    assert objects.find_one(None) is sure
    assert len(calls) == asked
    assert all(not how["arcs"] for how in calls)


@pytest.mark.parametrize(("attached", "short", "asked"), [(0.2, 20.0, 1), (0.0, 20.0, 0), (0.0, 3.0, 1)])
def test_a_sure_prism_that_leaves_lines_or_comes_nearly_to_a_point_may_be_a_pyramid(
    monkeypatch, attached, short, asked
):
    sure, calls = _sure(monkeypatch, "removed", 20.0, attached, short), []
    monkeypatch.setattr(objects, "find_pyramid", lambda _, below: calls.append(below))
    assert objects.find_one(None) is sure
    assert calls == [100.0] * asked


def _sure(monkeypatch, lines, foreign, attached=0.0, short=20.0):
    """A straight answer that is sure, and the only one, in a drawing of size 100; short: its shortest edge."""
    told = np.where(np.array(WITNESSES) == "attached", attached, 0.0)
    energy = SimpleNamespace(lines=lines, foreign=foreign, total=100.0)
    view = SimpleNamespace(size=100.0)
    face = np.array([[0.0, 0], [40, 0], [0, 30]])
    rings = Rings((face,), (face + [0.0, -short],))
    compared = SimpleNamespace(view=view)
    sure = SimpleNamespace(confidence=0.95, alone=0.95, energy=energy, witnesses=told, rings=rings, compared=compared)
    monkeypatch.setattr(objects, "observed", lambda _: SimpleNamespace(skeleton=None, view=view))
    monkeypatch.setattr(objects, "bowed_part", lambda *_: 0.0)
    monkeypatch.setattr(objects, "find", lambda _: sure)
    monkeypatch.setattr(objects, "find_drilled", lambda *_: None)
    return sure


def test_a_pyramid_that_may_be_a_prism_is_read_as_one():
    apex = np.array([90.0, 60])
    base = np.array([[190.0, 150], [330, 90], [350, 250], [210, 330]])
    picture = paper(400, 480)
    for a, b in pairwise([*base, base[0]]):
        line(picture, a, b)
    for corner in base[[0, 1, 3]]:
        line(picture, apex, corner)
    (found,) = objects.find_all(ink_of(picture))
    assert found.confidence > 0.8
    assert found.sweep.way.is_pointed
    assert np.hypot(*(found.sweep.way.centre - apex)) < 3


@pytest.mark.parametrize(
    ("straight", "swept", "cheaper", "is_given"),
    [
        (None, 0.4, 0, True),
        (LOW, 0.4, 40, True),
        (0.3, 0.4, 40, False),
        (0.3, 0.6, 40, True),
        (0.3, 0.6, -40, False),
        (LOW, 0.6, -40, True),
        (LOW, 0.4, -40, False),
        (None, 0.25, 0, False),
    ],
)
def test_an_answer_with_arcs_is_given_beside_or_without_a_straight_one(straight, swept, cheaper, is_given):
    """Unlikely ones where there is no other, and likely ones even if what is no answer is cheaper."""
    arcs = SimpleNamespace(
        confidence=swept,
        is_lone=False,
        nats=50.0,
        energy=SimpleNamespace(missing=0.0),
        sweep=SimpleNamespace(has_arcs=True),
        compared=SimpleNamespace(view=SimpleNamespace(all_foreign=80.0)),
        against=lambda _: arcs,
    )
    other = straight and SimpleNamespace(confidence=straight, energy=SimpleNamespace(total=50.0 + cheaper))
    assert objects._better(other, arcs) is (arcs if is_given else other)


@pytest.mark.parametrize(
    ("few", "missing", "whole", "none", "is_given"),
    [
        (True, 7.0, 30, 40.0, True),
        (True, 13.0, 300, 90.0, True),
        (True, 13.0, 60, 90.0, False),
        (True, 13.0, 300, 40.0, False),
        (False, 13.0, 60, 90.0, True),
        (False, 13.0, 60, 40.0, False),
    ],
)
def test_what_lacks_lines_is_worth_its_price_and_a_figure_of_few_has_nearly_all(few, missing, whole, none, is_given):
    lacking = SimpleNamespace(
        confidence=0.8,
        is_lone=few,
        nats=50.0,
        energy=SimpleNamespace(missing=missing),
        compared=SimpleNamespace(wanted=np.array([0.5 * whole, 0.5 * whole]), view=SimpleNamespace(all_foreign=none)),
        sweep=SimpleNamespace(has_arcs=True),
    )
    assert objects._better(None, lacking) is (lacking if is_given else None)
