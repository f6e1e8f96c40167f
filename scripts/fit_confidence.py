"""Fit how sure an answer is to what speaks for and against it, and say how well that holds.

    python scripts/fit_confidence.py                        fit, report both halves, write evidence/weights.py
    python scripts/fit_confidence.py --only chords          the weight of one witness; all others stay as they are
    python scripts/fit_confidence.py --sets fresh --check   the weights that are there, on drawings made anew

A logistic regression of right and wrong on the witnesses (`sketch2shape.evidence.witness`), and one on how sure that
makes an answer by itself and how close a rival comes. The even half of each set is fitted; the odd half only tells how
well that holds.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each

import numpy as np
from repository import ROOT

from evaluation import curves, meshes, metrics
from evaluation.cases import Case, collect
from evaluation.logistic import AGAINST, FOR, FREE, Answer, fitted, module_text, promise
from evaluation.measure import in_processes
from evaluation.options import add_drawings, add_sets, add_work, wanted
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.evidence import WITNESSES, Weights, confidence
from sketch2shape.evidence.calibration import probability, standardised, terms
from sketch2shape.evidence.rivals import AGAINST_RIVALS, beside
from sketch2shape.model import Floats

EVIDENCE = ROOT / "sketch2shape" / "evidence"
WEIGHTS, RIVAL_WEIGHTS = EVIDENCE / "weights.py", EVIDENCE / "rival_weights.py"
SETS = ("fresh", "hard", "real", "real2", "refuse", "abc")
FLAT, FLAT_TIMES = ("no_flat", "no_diagonals"), 8
"""Kinds of flat figures, of which so many times as many are drawn: they look most like objects, and are none."""
EITHER = {"vertices", "shallow", "small"}
"""Witnesses that may speak for an answer; all others can only speak against it, whatever the drawings happen to say."""
TERMS = ("whole", *WITNESSES)
BOUNDS = (FREE, *(FREE if name in EITHER else AGAINST for name in WITNESSES))
ABOUT = "Weights of the witnesses, written by `scripts/fit_confidence.py`; see `calibration`."
BESIDE = ("alone", "rival")
ABOUT_RIVALS = "Weights of a rival, written by `scripts/fit_confidence.py`; see `rivals`."


def main() -> None:
    args = _arguments()
    with tempfile.TemporaryDirectory() as scratch:
        asked = wanted(args, scratch)
        flat = replace(
            asked, categories=FLAT, scratch=asked.scratch / "flat", per_category=FLAT_TIMES * asked.per_category
        )
        drawn = [*collect(args.sets, asked), *(collect(["fresh"], flat) if "fresh" in args.sets else [])]
        cases = [case for case in drawn if case.truth.get("objects", ()) is not None]
        given = in_processes(_answers, [(case,) for case in cases], args.jobs, args.seconds)
    sets: dict[str, list[Answer]] = {case.set: [] for case in cases}
    for case, some in zip(cases, given, strict=True):
        sets[case.set] += [] if isinstance(some, Exception) else some
    every = [a for some in sets.values() for a in some]
    weights, rivals = Weights(), AGAINST_RIVALS
    if not args.check:
        even = [a for a in every if a.half == "even"]
        alone = [a._replace(witnesses=a.witnesses[:-1]) for a in even]
        weights = _with_one(alone, args.only, weights) if args.only else fitted(alone, terms, BOUNDS)
        if not args.only:
            beside_rivals = [a._replace(witnesses=_beside(a, weights)) for a in even]
            rivals = fitted(beside_rivals, standardised, (FOR, AGAINST))
        for path, text in (
            (WEIGHTS, module_text(ABOUT, weights, WITNESSES, TERMS)),
            (RIVAL_WEIGHTS, module_text(ABOUT_RIVALS, rivals, BESIDE, BESIDE)),
        ):
            path.write_text(text)
            print(f"wrote {path}")
    told = {name: [a._replace(witnesses=_beside(a, weights)) for a in some] for name, some in sets.items()}
    told["all"] = [a for some in told.values() for a in some]
    print(promise(told, lambda seen: probability(standardised(seen, rivals), rivals)))


def _with_one(answers: list[Answer], only: str, held: Weights) -> Weights:
    """These weights but that of one witness, which is fitted beside them."""
    bounds = [b if n == only else (w, w) for n, b, w in zip(TERMS, BOUNDS, held.weight, strict=True)]
    return fitted(answers, terms, bounds, bias=(held.bias, held.bias), scale=held)


def _beside(answer: Answer, weights: Weights) -> Floats:
    """What is weighed of an answer whose last witness is its rival."""
    return beside(confidence(answer.witnesses[:-1], weights), float(answer.witnesses[-1]))


def _answers(case: Case) -> list[Answer]:
    """Every hypothesis found in a drawing, refused ones too; how close its rival comes is the last of its witnesses."""
    from sketch2shape.ink import find_ink
    from sketch2shape.reading import read_picture
    from sketch2shape.search import Found, as_object, find_closely

    try:
        ink = find_ink(read_picture(case.picture, reduced=True))
    except Sketch2ShapeError:
        return []
    found, ink = find_closely(ink)
    straight = [f for f in found if isinstance(f, Found) and f.witnesses is not None]
    return [
        Answer(np.append(f.witnesses, f.rival), _is_right(case, as_object(f.rings, f.evidence, ink)), case.half)
        for f in straight
    ]


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


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_sets(parser, SETS)
    add_drawings(parser, seed=31, per_category=2)
    add_work(parser, seconds=60)
    parser.add_argument("--only", choices=WITNESSES, help="fit the weight of one witness beside those that are there")
    parser.add_argument("--check", action="store_true", help="leave the weights as they are")
    return parser.parse_args()


if __name__ == "__main__":
    main()
