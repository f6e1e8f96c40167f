"""A batch on a Dask scheduler with two workers, one of which is killed on the way."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
import stand_in
from PIL import Image

from sketch2shape.batch import cluster
from sketch2shape.command.parser import parse
from sketch2shape.command.run import run
from sketch2shape.errors import MissingPackageError, UsageError

pytest.importorskip("distributed")

ROOT = Path(__file__).parents[2]


@pytest.fixture
def scheduler(tmp_path):
    """Address of a scheduler, and its two workers."""
    note = tmp_path / "scheduler.json"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.path.dirname(stand_in.__file__), str(ROOT)])}
    common = ["--scheduler-file", str(note), "--no-dashboard"]
    quiet = {"env": environment, "cwd": tmp_path, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    dask = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0"]
    processes = [subprocess.Popen([*dask, *common], **quiet)]
    worker = [sys.executable, "-m", "distributed.cli.dask_worker", "--nthreads", "1", "--no-nanny"]
    processes += [subprocess.Popen([*worker, *common], **quiet) for _ in range(2)]
    deadline = time.monotonic() + 120
    while not note.exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    yield json.loads(note.read_text())["address"], processes[1:]
    for process in processes:
        process.kill()
        process.wait()


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    os.mkdir("in")
    for i in range(20):
        Image.new("L", (40, 30), 255 if i == 7 else 0).save(f"in/slow{i:02}.png")
    return tmp_path


@pytest.mark.posix
def test_a_killed_worker_costs_nothing(here, scheduler):
    address, workers = scheduler

    over = threading.Event()

    def kill_one():
        while not os.path.exists("out/slow02.obj") and not over.wait(0.02):
            pass
        workers[0].send_signal(signal.SIGKILL)

    killer = threading.Thread(target=kill_one)
    killer.start()
    try:
        assert run(parse(["in", "-o", "out", "--json", "--scheduler", address]), stand_in.work) == 3
        assert os.path.exists("out/slow02.obj")
    finally:
        over.set()
        killer.join()
    assert run(parse(["in", "-o", "alone", "--json", "--jobs", "2"]), stand_in.work) == 3
    assert contents("out") == contents("alone")
    assert len(contents("out")) == 40


@pytest.fixture
def ended(monkeypatch):
    """Set once the watchdog ends the process, which here it only says."""
    said = threading.Event()

    monkeypatch.setattr(os, "_exit", lambda _code: said.set())
    return said


def test_a_task_that_computes_too_long_ends_its_worker(ended):
    def compute(_task):
        begin = time.monotonic()
        while not ended.is_set() and time.monotonic() - begin < 60:
            pass

    cluster._watched(compute, None, 0.05)
    assert ended.is_set()


def test_and_one_that_waits_only_after_a_few_times_that(ended, monkeypatch):
    monkeypatch.setattr(cluster, "WAITING", 1e6)
    cluster._watched(lambda _task: time.sleep(0.3), None, 0.1)
    assert not ended.is_set()
    monkeypatch.setattr(cluster, "WAITING", 0.1)
    cluster._watched(lambda _task: ended.wait(60), None, 1.0)
    assert ended.is_set()


def test_where_threads_have_no_clock_that_of_the_wall_counts(ended, monkeypatch):
    monkeypatch.delattr(time, "pthread_getcpuclockid", raising=False)
    cluster._watched(lambda _task: ended.wait(60), None, 0.05)
    assert ended.is_set()


def contents(folder):
    return {name: open(os.path.join(folder, name), "rb").read() for name in os.listdir(folder)}


def test_no_scheduler_and_no_package(here, monkeypatch):
    monkeypatch.setattr("sketch2shape.batch.cluster._PATIENCE", 1)
    with pytest.raises(UsageError, match="no Dask scheduler"):
        run(parse(["in", "-o", "out", "--scheduler", "tcp://127.0.0.1:9"]), stand_in.work)
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(MissingPackageError, match="distributed"):
        run(parse(["in", "-o", "out", "--resume", "--scheduler", "tcp://127.0.0.1:9"]), stand_in.work)
