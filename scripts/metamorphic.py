"""Change drawings in ways that mean nothing and count how often the answer stays the same.

    python scripts/metamorphic.py                          every tenth drawing of all sets
    python scripts/metamorphic.py --sets real --every 1 --transforms 'scale*' --changed

Transformations: shift, padding, quarter turns, mirror, scale 0.5 to 2, inverted and coloured, JPEG 80 and 50, shade.
"""

from __future__ import annotations

import argparse
import dataclasses
import fnmatch
import json
import os
import tempfile
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import repository  # noqa: F401 - for `evaluation`

from evaluation.cases import SETS, collect
from evaluation.markdown import table
from evaluation.measure import in_processes
from evaluation.metamorphic import Trial, metamorphic_table, trials
from evaluation.options import add_drawings, add_sets, add_work, wanted
from evaluation.transforms import TRANSFORMS


def main() -> None:
    args = _arguments()
    names = [n for n in TRANSFORMS if any(fnmatch.fnmatch(n, p) for p in args.transforms)]
    with tempfile.TemporaryDirectory() as scratch:
        cases = collect(args.sets, wanted(args, scratch, args.categories))[:: args.every]
        answers = in_processes(trials, [(case, names) for case in cases], args.jobs, args.seconds * (len(names) + 1))
    found = [trial for answer in answers if not isinstance(answer, Exception) for trial in answer]
    if args.raw:
        Path(args.raw).write_text(json.dumps([dataclasses.asdict(t) for t in found]))
    print(metamorphic_table(found))
    print(_by_set(found))
    if args.changed:
        for trial in found:
            if trial.verdict != "same":
                print(f"{trial.verdict:7s} {trial.transform:10s} {trial.of_set}: {trial.id}  {trial.moved:+.2f}")
    for case, answer in zip(cases, answers, strict=True):
        if isinstance(answer, Exception):
            print(f"{case.set}: {case.id}  {type(answer).__name__}: {answer}")


def _by_set(found: list[Trial]) -> str:
    """Share of the same answers, one row a transformation, one column a set."""
    sets = list(dict.fromkeys(t.of_set for t in found))
    rows = []
    for name in dict.fromkeys(t.transform for t in found):
        groups = [[t for t in found if t.transform == name and t.of_set == s] for s in sets]
        rows.append([name, *(f"{100 * sum(t.verdict == 'same' for t in g) / max(len(g), 1):.0f}" for g in groups)])
    return table(["same %", *sets], rows)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_sets(parser, chosen=[s for s in SETS if s != "fresh"])
    parser.add_argument("--categories", nargs="+", default=["*"], metavar="PATTERN")
    parser.add_argument("--transforms", nargs="+", default=["*"], metavar="PATTERN")
    parser.add_argument("--every", type=int, default=10, metavar="N", help="take each N-th drawing only")
    add_drawings(parser, seed=7, per_category=1)
    add_work(parser, seconds=20)
    parser.add_argument("--changed", action="store_true", help="list the drawings whose answer changed")
    parser.add_argument("--raw", help="write one JSON record a trial")
    return parser.parse_args()


if __name__ == "__main__":
    main()
