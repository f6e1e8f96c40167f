"""A single picture through the command."""

from __future__ import annotations

import io
import json
import os
import sys

import pytest
import stand_in
from PIL import Image

from sketch2shape.command.parser import parse
from sketch2shape.command.run import run, stage_options
from sketch2shape.errors import UsageError, WriteError


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Image.new("L", (40, 30), 0).save("a.png")
    Image.new("L", (40, 30), 255).save("blank.png")
    return tmp_path


def command(*arguments):
    return run(parse(arguments), stand_in.work)


def files(folder="."):
    return sorted(n for n in os.listdir(folder) if not n.endswith(".png"))


def test_beside_the_input_by_default(here):
    assert command("a.png") == 0
    assert files() == ["a.obj"]


def test_an_existing_file_is_refused_replaced_or_kept(here):
    (here / "a.obj").write_text("mine")
    with pytest.raises(WriteError, match=r"a\.obj exists already"):
        command("a.png")
    assert (here / "a.obj").read_text() == "mine"
    assert command("a.png", "--versioned", "--json") == 0
    assert files() == ["a.2.json", "a.2.obj", "a.obj"]
    assert command("a.png", "--overwrite") == 0
    assert (here / "a.obj").read_bytes() == (here / "a.2.obj").read_bytes()


@pytest.mark.parametrize(
    "arguments",
    [
        ["a.png", "-o", "b.obj", "--overlay", "a.png"],
        ["a.png", "-o", "b.obj", "--preview", "./a.png"],
        ["a.png", "-o", "b.obj", "--stages", "A.PNG"],
        ["a.png", "-o", "b.obj", "--overlay", "link.png"],
        ["link.png", "-o", "b.obj", "--overlay", "a.png"],
        ["a.png", "-o", "b.obj", "--overlay", "twin.png"],
        ["drawing.svg", "--format", "svg"],
        ["drawing.svg", "-o", "drawing.svg"],
        ["a.png", "-o", "fix.obj", "--json", "--vertices", "fix.json"],
    ],
)
@pytest.mark.parametrize("existing", [[], ["--overwrite"]])
def test_an_input_is_never_replaced(here, arguments, existing):
    (here / "link.png").symlink_to("a.png")
    os.link("a.png", "twin.png")
    os.rename("blank.png", "drawing.svg")
    (here / "fix.json").write_text('{"schema": "sketch2shape-corrections/1", "objects": []}')
    before = {name: (here / name).read_bytes() for name in os.listdir(here)}
    with pytest.raises(UsageError, match="would replace an input"):
        command(*arguments, *existing)
    assert {name: (here / name).read_bytes() for name in os.listdir(here)} == before


def test_versions_are_beside_the_input(here):
    os.rename("a.png", "drawing.svg")
    before = (here / "drawing.svg").read_bytes()
    assert command("drawing.svg", "-o", "drawing.obj") == 0
    assert command("drawing.svg", "--format", "svg", "--versioned") == 0
    assert (here / "drawing.svg").read_bytes() == before
    assert b"<svg" in (here / "drawing.2.svg").read_bytes()


@pytest.mark.parametrize("picture", ["overlay", "stages", "preview", "html"])
def test_a_picture_is_of_the_format_that_its_name_promises(here, picture):
    with pytest.raises(UsageError, match="what is written is"):
        command("a.png", "-o", "b.obj", f"--{picture}", "c.jpg")


@pytest.mark.posix
def test_streams_as_outputs(here):
    assert command("a.png", "-o", "/dev/null") == 0
    assert command("a.png", "-o", "/dev/null", "--overwrite", "--format", "stl") == 0
    with open("b.txt", "wb") as file:
        assert command("a.png", "-o", f"/dev/fd/{file.fileno()}", "-o", "c.stl") == 0
    assert (here / "b.txt").read_bytes().count(b"\nv ") == 8
    for wrong in (["--json"], ["--format", "obj,stl"], ["--pages", "all"]):
        with pytest.raises(UsageError):
            command("a.png", "-o", "/dev/null", *wrong)
    assert files() == ["b.txt", "c.stl"]


def test_several_outputs_and_the_report_beside_each(here):
    assert command("a.png", "-o", "x/b.obj", "-o", "b.stl", "-o", "b.ply", "--json") == 0
    assert files("x") == ["b.json", "b.obj"]
    assert files() == ["b.json", "b.ply", "b.stl", "x"]


@pytest.mark.parametrize("out", ["new/", "new", "there"])
def test_a_folder_as_output(here, out):
    (here / "there").mkdir()
    assert command("a.png", "-o", out, "--format", "stl,off") == 0
    assert files(out) == ["a.off", "a.stl"]


def test_nothing_found(here, capsys):
    assert command("blank.png", "-o", "b.obj", "--json") == 5
    assert capsys.readouterr().err.startswith("blank.png: the picture is blank. Try: ")
    assert files() == ["b.json"]
    assert json.loads((here / "b.json").read_text())["status"] == "failed"


def test_a_line_says_what_was_found_and_written(here, capsys):
    assert command("a.png", "-o", "b.obj", "--json") == 0
    assert capsys.readouterr().err == "a.png: box, 40 x 30 x 9 px, confidence 0.90 -> b.obj, b.json\n"
    assert command("a.png", "-o", "c.obj", "--quiet") == 0
    assert command("blank.png", "-q") == 5
    assert capsys.readouterr().err.count("\n") == 1


def test_a_low_confidence_is_never_silent(here, capsys, monkeypatch):
    monkeypatch.setattr(stand_in, "CONFIDENCE", 0.44)
    assert command("a.png", "-o", "b.obj") == 0
    assert "a.png: please check it, confidence 0.44 is low. Try: --overlay" in capsys.readouterr().err


def test_the_least_confidence_is_handed_on():
    assert stage_options(parse(["a.png", "--min-confidence", "0.9"])) == {"min_confidence": 0.9}


def test_options_of_a_folder_work_for_one_picture(here):
    options = ["--report", "r.csv", "--contact-sheet", "c.png", "--index", "i.html", "--fail-fast", "--jobs", "2"]
    assert command("a.png", "-o", "o/b.obj", *options) == 0
    assert files("o") == ["b.obj"]
    assert os.path.exists("o/b.overlay.png")
    assert "a.png,ok,0," in (here / "r.csv").read_text()
    assert "o/b.obj" in (here / "i.html").read_text()
    assert Image.open("c.png").size[0] > 100
    assert command("blank.png", "-o", "o/n.obj", "--report", "n.jsonl") == 5
    assert json.loads((here / "n.jsonl").read_text())["exit_code"] == 5
    with pytest.raises(WriteError, match=r"r\.csv exists"):
        command("a.png", "-o", "o/c.obj", "--report", "r.csv")


def test_a_run_over_one_picture_goes_on_too(here):
    for _ in range(2):
        assert command("a.png", "-o", "o", "--resume") == 0
    assert files("o") == [".sketch2shape.jsonl", "a.obj"]
    with pytest.raises(UsageError, match="keeps its record"):
        command("a.png", "-o", "b.obj", "--resume")


def test_corrections_for_another_picture_are_refused_or_told(here, capsys):
    box = {"f1": [[2, 9], [20, 9], [20, 25], [2, 25]], "d": [9, -6]}
    (here / "many.json").write_text(json.dumps({"pictures": {"z.png": {"objects": [box]}}}))
    with pytest.raises(UsageError, match=r"many\.json corrects z\.png, not a\.png"):
        command("a.png", "--vertices", "many.json")
    (here / "one.json").write_text(json.dumps({"source": "x/z.png", "objects": [box]}))
    assert command("a.png", "--vertices", "one.json") == 0
    assert "one.json was made for x/z.png; it is used for a.png" in capsys.readouterr().err
    (here / "own.json").write_text(json.dumps({"source": "x/a.png", "objects": [box]}))
    assert command("a.png", "--vertices", "own.json", "--versioned") == 0
    assert "made for" not in capsys.readouterr().err


def test_the_report_of_a_single_picture_tells_the_time(here):
    command("a.png", "-o", "a.json")
    assert "read" in json.loads((here / "a.json").read_text())["timings_ms"]


class _Standard:
    """A standard stream over bytes."""

    def __init__(self, data=b""):
        self.buffer = io.BytesIO(data)


def test_standard_input_and_output(here, monkeypatch):
    out = _Standard()
    monkeypatch.setattr(sys, "stdin", _Standard((here / "a.png").read_bytes()))
    monkeypatch.setattr(sys, "stdout", out)
    assert command("-") == 0
    assert out.buffer.getvalue().count(b"\nv ") == 8
    assert files() == []


def test_the_report_on_standard_output(here, monkeypatch):
    out = _Standard()
    monkeypatch.setattr(sys, "stdout", out)
    assert command("blank.png", "-o", "-", "--format", "json") == 5
    assert json.loads(out.buffer.getvalue())["message"] == "the picture is blank"


def test_contradictions(here):
    for wrong in (["--json", "-o", "-"], ["-o", "a.obj", "--format", "stl"], ["-o", "-", "--pages", "all"]):
        with pytest.raises(UsageError):
            command("a.png", *wrong)


def test_dry_run_writes_nothing(here, capsys):
    assert command("a.png", "-o", "b.obj", "--dry-run") == 0
    assert capsys.readouterr().out == "a.png\tb.obj\n"
    assert files() == []


def test_limits_on_a_single_picture(here, capsys):
    for name, seconds in (("hang", "1"), ("hog", "60")):
        os.rename("a.png", f"{name}.png")
        assert command(f"{name}.png", "-o", "b.obj", "--timeout", seconds, "--max-memory", "300M") == 6
        os.rename(f"{name}.png", "a.png")
    assert command("a.png", "-o", "b.obj", "--timeout", "60") == 0
    printed = capsys.readouterr().err
    assert "not done after 1 s" in printed
    assert "not enough memory" in printed


def test_methods_are_handed_on_only_if_they_are_asked_for():
    assert stage_options(parse(["a.png"])) == {}
    asked = stage_options(parse(["a.png", "--connector", "tour", "--detector", "harris"]))
    assert asked == {"connector": "tour", "detector": "harris"}
