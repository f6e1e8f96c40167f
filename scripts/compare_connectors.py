"""Compare all connectors, fairly: exact orders on many faces, and time against the number of points.

    python scripts/compare_connectors.py [--count N] [--seed S] [--out docs] [--points FILE]

Repeats the evaluation of the paper for every method of `sketch2shape.connect`: its Table 1 (complexity) as measured
growth curves, its Fig. 13 (precision) as the part of faces whose whole order is right, its Fig. 14 (computations
against n) as time. Parameters of a rival are the best of a sweep on the frontal set. Writes OUT/connectors.md with
two plots (these need matplotlib). --points FILE adds a table for a JSON list of {"profile", "points", "order"}.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).parent))
from connector_profiles import PROFILES, faces

from sketch2shape.connect import connect, connect_detailed, methods, split_walk_preconditions
from sketch2shape.connect.geometry import canonical, ring_is_simple
from sketch2shape.connect.registry import find_method
from sketch2shape.errors import Sketch2ShapeError

Ring = NDArray[np.float64]
RANDOM = ("star-shaped", "blob", "simple")
NAMED = tuple(name for name in PROFILES if name not in (*RANDOM, "rectilinear"))
SETS = {
    "frontal": (NAMED, ("frontal", "turned")),
    "affine": (NAMED, ("sheared", "affine")),
    "rectilinear": (("rectilinear",), ("frontal", "turned", "sheared", "affine")),
    "random": (("star-shaped", "blob"), ("frontal", "affine")),
    "simple": (("simple",), ("frontal", "affine")),
}
NOISE = (0.0, 0.5, 1.0, 2.0)
SWEEPS: dict[str, tuple[str, tuple[float, ...]]] = {
    "park-oh": ("N", (0.7, 0.9, 1.1, 1.3, 1.5, 2.0)),
    "park-oh-all": ("N", (0.7, 0.9, 1.1, 1.3, 1.5, 2.0)),
    "concave-hull": ("concavity", (0.6, 0.8, 1.0, 1.2, 1.5, 2.0)),
    "chi-shape": ("ratio", (0.0, 0.1, 0.2, 0.3, 0.5)),
    "chi-shape-shapely": ("ratio", (0.0, 0.1, 0.2, 0.3, 0.5)),
    "ec-shape": ("v", (0.8, 1.0, 1.2, 1.5)),
    "moreira-santos": ("k", (3, 4, 5)),
}
#: seconds; a method's growth curve ends where one call takes longer
PATIENCE = 0.15
SIZES = tuple(int(n) for n in (10, 30, 100, 300, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6, 3e6))


@dataclass(frozen=True)
class Face:
    """Shuffled points and their true order."""

    profile: str
    points: Ring
    order: tuple[int, ...]


def shuffled(name: str, ring: Ring, rng: np.random.Generator) -> Face:
    place = rng.permutation(len(ring))
    points = np.empty_like(ring)
    points[place] = ring
    return Face(name, points, canonical(place))


def face_set(name: str, count: int, noise: float, seed: int) -> list[Face]:
    profiles, views = SETS[name]
    repeat = count if len(profiles) > 5 else count * 12 // len(profiles)
    clean = np.random.default_rng(seed)
    rng = np.random.default_rng(seed + 1)
    found = []
    for profile, _, ring in faces(clean, profiles, views, repeat):
        moved = ring + rng.normal(0, noise, ring.shape)
        if ring_is_simple(moved):
            found.append(shuffled(profile, moved, rng))
    return found


def with_a_vertex_missing(face: Face, rng: np.random.Generator) -> Face:
    """The face without one vertex; right is the ring without it."""
    gone = int(rng.integers(len(face.points)))
    order = [i - (i > gone) for i in face.order if i != gone]
    return Face(face.profile, np.delete(face.points, gone, axis=0), canonical(np.array(order)))


def with_an_extra_vertex(face: Face, rng: np.random.Generator) -> Face:
    """The face and one stray point in its box; right is the ring that leaves it out."""
    low, high = face.points.min(axis=0), face.points.max(axis=0)
    return Face(face.profile, np.concatenate((face.points, rng.uniform(low, high)[None])), face.order)


def is_right(face: Face, method: str, parameters: dict[str, Any]) -> bool:
    try:
        return canonical(connect(face.points, method, **parameters)) == face.order
    except Sketch2ShapeError:
        return False


def precision(found: list[Face], method: str, parameters: dict[str, Any]) -> float:
    """Part of the faces whose whole order is right: TP / (TP + FP) of the paper."""
    return float(np.mean([is_right(face, method, parameters) for face in found]))


def best_parameters(found: list[Face], method: str) -> dict[str, Any]:
    """The best value of a sweep, or the defaults where they are no worse."""
    if method not in SWEEPS:
        return {}
    name, values = SWEEPS[method]
    choices: list[dict[str, Any]] = [{}, *({name: value} for value in values)]
    scores = [precision(found, method, choice) for choice in choices]
    return choices[int(np.argmax(scores))]


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def percent(value: float) -> str:
    return f"{100 * value:.0f}"


# ---------------------------------------------------------------- what is measured


def exactness(parameters: dict[str, dict[str, Any]], count: int, seed: int) -> tuple[str, dict[str, float]]:
    """Exact orders of each method on each set."""
    sets = {name: face_set(name, count, 0.0, seed) for name in SETS}
    rows, frontal = [], {}
    for method, chosen in parameters.items():
        scores = [precision(found, method, chosen) for found in sets.values()]
        frontal[method] = scores[0]
        took = time.perf_counter()
        for face in sets["frontal"][:40]:
            is_right(face, method, chosen)
        took = (time.perf_counter() - took) / 40
        value = ", ".join(f"{k}={v:g}" for k, v in chosen.items()) or "-"
        rows.append([f"`{method}`", value, *(percent(score) for score in scores), f"{1e6 * took:.0f}"])
    head = ["method", "parameter", *(f"{name} ({len(found)})" for name, found in sets.items()), "us a face"]
    return table(head, rows), frontal


def under_noise(parameters: dict[str, dict[str, Any]], count: int, seed: int) -> str:
    """Exact orders with moved, missing and extra vertices, over the frontal, affine and rectilinear sets together."""
    conditions: dict[str, list[Face]] = {}
    for noise in NOISE:
        conditions[f"{noise:g} px"] = [
            face
            for name in ("frontal", "affine", "rectilinear")
            for face in face_set(name, max(count // 2, 1), noise, seed)
        ]
    clean, rng = conditions["0 px"], np.random.default_rng(seed)
    conditions["one missing"] = [with_a_vertex_missing(face, rng) for face in clean if len(face.points) > 4]
    conditions["one extra"] = [with_an_extra_vertex(face, rng) for face in clean]
    rows = [
        [f"`{method}`", *(percent(precision(found, method, chosen)) for found in conditions.values())]
        for method, chosen in parameters.items()
    ]
    return table(["method", *(f"{name} ({len(found)})" for name, found in conditions.items())], rows)


def where_the_walk_is_right(count: int, seed: int) -> str:
    """For each profile: faces the walk gets right, and faces that meet its preconditions."""
    right: dict[str, list[bool]] = defaultdict(list)
    held: dict[str, list[bool]] = defaultdict(list)
    rivals: dict[str, list[bool]] = defaultdict(list)
    for name in ("frontal", "affine", "rectilinear", "random", "simple"):
        for face in face_set(name, count, 0.0, seed):
            order = np.array(face.order)
            right[face.profile].append(is_right(face, "split-walk", {}))
            held[face.profile].append(split_walk_preconditions(face.points, order).hold)
            rivals[face.profile].append(is_right(face, "auto", {}))
    rows = [
        [
            name,
            str(len(right[name])),
            percent(np.mean(right[name])),
            percent(np.mean(held[name])),
            percent(np.mean(rivals[name])),
        ]
        for name in right
    ]
    return table(["profile", "faces", "`split-walk` exact %", "preconditions hold %", "`auto` exact %"], rows)


def sureness(count: int, seed: int) -> str:
    """How often `auto` is right, by how sure it says it is."""
    answers = []
    for name in SETS:
        for noise in (0.0, 1.0):
            for face in face_set(name, count, noise, seed + 7):
                found = connect_detailed(face.points)
                answers.append((found.sureness or 0.0, canonical(found.order) == face.order))
    got = np.array(answers)
    rows = []
    for low, high in ((0, 0.3), (0.3, 0.5), (0.5, 0.7), (0.7, 0.9), (0.9, 0.98), (0.98, 1.01)):
        here = (got[:, 0] >= low) & (got[:, 0] < high)
        if here.any():
            rows.append([f"{low:g} to {min(high, 1):g}", str(int(here.sum())), percent(got[here, 1].mean())])
    return table(["sureness", "answers", "right %"], rows)


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


# ---------------------------------------------------------------- plots and the page


def plots(curves: dict[str, list[tuple[int, float]]], frontal: dict[str, float], out: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.2))
    for method, curve in curves.items():
        if len(curve) > 1:
            n, t = np.array(curve).T
            strong = method in ("split-walk", "park-oh", "auto")
            left.loglog(n, t, lw=2.5 if strong else 1, label=method, alpha=1 if strong else 0.6)
    left.set(xlabel="points", ylabel="seconds", title="Measured growth (the paper's Table 1)")
    left.legend(fontsize=6, ncol=2)
    n = np.linspace(10, 1e5, 50)
    right.plot(n, n * np.log2(n) + n, label="Park and Oh: n log n + n")
    right.plot(n, 3 * n, label="split and walk: w n, w = 3")
    right.set(xlabel="points", ylabel="computations", title="As the paper counts them (its Fig. 14)")
    right.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(out / "connectors-growth.png", dpi=72)
    figure, axes = pyplot.subplots(figsize=(8, 3.8))
    names = sorted(frontal, key=lambda name: frontal[name])
    colours = [
        "tab:orange" if name == "split-walk" else "tab:green" if name == "auto" else "tab:blue" for name in names
    ]
    axes.barh(names, [100 * frontal[name] for name in names], color=colours)
    axes.set(
        xlabel="faces with the whole order right, %",
        xlim=(0, 100),
        title="Precision on named profiles (the paper's Fig. 13)",
    )
    axes.tick_params(axis="y", labelsize=7)
    figure.tight_layout()
    figure.savefig(out / "connectors-precision.png", dpi=72)


def given_points(file: Path, parameters: dict[str, dict[str, Any]]) -> str:
    by_profile: dict[str, list[Face]] = defaultdict(list)
    for row in json.loads(file.read_text()):
        by_profile[row["profile"]].append(
            Face(row["profile"], np.array(row["points"]), canonical(np.array(row["order"])))
        )
    shown = list(parameters)
    rows = []
    for profile, found in by_profile.items():
        rows.append([profile, str(len(found)), *(percent(precision(found, m, parameters[m])) for m in shown)])
    every = [face for found in by_profile.values() for face in found]
    rows.append(["all", str(len(every)), *(percent(precision(every, m, parameters[m])) for m in shown)])
    return table(["profile", "faces", *shown], rows)


def page(count: int, seed: int, out: Path) -> Iterator[str]:
    frontal_faces = face_set("frontal", count, 0.0, seed + 1000)  # the sweep does not see the faces it is judged on
    parameters = {method: best_parameters(frontal_faces, method) for method in methods()}
    exact, frontal = exactness(parameters, count, seed)
    curves = growth(seed)
    plots(curves, frontal, out)
    yield INTRODUCTION.format(
        count=count, seed=seed, machine=f"Python {platform.python_version()}, numpy {np.__version__}"
    )
    yield "## Exact order, % of faces\n\n" + SETS_SAID + "\n\n" + exact + "\n\n![precision](connectors-precision.png)"
    yield "## Where the paper's 100 % holds\n\n" + HOLDS + "\n\n" + where_the_walk_is_right(count, seed)
    yield (
        "## Moved, missing and extra vertices, % exact\n\n" + NOISE_SAID + "\n\n" + under_noise(parameters, count, seed)
    )
    yield "## How sure `auto` is\n\n" + SURE + "\n\n" + sureness(max(count // 2, 1), seed)
    yield (
        "## Time against the number of points\n\n"
        + TIMES
        + "\n\n"
        + exponents(curves)
        + "\n\n![growth](connectors-growth.png)"
    )
    yield "### The walk against one sort\n\n" + against_a_sort(seed)


INTRODUCTION = """# Connectors compared

Written by `python scripts/compare_connectors.py --count {count} --seed {seed}` ({machine}).
"Exact" means the whole cyclic order is right; one wrong edge makes a face wrong. Faces come from
`scripts/connector_profiles.py`; `auto` was fitted to other random faces of the same generator (other seeds), so also
try it on yours (`--points FILE`)."""
SETS_SAID = """\
`frontal`: named profiles as drawn or turned; `affine`: sheared and in parallel views; `rectilinear`: random
polygons of right angles in such views; `random`: star-shaped about a centre nobody knows; `simple`: random points
joined at random and uncrossed, where many orders are equally good and no method can know. The parameter of a rival
is the best of a sweep on other frontal faces; "-" is its default. No hull can do the task from corners alone.
On `simple` the shortest tour is about as good a guess as any."""
HOLDS = """\
The paper reports 100 % for its method on its own images. That is right, and provably so, for faces that meet the
walk's preconditions: both chains between the leftmost and the rightmost vertex never turn back in x, and the line
y = mean y separates them. Convex faces whose leftmost and rightmost vertices lie near that line do; most faces
with arms, slots or steps do not. The walk is exact on exactly the faces that meet them, so the two columns agree.
Its 52 % for the unmodified method of Park and Oh is near what `park-oh` gets on the named profiles above."""
NOISE_SAID = """\
Vertices moved by Gaussian noise (faces are 300 px large), one vertex missing (right: the ring without it), one
stray point added (right: the ring that leaves it out, which only hulls can do)."""
SURE = """\
`connect_detailed(points).sureness` is the probability of the answer among the rings looked at. Over all sets,
without noise and with 1 px:"""
TIMES = """\
Random whole-numbered points; the least of several runs. The paper counts w n for its method (w digits of a radix
sort) against n log n + n for Park and Oh. Measured, the walk is linear. Where a method leaves points out it can be
faster than it would be on a face. Compare times within a table only: the machine had other work at the same time."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=2, help="faces of each profile in each view")
    parser.add_argument("--seed", type=int, default=2024)
    parser.add_argument("--out", type=Path, default=Path(__file__).parent.parent / "docs")
    parser.add_argument("--points", type=Path, help="compare on these points only, and print the table")
    args = parser.parse_args()
    if args.points:
        print(given_points(args.points, {method: {} for method in methods()}))
        return
    args.out.mkdir(parents=True, exist_ok=True)
    text = ""
    for section in page(args.count, args.seed, args.out):
        text += section + "\n\n"
        (args.out / "connectors.md").write_text(text.rstrip() + "\n")
    print(f"wrote {args.out / 'connectors.md'}")


if __name__ == "__main__":
    main()
