"""Measure the tool on drawings with truth and write docs/results.md.

    python scripts/evaluate.py                     all sets, page rewritten
    python scripts/evaluate.py --sets fresh --categories 'photo_*' --page ''     one kind, table on the screen only
    python scripts/evaluate.py --page '' --raw A.json      to be compared with another run by compare_runs.py

Sets: `committed` (data/synthetic), `fresh` (every category, drawn anew from --seed), and, where --bench exists,
`drawings`, `hard`, `real`, `real2`, `refuse`, `curved`, `abc`: independent drawings and real pictures that are not in
this repository.
"""

from __future__ import annotations

import argparse
import os
import shlex
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from repository import ROOT

from evaluation.cases import collect
from evaluation.confidence import confidence_tables
from evaluation.failures import write_sheets
from evaluation.measure import run
from evaluation.options import add_drawings, add_sets, add_work, wanted
from evaluation.outcome import save
from evaluation.page import FRESH, summary_table, write_page


def main() -> None:
    args = _arguments()
    with tempfile.TemporaryDirectory() as scratch:
        outcomes = run(collect(args.sets, wanted(args, scratch, args.categories)), args.jobs, args.seconds)
        if args.raw:
            save(outcomes, Path(args.raw))
        if args.page:
            page = Path(args.page)
            sheets = write_sheets([o for o in outcomes if o.case.set in FRESH], page.parent / "failures")
            write_page(page, outcomes, recorded(sys.argv[1:]), sheets, args.jobs)
        print(summary_table(outcomes))
        print(confidence_tables(outcomes))


def recorded(options: Sequence[str]) -> str:
    """The command for the page, without where things lie on this machine."""
    local = ("--raw", "--page", "--bench")
    kept = [o for i, o in enumerate(options) if o not in local and (i == 0 or options[i - 1] not in local)]
    return shlex.join(["python", "scripts/evaluate.py", *kept])


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_sets(parser)
    parser.add_argument("--categories", nargs="+", default=["*"], metavar="PATTERN")
    add_drawings(parser, seed=7, per_category=4)
    add_work(parser, seconds=30)
    parser.add_argument("--page", default=str(ROOT / "docs" / "results.md"), help="'' writes none")
    parser.add_argument("--raw", help="write one JSON record a drawing")
    return parser.parse_args()


if __name__ == "__main__":
    main()
