"""The memory limit of a worker."""

from __future__ import annotations

import subprocess
import sys

from sketch2shape.batch import pool
from sketch2shape.processes import contexts

_ALLOCATE = """
from sketch2shape.batch.worker import limit_memory
limit_memory({allowance})
try:
    print(len(bytearray({size})))
except MemoryError:
    print("too much")
"""


def _try(allowance, size):
    code = _ALLOCATE.format(allowance=allowance, size=size)
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def test_the_allowance_comes_on_top_of_what_is_in_use():
    assert _try(200 * 2**20, 100 * 2**20) == str(100 * 2**20)
    assert _try(200 * 2**20, 300 * 2**20) == "too much"


_CONVERT = """
import importlib, sys
from sketch2shape.batch.worker import PRELOAD
for name in PRELOAD:
    importlib.import_module(name)
before = set(sys.modules)
from sketch2shape.conversion.convert import Output, Task, convert
assert convert(Task({source!r}, "a", (Output("obj", {out!r}), Output("json", {out!r} + ".json")))).exit_code == 0
print(*{{name.partition(".")[0] for name in set(sys.modules) - before}} - {{"PIL"}})
"""


def test_the_first_picture_of_a_worker_waits_for_no_import(drawings, tmp_path):
    code = _CONVERT.format(source=str(drawings / "clean_wire_oblique" / "000.png"), out=str(tmp_path / "a.obj"))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.strip()) == (0, ""), done.stderr


def test_systems_that_lack_a_function_do_without(monkeypatch):
    """As on Windows: no limits on memory, no timer of computing time; neither is a reason to stop."""
    import os
    import signal

    from sketch2shape.batch import worker

    monkeypatch.setitem(sys.modules, "resource", None)
    worker.limit_memory(2**20)
    monkeypatch.setattr(worker, "HAS_TIMER", False)
    monkeypatch.setattr(signal, "setitimer", None)
    with worker.limited_time(0.001):
        sum(range(10**6))
    monkeypatch.setattr(worker.sys, "platform", "win32")
    worker.die_with_parent()
    monkeypatch.delattr(os, "sched_getaffinity", raising=False)
    assert pool.default_jobs() >= 1


def test_without_a_fork_server_workers_are_spawned(monkeypatch):
    monkeypatch.setattr(contexts, "_WORKING", {})
    monkeypatch.setattr(contexts.multiprocessing, "get_all_start_methods", lambda: ["spawn"])
    told = []
    assert dict(pool.run_each([-1, 2], abs, jobs=1, timeout=60.0, notice=told.append)) == {-1: 1, 2: 2}
    assert told == []
