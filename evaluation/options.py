"""Options that scripts share: which drawings are taken, by how many processes, and for how long."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from evaluation.cases import BENCH, SETS, Wanted


def add_drawings(parser: argparse.ArgumentParser, *, seed: int, per_category: int) -> None:
    """Which drawings are made anew."""
    parser.add_argument("--seed", type=int, default=seed, help="of the fresh drawings")
    parser.add_argument(
        "--per-category", type=int, default=per_category, metavar="N", help="fresh drawings of each category"
    )


def add_sets(parser: argparse.ArgumentParser, offered: Sequence[str] = (), chosen: Sequence[str] = ()) -> None:
    """Which sets are taken, and where those lie that are not in this repository.

    offered : names of sets; none: all
    chosen  : those of them that are taken unless others are named; none: all that are offered
    """
    names = tuple(offered or SETS)
    parser.add_argument("--sets", nargs="+", choices=names, default=tuple(chosen or names))
    parser.add_argument("--bench", type=Path, default=BENCH)


def add_work(parser: argparse.ArgumentParser, *, seconds: float) -> None:
    """How many processes work, and for how long."""
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--seconds", type=float, default=seconds, help="for a picture, after which it is given up")


def wanted(args: argparse.Namespace, scratch: str, categories: Sequence[str] = ("*",)) -> Wanted:
    """What these options ask for; drawings made anew go below `scratch`."""
    return Wanted(args.bench, Path(scratch), categories, args.seed, args.per_category)
