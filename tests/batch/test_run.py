"""A whole batch, with faults, stops and resumption."""

from __future__ import annotations

import csv
import hashlib
import json
import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import stand_in
from PIL import Image

from sketch2shape.batch.manifest import NAME
from sketch2shape.command.parser import parse
from sketch2shape.command.run import run
from sketch2shape.errors import UsageError, WriteError
from sketch2shape.pictures import folder

ROOT = Path(__file__).parents[2]
_KINDS = ("clean_wire_oblique", "clean_removed_axono", "taper_wire")


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for i in range(6):
        picture(f"in/{i}.png", 10 * i)
    return tmp_path


def picture(path, value=0):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    Image.new("L", (40, 30), value).save(path)


def command(*arguments):
    return run(parse(arguments), stand_in.work)


def snapshot(folder):
    """Every file below a folder with the hash of its bytes."""
    found = {}
    for root, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(root, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = hashlib.sha256(file.read()).hexdigest()
    return found


@pytest.mark.posix
def test_faults_are_named_and_the_rest_is_done(here, capsys):
    for fault in ("crash", "hang", "hog", "bug", "blank"):
        picture(f"in/{fault}.png", 255 if fault == "blank" else 0)
    os.mkfifo("in/pipe.png")
    os.symlink("loop.png", "in/loop.png")
    before = snapshot_of_files("in")
    code = command(
        "in", "-o", "out", "--json", "--jobs", "2", "--timeout", "10", "--max-memory", "300M", "--report", "r.jsonl"
    )
    assert code == 3
    rows = {row["name"]: row for row in map(json.loads, (here / "r.jsonl").read_text().splitlines())}
    codes = {name.partition(".")[0]: row["exit_code"] for name, row in rows.items()}
    assert codes == {
        **{str(i): 0 for i in range(6)},
        **{"crash": 1, "bug": 1, "hang": 6, "hog": 6, "blank": 5, "pipe": 4, "loop": 4},
    }
    assert list(rows) == sorted(rows)
    assert all(os.path.exists(f"out/{i}.obj") for i in range(6))
    assert all(os.path.exists("out/" + name.replace(".png", ".json")) for name in rows)
    printed = capsys.readouterr()
    assert printed.out == ""
    assert "in/crash.png: the worker died (SIGSEGV). Try: " in printed.err
    assert " 6  done (0)" in printed.err
    assert snapshot_of_files("in") == before


def snapshot_of_files(folder):
    return {n: os.stat(os.path.join(folder, n), follow_symlinks=False).st_mtime_ns for n in os.listdir(folder)}


def test_the_same_bytes_for_any_number_of_jobs_and_after_a_stop(here):
    assert command("in", "-o", "one", "--json", "--jobs", "1") == 0
    assert command("in", "-o", "two", "--json", "--jobs", "2") == 0
    assert snapshot("one") == snapshot("two")
    picture("in/bug.png")
    assert command("in", "-o", "stopped", "--json", "--fail-fast", "--jobs", "1") == 3
    os.unlink("in/bug.png")
    for name in ("bug.json", "5.obj"):
        if os.path.exists(f"stopped/{name}"):
            os.unlink(f"stopped/{name}")
    assert command("in", "-o", "stopped", "--json", "--resume") == 0
    assert snapshot("stopped") == snapshot("one")


def test_the_same_bytes_for_any_hash_seed(drawings, tmp_path):
    for seed in ("1", "2"):
        call = [sys.executable, "-m", "sketch2shape", *(str(drawings / f"{kind}/000.png") for kind in _KINDS)]
        call += ["-o", str(tmp_path / seed), "--json", "--quiet", "--jobs", seed]
        subprocess.run(call, env={**os.environ, "PYTHONHASHSEED": seed}, cwd=ROOT, check=True)
    assert len(snapshot(tmp_path / "1")) == 7
    assert snapshot(tmp_path / "1") == snapshot(tmp_path / "2")


def test_resume_works_off_what_is_left_only(here):
    command("in", "-o", "out")
    os.unlink("out/3.obj")
    picture("in/new.png")
    stamps = snapshot_of_files("out")
    assert command("in", "-o", "out", "--resume") == 0
    after = snapshot_of_files("out")
    assert {n for n in after if after[n] != stamps.get(n)} == {"3.obj", "new.obj", NAME}


def test_resume_does_not_replace_files_of_others(here):
    command("in", "-o", "out")
    picture("in/new.png")
    (here / "out" / "new.obj").write_text("mine")
    with pytest.raises(WriteError, match=r"new\.obj exists already"):
        command("in", "-o", "out", "--resume")
    with pytest.raises(UsageError, match="other options"):
        command("in", "-o", "out", "--resume", "--format", "stl")


def test_existing_outputs_stop_the_run_before_it_starts(here):
    command("in", "-o", "out")
    before = snapshot("out")
    with pytest.raises(WriteError):
        command("in", "-o", "out")
    assert snapshot("out") == before
    assert command("in", "-o", "out", "--overwrite") == 0
    assert snapshot("out") == before
    assert command("in", "-o", "out", "--versioned") == 0
    assert os.path.exists("out/3.2.obj")


@pytest.mark.parametrize("option", ["--contact-sheet", "--index", "--report"])
def test_pages_and_tables_replace_no_input_and_no_file(here, option):
    ending = {"--contact-sheet": ".png", "--index": ".html", "--report": ".csv"}[option]
    (here / f"mine{ending}").write_text("mine")
    with pytest.raises(WriteError, match="exists already"):
        command("in", "-o", "out", option, f"mine{ending}")
    assert (here / f"mine{ending}").read_text() == "mine"
    os.rename(f"mine{ending}", f"in/mine{ending}")
    inputs = ["in", f"in/mine{ending}"]
    with pytest.raises(UsageError, match=r"would replace an input|by its name"):
        command(*inputs, "-o", "out", option, f"in/mine{ending}", "--overwrite")
    assert not os.path.exists("out")


def test_two_formats_of_one_ending_are_two_runs(here):
    for existing in ([], ["--overwrite"]):
        with pytest.raises(UsageError, match=r"stl and stl-ascii would both be written to NAME\.stl"):
            command("in", "-o", "out", "--format", "stl,stl-ascii", *existing)
    assert not os.path.exists("out")


def test_in_place_twice(here):
    assert command("in") == 0
    assert os.path.exists("in/0.obj")
    assert command("in", "--resume") == 0


def test_fail_fast_leaves_the_rest(here):
    for i in range(30):
        picture(f"in/z{i:02}.png")
    picture("in/00bug.png")
    assert command("in", "-o", "out", "--fail-fast", "--jobs", "1", "--report", "r.csv") == 3
    with open("r.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 37
    assert sum(row["exit_code"] == "130" for row in rows) > 20


def test_dry_run_and_contradictions(here, capsys):
    assert command("in", "-o", "out", "--dry-run") == 0
    assert capsys.readouterr().out.splitlines()[0] == "in/0.png\tout/0.obj"
    assert not os.path.exists("out")
    (here / "file").write_text("")
    for wrong in (["-o", "-"], ["-o", "a", "-o", "b"], ["-o", "file"], ["-o", "new.obj"], ["--report", "x.txt"]):
        with pytest.raises(UsageError):
            command("in", *wrong)


def test_quiet_tells_failures_only(here, capsys):
    picture("in/blank.png", 255)
    command("in", "-o", "out", "--quiet")
    assert capsys.readouterr().err.count("\n") == 1


def test_corrections_for_other_pictures_are_told(here, capsys):
    entry = {"objects": [{"projection": "oblique"}]}
    (here / "c.json").write_text(json.dumps({"pictures": {"0.png": entry, "z.png": entry}}))
    assert command("in", "-o", "out", "--vertices", "c.json") == 0
    assert "c.json corrects z.png too: no input is called so" in capsys.readouterr().err
    (here / "c.json").write_text(json.dumps({"pictures": {"y.png": entry, "z.png": entry}}))
    with pytest.raises(UsageError, match=r"corrects y\.png, z\.png, not 0\.png, 1\.png, 2\.png and 3 more"):
        command("in", "-o", "new", "--vertices", "c.json")


def test_advice_is_given_once(here, capsys):
    for i in range(3):
        picture(f"in/blank{i}.png", 255)
    assert command("in", "-o", "out") == 3
    lines = [
        line for line in capsys.readouterr().err.splitlines() if "blank." in line or "the picture is blank" in line
    ]
    assert sorted(line.rpartition("Try: ")[2][:8] for line in lines) == ["a drawin", "as above", "as above"]


@pytest.mark.posix
def test_names_that_are_no_utf8_everywhere(here):
    name = os.fsdecode(b"caf\xe9.png")
    picture(f"in/{name}")
    pages = ["--index", "i.html", "--contact-sheet", "c.png", "--report", "r.csv"]
    assert command("in", "-o", "out", "--format", "obj,html,json", *pages) == 0
    assert os.path.exists(b"out/caf\xe9.obj")
    assert "out/caf%E9.obj" in (here / "i.html").read_text("utf-8")
    assert command(f"in/{name}", "-o", "one", "--html", "one.html", "--index", "j.html") == 0


def test_a_long_folder_takes_several_contact_sheets_and_replaces_none(here, monkeypatch):
    monkeypatch.setattr(folder.contact_sheets, "__defaults__", (5, 4))
    monkeypatch.setattr(folder.count_sheets, "__defaults__", (4,))
    (here / "c.p2.png").write_text("mine")
    with pytest.raises(WriteError, match=r"c\.p2\.png exists already"):
        command("in", "-o", "out", "--contact-sheet", "c.png")
    assert command("in", "-o", "out", "--contact-sheet", "d.png") == 0
    assert os.path.exists("d.p2.png")
    assert not os.path.exists("d.p3.png")


@pytest.mark.parametrize(
    ("machine", "cause"),
    [
        ("export TMPDIR=$PWD/" + "x" * 100 + "; mkdir $TMPDIR", None),  # too long for the socket of a fork server
        ("ulimit -n 16", "Too many open files"),
        ("mkdir gone; cd gone; rmdir ../gone", "No such file or directory"),
    ],
)
@pytest.mark.posix
def test_machines_on_which_workers_cannot_be_started_as_usual(machine, cause, drawings, tmp_path):
    pictures = " ".join(shlex.quote(str(drawings / kind / "000.png")) for kind in _KINDS[:2])
    command = f"{machine} && {shlex.quote(sys.executable)} -m sketch2shape {pictures} -o {tmp_path}/out --jobs 1"
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        ["sh", "-c", command], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    assert len(list((tmp_path / "out").rglob("*.obj"))) == 2
    assert "Traceback" not in done.stderr
    told = [line for line in done.stderr.splitlines() if "no worker process can be started" in line]
    assert len(told) == (cause is not None)
    assert not cause or cause in told[0]


_RUN = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever runs the tests in the background has it ignored
sys.path.insert(0, sys.argv.pop(1))
import stand_in
from sketch2shape.command.parser import parse
from sketch2shape.command.run import run
sys.exit(run(parse(sys.argv[1:]), stand_in.work))
"""


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP", "SIGKILL"])
@pytest.mark.posix
def test_a_stopped_batch_goes_on_to_the_same_bytes(here, name):
    number = getattr(signal, name)
    picture("in/gate.png")
    (here / "open").touch()
    assert command("in", "-o", "whole") == 0
    (here / "open").unlink()
    (here / "run.py").write_text(_RUN)
    call = [sys.executable, "run.py", os.path.dirname(stand_in.__file__), "in", "-o", "out", "--jobs", "1"]
    with subprocess.Popen(call, stderr=subprocess.PIPE, text=True) as batch:
        while batch.poll() is None and not os.path.exists("out/5.obj"):
            time.sleep(0.01)
        batch.send_signal(number)
        printed = batch.stderr.read()
    assert batch.returncode == (-9 if number == signal.SIGKILL else 130)
    assert number == signal.SIGKILL or "interrupted. Try: --resume" in printed
    assert not os.path.exists("out/gate.obj")
    assert "Traceback" not in printed
    (here / "open").touch()
    assert command("in", "-o", "out", "--resume") == 0
    assert snapshot("out") == snapshot("whole")
