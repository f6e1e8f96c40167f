"""Which inputs, which outputs: nothing lost, nothing doubled, nothing overwritten."""

from __future__ import annotations

import os
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketch2shape.batch.plan import common_folder, fold, make_plan, name_outputs, settle
from sketch2shape.errors import UnreadableError, UsageError, WriteError


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def touch(*names):
    for name in names:
        os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
        open(name, "w").close()


def planned(inputs, out="out", products=("obj",)):
    return {
        i.name: [os.path.relpath(o.path, out or ".") for o in i.outputs] for i in make_plan(inputs, out, products).items
    }


def test_the_tree_is_kept_and_other_files_are_no_inputs(here):
    touch("in/a.png", "in/sub/deep/b.JPG", "in/notes.txt", "in/a.json", "in/._a.png", "in/.hidden.png")
    assert planned(["in"], products=("obj", "json")) == {
        ".hidden.png": [".hidden.obj", ".hidden.json"],
        "a.png": ["a.obj", "a.json"],
        "sub/deep/b.JPG": ["sub/deep/b.obj", "sub/deep/b.json"],
    }


def test_several_inputs_keep_the_tree_below_what_they_share(here):
    touch("x/a.png", "x/one/a.png", "x/two/b.png")
    assert planned(["x/one", "x/two"]) == {"one/a.png": ["one/a.obj"], "two/b.png": ["two/b.obj"]}
    assert planned(["x/one/a.png", "x/two/b.png"]) == {"one/a.png": ["one/a.obj"], "two/b.png": ["two/b.obj"]}
    assert planned(["x/a.png", "x/one/a.png"]) == {"a.png": ["a.obj"], "one/a.png": ["one/a.obj"]}
    assert common_folder(["x/one/"]) == "x/one/"


def test_without_out_meshes_go_beside_the_inputs(here):
    touch("in/sub/a.png")
    assert planned(["in"], None) == {"sub/a.png": ["in/sub/a.obj"]}


def test_a_name_given_is_an_input_even_if_it_is_missing_or_no_picture(here):
    touch("a.txt")
    assert set(planned(["a.txt", "gone.png"])) == {"a.txt", "gone.png"}


def test_the_same_file_given_twice_is_one_input(here):
    touch("a.png")
    assert set(planned(["a.png", "./a.png", "../" + os.path.basename(here) + "/a.png"])) == {"a.png"}


def test_equal_stems_get_full_names(here):
    touch("in/a.png", "in/a.jpg", "in/b.png", "in/a.png.gif")
    assert planned(["in"]) == {
        "a.png.gif": ["a.png.obj"],
        "a.jpg": ["a.jpg.obj"],
        "a.png": ["a.png~2.obj"],
        "b.png": ["b.obj"],
    }


@pytest.mark.parametrize("twins", [("A.png", "a.png"), ("é.png", "e\u0301.png"), ("ß.png", "SS.png")])
def test_names_that_some_file_system_takes_for_one_are_kept_apart(here, twins):
    touch(*(f"in/{t}" for t in twins))
    outputs = [o for group in planned(["in"]).values() for o in group]
    assert len({fold(o) for o in outputs}) == 2


def test_links_are_read_but_folders_behind_links_are_not_searched(here):
    touch("in/a.png")
    os.symlink("a.png", "in/b.png")
    os.symlink("..", "in/up")
    os.symlink("loop.png", "in/loop.png")
    assert set(planned(["in"])) == {"a.png", "b.png", "loop.png"}


def test_output_inside_input_is_not_searched(here):
    touch("in/a.png", "in/out/a.overlay.png")
    assert set(planned(["in"], "in/out")) == {"a.png"}


def test_outputs_of_an_earlier_run_are_no_inputs(here):
    touch("in/a.png", "in/a.overlay.png")
    plan = make_plan(["in"], None, ["obj"], ours=["in/a.overlay.png"])
    assert [i.name for i in plan.items] == ["a.png"]


def test_no_pictures(here):
    touch("in/a.txt")
    with pytest.raises(UnreadableError, match="no pictures"):
        make_plan(["in"], "out", ["obj"])


def test_an_output_never_replaces_an_input(here):
    touch("a.obj", "b.png")
    with pytest.raises(UsageError, match="replace an input"):
        make_plan(["a.obj", "b.png"], None, ["obj"])


def test_existing_outputs_are_refused_or_moved_aside(here):
    touch("in/a.png", "in/a.2.png", "out/a.obj")
    plan = make_plan(["in"], "out", ["obj", "json"])
    with pytest.raises(WriteError, match=r"out/a\.obj exists already"):
        settle(plan, versioned=False)
    assert settle(plan, versioned=False, ours=["out/a.obj"]) == plan
    moved = {i.name: i.outputs[0].path for i in settle(plan, versioned=True).items}
    assert moved == {"a.2.png": "out/a.2.obj", "a.png": "out/a.3.obj"}


def test_a_missing_input_is_said_before_outputs_that_exist(here):
    touch("in/a.png", "out/a.obj")
    plan = make_plan(["in/a.png", "in/b.png"], "out", ["obj"])
    with pytest.raises(UnreadableError, match=r"in/b\.png: no such file"):
        settle(plan, versioned=False)


_NAMES = [
    f"{stem}.{end}" for stem, end in product(["a", "A", "a.png", "a.png~2", "b", "ß", "ss"], ["png", "jpg", "PNG"])
]


@given(st.sets(st.sampled_from(_NAMES), min_size=1), st.sampled_from([(".obj",), (".obj", ".json")]))
def test_outputs_never_collide_and_lone_stems_are_kept(names, endings):
    ordered = sorted(names)
    stems = name_outputs(ordered, endings)
    assert len({fold(s + endings[0]) for s in stems}) == len(ordered)
    plain = [os.path.splitext(n)[0] for n in ordered]
    folded = [fold(p) for p in plain]
    for stem, short, key in zip(stems, plain, folded, strict=True):
        if folded.count(key) == 1:
            assert stem == short
