"""Draw test drawings with truth: OUT/CATEGORY/NNN.png (or .jpg) with NNN.json beside each.

    python scripts/make_drawings.py OUT --seed 7 --per-category 12 --categories 'photo_*' negative

The same seed gives the same bytes.
"""

from __future__ import annotations

import argparse
import fnmatch
from pathlib import Path

import repository  # noqa: F401 - for `synthetic`

from synthetic.drawing import draw
from synthetic.recipes import RECIPES


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path, nargs="?")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--per-category", type=int, default=6, metavar="N")
    parser.add_argument("--categories", nargs="+", default=["*"], metavar="PATTERN", help="names or patterns")
    parser.add_argument("--list", action="store_true", help="print the categories and stop")
    args = parser.parse_args()
    names = [c for c in RECIPES if any(fnmatch.fnmatch(c, p) for p in args.categories)]
    if args.list:
        print("\n".join(names))
        return
    if args.out is None or not names:
        parser.error("give OUT and categories that exist (--list prints them)")
    for name in names:
        for index in range(args.per_category):
            draw(name, args.seed, index).save(args.out)
        print(f"{name}: {args.per_category}")


if __name__ == "__main__":
    main()
