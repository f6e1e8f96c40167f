"""Workers that crash, hang, hoard memory or are killed from outside."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import time
from collections import Counter
from pathlib import Path

import stand_in

from sketch2shape.batch import pool
from sketch2shape.batch.pool import default_jobs, run_each
from sketch2shape.errors import CrashError, LimitError, UnreadableError


def outcomes(names, **options):
    return dict(run_each(names, stand_in.act, **options))


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
