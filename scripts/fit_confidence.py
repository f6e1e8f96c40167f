"""Fit how sure an answer is to what speaks for and against it, and say how well that holds.

    python scripts/fit_confidence.py                        fit, report both halves, write evidence/weights.py
    python scripts/fit_confidence.py --sets fresh --check   the weights that are there, on drawings made anew

A logistic regression of right and wrong on the witnesses (`sketch2shape.evidence.witness`). The even half of each set
is fitted; the odd half only tells how well that holds.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each

import numpy as np
from numpy.typing import NDArray
from repository import ROOT
from scipy.optimize import minimize

from evaluation import curves, meshes, metrics
from evaluation.cases import Case, Wanted, collect
from evaluation.markdown import percent, table
from evaluation.measure import in_processes
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.evidence import WITNESSES, confidence
from sketch2shape.evidence.calibration import Weights, terms

WEIGHTS = ROOT / "sketch2shape" / "evidence" / "weights.py"
SETS = ("fresh", "hard", "real", "real2", "refuse", "abc")
EITHER = {"vertices", "shallow", "small"}
"""Witnesses that may speak for an answer; all others can only speak against it, whatever the drawings happen to say."""
RIDGE = 2.0
"""Penalty on the square of a weight: that of two answers that contradict it."""

Floats = NDArray[np.float64]


class Answer(NamedTuple):
    """What speaks for an answer, and whether it is right."""

    case: Case
    witnesses: Floats
    right: bool


def main() -> None:
    args = _arguments()
    with tempfile.TemporaryDirectory() as scratch:
        wanted = Wanted(args.bench, Path(scratch), seed=args.seed, per_category=args.per_category)
        cases = [c for c in collect(args.sets, wanted) if c.truth.get("objects", ()) is not None]
        given = in_processes(_answers, [(case,) for case in cases], args.jobs, args.seconds)
    answers = [a for some in given if not isinstance(some, Exception) for a in some]
    weights = Weights()
    if not args.check:
        weights = fit([a for a in answers if a.case.half == "even"])
        WEIGHTS.write_text(_module(weights))
        print(f"wrote {WEIGHTS.relative_to(ROOT)}")
    print(report(answers, weights))


def _answers(case: Case) -> list[Answer]:
    """Every hypothesis found in a drawing, refused ones too."""
    from sketch2shape.ink import find_ink
    from sketch2shape.reading import read_picture
    from sketch2shape.search import Found, as_object, find_all

    try:
        ink = find_ink(read_picture(case.picture, reduced=True))
    except Sketch2ShapeError:
        return []
    found = ((f.witnesses, as_object(f.rings, f.evidence, ink)) for f in find_all(ink) if isinstance(f, Found))
    return [Answer(case, seen, _is_right(case, obj)) for seen, obj in found if seen is not None]


def _is_right(case: Case, obj: Any) -> bool:
    truth = case.truth
    if curves.has_curves(truth):
        return False
    if "mesh" in truth:
        corners = meshes.corners(meshes.true_mesh(Path(truth["mesh"]), Path(case.picture)))
        return meshes.has_corners(np.asarray(obj.vertices), corners)
    answer = {k: np.asarray(getattr(obj, k)).tolist() for k in ("f1", "f2")}
    answer["holes"] = [{"f1": h.f1.tolist(), "f2": h.f2.tolist()} for h in getattr(obj, "holes", ())]
    shared = {k: v for k, v in truth.items() if k != "objects"}
    return any(metrics.judge(shared | one, [answer]).exact for one in truth.get("objects", [truth]) if one.get("f1"))


def fit(answers: Sequence[Answer]) -> Weights:
    """Mean, spread and weight of each witness, and the bias."""
    x = np.nan_to_num(np.array([a.witnesses for a in answers]))
    right = np.array([a.right for a in answers], float)
    flat = Weights(tuple(x.mean(axis=0)), tuple(np.maximum(x.std(axis=0), 1e-6)))
    z = np.column_stack([terms(x, flat), np.ones(len(x))])

    def loss(w: Floats) -> tuple[float, Floats]:
        t = z @ w
        held = np.append(w[:-1], 0.0)
        cost = float(np.logaddexp(0.0, np.where(right > 0, -t, t)).sum() + 0.5 * RIDGE * held @ held)
        return cost, z.T @ (1.0 / (1.0 + np.exp(-t)) - right) + RIDGE * held

    free = [(None, None)]
    bounds = [*free, *((None, None if name in EITHER else 0.0) for name in WITNESSES), *free]
    w = minimize(loss, np.zeros(z.shape[1]), jac=True, method="L-BFGS-B", bounds=bounds).x
    centre, spread, weight = (tuple(round(float(v), 4) for v in p) for p in (flat.centre, flat.spread, w[:-1]))
    return Weights(centre, spread, weight, round(float(w[-1]), 4))


def _module(weights: Weights) -> str:
    lines = ['"""Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."""', ""]
    for name, values in zip(("CENTRE", "SPREAD", "WEIGHT"), weights[:3], strict=True):
        names = WITNESSES if len(values) == len(WITNESSES) else ("whole", *WITNESSES)
        named = (f"    {v},  # {w}" for v, w in zip(values, names, strict=True))
        lines += [f"{name} = (", *named, ")"]
    return "\n".join([*lines, f"BIAS = {weights.bias}"]) + "\n"


def report(answers: Sequence[Answer], weights: Weights) -> str:
    """How far the confidence keeps its promise, by set and half."""
    rows = []
    for name in (*dict.fromkeys(a.case.set for a in answers), "all"):
        for half in ("even", "odd"):
            some = [a for a in answers if name in (a.case.set, "all") and a.case.half == half]
            sure = [a for a in some if confidence(a.witnesses, weights) >= 0.9]
            right = sum(a.right for a in some)
            kept = sum(a.right for a in sure)
            rows.append([name, half, str(len(some)), str(len(sure)), percent(kept, len(sure)), percent(kept, right)])
    return table(["set", "half", "answers", "sure", "of those right %", "of the right ones sure %"], rows)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", nargs="+", choices=SETS, default=SETS)
    parser.add_argument("--bench", type=Path, default=ROOT.parent / "shared" / "bench")
    parser.add_argument("--seed", type=int, default=31, help="of the drawings made anew")
    parser.add_argument("--per-category", type=int, default=2, metavar="N", help="drawings made anew of each category")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=60, help="after which a picture is given up")
    parser.add_argument("--check", action="store_true", help="leave the weights as they are")
    return parser.parse_args()


if __name__ == "__main__":
    main()
