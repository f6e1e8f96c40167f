"""Changes that mean nothing: the changes themselves, the verdicts, and the tool on a few drawings."""

import numpy as np
import pytest

from evaluation.cases import ROOT, case_of
from evaluation.metamorphic import metamorphic_table, trials, verdict
from evaluation.transforms import TRANSFORMS, mapped

SAMPLE = ("clean_wire_oblique", "hand_dashed", "holes_wire", "clean_removed_axono")
"""Committed drawings that every change must leave as they are."""


@pytest.mark.parametrize("name", list(TRANSFORMS))
def test_a_point_goes_where_the_homography_says(name):
    pixels = np.full((90, 120, 3), 235, np.uint8)
    pixels[40:47, 70:79] = 20
    changed, move = TRANSFORMS[name](pixels)
    assert changed.dtype == np.uint8
    there = mapped({"f1": [[74, 43]], "f2": [[20, 10]]}, move)
    spot, paper = (changed[round(y), round(x)].astype(int).sum() for ((x, y),) in (there["f1"], there["f2"]))
    assert spot < paper - 150 if name != "inverted" else spot > paper + 150


@pytest.mark.parametrize("name", list(TRANSFORMS))
def test_each_change_changes_the_picture(name):
    pixels = np.full((60, 80, 3), 240, np.uint8)
    pixels[10:50, 20:24] = 10
    changed, _ = TRANSFORMS[name](pixels)
    assert changed.shape != pixels.shape or not np.array_equal(changed, pixels)


BOX = {
    **{"f1": [[10, 10], [90, 10], [90, 90], [10, 90]], "f2": [[40, 0], [120, 0], [120, 80], [40, 80]]},
    **{"holes": [], "lines": "wire", "confidence": 0.95},
}


def test_verdicts():
    other = BOX | {"f2": BOX["f2"][1:] + BOX["f2"][:1]}
    assert verdict([], []) == "same"
    assert verdict([BOX], []) == "lost"
    assert verdict([], [BOX]) == "gained"
    assert verdict([BOX], [BOX | {"confidence": 0.5}]) == "same"
    assert verdict([BOX], [BOX | {"f1": BOX["f2"], "f2": BOX["f1"]}]) == "same"
    assert verdict([BOX], [other]) == "other"
    assert verdict([BOX], [BOX, BOX]) == "other"


def test_a_tool_that_follows_the_picture_is_the_same_and_one_that_does_not_is_another():
    case = case_of(ROOT / "data" / "synthetic" / "clean_wire_oblique" / "000.png")
    truth = {k: case.truth[k] for k in ("f1", "f2", "holes", "lines")} | {"confidence": 0.95}
    stubborn = trials(case, answer=lambda _: [truth])
    still = {t.transform for t in stubborn if t.verdict == "same"}
    assert still == {"inverted", "coloured", "JPEG 80", "JPEG 50", "shade"}
    assert all(t.right == (True, t.transform in still) for t in stubborn)
    gone = trials(case, ["shift"], answer=lambda pixels: [truth] if pixels.shape[1] == case.truth["width"] else [])
    assert gone[0].verdict == "lost"
    assert "| shift | 1 | 0.0 | 1 | 0 | 0 | 1 | 0 | 1 | 0 | - |" in metamorphic_table(gone)


@pytest.mark.parametrize("category", SAMPLE)
def test_the_answer_stays_the_same(category):
    case = case_of(ROOT / "data" / "synthetic" / category / "000.png")
    changed = {t.transform: t.verdict for t in trials(case) if t.verdict != "same"}
    assert changed == {}
