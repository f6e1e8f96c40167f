"""One input from start to end."""

from __future__ import annotations

import hashlib
import io
import json
import os
from dataclasses import replace
from importlib import import_module

import numpy as np
import pytest
import stand_in
from PIL import Image

from sketch2shape.conversion.convert import Output, Settings, Task, as_known, convert, failure
from sketch2shape.errors import CrashError, LimitError, NoObjectError
from sketch2shape.model import Answer
from sketch2shape.reading.limits import Limits

PIPELINE = import_module("sketch2shape.pipeline")


@pytest.fixture(autouse=True)
def _stand_in(monkeypatch):
    monkeypatch.setattr(PIPELINE, "reconstruct", stand_in.reconstruct)


def png(value=0, size=(40, 30)):
    out = io.BytesIO()
    Image.new("L", size, value).save(out, "PNG")
    return out.getvalue()


@pytest.fixture
def task(tmp_path):
    path = tmp_path / "a.png"
    path.write_bytes(png())
    outputs = (Output("json", str(tmp_path / "a.json")), Output("obj", str(tmp_path / "a.obj")))
    return Task(str(path), "a.png", outputs)


def test_a_good_picture_gives_mesh_and_report(task, tmp_path):
    outcome = convert(task)
    assert (outcome.status, outcome.exit_code, outcome.objects, outcome.confidence) == ("ok", 0, 1, 0.9)
    assert outcome.digest == hashlib.sha256(png()).hexdigest()
    for path, digest in outcome.written.items():
        with open(path, "rb") as file:
            assert hashlib.sha256(file.read()).hexdigest() == digest
    data = json.loads((tmp_path / "a.json").read_text())
    assert (data["source"], data["width"], data["status"], data["timings_ms"]) == ("a.png", 40, "ok", {})
    assert (tmp_path / "a.obj").read_text().count("\nv ") == 8


def test_timings_only_where_asked_for(task, tmp_path):
    convert(replace(task, settings=Settings(timings=True)))
    assert set(json.loads((tmp_path / "a.json").read_text())["timings_ms"]) == {"read", "ink"}


def test_nothing_found_still_gives_a_report(task, tmp_path):
    outcome = convert(replace(task, data=png(255)))
    assert (outcome.exit_code, outcome.message) == (5, "the picture is blank")
    data = json.loads((tmp_path / "a.json").read_text())
    assert (data["status"], data["width"], data["objects"]) == ("failed", 40, [])
    assert not (tmp_path / "a.obj").exists()


def test_unreadable_and_too_large(task, tmp_path):
    assert convert(replace(task, data=b"text")).exit_code == 4
    assert json.loads((tmp_path / "a.json").read_text())["width"] is None
    assert convert(replace(task, outputs=(), settings=Settings(Limits(max_pixels=5)))).exit_code == 6


def test_an_output_that_exists_is_kept_and_told(task, tmp_path):
    (tmp_path / "a.obj").write_text("mine")
    outcome = convert(task)
    assert outcome.exit_code == 7
    assert "exists already" in outcome.message
    assert (tmp_path / "a.obj").read_text() == "mine"
    assert convert(replace(task, overwrite=True)).exit_code == 0


def test_a_bug_is_told_as_one_and_never_raised(task, monkeypatch):
    def bug(*_, **__):
        raise KeyError("oops")

    monkeypatch.setattr(PIPELINE, "reconstruct", bug)
    outcome = convert(task)
    assert outcome.exit_code == 1
    assert "KeyError" in outcome.message


def test_nothing_is_written_if_one_format_cannot_be_encoded(task, tmp_path, monkeypatch):
    monkeypatch.setattr("sketch2shape.conversion.convert.encode_product", lambda *_: 1 / 0)
    convert(replace(task, outputs=(Output("obj", str(tmp_path / "a.obj")),)))
    assert os.listdir(tmp_path) == ["a.png"]


def test_all_pages(task, tmp_path):
    out = io.BytesIO()
    pages = [Image.new("L", (40, 30), v) for v in (0, 255, 0)]
    pages[0].save(out, "TIFF", save_all=True, append_images=pages[1:])
    outcome = convert(replace(task, data=out.getvalue(), settings=Settings(page=None)))
    assert (outcome.exit_code, outcome.objects) == (0, 2)
    names = sorted(os.path.basename(path) for path in outcome.written)
    assert names == ["a.json", "a.obj", "a.p2.json", "a.p3.json", "a.p3.obj"]
    assert convert(replace(task, data=out.getvalue(), outputs=(), settings=Settings(page=1))).exit_code == 5


def test_errors_of_others_are_sorted():
    assert isinstance(as_known(MemoryError()), LimitError)
    assert isinstance(as_known(RuntimeError("OpenCV: Insufficient memory")), LimitError)
    assert isinstance(as_known(RuntimeError("x\ny")), CrashError)
    known = NoObjectError("x", remedy="y")
    assert as_known(known) is known
    assert failure(Task("a", "b", ()), known).remedy == "y"


def test_the_input_is_not_touched(task):
    before = os.stat(task.source)
    convert(task)
    after = os.stat(task.source)
    assert (before.st_mtime_ns, before.st_size) == (after.st_mtime_ns, after.st_size)
    assert np.array_equal(np.frombuffer(png(), np.uint8), np.fromfile(task.source, np.uint8))


def test_a_guess_is_drawn_where_an_overlay_is_asked_for(tmp_path, monkeypatch):
    result = stand_in.reconstruct(np.zeros((30, 40), np.uint8))

    def refuse(*_, **__):
        error = NoObjectError("not sure")
        error.guess = Answer(result.objects, result.solids, result.picture, error=error)
        raise error

    monkeypatch.setattr(PIPELINE, "reconstruct", refuse)
    outputs = tuple(Output(product, str(tmp_path / f"a.{product}")) for product in ("obj", "overlay", "json"))
    outcome = convert(Task("a.png", "a.png", outputs, data=png()))
    assert outcome.exit_code == 5
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.json", "a.overlay"]
    assert (tmp_path / "a.overlay").read_bytes().startswith(b"\x89PNG")
