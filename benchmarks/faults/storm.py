"""A folder in which much goes wrong: every good picture is done, every bad one named, and the parent stays small."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from pathlib import Path

import numpy as np

from benchmarks.faults.samples import drawing

_ROOT = Path(__file__).parents[2]
#: name of a fault -> (how many in a thousand, the exit code it must get)
_FAULTS = {"crash": (25, 1), "hang": (10, 6), "hog": (25, 6), "corrupt": (50, 4)}


def run(size: int = 1000) -> dict[str, object]:
    """A folder of `size` inputs, about a tenth of them bad."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        expected = _fill(folder / "in", size)
        begin = time.monotonic()
        code, memory = _batch(folder)
        seconds = time.monotonic() - begin
        lines = (folder / "report.jsonl").read_text().splitlines()
        rows = {row["name"]: row for row in map(json.loads, lines)}
        findings = [f"exit code {code}"] if code != 3 else []
        for picture, want in expected.items():
            got = rows.get(picture, {}).get("exit_code")
            if got != want:
                findings.append(f"{picture}: exit code {got}, not {want}: {rows.get(picture, {}).get('message')}")
            if (want == 0) != (folder / "out" / picture).with_suffix(".obj").exists():
                findings.append(f"{picture}: mesh there or missing against expectation")
        left = [p.name for p in folder.rglob("*.tmp")]
    half = memory[len(memory) // 2 :]
    return {
        "inputs": len(expected),
        "exit codes": dict(sorted(Counter(expected.values()).items())),
        "seconds": round(seconds, 1),
        "parent memory, MB: after a tenth of the time, at most": [round(memory[len(memory) // 10]), round(max(memory))],
        "growth over the second half, MB": round(half[-1] - half[0], 1),
        "findings": (findings + left)[:20],
    }


def _fill(folder: Path, size: int) -> dict[str, int]:
    """Make the inputs; name -> exit code each must get."""
    folder.mkdir()
    rng = np.random.default_rng(5)
    scaled = {kind: max(1, round(count * size / 1000)) for kind, (count, _) in _FAULTS.items()}
    kinds = [kind for kind, count in scaled.items() for _ in range(count)]
    kinds += ["good"] * (size - len(kinds) - 3)
    expected = {}
    for number, kind in enumerate(rng.permutation(kinds)):
        name = f"{number:04}{kind}.png"
        drawing(480, 360).save(folder / name)
        if kind == "corrupt":
            (folder / name).write_bytes((folder / name).read_bytes()[: int(rng.integers(0, 400))])
        expected[name] = _FAULTS[kind][1] if kind in _FAULTS else 0
    os.mkfifo(folder / "pipe.png")
    (folder / "loop.png").symlink_to("loop.png")
    if os.getuid() == 0:  # root may read everything, but not this
        (folder / "locked.png").symlink_to("/proc/self/mem")
    else:
        (folder / "locked.png").write_bytes(b"x")
        (folder / "locked.png").chmod(0)
    return {**expected, "pipe.png": 4, "loop.png": 4, "locked.png": 4}


def _batch(folder: Path) -> tuple[int, list[float]]:
    """Run the batch; its exit code, and the parent's memory in MB over time."""
    command = [sys.executable, "-m", "benchmarks.faults.misbehave", str(folder / "in"), "-o", str(folder / "out")]
    command += ["--report", str(folder / "report.jsonl"), "--timeout", "10", "--max-memory", "1G", "--json"]
    memory: list[float] = []
    with open(folder / "errors.txt", "wb") as errors:
        process = subprocess.Popen(command, cwd=_ROOT, stderr=errors)
        watcher = threading.Thread(target=_watch, args=(process, memory))
        watcher.start()
        code = process.wait()
        watcher.join()
    return code, memory


def _watch(process: subprocess.Popen[bytes], memory: list[float]) -> None:
    while process.poll() is None:
        try:
            status = Path(f"/proc/{process.pid}/status").read_text()
        except OSError:
            break
        lines = [line for line in status.splitlines() if line.startswith("VmRSS")]
        if lines:
            memory.append(int(lines[0].split()[1]) / 1024)
        time.sleep(0.2)
