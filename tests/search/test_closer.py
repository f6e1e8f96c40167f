"""A closer look: taken where fine lines are not read for sure, and believed where it is surer."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from sketches import SQUARE, ink_of, prism, same_object

from sketch2shape.model import TRUSTED
from sketch2shape.search import as_object, closer, find_closely
from sketch2shape.search.objects import LIKELY

BOX = ink_of(prism(SQUARE, SQUARE + [40, -30.0], width=1))
TEE = np.array([[0, 0], [6, 0], [6, 12], [30, 12], [30, 18], [6, 18], [6, 30], [0, 30.0]]) * 10 + [80, 60]


@pytest.fixture
def looks(monkeypatch):
    """Confidences at the first and at a closer look, and how often there was a look."""

    def given(ink, first, second):
        seen = []

        def find_all(ink):
            seen.append(ink)
            sure = first if len(seen) == 1 else second
            return [] if sure is None else [SimpleNamespace(confidence=sure)]

        monkeypatch.setattr(closer, "find_all", find_all)
        found, own = find_closely(ink)
        assert own is seen[0] or own is seen[1]
        return [f.confidence for f in found], len(seen), own is not ink

    return given


def test_a_likely_answer_is_not_looked_at_again(looks):
    assert looks(BOX, LIKELY, 1.0) == ([LIKELY], 1, False)


@pytest.mark.parametrize("first", [None, 0.1, 0.6])
def test_a_sure_answer_of_a_closer_look_is_believed(looks, first):
    assert looks(BOX, first, 0.95) == ([0.95], 2, True)


@pytest.mark.parametrize(("first", "second"), [(0.6, 0.85), (0.1, 0.4), (0.5, None)])
def test_another_answer_that_is_not_sure_is_not(looks, first, second):
    assert looks(BOX, first, second) == ([first], 2, False)


@pytest.mark.parametrize("first", [None, 0.1])
def test_a_likely_one_is_believed_where_there_was_no_answer(looks, first):
    assert looks(BOX, first, LIKELY) == ([LIKELY], 2, True)
    assert looks(BOX, first, LIKELY - 0.01) == ([first] if first else [], 2, False)


def test_nor_is_one_that_leaves_ink(looks, monkeypatch):
    monkeypatch.setattr(closer, "_is_all", lambda _: False)
    assert looks(BOX, 0.3, 0.95) == ([0.3], 2, False)


def test_thick_lines_need_no_closer_look(looks):
    thick = ink_of(prism(SQUARE, SQUARE + [40, -30.0], width=9))
    assert looks(thick, 0.3, 0.95) == ([0.3], 1, False)


@pytest.mark.parametrize(("part", "looks"), [(closer.PARTLY - 0.01, 1), (closer.PARTLY + 0.01, 2)])
def test_what_is_refused_and_yet_better_than_nothing_has_pixels_enough(monkeypatch, part, looks):
    (box,) = find_closely(BOX)[0]
    energy = box.energy._replace(foreign=part * box.compared.view.all_foreign - box.energy.total + box.energy.foreign)
    seen, refused = [], replace(box, energy=energy, confidence=0.1)

    def find_all(ink):
        seen.append(ink)
        return [refused]

    monkeypatch.setattr(closer, "find_all", find_all)
    find_closely(BOX)
    assert len(seen) == looks


def test_a_plate_of_four_pixels_is_read():
    found, ink = find_closely(ink_of(prism(TEE, TEE + [4.0, -4.0], width=1)))
    (best,) = found
    assert best.confidence > TRUSTED
    assert same_object(as_object(best.rings, best.evidence, ink), TEE, TEE + [4.0, -4.0], 1.0)
