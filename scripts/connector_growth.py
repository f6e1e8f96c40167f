"""How the time of each connector grows with the number of points."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import repository  # noqa: F401 - for `evaluation`
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).parent))
from evaluation.markdown import table
from sketch2shape.connectors import connect, methods
from sketch2shape.connectors.registry import find_method
from sketch2shape.errors import Sketch2ShapeError

#: seconds; a method's growth curve ends where one call takes longer
PATIENCE = 0.15
SIZES = tuple(int(n) for n in (10, 30, 100, 300, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6))


def growth(seed: int) -> dict[str, list[tuple[int, float]]]:
    """(n, seconds) of each method on random whole-numbered points."""
    rng = np.random.default_rng(seed)
    curves: dict[str, list[tuple[int, float]]] = {}
    inputs = [scattered(n, 10**7, rng) for n in SIZES]
    for method in methods():
        limit = find_method(method).limit
        curve: list[tuple[int, float]] = []
        for points in inputs:
            if (limit is not None and len(points) > limit) or (curve and curve[-1][1] > PATIENCE):
                break
            took = fastest(lambda p=points, m=method: connect(p, m))
            if took is None:
                break
            curve.append((len(points), took))
        curves[method] = curve
    return curves


def scattered(n: int, side: int, rng: np.random.Generator) -> NDArray[np.int64]:
    """About n distinct points with whole coordinates below `side`, in random order."""
    keys = np.unique(rng.integers(0, side * side, n))
    rng.shuffle(keys)
    return np.column_stack(np.divmod(keys, side))


def fastest(run: Callable[[], object]) -> float | None:
    """Least of a few timings, seconds; None if the method has no answer for these points."""
    best, until = np.inf, time.perf_counter() + 0.05
    while True:
        start = time.perf_counter()
        try:
            run()
        except Sketch2ShapeError:
            return None
        best = min(best, time.perf_counter() - start)
        if time.perf_counter() > until:
            return best


def exponents(curves: dict[str, list[tuple[int, float]]]) -> str:
    rows = []
    for method, curve in curves.items():
        entry = find_method(method)
        large = [(n, t) for n, t in curve if n >= 300] or curve
        slope = "-"
        if len(large) >= 2:
            n, t = np.log(np.array(large)).T
            slope = f"{np.polyfit(n, t, 1)[0]:.2f}"
        last = (
            f"{curve[-1][1] / curve[-1][0] * 1e9:,.0f} at n = {curve[-1][0]:,}"
            if curve
            else "no ring for scattered points"
        )
        limit = f"{entry.limit:,}" if entry.limit else "none"
        rows.append([f"`{method}`", entry.complexity, slope, last, limit])
    return table(["method", "as analysed", "measured exponent (n >= 300)", "ns a point", "limit"], rows)


def against_a_sort(seed: int) -> str:
    rows = []
    rng = np.random.default_rng(seed)
    for n in (10**4, 10**5, 10**6, 10**7):
        points = scattered(n, 10**6, rng)
        walk = fastest(lambda p=points: connect(p, "split-walk")) or 0.0
        x = np.ascontiguousarray(points[:, 0])
        sort = fastest(lambda x=x: np.argsort(x, kind="stable")) or 1.0
        rows.append([f"{len(points):,}", f"{1e9 * walk / n:.0f}", f"{1e9 * sort / n:.0f}", f"{walk / sort:.2f}"])
    return table(["n", "`split-walk`, ns a point", "stable argsort of x, ns a point", "ratio"], rows)
