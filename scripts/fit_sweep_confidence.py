"""Fit how sure an answer with arcs or a point is to what speaks for and against it, and say how well that holds.

    python scripts/fit_sweep_confidence.py            fit, report both halves, write evidence/sweep_weights.py
    python scripts/fit_sweep_confidence.py --check    the weights that are there, on drawings of another seed

A logistic regression of right and wrong on the witnesses (`sketch2shape.evidence.sweep_witness`), on drawings that the
generator makes: round and pointed ones in all styles, and what is no such object. Even drawings are fitted; the odd
ones only tell how well that holds.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each

import numpy as np
from repository import ROOT
from scipy.optimize import minimize

from evaluation import curves
from evaluation.cases import Case, Wanted, collect
from evaluation.markdown import percent, table
from evaluation.measure import in_processes
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.evidence import SWEEP_WITNESSES, SweepWeights, sweep_confidence, sweep_terms
from sketch2shape.model import Floats

WEIGHTS = ROOT / "sketch2shape" / "evidence" / "sweep_weights.py"
KINDS = ("cylinder_*", "tube_*", "plate_*", "arcs_*", "cone_*", "frustum_*", "pyramid_*", "curved_*", "no_*")
"""Kinds of drawings that such answers are given to."""
EITHER = {"numbers", "shallow", "small", "pointed", "holes"}
"""Witnesses that may speak for an answer or against it; `gap` speaks for it, all others against."""
RIDGE = 2.0
"""Penalty on the square of a weight: that of two answers that contradict it."""


class Answer(NamedTuple):
    """What speaks for an answer, and whether it is right."""

    case: Case
    witnesses: Floats
    right: bool


def main() -> None:
    args = _arguments()
    with tempfile.TemporaryDirectory() as scratch:
        wanted = Wanted(ROOT, Path(scratch), KINDS, args.seed + args.check, args.per_category)
        cases = collect(["fresh"], wanted)
        given = in_processes(_answers, [(case,) for case in cases], args.jobs, args.seconds)
    answers = [a for some in given if not isinstance(some, Exception) for a in some]
    weights = SweepWeights()
    if not args.check:
        weights = fit([a for a in answers if a.case.half == "even"])
        WEIGHTS.write_text(_module(weights))
        print(f"wrote {WEIGHTS.relative_to(ROOT)}")
    print(report(answers, weights))


def _answers(case: Case) -> list[Answer]:
    """The answers with arcs or a point that are found in a drawing, refused ones too."""
    from sketch2shape.ink import find_ink
    from sketch2shape.lifting import choose_front
    from sketch2shape.pipeline.report import report as reported
    from sketch2shape.pipeline.result import Result
    from sketch2shape.pipeline.solid import lift
    from sketch2shape.reading import read_picture
    from sketch2shape.search import FoundSweep, find_all, sweep_as_object

    try:
        picture = read_picture(case.picture, reduced=True)
        ink = find_ink(picture)
        found = [f for f in find_all(ink) if isinstance(f, FoundSweep)]
        objects = tuple(choose_front(sweep_as_object(f, ink)) for f in found)
        told = reported(Result(objects, tuple(map(lift, objects)), picture, {}))["objects"]
    except Sketch2ShapeError:
        return []
    right = curves.has_curves(case.truth) and curves.judge(case.truth, told).exact
    return [Answer(case, f.witnesses, right) for f in found if f.witnesses is not None]


def fit(answers: Sequence[Answer]) -> SweepWeights:
    """Mean, spread and weight of each witness, and the bias."""
    x = np.nan_to_num(np.array([a.witnesses for a in answers]))
    right = np.array([a.right for a in answers], float)
    flat = SweepWeights(tuple(x.mean(axis=0)), tuple(np.maximum(x.std(axis=0), 1e-6)))
    z = np.column_stack([sweep_terms(x, flat), np.ones(len(x))])

    def loss(w: Floats) -> tuple[float, Floats]:
        t = z @ w
        held = np.append(w[:-1], 0.0)
        cost = float(np.logaddexp(0.0, np.where(right > 0, -t, t)).sum() + 0.5 * RIDGE * held @ held)
        return cost, z.T @ (1.0 / (1.0 + np.exp(-t)) - right) + RIDGE * held

    bounds = [_bounds(name) for name in SWEEP_WITNESSES] + [(None, None)]
    w = minimize(loss, np.zeros(z.shape[1]), jac=True, method="L-BFGS-B", bounds=bounds).x
    centre, spread, weight = (tuple(round(float(v), 4) for v in p) for p in (flat.centre, flat.spread, w[:-1]))
    return SweepWeights(centre, spread, weight, round(float(w[-1]), 4))


def _bounds(name: str) -> tuple[float | None, float | None]:
    if name in EITHER:
        return None, None
    return (0.0, None) if name == "gap" else (None, 0.0)


def _module(weights: SweepWeights) -> str:
    lines = ['"""Weights of the witnesses of sweeps, written by `scripts/fit_sweep_confidence.py`."""', ""]
    for name, values in zip(("CENTRE", "SPREAD", "WEIGHT"), weights[:3], strict=True):
        named = (f"    {v},  # {w}" for v, w in zip(values, SWEEP_WITNESSES, strict=True))
        lines += [f"{name} = (", *named, ")"]
    return "\n".join([*lines, f"BIAS = {weights.bias}"]) + "\n"


def report(answers: Sequence[Answer], weights: SweepWeights) -> str:
    """How far the confidence keeps its promise, by half."""
    rows = []
    for half in ("even", "odd"):
        mine = [a for a in answers if a.case.half == half]
        sure = [a for a in mine if sweep_confidence(a.witnesses, weights) >= 0.9]
        right = [a for a in mine if a.right]
        rows.append(
            [
                half,
                str(len(mine)),
                percent(len(right), len(mine)),
                str(len(sure)),
                percent(sum(a.right for a in sure), len(sure)),
                percent(sum(sweep_confidence(a.witnesses, weights) >= 0.9 for a in right), len(right)),
            ]
        )
    return table(["half", "answers", "right", ">= 0.9", "of these right", "right ones >= 0.9"], rows)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="keep the weights; take drawings of another seed")
    parser.add_argument("--seed", type=int, default=7000, help="of the drawings")
    parser.add_argument("--per-category", type=int, default=10, help="drawings of each kind")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--seconds", type=float, default=30.0, help="limit for one drawing")
    return parser.parse_args()


if __name__ == "__main__":
    main()
