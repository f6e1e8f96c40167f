"""Folders: two workers beside one, isolation beside a plain loop, memory, many files."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path

from benchmarks import subjects
from benchmarks.timing import Report, Table, in_turn, python, times, tool

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
PEAK = """
import resource
from sketch2shape.reconstruct import reconstruct
from sketch2shape.errors import Sketch2ShapeError
try:
    reconstruct({path!r}).mesh
except Sketch2ShapeError:
    pass
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
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
    source = copies(files, scratch / "folder", 48 if quick else 160)
    target = scratch / "loop"
    target.mkdir()

    def jobs(n: int) -> list[str]:
        return [str(source), "-o", str(scratch / "out"), "--overwrite", "--quiet", "--jobs", str(n)]

    t = in_turn(
        {
            "one": tool(*jobs(1), codes=(0, 3)),
            "two": tool(*jobs(2), codes=(0, 3)),
            "loop": python(LOOP.format(source=str(source), out=str(target))),
        },
        1 if quick else 3,
    )
    large = subjects.of_pixels(scratch, [20.0])[20.0]
    rows = [
        ["speed of 2 jobs over 1 job", times(t["one"] / t["two"]), "at least 1.8"],
        ["time of 1 job over a plain loop", times(t["one"] / t["loop"]), "at most 1.1"],
        ["memory of a process, 640 x 480, of 300 MB", times(peak(files[0]) / 300), "at most 1"],
        ["memory of a process, 20 megapixels, of 700 MB", times(peak(large) / 700), "at most 1"],
        ["time a file, many files over few", times(flat(files, scratch, quick)), "about 1"],
    ]
    words = f"{len(list(source.iterdir()))} drawings of 640 x 480, OBJ written."
    return Report([Table("Folders", words, ["", "ratio", "goal"], rows)])


def peak(path: Path) -> float:
    """Largest resident memory of a fresh process that reconstructs one picture, MB."""
    code = PEAK.format(path=str(path))
    return float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)


def flat(files: list[Path], scratch: Path, quick: bool) -> float:
    """Time a file of a large folder over that of a small one, both without the time of an almost empty one."""
    few, many = (20, 200) if quick else (200, 5000)
    seconds = []
    for count in (2, few, many):
        source = copies(files, scratch / f"flat_{count}", count)
        start = time.perf_counter()
        target = str(scratch / f"flat_out_{count}")
        tool(str(source), "-o", target, "--overwrite", "--quiet", "--jobs", "2", codes=(0, 3))()
        seconds.append(time.perf_counter() - start)
    return ((seconds[2] - seconds[0]) / (many - 2)) / ((seconds[1] - seconds[0]) / (few - 2))
