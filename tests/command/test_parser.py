"""Options and exit codes, as a shell sees them."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from sketch2shape import __version__
from sketch2shape.command.parser import main, parse

ROOT = Path(__file__).parents[2]


def shell(*arguments, **options):
    command = [sys.executable, "-m", "sketch2shape", *arguments]
    return subprocess.run(command, capture_output=True, timeout=60, check=False, **options)


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_and_version_import_nothing_heavy(option):
    code = (
        "import sys, sketch2shape.command.parser as c\n"
        f"try: c.main(['{option}'])\nexcept SystemExit: pass\n"
        "heavy = {'numpy', 'cv2', 'scipy', 'trimesh', 'PIL', 'skimage', 'rich', 'pebble', 'dataclasses'}\n"
        "print(sorted(heavy & set(sys.modules)), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "[]"
    assert (__version__ if option == "--version" else "exit codes") in done.stdout


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["--nonsense", "a.png"],
        ["a.png", "--jobs", "0"],
        ["a.png", "--timeout", "-1"],
        ["a.png", "--max-pixels", "many"],
        ["a.png", "--max-memory", "nan"],
        ["a.png", "--overwrite", "--versioned"],
        ["a.png", "-o", "a.xyz"],
        ["a.png", "--pages", "0"],
        ["a.png", "--format", "xyz"],
        ["a.png", "-o", "a.obj", "--format", "stl"],
        ["a.png", "-o", "a.obj", "-o", "a.obj", "-o", "./a.obj/../a.obj"][:5],
        ["-", "--json"],
        ["-", "-o", "-", "--format", "obj,stl"],
    ],
)
def test_usage_errors_are_one_line_and_exit_2(arguments, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    try:
        code = main(arguments)
    except SystemExit as stop:
        code = stop.code
    printed = capsys.readouterr()
    if arguments[-2:] == ["-o", "a.obj"]:  # the same output twice is the output once; the picture is missing
        assert code == 4
    else:
        assert code == 2
    assert printed.out == ""
    assert printed.err.count("\n") == 1
    assert "Try: " in printed.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("wrong", "right"),
    [("--overwite", "--overwrite"), ("--formt=obj", "--format"), ("--confidence", "--min-confidence")],
)
def test_the_option_that_was_meant_is_named(wrong, right, capsys):
    with pytest.raises(SystemExit):
        parse(["a.png", wrong])
    assert capsys.readouterr().err.endswith(f"Try: {right}\n")


def test_short_options_and_other_names_of_values():
    arguments = parse(["a.png", "-q", "-f", "stl", "--unit", "Inches", "--projection", "isometric"])
    assert (arguments.quiet, arguments.format) == (True, ["stl"])
    assert (arguments.unit, arguments.projection) == ("in", "axonometric")
    assert parse(["a.png", "--detector", "goodFeaturesToTrack"]).detector == "shi-tomasi"


def test_the_formats_listed_are_all_formats(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["a.png", "-o", "a.xyz"]) == 2
    listed = capsys.readouterr().err
    assert all(name in listed for name in ("obj", "step", "face.svg", "json", "overlay.png", "html"))
    assert main(["a.png", "--format", "objj"]) == 2
    assert capsys.readouterr().err.endswith("Try: --format obj\n")


@pytest.mark.parametrize("value", ["-0.1", "1.1", "nan", "high"])
def test_a_confidence_is_between_0_and_1(value):
    with pytest.raises(SystemExit):
        parse(["a.png", f"--min-confidence={value}"])


@pytest.mark.parametrize(
    ("words", "code"),
    [
        ("w.png -o w.obj 2>&-", 0),
        ("w.png -o w.obj >&- 2>&-", 0),
        ("w.png -o w.obj <&- >&- 2>&-", 0),
        ("two -o out <&- >&- 2>&-", 0),
        ("text.png 2>&-", 4),
        ("--nonsense 2>&-", 2),
        ("w.png -o - >&-", 7),
        ("- <&-", 4),
        ("w.png -o w.obj 2>/dev/full", 0),
    ],
)
@pytest.mark.posix
def test_closed_streams_change_neither_the_work_nor_the_exit_code(words, code, drawings, tmp_path):
    picture = (drawings / "clean_wire_oblique" / "000.png").read_bytes()
    (tmp_path / "two").mkdir()
    for name in ("w.png", "two/a.png", "two/b.png"):
        (tmp_path / name).write_bytes(picture)
    (tmp_path / "text.png").write_text("hello")
    command = f"{shlex.quote(sys.executable)} -m sketch2shape {words}"
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(["sh", "-c", command], cwd=tmp_path, timeout=120, env=environment, check=False)
    assert done.returncode == code
    made = sorted(str(p.relative_to(tmp_path)) for p in tmp_path.rglob("*.obj"))
    expected = [] if code else ["out/a.obj", "out/b.obj"] if words.startswith("two") else ["w.obj"]
    assert made == expected
    assert all((tmp_path / name).read_bytes().count(b"\nv ") == 8 for name in made)


def test_sizes():
    assert parse(["a", "--max-pixels", "20M"]).max_pixels == 20_000_000
    assert parse(["a", "--max-memory", "1.5G"]).max_memory == 3 * 2**29
    assert parse(["a", "--max-bytes", "10KiB"]).max_bytes == 10 * 2**10
    assert parse(["a", "--max-bytes", "77"]).max_bytes == 77


def test_options_may_stand_between_inputs():
    assert parse(["a", "-o", "out", "b"]).inputs == ["a", "b"]


@pytest.mark.parametrize(
    ("name", "content"), [("text.png", b"hello"), ("empty.png", b""), ("cut.png", b"\x89PNG\r\n\x1a\n\0")]
)
def test_bad_files_end_in_one_line_and_their_code(name, content, tmp_path):
    (tmp_path / name).write_bytes(content)
    done = shell(name, "-o", "a.obj", cwd=tmp_path)
    assert done.returncode == 4
    assert done.stdout == b""
    assert done.stderr.startswith(name.encode() + b": ")
    assert done.stderr.count(b"\n") == 1
    assert b"Try: " in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == [name]


def test_missing_file_and_empty_folder(tmp_path):
    assert shell("nothing.png", cwd=tmp_path).returncode == 4
    assert shell(".", cwd=tmp_path).returncode == 4


def test_names_with_leading_dashes(tmp_path):
    (tmp_path / "-x.png").write_bytes(b"text")
    done = shell("--", "-x.png", cwd=tmp_path)
    assert (done.returncode, done.stderr[:7]) == (4, b"./-x.pn")


def test_an_unforeseen_error_is_one_line_and_exit_1(monkeypatch, capsys):
    monkeypatch.setattr("sketch2shape.command.run.run", lambda *_: 1 / 0)
    assert main(["a.png"]) == 1
    assert "internal error (ZeroDivisionError" in capsys.readouterr().err
    with pytest.raises(ZeroDivisionError):
        main(["a.png", "--debug"])


@pytest.mark.posix
def test_interrupted(monkeypatch, capsys):
    def stop(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("sketch2shape.command.run.run", stop)
    assert main(["a.png"]) == 130
    assert capsys.readouterr().err == "sketch2shape: interrupted\n"


def test_the_command_starts_no_threads_for_small_matrices(monkeypatch):
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    assert main(["nothing.png"]) == 4
    assert os.environ["OPENBLAS_NUM_THREADS"] == "1"
    assert os.environ["OMP_NUM_THREADS"] == "3"  # whoever asks for more gets it
