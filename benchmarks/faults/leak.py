"""Thousands of conversions in one process: memory and file descriptors stay where they are."""

from __future__ import annotations

import gc
import os
import tempfile
from pathlib import Path

from benchmarks.faults.samples import drawing, samples
from sketch2shape.conversion.convert import Output, Task, convert


def run(size: int = 2000) -> dict[str, object]:
    """`size` conversions of pictures, good and bad; memory is compared after the first tenth."""
    with tempfile.TemporaryDirectory() as name:
        sources = _sources(Path(name))
        outputs = (
            Output("obj", name + "/out.obj"),
            Output("json", name + "/out.json"),
            Output("stl", name + "/out.stl"),
        )
        failed = 0
        for number in range(size):
            source = sources[number % len(sources)]
            failed += convert(Task(str(source), source.name, outputs, overwrite=True)).exit_code != 0
            if number == size // 10:
                before = _state()
        after = _state()
    growth = after[0] - before[0]
    findings = [f"memory grew by {growth:.1f} MB"] if growth >= 20 else []
    if after[1] != before[1]:
        findings.append(f"{after[1] - before[1]} file descriptors are left open")
    return {
        "conversions": size,
        "of these failed": failed,
        "memory before and after, MB": [round(before[0], 1), round(after[0], 1)],
        "growth, MB": round(growth, 1),
        "file descriptors": list((before[1], after[1])),
        "findings": findings,
    }


def _sources(folder: Path) -> list[Path]:
    files = {"a.png": None, "b.jpg": None, **{f"cut-{n}": d[: len(d) // 2] for n, d in samples().items()}}
    for name, data in files.items():
        if data is None:
            drawing(240, 180).save(folder / name)
        else:
            (folder / name).write_bytes(data)
    return [folder / name for name in files] + [folder / "a.png"] * 10 + [folder / "missing.png", folder]


def _state() -> tuple[float, int]:
    """Memory in MB and open file descriptors of this process."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20, len(os.listdir("/proc/self/fd"))
