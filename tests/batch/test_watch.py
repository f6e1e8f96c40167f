"""Pictures converted as they appear."""

from __future__ import annotations

import os

import pytest
import stand_in
from PIL import Image

from sketch2shape.batch.watch import watch
from sketch2shape.command.parser import parse
from sketch2shape.command.run import run, settings_of
from sketch2shape.errors import UsageError


class _EnoughError(Exception):
    pass


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    os.mkdir("in")
    return tmp_path


def watched(*steps, out=("-o", "out")):
    """Watch the folder; before each further look one of the steps is taken."""
    left = list(steps)

    def pause():
        if not left:
            raise _EnoughError
        left.pop(0)()

    arguments = parse(["in", *out, "--jobs", "1"])
    with pytest.raises(_EnoughError):
        watch(arguments, settings_of(arguments), stand_in.work, pause=pause)


def picture(name, value=0):
    return lambda: Image.new("L", (40, 30), value).save(f"in/{name}.png")


def nothing():
    pass


def test_pictures_are_converted_as_they_come_and_when_they_change(here):
    stamps = []

    def look():
        stamps.append({name: os.stat(f"out/{name}").st_mtime_ns for name in sorted(os.listdir("out"))})

    watched(picture("a"), nothing, look, picture("b"), nothing, look, picture("a", 9), nothing, look)
    assert [[name for name in seen if name.endswith(".obj")] for seen in stamps] == [
        ["a.obj"],
        ["a.obj", "b.obj"],
        ["a.obj", "b.obj"],
    ]
    assert stamps[0]["a.obj"] == stamps[1]["a.obj"] != stamps[2]["a.obj"]
    assert stamps[1]["b.obj"] == stamps[2]["b.obj"]


def test_a_picture_that_is_still_being_written_waits(here):
    def grow():
        with open("in/a.png", "ab") as file:
            file.write(b"more")

    watched(picture("a"), grow, grow)
    assert not os.path.exists("out")


def test_what_it_writes_beside_the_inputs_is_no_input(here):
    options = ("--format", "obj,svg,overlay")
    watched(picture("a"), nothing, nothing, nothing, nothing, out=options)
    assert sorted(n for n in os.listdir("in") if n[0] != ".") == ["a.obj", "a.overlay.png", "a.png", "a.svg"]


def test_only_folders_are_watched(here):
    picture("a")()
    with pytest.raises(UsageError, match="folders"):
        run(parse(["in/a.png", "--watch"]), stand_in.work)
