"""The index and the contact sheet of a batch, and the pictures of one input, as the command writes them."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from sketch2shape.command.parser import main
from sketch2shape.ui.examples import example_png


@pytest.fixture
def drawings(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "in"
    (folder / "sub").mkdir(parents=True)
    (folder / "sub" / "steps.png").write_bytes(example_png("wireframe"))
    cv2.imwrite(str(folder / "blank.png"), np.full((90, 120, 3), 255, np.uint8))
    return folder


def test_an_index_and_a_contact_sheet_of_a_folder(drawings, tmp_path):
    arguments = ["in", "-o", "out", "--index", "out/index.html", "--contact-sheet", "out/all.png", "--quiet"]
    assert main(arguments) == 3  # one of the two is blank
    page = (tmp_path / "out" / "index.html").read_text()
    assert "2 pictures: 1 done, 1 failed" in page
    assert 'href="sub/steps.obj"' in page
    assert "no ink was found" in page
    sheet = (tmp_path / "out" / "all.png").read_bytes()
    assert cv2.imdecode(np.frombuffer(sheet, np.uint8), 1).shape[0] > 200
    assert main([*arguments, "--overwrite"]) == 3
    assert (tmp_path / "out" / "all.png").read_bytes() == sheet
    assert (tmp_path / "out" / "index.html").read_text() == page


def test_pictures_of_one_input_are_the_same_each_time(drawings, tmp_path):
    for run in ("a", "b"):
        pictures = [f"--{kind}={run}.{kind}.{end}" for kind, end in KINDS.items()]
        assert main([str(drawings / "sub" / "steps.png"), "-o", f"{run}.obj", *pictures]) == 0
    for kind, end in KINDS.items():
        first, second = ((tmp_path / f"{run}.{kind}.{end}").read_bytes() for run in ("a", "b"))
        assert first == second
        assert len(first) > 1000


KINDS = {"overlay": "png", "stages": "png", "preview": "png", "html": "html"}


@pytest.mark.parametrize(
    "arguments", [["--overlay", "x.png"], ["--index", "x.txt"], ["--contact-sheet", "x.jpg"], ["--vertices", "no.json"]]
)
def test_what_cannot_be_meant_is_said_before_any_work(drawings, arguments, capsys):
    assert main(["in", "-o", "out", *arguments]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert not (drawings.parent / "out" / "sub").exists()


def test_a_corrected_report_is_taken_by_the_command(drawings, tmp_path):
    import json

    picture = str(drawings / "sub" / "steps.png")
    assert main([picture, "-o", "a.obj", "--json"]) == 0
    report = json.loads((tmp_path / "a.json").read_text())
    report["objects"][0]["f1"] = [[round(x + 30, 3), y] for x, y in report["objects"][0]["f1"]]
    (tmp_path / "fix.json").write_text(json.dumps(report))
    assert main([picture, "-o", "b.obj", "--json", "--vertices", "fix.json"]) == 0
    again = json.loads((tmp_path / "b.json").read_text())
    assert again["objects"][0]["f1"] == report["objects"][0]["f1"]
    assert again["objects"][0]["confidence"] == 1
    assert (tmp_path / "a.obj").read_bytes() != (tmp_path / "b.obj").read_bytes()
