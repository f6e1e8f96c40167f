"""Folders: two workers beside one, isolation beside a plain loop, memory, many files."""

from __future__ import annotations

import contextlib
import resource
import shutil
from pathlib import Path

import numpy as np

from benchmarks import subjects
from benchmarks.timing import Call, Report, Table, in_turn, python, times, tool
from sketch2shape.batch.pool import run_each
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.reconstruct import reconstruct

LOOP = """
import pathlib, cv2
from sketch2shape.reconstruct import reconstruct
from sketch2shape.errors import Sketch2ShapeError
cv2.setNumThreads(1)
for path in sorted(pathlib.Path({source!r}).iterdir()):
    try:
        reconstruct(path).export({out!r} + "/" + path.stem + ".obj")
    except Sketch2ShapeError:
        pass
"""


def copies(files: list[Path], folder: Path, count: int) -> Path:
    """A folder of `count` drawings, the files again and again."""
    folder.mkdir(parents=True, exist_ok=True)
    for number in range(count):
        source = files[number % len(files)]
        shutil.copyfile(source, folder / f"{number:05d}{source.suffix}")
    return folder


def folder(scratch: Path, quick: bool) -> Report:
    """Workers, isolation and memory."""
    files = subjects.small_drawings(scratch, 24)
    rounds = 4 if quick else 20
    one, two, plain = _seconds_a_file(files, scratch, rounds, 3)
    large = subjects.of_pixels(scratch, [20.0])[20.0]
    count = len(files) * (10 if quick else 209)
    rows = [
        ["speed of 2 jobs over 1 job", times(one / two), "at least 1.8"],
        ["time of 1 job over a plain loop", times(one / plain), "at most 1.1"],
        ["memory of a worker, 640 x 480, of 300 MB", times(_peak(files) / 300), "at most 1"],
        ["memory of a worker, 20 megapixels, of 700 MB", times(_peak([large]) / 700), "at most 1"],
        [f"time a file, last third over first third of {count}", times(_flat(files, scratch, count)), "about 1"],
    ]
    words = (
        f"{len(files)} drawings of 640 x 480, OBJ written. Times of jobs and loop are of {rounds} rounds of them less"
        " one round, so that starting up does not count."
    )
    return Report([Table("Folders", words, ["", "ratio", "goal"], rows)])


def _seconds_a_file(files: list[Path], scratch: Path, rounds: int, repeats: int) -> tuple[float, float, float]:
    """Of a run with one job, with two, and of a plain loop, without what it takes to start up."""
    calls = {}
    for count in (1, rounds):
        source, target = copies(files, scratch / f"folder_{count}", count * len(files)), scratch / f"loop_{count}"
        target.mkdir()
        calls[f"one {count}"] = _batch(source, scratch, 1)
        calls[f"two {count}"] = _batch(source, scratch, 2)
        calls[f"loop {count}"] = python(LOOP.format(source=str(source), out=str(target)))
    t = in_turn(calls, repeats)
    one, two, loop = ((t[f"{kind} {rounds}"] - t[f"{kind} 1"]) / (rounds - 1) for kind in ("one", "two", "loop"))
    return one, two, loop


def _batch(source: Path, scratch: Path, jobs: int) -> Call:
    out = str(scratch / f"out_{source.name}")
    return tool(str(source), "-o", out, "--overwrite", "--quiet", "--jobs", str(jobs), codes=(0, 3))


def _peak(paths: list[Path]) -> float:
    """Largest resident memory of a worker that reconstructs the pictures one after the other, MB."""
    return max(found for _, found in run_each(paths, resident_after, jobs=1) if isinstance(found, float))


def resident_after(path: Path) -> float:
    """Reconstruct a picture; the largest resident memory of this process so far, MB."""
    with contextlib.suppress(Sketch2ShapeError):
        _ = reconstruct(path).mesh
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def _flat(files: list[Path], scratch: Path, count: int) -> float:
    """Time a file in the last third of a large folder over that in its first third, by when the meshes appeared."""
    source = copies(files, scratch / "large", count)
    _batch(source, scratch, 2)()
    seconds = np.sort([path.stat().st_mtime_ns for path in (scratch / "out_large").glob("*.obj")]) / 1e9
    third = len(seconds) // 3
    return float((seconds[-1] - seconds[-third]) / (seconds[third - 1] - seconds[0]))
