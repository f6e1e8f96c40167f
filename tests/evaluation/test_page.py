"""The page of results, the record of a run, and what two runs differ in."""

import importlib
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from evaluation import page as page_of
from evaluation.cases import SETS, Case, Wanted, collect
from evaluation.compare import changes, load, summary
from evaluation.confidence import confidence_tables
from evaluation.failures import write_sheets
from evaluation.outcome import Outcome, save

SCRIPTS = Path(__file__).parent.parent.parent / "scripts"


def outcome(case, stem="000", right=True, confidence=0.95, cause=""):
    answers = ({"confidence": confidence} | {k: case.truth[k] for k in ("f1", "f2", "holes")},)
    return Outcome(replace(case, id=f"a/{stem}"), answers=answers, right=right, cause=cause, ms=20.0)


def test_the_page_tells_the_command_the_shares_and_the_failures(case, tmp_path):
    pytest.importorskip("matplotlib")
    outcomes = [outcome(case, f"00{i}") for i in range(3)]
    outcomes += [outcome(case, "003", right=False, cause="vertices right, edges wrong")]
    page = tmp_path / "docs" / "results.md"
    sheets = write_sheets(outcomes, page.parent / "failures")
    page_of.write_page(page, outcomes, "python scripts/evaluate.py", sheets)
    text = page.read_text()
    assert "python scripts/evaluate.py" in text
    assert "| fresh | 4 | 75.0 | 100.0 | 50.0 |" in text
    assert "Of 4 answers with confidence 0.9 or more, 75.0 % are right." in text
    assert "vertices right, edges wrong" in text
    assert "failures/1.jpg" in text
    assert (page.parent / "failures" / "1.jpg").stat().st_size > 1000
    assert (page.parent / "reliability.svg").exists()


def test_the_promise_is_counted_for_each_half(case):
    outcomes = [outcome(case, "000"), outcome(case, "002", confidence=0.6), outcome(case, "001", right=False)]
    outcomes += [outcome(case, "003", right=None)]
    text = confidence_tables(outcomes)
    assert "| fresh, even | 2 | 1 | 1 | 100.0 | 2 | 50.0 |" in text
    assert "| fresh, odd | 1 | 1 | 0 | 0.0 | 0 | - |" in text
    assert "| 0.6 to 0.7 | 1 | 100.0 | 100.0 | - |" in text


def test_pictures_of_something_else_are_counted_by_kind(case):
    flat = Case("refuse", "flat/1", case.picture, case.truth | {"category": "flat"})
    sheet = Case("refuse", "neg_multi/2", case.picture, case.truth | {"category": "neg_multi"})
    answered = replace(outcome(case, right=None), case=sheet)
    text = page_of.refusal_table([Outcome(flat, "refused", right=True), answered])
    assert "| flat | 1 | 0 | 0 | 0 | 0.0 | 0 |" in text
    assert "| neg_multi* | 1 | 1 | 1 | 0 | 100.0 | 1 |" in text
    assert "Answers that only the eye can judge" in page_of.failures([answered], [], Path())


def test_the_page_holds_the_tables_of_the_lifting(tmp_path):
    (tmp_path / "lifting.md").write_text(
        "# Lifting\n\nWords.\n\n## How often\n\n### A set\n\n| right | 0 px |\n|---|---|\n| all | 90 % |\n"
    )
    text = page_of.lifting(tmp_path / "lifting.md")
    assert "### A set\n\n| right | 0 px |\n|---|---|\n| all | 90 % |\n" in text
    assert "Words" not in text
    assert "How often" not in text
    assert "Not measured" in page_of.lifting(tmp_path / "none.md")


def test_the_recorded_command_leaves_out_places_on_this_machine(monkeypatch):
    monkeypatch.syspath_prepend(SCRIPTS)
    recorded = importlib.import_module("evaluate").recorded
    sys.modules.pop("evaluate")
    options = ["--raw", "/somewhere/raw.json", "--sets", "committed", "--page", "", "--seed", "3"]
    assert recorded(options) == "python scripts/evaluate.py --sets committed --seed 3"


def test_two_runs_differ_in_what_was_fixed_broken_and_moved(case, tmp_path):
    before = [outcome(case, "0", right=False), outcome(case, "1"), outcome(case, "2"), outcome(case, "3")]
    before += [outcome(case, "4", right=False, confidence=0.5), outcome(case, "5", right=None), outcome(case, "6")]
    after = [outcome(case, "0"), outcome(case, "1", right=False, cause="off"), outcome(case, "2", confidence=0.7)]
    after += [outcome(case, "3", confidence=0.93), outcome(case, "4", right=False)]
    after += [Outcome(replace(case, id="a/5"), "refused", right=True)]
    for name, run in (("a", before), ("b", after)):
        save(run, tmp_path / name)
    a, b = load(tmp_path / "a"), load(tmp_path / "b")
    found = changes(a, b)
    assert [(c.kind, c.id) for c in found] == [
        ("fixed", "a/0"),
        ("broken", "a/1"),
        ("sure and wrong now", "a/4"),
        ("other verdict", "a/5"),
        ("less sure", "a/2"),
    ]
    assert "0.95 -> 0.95 off" in str(found[1])
    assert "0.95 -> no answer" in str(found[3])
    assert "| fresh | 6 | 3 | 4 | 1 | 1 | 1 | 0 | 1 | 0 | 1 |" in summary(a, b, found)
    assert "1 drawings are in one run only" in summary(a, b, found)
    assert changes(a, a) == []


def test_a_set_that_is_not_there_has_no_cases(tmp_path):
    assert collect([s for s in SETS if s not in ("committed", "fresh")], Wanted(tmp_path, tmp_path)) == []


def test_fresh_drawings_come_by_category_with_their_truth(tmp_path):
    cases = collect(["fresh"], Wanted(tmp_path, tmp_path, ["clean_wire_o*"], per_category=2))
    assert [c.id for c in cases] == ["clean_wire_oblique/000", "clean_wire_oblique/001"]
    assert cases[0].truth["width"] == 640
