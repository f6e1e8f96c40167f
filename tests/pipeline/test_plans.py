"""Programs and plans from Python and from the command: options reach them, and what was assumed is said."""

from __future__ import annotations

import pytest

import sketch2shape as s2s
from sketch2shape.command import main
from sketch2shape.errors import UsageError


@pytest.fixture(scope="module")
def house(drawings):
    return drawings / "hand_removed/000.png"


@pytest.fixture(scope="module")
def result(house):
    return s2s.reconstruct(house, lift={"width": "60mm"})


def test_results_and_solids_export_them(result, tmp_path):
    for solid in (result, result.solids[0]):
        assert b"build123d" in solid.export(tmp_path / "a.py").read_bytes()
        assert b"cadquery" in solid.export(tmp_path / "a.py", format="cadquery").read_bytes()
        assert b'width="215.9mm"' in solid.export(tmp_path / "a.net.svg", paper="letter").read_bytes()
        assert b"first-angle" in solid.export(tmp_path / "a.views.svg", angle="first").read_bytes()
        assert solid.export(tmp_path / "a.worksheet.pdf").read_bytes().startswith(b"%PDF")
        with pytest.raises(UsageError, match="a5"):
            solid.export(tmp_path / "b.net.svg", paper="a5")


def test_the_same_result_gives_the_same_bytes(result, house, tmp_path):
    again = s2s.reconstruct(house, lift={"width": "60mm"})
    for name in ("a.scad", "a.py", "a.net.pdf", "a.views.dxf", "a.worksheet.pdf"):
        assert result.export(tmp_path / name).read_bytes() == again.export(tmp_path / f"b.{name}").read_bytes()


def test_the_command_writes_them_and_says_what_it_assumed(house, tmp_path, capsys):
    names = [str(tmp_path / name) for name in ("a.scad", "a.net.pdf", "a.views.svg")]
    assert main([str(house), *(word for name in names for word in ("-o", name)), "--paper", "Letter"]) == 0
    said = capsys.readouterr().err
    assert said.count("no real size is known") == 2  # the net and the views have scales of their own
    assert b'width="279.4mm"' in (tmp_path / "a.views.svg").read_bytes()
    assert main([str(house), "-o", str(tmp_path / "b.net.pdf"), "--width", "60mm"]) == 0
    assert "no real size" not in capsys.readouterr().err


def test_a_format_chooses_among_those_of_the_same_ending(house, tmp_path, capsys):
    assert main([str(house), "-o", str(tmp_path / "a.py"), "--format", "cadquery"]) == 0
    assert b"import cadquery" in (tmp_path / "a.py").read_bytes()
    assert main([str(house), "-o", str(tmp_path) + "/", "--format", "build123d,cadquery"]) == 2
    assert "the same name" in capsys.readouterr().err


@pytest.mark.parametrize("option", [["--paper", "letter"], ["--angle", "first"]])
def test_options_without_effect_are_refused(house, tmp_path, capsys, option):
    assert main([str(house), "-o", str(tmp_path / "a.stl"), *option]) == 2
    assert "has no effect" in capsys.readouterr().err


def test_compound_endings_are_not_confused(house, tmp_path):
    for name in ("a.face.svg", "a.net.svg", "a.views.svg", "a.svg"):
        assert main([str(house), "-o", str(tmp_path / name), "--width", "60mm"]) == 0
    texts = [(tmp_path / name).read_bytes() for name in ("a.face.svg", "a.net.svg", "a.views.svg", "a.svg")]
    assert [b"face_1" in t for t in texts] == [True, False, False, False]
    assert [b'id="fold"' in t for t in texts] == [False, True, False, False]
    assert [b'id="center"' in t for t in texts] == [False, False, True, False]


def test_a_folder_of_nets(drawings, tmp_path):
    folder = tmp_path / "in"
    folder.mkdir()
    for name in ("clean_wire_axono/000.png", "hand_removed/000.png"):
        (folder / name.replace("/", "_")).write_bytes((drawings / name).read_bytes())
    out = tmp_path / "out"
    assert main([str(folder), "-o", str(out), "--format", "net.pdf,scad", "--jobs", "1", "-q"]) == 0
    assert sorted(p.name for p in out.glob("[!.]*")) == [
        "clean_wire_axono_000.net.pdf",
        "clean_wire_axono_000.scad",
        "hand_removed_000.net.pdf",
        "hand_removed_000.scad",
    ]
