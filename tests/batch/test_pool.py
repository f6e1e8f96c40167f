"""Workers that crash, hang, hoard memory or are killed from outside."""

from __future__ import annotations

import multiprocessing.forkserver
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
import warnings
from collections import Counter
from pathlib import Path

import pytest
import stand_in

import sketch2shape as s2s
from sketch2shape.batch import pool
from sketch2shape.batch.pool import default_jobs, run_each
from sketch2shape.errors import CrashError, LimitError, UnreadableError
from sketch2shape.processes import contexts


def outcomes(names, **options):
    return dict(run_each(names, stand_in.act, **options))


@pytest.mark.posix
def test_each_fault_fails_its_own_item_only():
    names = ["crash", "hang", "hog", "bug", "known", "suicide", *(f"good {i}" for i in range(20))]
    got = outcomes(names, jobs=2, timeout=10.0, max_memory=300 * 2**20)
    assert set(got) == set(names)
    assert all(got[n][0] == f"did {n}" for n in names if n.startswith("good"))
    assert isinstance(got["crash"], CrashError)
    assert "SIGSEGV" in got["crash"].message
    assert "SIGKILL" in got["suicide"].message
    assert isinstance(got["hang"], LimitError)
    assert isinstance(got["hog"], LimitError)
    assert isinstance(got["known"], UnreadableError)
    assert "ZeroDivisionError" in got["bug"].message


@pytest.mark.posix
def test_time_is_that_of_computing_and_by_the_clock_a_few_times_that():
    started = time.monotonic()
    got = outcomes(["hang", "wait", "good"], jobs=2, timeout=1.0)
    assert got["hang"].message == "not done after 1 s of computing"
    assert got["wait"].message == "not done after 1 s"
    assert time.monotonic() - started >= 5.0
    assert got["good"][0] == "did good"


def test_an_item_that_only_waits_is_not_computing():
    assert outcomes(["slow"], jobs=1, timeout=0.1)["slow"][0] == "did slow"


class _Watch(threading.Thread):
    """Looks at what belongs to the whole process, again and again, until it is told to stop."""

    def __init__(self):
        super().__init__(daemon=True)
        self.stop, self.seen = threading.Event(), set()

    @staticmethod
    def look():
        preload = tuple(multiprocessing.forkserver._forkserver._preload_modules)
        return id(sys.modules["__main__"]), str(sorted(os.environ.items())), str(warnings.filters), preload

    def run(self):
        while not self.stop.is_set():
            self.seen.add(self.look())


def test_nothing_of_this_process_is_changed_even_for_a_moment(monkeypatch):
    monkeypatch.setattr(contexts, "_WORKING", {})  # so that a fork server is started, too
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    before, watch = _Watch.look(), _Watch()
    watch.start()
    try:
        threads = [threading.Thread(target=lambda: outcomes(["good 1", "good 2"], jobs=1)) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        watch.stop.set()
        watch.join()
        sys.setswitchinterval(interval)
    assert watch.seen == {before}


def _without_workers(monkeypatch, error):
    """A system on which no lock, and so no worker, can be made."""

    class Broken:
        def RLock(self):  # noqa: N802
            raise error

    monkeypatch.setattr(contexts, "_WORKING", {})
    monkeypatch.setattr(contexts, "_contexts", lambda _: [Broken(), Broken()])


@pytest.mark.parametrize(
    "error", [OSError(30, "Read-only file system"), AssertionError("daemonic processes"), OSError()]
)
def test_without_workers_the_work_is_done_here_and_the_cause_is_named(monkeypatch, error):
    _without_workers(monkeypatch, error)
    told = []
    got = dict(run_each([-1, 2, -3], abs, jobs=2, timeout=5.0, notice=told.append))
    assert got == {-1: 1, 2: 2, -3: 3}
    assert len(told) == 1
    assert (getattr(error, "strerror", None) or str(error) or "OSError") in told[0]
    faults = dict(run_each(["bug", "known"], stand_in.act, notice=told.append))
    assert isinstance(faults["bug"], CrashError)
    assert isinstance(faults["known"], UnreadableError)


def test_from_python_the_cause_is_logged(monkeypatch, caplog):
    _without_workers(monkeypatch, OSError(24, "Too many open files"))
    assert [r.objects for r in s2s.reconstruct_many([b"no picture"])] == [()]
    assert "Too many open files" in caplog.text


def test_a_frozen_application_does_not_start_itself_again(monkeypatch):
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    told = []
    assert dict(run_each([-1], abs, notice=told.append)) == {-1: 1}
    assert "frozen" in told[0]


def _here(numbers):
    return dict(run_each(numbers, abs, notice=lambda _: None))


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_daemonic_workers_of_others_may_use_it(method):
    with multiprocessing.get_context(method).Pool(1) as others:
        assert others.apply(_here, ([-1, -2],)) == {-1: 1, -2: 2}


@pytest.mark.posix
def test_a_forked_child_has_a_fork_server_of_its_own():
    assert _here([-1]) == {-1: 1}
    child = multiprocessing.get_context("fork").Process(target=_check_here)
    child.start()
    child.join(60)
    assert child.exitcode == 0


def _check_here():
    told = []
    assert dict(run_each([-1, -2], abs, notice=told.append)) == {-1: 1, -2: 2}
    assert told == []


def test_items_are_drawn_a_few_at_a_time():
    drawn = []

    def source():
        for i in range(200):
            drawn.append(i)
            yield f"good {i}"

    run = run_each(source(), stand_in.act, jobs=2)
    next(run)
    assert len(drawn) < 30
    run.close()


@pytest.mark.posix
def test_a_pool_whose_workers_are_killed_is_made_anew(monkeypatch):
    def source():
        yield "good 0"
        yield "good 1"
        while len(pids) < 2:
            yield f"more {len(pids)}{time.monotonic()}"
        for pid in pids:
            os.kill(pid, signal.SIGKILL)
        time.sleep(0.5)
        yield from (f"late {i}" for i in range(5))

    monkeypatch.setattr(pool, "_PATIENCE", 8.0)
    pids, done = set(), Counter()
    for name, value in run_each(source(), stand_in.act, jobs=2, timeout=60.0):
        if isinstance(value, tuple):
            pids.add(value[1])
            done[name.split()[0]] += 1
    assert done["good"] == 2
    assert done["late"] == 5


def test_no_items():
    assert list(run_each([], stand_in.act)) == []
    assert default_jobs() >= 1


def test_a_script_without_a_guard_may_use_the_pool(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        textwrap.dedent("""
        from sketch2shape.batch.pool import run_each
        print("once")
        print(sorted(v for _, v in run_each([-1, 2, -3], abs, jobs=2)))
        """)
    )
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=60, check=False)
    assert done.stdout == "once\n[1, 2, 3]\n", done.stderr


_FOREVER = """
import os, sys, time
from sketch2shape.batch.pool import run_each
sys.path.insert(0, sys.argv[1])
import napping
for _, pid in run_each(range(10**6), napping.nap, jobs=2, timeout=60): print(pid, flush=True)
"""


@pytest.mark.posix
def test_workers_end_with_a_parent_that_is_killed(tmp_path):
    (tmp_path / "napping.py").write_text("import os, time\ndef nap(_):\n    time.sleep(0.05)\n    return os.getpid()\n")
    script = tmp_path / "forever.py"
    script.write_text(_FOREVER)
    with subprocess.Popen([sys.executable, str(script), str(tmp_path)], stdout=subprocess.PIPE, text=True) as parent:
        pids = {int(parent.stdout.readline()) for _ in range(10)}
        parent.kill()
    deadline = time.monotonic() + 60
    while any(_alive(pid) for pid in pids) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not any(_alive(pid) for pid in pids)


def _alive(pid):
    status = Path(f"/proc/{pid}/stat")
    return status.exists() and status.read_text().rpartition(")")[2].split()[0] != "Z"
