"""Folders: two workers beside one, isolation beside a plain loop, memory, many files."""

from __future__ import annotations

import contextlib
import resource
import shutil
from pathlib import Path

import numpy as np

from benchmarks import subjects
from benchmarks.timing import Call, Report, Table, python, times, tool
from sketch2shape.batch.pool import run_each
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.model.arrays import Floats
from sketch2shape.pipeline import reconstruct

LOOP = """
import pathlib, cv2
from sketch2shape.pipeline import reconstruct
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
    rounds, repeats = (3, 5) if quick else (10, 9)
    pace = _paces(copies(files, scratch / "folder", rounds * len(files)), scratch, repeats)
    large = subjects.of_pixels(scratch, [20.0])[20.0]
    count = len(files) * (10 if quick else 209)
    rows = [
        ["speed of 2 jobs over 1 job", times(float(np.median(pace["one"] / pace["two"]))), "at least 1.9"],
        ["time of 1 job over a plain loop", times(float(np.median(pace["one"] / pace["loop"]))), "at most 1.05"],
        ["memory of a worker, 640 x 480, of 200 MB", times(_peak(files) / 200), "at most 1"],
        ["memory of a worker, 20 megapixels, of 700 MB", times(_peak([large]) / 700), "at most 1"],
        [f"time a file, last third over first third of {count}", times(_flat(files, scratch, count)), "about 1"],
    ]
    words = (
        f"{len(files)} drawings of 640 x 480, OBJ written, {rounds} times over by each run. Runs are timed from their"
        f" first mesh to their last, so that starting up does not count; medians of {repeats} ratios of runs that"
        " follow one another."
    )
    return Report([Table("Folders", words, ["", "ratio", "goal"], rows)])


def _paces(source: Path, scratch: Path, repeats: int) -> dict[str, Floats]:
    """Seconds a file of a run with one job, with two, and of a plain loop, one for each repeat; they take turns."""
    outs = {name: scratch / f"out_{name}" for name in ("two", "one", "loop")}
    calls = {
        "two": _batch(source, outs["two"], 2),
        "one": _batch(source, outs["one"], 1),
        "loop": python(LOOP.format(source=str(source), out=str(outs["loop"]))),
    }
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(repeats):
        for name, call in calls.items():
            shutil.rmtree(outs[name], ignore_errors=True)
            outs[name].mkdir()
            call()
            appeared = _appeared(outs[name])
            seconds[name].append(float(appeared[-1] - appeared[0]) / (len(appeared) - 1))
    return {name: np.array(own) for name, own in seconds.items()}


def _batch(source: Path, out: Path, jobs: int) -> Call:
    return tool(str(source), "-o", str(out), "--overwrite", "--quiet", "--jobs", str(jobs), codes=(0, 3))


def _appeared(out: Path) -> Floats:
    """When the meshes in a folder were written, seconds, in order."""
    return np.sort([path.stat().st_mtime_ns for path in out.glob("*.obj")]) / 1e9


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
    _batch(source, scratch / "out_large", 2)()
    seconds = _appeared(scratch / "out_large")
    third = len(seconds) // 3
    return float((seconds[-1] - seconds[-third]) / (seconds[third - 1] - seconds[0]))
