"""kill -9 at random moments: nothing truncated, nothing left over, and the resumed run ends with the same bytes."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import uuid
from collections import Counter
from pathlib import Path

import numpy as np

from benchmarks.faults.samples import drawing
from sketch2shape.batch.manifest import NAME as MANIFEST

_MARK = "SKETCH2SHAPE_CAMPAIGN"
_INPUTS = 16


def run(size: int = 100) -> dict[str, object]:
    """`size` rounds; in each a batch is killed (or one of its workers), perhaps again while resuming, then finished."""
    findings: list[str] = []
    killed: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "in" / "sub").mkdir(parents=True)
        for number in range(_INPUTS):
            drawing(150 + 4 * number, 120).save(folder / "in" / ("sub" if number % 2 else "") / f"{number}.png")
        seconds = _finish(folder, folder / "whole", resume=False)
        whole = _snapshot(folder / "whole")
        for number in range(size):
            findings += [f"round {number}: {f}" for f in _round(folder, whole, number, seconds, killed)]
    return {"rounds": size, "killed": dict(killed), "inputs of a round": _INPUTS, "findings": findings[:20]}


def _round(folder: Path, whole: dict[str, str], number: int, seconds: float, killed: Counter[str]) -> list[str]:
    rng = np.random.default_rng(number)
    out, findings = folder / f"out{number}", []
    for attempt in range(1 + rng.integers(0, 2)):
        whom = "parent" if rng.random() < 0.6 else "worker"
        mark = uuid.uuid4().hex
        process = _start(folder, out, mark, resume=attempt > 0)
        time.sleep(rng.uniform(0, seconds))
        others = [pid for pid in _marked(mark) if pid != process.pid]
        victim = process.pid if whom == "parent" or not others else int(rng.choice(others))
        with contextlib.suppress(ProcessLookupError):
            os.kill(victim, signal.SIGKILL)
            killed["parent" if victim == process.pid else "worker or fork server"] += 1
        process.wait()
        findings += _truncated(out, whole)
        findings += _stray(mark)
    _finish(folder, out, resume=out.exists())
    after = _snapshot(out)
    if after != whole:
        differ = sorted(name for name in {*after, *whole} if after.get(name) != whole.get(name))
        findings.append(f"differs after resuming: {differ}")
    return findings


def _start(folder: Path, out: Path, mark: str, *, resume: bool) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "sketch2shape", str(folder / "in"), "-o", str(out), "--json", "--quiet"]
    command += ["--jobs", "2", "--timeout", "20", *(["--resume"] if resume else [])]
    return subprocess.Popen(command, env={**os.environ, _MARK: mark}, stderr=subprocess.DEVNULL)


def _finish(folder: Path, out: Path, *, resume: bool) -> float:
    """Run to the end; how long it took."""
    begin = time.monotonic()
    _start(folder, out, "finish", resume=resume).wait()
    return time.monotonic() - begin


def _marked(mark: str) -> list[int]:
    """Running processes that inherited the mark."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            with contextlib.suppress(OSError):
                if f"{_MARK}={mark}".encode() in (entry / "environ").read_bytes():
                    found.append(int(entry.name))
    return found


def _stray(mark: str) -> list[str]:
    """Processes of a killed run that are still there after some seconds."""
    deadline = time.monotonic() + 10
    while _marked(mark) and time.monotonic() < deadline:
        time.sleep(0.05)
    return [f"process {pid} still runs" for pid in _marked(mark)]


def _truncated(out: Path, whole: dict[str, str]) -> list[str]:
    """Outputs under their final names that are neither what they should be nor the whole report of a lost worker."""
    differ = [name for name, digest in _snapshot(out).items() if name in whole and digest != whole[name]]
    return [f"{name} is not whole" for name in differ if not _tells_of_a_failure(out / name)]


def _tells_of_a_failure(path: Path) -> bool:
    """Whether a file is complete JSON, or JSON lines, in which a failure is told."""
    text = path.read_text()
    try:
        records = [json.loads(line) for line in text.splitlines()]
    except ValueError:
        return False
    return text.endswith("\n") and any(r.get("status") == "failed" or r.get("exit_code") for r in records)


def _snapshot(out: Path) -> dict[str, str]:
    """Name -> hash of every file; the record of a run in progress is left out."""
    found = {}
    for path in out.rglob("*"):
        if path.is_file() and not (path.name == MANIFEST and b'"planned"' in path.read_bytes()):
            found[str(path.relative_to(out))] = hashlib.sha256(path.read_bytes()).hexdigest()
    return {name: digest for name, digest in found.items() if name != MANIFEST or digest}
