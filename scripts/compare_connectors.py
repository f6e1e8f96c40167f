"""Compare all connectors, fairly: exact orders on many faces, and time against the number of points.

    python scripts/compare_connectors.py [--count N] [--seed S] [--out docs] [--points FILE]

Repeats the evaluation of the paper for every method of `sketch2shape.connectors`: its Table 1 (complexity) as measured
growth curves, its Fig. 13 (precision) as the part of faces whose whole order is right, its Fig. 14 (computations
against n) as time. Parameters of a rival are the best of a sweep on the frontal set. Writes OUT/connectors.md with
two plots (these need matplotlib). --points FILE adds a table for a JSON list of {"profile", "points", "order"}.
"""

from __future__ import annotations

import argparse
import platform
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from connector_faces import face_set
from connector_growth import against_a_sort, exponents, growth
from connector_precision import (
    best_parameters,
    exactness,
    given_points,
    sureness,
    under_noise,
    where_the_walk_is_right,
)

from sketch2shape.connectors import methods

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
sort) against n log n + n for Park and Oh. Measured, the walk is linear up to ten million points, as it works piece by
piece: with arrays as long as the input, most of the time went to the memory that the system hands out, and the last
row of the table below said 2.7 to 3.3 instead. Where a method leaves points out it can be
faster than it would be on a face. Compare times within a table only: the machine had other work at the same time."""


def page(count: int, seed: int, out: Path) -> Iterator[str]:
    frontal_faces = face_set("frontal", count, 0.0, seed + 1000)  # the sweep does not see the faces it is judged on
    parameters = {method: best_parameters(frontal_faces, method) for method in methods()}
    exact, frontal = exactness(parameters, count, seed)
    curves = growth(seed)
    plots(curves, frontal, out)
    yield INTRODUCTION.format(
        count=count, seed=seed, machine=f"Python {platform.python_version()}, numpy {np.__version__}"
    )
    yield "## Exact order, % of faces\n\n" + SETS_SAID + "\n\n" + exact + "\n![precision](connectors-precision.png)"
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
        + "\n![growth](connectors-growth.png)"
    )
    yield "### The walk against one sort\n\n" + against_a_sort(seed)


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
        text += section.rstrip() + "\n\n"
        (args.out / "connectors.md").write_text(text.rstrip() + "\n")
    print(f"wrote {args.out / 'connectors.md'}")


if __name__ == "__main__":
    main()
