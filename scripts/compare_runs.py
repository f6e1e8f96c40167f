"""What changed between two runs of `evaluate.py --raw`: fixed, broken, and how sure.

python scripts/compare_runs.py A.json B.json [--moved 0.05]
"""

from __future__ import annotations

import argparse
from pathlib import Path

import repository  # noqa: F401 - for `evaluation`

from evaluation.compare import changes, load, summary


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=Path, metavar="A.json")
    parser.add_argument("after", type=Path, metavar="B.json")
    parser.add_argument("--moved", type=float, default=0.05, help="least change of confidence that is told")
    args = parser.parse_args()
    before, after = load(args.before), load(args.after)
    found = changes(before, after, args.moved)
    print(summary(before, after, found))
    for change in found:
        print(change)


if __name__ == "__main__":
    main()
