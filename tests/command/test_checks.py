"""Words that are no inputs, and options that change nothing."""

from __future__ import annotations

import pytest

from sketch2shape.command.checks import check_effects, check_input, check_inputs
from sketch2shape.command.parser import main, parse
from sketch2shape.errors import UnreadableError, UsageError


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "w.png").touch()
    (tmp_path / "drawing.svg").touch()
    (tmp_path / "old.obj").touch()
    return tmp_path


@pytest.mark.parametrize("name", ["out.obj", "old.obj", "out.STL", "out.svg", "out.json", "a/out.face.dxf"])
def test_an_output_among_the_inputs_is_told_from_a_picture(here, name):
    with pytest.raises(UsageError, match="is an output") as caught:
        check_inputs(["w.png", name])
    assert caught.value.advice == f"give the output with -o {name}"


def test_words_that_are_no_files(here):
    for words, remedy in ((["w.png", "mm"], "--width 40mm"), (["convert", "w.png"], "INPUT -o OUT")):
        with pytest.raises(UsageError) as caught:
            check_inputs(words)
        assert remedy in caught.value.advice


def test_pictures_are_left_to_the_run(here):
    check_inputs(["w.png", "gone.png", "drawing.svg"])
    check_inputs(["gone"])


def test_a_missing_picture_is_named_before_its_outputs(here, capsys):
    with pytest.raises(UnreadableError):
        check_input("gone.png")
    (here / "gone.obj").touch()
    assert main(["gone.png"]) == 4
    assert capsys.readouterr().err == "gone.png: no such file or directory. Try: check the path\n"


@pytest.mark.parametrize(
    ("words", "products"),
    [
        (["--ngons"], ["stl"]),
        (["--ngons", "--format", "stl"], None),
        (["--tolerance", "1mm"], ["step", "json"]),
        (["--tolerance", "1mm", "--format", "step"], None),
        (["--timings"], ["obj"]),
        (["--timings"], None),
        (["--jobs", "2", "--scheduler", "tcp://a:1"], None),
        (["--max-memory", "2G", "--scheduler", "tcp://a:1"], None),
    ],
)
def test_an_option_that_changes_nothing_is_refused(words, products):
    with pytest.raises(UsageError, match="has no effect"):
        check_effects(parse(["w.png", *words]), products)


def test_and_one_that_does_is_not():
    check_effects(parse(["w.png", "--ngons", "--timings", "--json"]))
    check_effects(parse(["w.png", "--tolerance", "0.1mm"]), ["step", "stl"])
    check_effects(parse(["w.png", "--ngons", "--timings"]), ["obj", "json"])
