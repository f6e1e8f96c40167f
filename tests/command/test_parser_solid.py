"""The options of the command that say how to lift and what to write."""

import argparse

import pytest

from sketch2shape.command.parser import parse
from sketch2shape.command.run import mesh_options, stage_options
from sketch2shape.errors import UsageError
from sketch2shape.lifting import LiftOptions


def test_no_option_asks_for_nothing():
    arguments = parse(["a.png"])
    assert stage_options(arguments) == {}
    assert mesh_options(arguments) == {}


def test_every_option_reaches_the_lifting():
    words = "a.png --projection oblique --width 40mm --height 3cm --depth 1in --depth-ratio 0.7 --unit mm --up z"
    arguments = parse([*words.split(), "--necker", "--no-beautify", "--ngons"])
    assert stage_options(arguments)["lift"] == LiftOptions(
        projection="oblique",
        width="40mm",
        height="3cm",
        depth="1in",
        depth_ratio=0.7,
        unit="mm",
        up="z",
        necker=True,
        beautify=False,
    )
    assert mesh_options(arguments) == {"ngons": True}


def test_a_tolerance_reaches_the_meshes_and_has_to_be_a_length():
    assert mesh_options(parse(["a.png", "--tolerance", "0.1mm"])) == {"tolerance": "0.1mm"}
    with pytest.raises(UsageError, match="tolerance"):
        mesh_options(parse(["a.png", "--tolerance", "fine"]))


def test_another_reading_a_fit_and_the_pictures_frame_can_be_asked_for():
    arguments = parse(["a.png", "--reading", "2", "--fit", "50mm", "--up", "camera"])
    assert stage_options(arguments)["lift"] == LiftOptions(reading=2, fit="50mm", up="camera")


@pytest.mark.parametrize("words", [["--depth", "banana"], ["--width=-3mm"], ["--depth-ratio", "0"]])
def test_sizes_that_make_no_sense_are_usage_errors(words):
    with pytest.raises(UsageError):
        stage_options(parse(["a.png", *words]))


def test_unknown_words_are_refused_by_the_parser():
    with pytest.raises(SystemExit) as exit_:
        parse(["a.png", "--projection", "fisheye"])
    assert exit_.value.code == 2
    assert isinstance(parse(["a.png"]), argparse.Namespace)


def test_one_report_stands_beside_outputs_of_one_name(tmp_path, monkeypatch, capsys):
    from sketch2shape.command.parser import main

    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.png").write_bytes(b"")
    assert main(["a.png", "-o", "b.obj", "-o", "b.face.svg", "-o", "b.stp", "--json", "--dry-run"]) == 0
    assert [line.split("\t")[1] for line in capsys.readouterr().out.splitlines()] == [
        "b.obj",
        "b.face.svg",
        "b.stp",
        "b.json",
    ]
