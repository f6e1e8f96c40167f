"""Beside others: tracers that give vectors (no solid), libraries for hulls of points."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path

import cv2
import numpy as np

from benchmarks import subjects
from benchmarks.single import floor, ours
from benchmarks.timing import Call, Report, Table, command, in_turn, times
from sketch2shape.errors import MissingPackageError
from sketch2shape.model.arrays import Floats


def tracers(scratch: Path, quick: bool) -> Report:
    """What people use today to get vectors from a drawing, on the same files."""
    files = subjects.small_drawings(scratch, 12 if quick else 36)
    calls: dict[str, Call] = {
        "floor": lambda: [floor(p) for p in files],
        "sketch2shape": lambda: [ours(p) for p in files],
    }
    peers = {"potrace": _potrace(files, scratch), "vtracer": _vtracer(files, scratch)}
    calls |= {name: call for name, call in peers.items() if call}
    t = in_turn(calls, 1 if quick else 3)
    named = [name for name in calls if name != "floor"]
    rows = [[name, times(t[name] / t["floor"]), times(t[name] / t["sketch2shape"])] for name in named]
    absent = [name for name in peers if name not in calls]
    words = (
        f"All {len(files)} drawings one after the other. potrace gets them thresholded (not timed) and writes SVG, one"
        " process for all; vtracer reads and writes files in this process. Neither finds the object."
    )
    if absent:
        words += f" Not installed here: {', '.join(absent)}."
    return Report([Table("Tracers", words, ["", "over the floor", "over sketch2shape"], rows)])


def _potrace(files: list[Path], scratch: Path) -> Call | None:
    if not shutil.which("potrace"):
        return None
    maps = []
    for number, path in enumerate(files):
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        _, ink = cv2.threshold(grey, 0, 255, cv2.THRESH_BINARY | cv2.THRESH_OTSU)
        maps.append(str(scratch / f"potrace_{number}.pgm"))
        cv2.imwrite(maps[-1], ink)
    return command("potrace", "--svg", *maps)


def _vtracer(files: list[Path], scratch: Path) -> Call | None:
    try:
        import vtracer
    except ImportError:
        return None
    out = str(scratch / "vtracer.svg")
    return lambda: [vtracer.convert_image_to_svg_py(str(p), out, colormode="binary") for p in files]


def connectors(_scratch: Path, quick: bool) -> Report:
    """Ordering 24 points of a comb: our methods beside libraries, over SciPy's convex hull."""
    from scipy.spatial import ConvexHull

    points = comb(12)
    calls: dict[str, Callable[[], object]] = {"scipy convex hull": lambda: ConvexHull(points)}
    calls |= _libraries(points)
    own, absent = _ours(points)
    calls |= own
    repeated = {name: (lambda c=call: [c() for _ in range(20)]) for name, call in calls.items()}
    t = in_turn(repeated, 2 if quick else 7)
    rows = [[name, times(t[name] / t["scipy convex hull"])] for name in calls]
    words = f"One face of {len(points)} vertices, unordered; over `scipy.spatial.ConvexHull`."
    if absent:
        words += f" Not installed here: what {', '.join(absent)} needs."
    return Report([Table("Connectors", words, ["method", "times"], rows)])


def comb(teeth: int) -> Floats:
    """Vertices of a comb in random order, (4 teeth, 2)."""
    x = np.repeat(np.arange(2.0 * teeth), 2)
    y = np.tile([0.0, 1.0, 1.0, 0.0], teeth) + 0.01 * x
    order = np.random.default_rng(0).permutation(len(x))
    points: Floats = np.c_[x, y][order]
    return points


def _libraries(points: Floats) -> dict[str, Callable[[], object]]:
    import shapely

    cloud = shapely.MultiPoint(points)
    out: dict[str, Callable[[], object]] = {"shapely.concave_hull": lambda: shapely.concave_hull(cloud, ratio=0.3)}
    try:
        from concave_hull import concave_hull_indexes
    except ImportError:
        return out
    return out | {"concave-hull": lambda: concave_hull_indexes(points, concavity=1.0)}


def _ours(points: Floats) -> tuple[dict[str, Callable[[], object]], list[str]]:
    """A call for each of our methods, and the methods whose package is not installed."""
    from sketch2shape.connectors import connect
    from sketch2shape.connectors import methods as names

    def one(method: str) -> object:
        try:
            return connect(points, method=method)
        except ValueError:
            return None

    calls: dict[str, Callable[[], object]] = {}
    absent = []
    for name in names():
        try:
            one(name)
        except MissingPackageError:
            absent.append(f"`{name}`")
        else:
            calls[f"`{name}`"] = partial(one, name)
    return calls, absent
