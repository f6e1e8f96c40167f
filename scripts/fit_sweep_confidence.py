"""Fit how sure an answer with arcs or a point is to what speaks for and against it, and say how well that holds.

    python scripts/fit_sweep_confidence.py            fit, report both halves, write evidence/sweep_weights.py
    python scripts/fit_sweep_confidence.py --check    the weights that are there, on drawings of another seed

A logistic regression of right and wrong on the witnesses (`sketch2shape.evidence.sweep_witness`), on drawings that the
generator makes: round and pointed ones in all styles, and what is no such object; and, where they are at hand, on
drawings of others, among them straight ones. Even drawings are fitted; the odd ones only tell how well that holds.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each

from repository import ROOT

from evaluation.cases import BENCH, Case, Wanted, collect
from evaluation.logistic import AGAINST, FOR, FREE, Answer, fitted, module_text, promise
from evaluation.measure import in_processes, judged
from evaluation.options import add_drawings, add_work
from evaluation.outcome import Outcome
from sketch2shape.errors import Sketch2ShapeError
from sketch2shape.evidence import SWEEP_WITNESSES, sweep_confidence
from sketch2shape.evidence.calibration import standardised
from sketch2shape.evidence.sweep_calibration import SWEEP_WEIGHTS
from sketch2shape.ink import Group, find_ink, split_groups
from sketch2shape.lifting import choose_front
from sketch2shape.model import Picture, TwoFaceObject
from sketch2shape.pipeline import Result, lift
from sketch2shape.pipeline.report import report
from sketch2shape.reading import read_picture
from sketch2shape.search import FoundSweep, sweep_as_object
from sketch2shape.search.objects import LEAST_COMPANION, SOME_BOWED, bowed_part
from sketch2shape.search.observed import observed
from sketch2shape.search.sweeping import find_sweep
from sketch2shape.sweeps import Sweep

WEIGHTS = ROOT / "sketch2shape" / "evidence" / "sweep_weights.py"
KINDS = ("cylinder_*", "tube_*", "plate_*", "arcs_*", "cone_*", "frustum_*", "pyramid_*", "curved_*", "no_*")
"""Kinds of drawings that such answers are given to."""
OTHERS = ("curved", "abc", "hard", "real", "real2")
"""Sets of drawings that are not in this repository."""
EITHER = {"numbers", "shallow", "small", "pointed", "holes"}
"""Witnesses that may speak for an answer or against it; `gap` speaks for it, all others against."""
BOUNDS = tuple(FREE if name in EITHER else FOR if name == "gap" else AGAINST for name in SWEEP_WITNESSES)
ABOUT = "Weights of the witnesses of sweeps, written by `scripts/fit_sweep_confidence.py`; see `sweep_calibration`."


def main() -> None:
    args = _arguments()
    with tempfile.TemporaryDirectory() as scratch:
        made = Wanted(args.bench, Path(scratch), KINDS, args.seed + args.check, args.per_category)
        cases = [*collect(["fresh"], made), *collect(OTHERS, replace(made, categories=("*",)))]
        given = in_processes(_answers, [(case,) for case in cases], args.jobs, args.seconds)
    sets: dict[str, list[Answer]] = {case.set: [] for case in cases}
    for case, some in zip(cases, given, strict=True):
        sets[case.set] += [] if isinstance(some, Exception) else some
    answers = [a for some in sets.values() for a in some]
    weights = SWEEP_WEIGHTS
    if not args.check:
        weights = fitted([a for a in answers if a.half == "even"], standardised, BOUNDS)
        args.output.write_text(module_text(ABOUT, weights, SWEEP_WITNESSES, SWEEP_WITNESSES))
        print(f"wrote {args.output}")
    print(promise(sets | {"all": answers}, lambda witnesses: sweep_confidence(witnesses, weights)))


def _answers(case: Case) -> list[Answer]:
    """The best answer with arcs or a point for each group of ink, also where the search would not give it."""
    try:
        picture = read_picture(case.picture, reduced=True)
        ink = find_ink(picture)
    except Sketch2ShapeError:
        return []
    groups = split_groups(ink)
    found = [_swept(g) for g in groups if g.size >= LEAST_COMPANION * groups[0].size]  # smaller ones are letters
    told = [(f.witnesses, choose_front(sweep_as_object(f, ink))) for f in found if f is not None]
    return [Answer(seen, _is_right(case, obj, picture), case.half) for seen, obj in told if seen is not None]


def _swept(group: Group) -> FoundSweep | None:
    """The best sweep for a group of ink as `search.objects` asks for it; one that it would never give is none."""
    seen = observed(group)
    if seen is None:
        return None
    found = find_sweep(seen, arcs=bowed_part(seen.skeleton, seen.view.size) >= SOME_BOWED)
    return found.shifted(group.offset) if found is not None and _is_proper(found.sweep) else None


def _is_proper(sweep: Sweep) -> bool:
    return sweep.has_arcs or sweep.way.is_pointed


def _is_right(case: Case, obj: TwoFaceObject, picture: Picture) -> bool:
    try:
        result = Result((obj,), (lift(obj),), picture, {})
    except Sketch2ShapeError:
        return False
    outcome = judged(Outcome(case, answers=tuple(report(result)["objects"])), list(result.solids))
    return outcome.right is True


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="keep the weights; take drawings of another seed")
    add_drawings(parser, seed=7000, per_category=10)
    parser.add_argument("--bench", type=Path, default=BENCH)
    add_work(parser, seconds=30)
    parser.add_argument("--output", type=Path, default=WEIGHTS, metavar="FILE", help="where the weights are written")
    return parser.parse_args()


if __name__ == "__main__":
    main()
