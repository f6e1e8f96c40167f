"""One drawing in a warm process, beside the least that any such tool must do with its pixels."""

from __future__ import annotations

import time
from collections import Counter
from pathlib import Path

import cv2
import numpy as np

from benchmarks import subjects
from benchmarks.timing import Plot, Report, Table, exponent, in_turn, steepest, times
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.pipeline import reconstruct

WORKING = 1_000_000
"""Pixels to which the floor of a large picture reduces it."""
WITHIN = 0.5
"""Seconds within which a hard picture is to be refused."""


def floor(path: Path) -> None:
    """Read, Otsu, skeletonize, goodFeaturesToTrack."""
    from skimage.morphology import skeletonize

    grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    _, ink = cv2.threshold(grey, 0, 255, cv2.THRESH_BINARY_INV | cv2.THRESH_OTSU)
    skeletonize(ink > 0)
    cv2.goodFeaturesToTrack(grey, 200, 0.05, 5)


def large_floor(path: Path) -> None:
    """Decode, Otsu, resize to a working size."""
    grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    cv2.threshold(grey, 0, 255, cv2.THRESH_BINARY_INV | cv2.THRESH_OTSU)
    factor = (WORKING / grey.size) ** 0.5
    cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)


def ours(path: Path) -> str:
    """Reconstruct; says what became of it."""
    try:
        return f"{len(reconstruct(path).objects)} found"
    except Sketch2ShapeError as error:
        return type(error).__name__


def vertices(path: Path) -> str:
    """Vertices of each face found, how often if several are alike, or why none."""
    try:
        found = Counter(len(o.f1) for o in reconstruct(path).objects)
        return " and ".join(f"{n}" if often == 1 else f"{often} x {n}" for n, often in found.items())
    except Sketch2ShapeError as error:
        return type(error).__name__


def warm(scratch: Path, quick: bool) -> Report:
    """Median and 95th percentile over the floor; a photo; where the time goes."""
    files = subjects.small_drawings(scratch, 30 if quick else 108)
    ours(files[0])
    floor(files[0])
    rows, floors, mine = [], [], []
    stages: dict[str, list[float]] = {}
    for path in files:
        t = in_turn({"floor": lambda p=path: floor(p), "ours": lambda p=path: ours(p)}, 1 if quick else 3)
        floors.append(t["floor"])
        mine.append(t["ours"])
        try:
            for stage, ms in reconstruct(path).timings_ms.items():
                stages.setdefault(stage, []).append(ms)
        except Sketch2ShapeError:
            pass
    base = float(np.median(floors))
    rows.append(["median of `reconstruct`", times(float(np.median(mine)) / base), "1.8"])
    rows.append(["95th percentile", times(float(np.percentile(mine, 95)) / base), "5"])
    rows += _sets(20 if quick else 60)
    photo = subjects.photo(scratch, (4000, 3000))
    t = in_turn({"floor": lambda: large_floor(photo), "ours": lambda: ours(photo)}, 3)
    rows.append(["photo of 12 megapixels, over its own decode + Otsu + resize", times(t["ours"] / t["floor"]), "1.5"])
    words = f"Over read + Otsu + skeletonize + goodFeaturesToTrack on the same {len(files)} drawings of 640 x 480."
    words += " Other sets: each picture over its own floor."
    tables = [Table("One drawing in a warm process", words, ["", "times the floor", "goal"], rows)]
    total = sum(float(np.sum(v)) for v in stages.values())
    if total:
        share = [[name, f"{100 * float(np.sum(v)) / total:.0f}"] for name, v in stages.items()]
        tables.append(Table("Where the time goes", "Of all time in the stages.", ["stage", "%"], share))
    return Report(tables)


def _sets(most: int) -> list[list[str]]:
    """95th percentiles over pictures that people made, as far as they are there, each over its own floor."""
    rows = []
    for name in ("hard", "real"):
        files = subjects.of_set(name, most)
        turns = [in_turn({"floor": lambda p=p: floor(p), "ours": lambda p=p: ours(p)}, 1) for p in files]
        if turns:
            ratio = float(np.percentile([t["ours"] / t["floor"] for t in turns], 95))
            rows.append([f"95th percentile of {len(files)} of the set `{name}`", times(ratio), "10"])
    return rows


def growth(scratch: Path, quick: bool) -> Report:
    """Time against vertices and against pixels, with fitted exponents."""
    counts = (3, 6, 12, 24, 50) if quick else (3, 6, 12, 24, 50, 100, 200)
    objects = (1, 3, 10) if quick else (1, 3, 10, 25, 50)
    sizes = (0.1, 0.3, 1.0, 3.0, 10.0) if quick else (0.1, 0.3, 1.0, 3.0, 10.0, 20.0)
    rows, plots = [], []
    sets = (
        ("vertices a face", subjects.of_vertices(scratch, counts), 1.5),
        ("objects on a sheet", subjects.of_objects(scratch, objects), 1.1),
        ("megapixels", subjects.of_pixels(scratch, sizes), 1.1),
    )
    for label, files, goal in sets:
        x, y, said = [], [], []
        for number, path in files.items():
            y.append(in_turn({"ours": lambda p=path: ours(p)}, 1 if quick else 3)["ours"])
            x.append(float(number))
            said.append(vertices(path))
        relative = [v / y[0] for v in y]
        slopes = [f"{slope(x, y):.2f}" for slope in (exponent, steepest)]
        rows.append([label, f"{x[0]:g} to {x[-1]:g}", *slopes, f"{goal:g}", ", ".join(said)])
        plots.append(Plot(label.split()[0], label, f"time over that of {x[0]:g}", {"sketch2shape": (x, relative)}))
    words = (
        "Slope of the straight line through log time against log size, and the steepest slope from one size to the"
        " next; the vertices a face of what was found."
    )
    head = ["against", "range", "exponent", "steepest", "goal", "vertices found"]
    return Report([Table("Growth", words, head, rows)], plots)


def hard(scratch: Path, _quick: bool) -> Report:
    """Pictures made to explode a search; seconds of computing, which other work on the machine does not lengthen."""
    rows = []
    for name, path in subjects.hard(scratch).items():
        start = time.process_time()
        said = ours(path)
        middle = time.process_time()
        floor(path)
        spent, base = middle - start, time.process_time() - middle
        rows.append([name, times(spent / base), "yes" if spent < WITHIN else f"no, {spent:.1f} s", said])
    words = "1600 x 1200 pixels each; over the floor of the same file; first call; time of the processor."
    return Report([Table("Hard pictures", words, ["", "times the floor", f"within {WITHIN:g} s", "answer"], rows)])
