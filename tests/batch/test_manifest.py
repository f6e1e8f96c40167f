"""The record of a run."""

from __future__ import annotations

import json

import pytest

from sketch2shape.batch.manifest import NAME, Manifest, Past, digest_file, load_past, options_hash
from sketch2shape.batch.plan import Plan, Planned
from sketch2shape.conversion.convert import Outcome, Output, Settings
from sketch2shape.conversion.summary import Measures
from sketch2shape.errors import UsageError
from sketch2shape.reading.limits import Limits


@pytest.fixture
def plan(tmp_path):
    items = []
    for name in ("a", "b"):
        (tmp_path / f"{name}.png").write_text(name)
        (tmp_path / f"{name}.obj").write_text(f"mesh {name}")
        items.append(
            Planned(str(tmp_path / f"{name}.png"), f"{name}.png", (Output("obj", str(tmp_path / f"{name}.obj")),))
        )
    return Plan(str(tmp_path), tuple(items))


def outcome(item, code=0):
    path = item.outputs[0].path
    return Outcome(
        item.name,
        code,
        digest=digest_file(item.path),
        written={path: digest_file(path)},
        seconds=1.5,
        measures=(Measures(4.0, 3.0, 2.0, 52.0, 24.0, "mm"),),
    )


def test_a_stopped_run_is_read_back(plan, tmp_path):
    manifest = Manifest(plan, "x")
    manifest.begin()
    manifest.add(outcome(plan.items[0]))
    manifest.close()
    with open(tmp_path / NAME, "a") as file:
        file.write('{"done": "b.png", "exit_')  # a kill in the middle of a line
    past = load_past(str(tmp_path))
    assert past.options == "x"
    assert sorted(past.files) == [item.outputs[0].path for item in plan.items]
    assert past.still_done(plan.items[0]).exit_code == 0
    assert past.still_done(plan.items[0]).measures == outcome(plan.items[0]).measures
    assert past.still_done(plan.items[1]) is None


@pytest.mark.parametrize("spoil", ["a.png", "a.obj"])
def test_what_changed_is_done_again(plan, tmp_path, spoil):
    past = Past(str(tmp_path), "x", {}, {"a.png": outcome(plan.items[0])})
    assert past.still_done(plan.items[0]) is not None
    (tmp_path / spoil).write_text("changed")
    assert past.still_done(plan.items[0]) is None
    (tmp_path / spoil).unlink()
    assert past.still_done(plan.items[0]) is None


@pytest.mark.parametrize(
    ("code", "again"), [(0, False), (4, False), (5, False), (1, True), (6, True), (7, True), (8, True)]
)
def test_failures_that_may_pass_are_tried_again(plan, tmp_path, code, again):
    past = Past(str(tmp_path), "x", {}, {"a.png": outcome(plan.items[0], code)})
    assert (past.still_done(plan.items[0]) is None) == again


def test_a_finished_run_leaves_the_same_bytes_whatever_the_order(plan, tmp_path):
    texts = []
    for order in (plan.items, plan.items[::-1]):
        manifest = Manifest(plan, "x")
        manifest.begin()
        for item in order:
            manifest.add(outcome(item))
        manifest.finish()
        texts.append((tmp_path / NAME).read_bytes())
    assert texts[0] == texts[1]
    assert b"seconds" not in texts[0]
    assert [json.loads(line).get("done") for line in texts[0].splitlines()] == [None, "a.png", "b.png"]


def test_other_options_are_refused(tmp_path):
    one = options_hash(Settings(), ["obj"])
    assert one == options_hash(Settings(), ["obj"])
    assert len({one, options_hash(Settings(), ["stl"]), options_hash(Settings(Limits(max_pixels=5)), ["obj"])}) == 3
    Past("r", one).check_options(one)
    Past("r").check_options(one)
    with pytest.raises(UsageError, match="other options"):
        Past("r", one).check_options("y")


def test_a_file_that_is_no_record_is_passed_over(tmp_path):
    (tmp_path / NAME).write_text('[1]\n{"done": 3}\nnot json\n{"planned": "a", "outputs": []}\n')
    assert load_past(str(tmp_path)).done == {}
    assert load_past(str(tmp_path / "missing")) == Past(str(tmp_path / "missing"))


def test_digest_of_what_is_no_file(tmp_path):
    assert digest_file(str(tmp_path)) == digest_file("/dev/null") == digest_file("gone") == ""
