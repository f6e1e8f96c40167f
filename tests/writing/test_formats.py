"""The table of formats: every kind of file has its maker, and its names are told apart."""

from __future__ import annotations

import pytest

from sketch2shape.export import FORMATS as EXPORTED
from sketch2shape.pipeline.products import ENCODERS
from sketch2shape.writing.formats import FORMATS, ending, meant_by, named


def test_every_format_is_made_somewhere():
    assert {*EXPORTED, *ENCODERS} == {*FORMATS}
    assert not {*EXPORTED} & {*ENCODERS}


def test_the_groups_hold_every_format_once():
    assert sorted(named("solid", "program", "plan", "drawing", "report", "picture")) == sorted(FORMATS)


@pytest.mark.parametrize("name", FORMATS)
def test_what_is_written_under_an_ending_is_read_from_it(name):
    assert ending(meant_by(f"a.b{ending(name).upper()}")) == ending(name)


@pytest.mark.parametrize(
    ("file", "name"),
    [
        ("a.face.svg", "face.svg"),
        ("a.v2.svg", "svg"),
        ("face.svg", "svg"),
        ("a.stp", "step"),
        ("A.OVERLAY.PNG", "overlay"),
        ("a.png", None),
        ("svg", None),
    ],
)
def test_the_longest_ending_counts(file, name):
    assert meant_by(file) == name
