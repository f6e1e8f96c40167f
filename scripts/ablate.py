"""Switch each mechanism of the heart off, one at a time, and tell what it earns: right answers, sure errors, time.

    python scripts/ablate.py --sets drawings hard --most 8            a sample, table on the screen
    python scripts/ablate.py --mechanisms 'second*' --sets fresh --per-category 1
    python scripts/ablate.py --page docs/heart.md                     the table of the page written anew

The weights of the witnesses stay as they were fitted. Time is that of the processor: other work beside counts little.
"""

from __future__ import annotations

import argparse
import fnmatch
import os
import pkgutil
import shlex
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

os.environ.setdefault("OMP_NUM_THREADS", "1")  # worker processes, a core each
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
import repository  # noqa: F401 - for `evaluation`
from mechanisms import MECHANISMS, Mechanism

import sketch2shape as s2s
from evaluation.cases import Case, collect
from evaluation.markdown import part_replaced, table
from evaluation.measure import in_processes, measure
from evaluation.options import add_drawings, add_sets, add_work, wanted
from evaluation.outcome import Outcome

UNCHANGED = 0.2
"""Part by which times may differ by chance: on a busy machine they did by up to so much where nothing had changed."""


"""What can be switched off, in the order of the table."""


class Effect(NamedTuple):
    """What a mechanism does to a set of drawings.

    earned, spoilt : answers that are right with it alone, and without it alone
    averted, made  : answers that are sure and wrong without it alone, and with it alone
    time           : processor time with it over that without it
    """

    earned: int
    spoilt: int
    averted: int
    made: int
    time: float

    @classmethod
    def of(cls, on: Sequence[Outcome], off: Sequence[Outcome]) -> Effect:
        """From the outcomes of the same drawings with it and without it."""
        pairs = list(zip(on, off, strict=True))
        right = [(a.right is True, b.right is True) for a, b in pairs]
        sure = [(a.wrong and a.sure, b.wrong and b.sure) for a, b in pairs]
        spent = sum(a.ms for a in on) / max(sum(b.ms for b in off), 1e-9)
        there, not_there = (True, False), (False, True)
        return cls(right.count(there), right.count(not_there), sure.count(not_there), sure.count(there), spent)

    @property
    def cells(self) -> list[str]:
        """Of the table."""
        return [_signed(self.earned, self.spoilt), _signed(self.made, self.averted), f"{self.time:.2f}"]

    @property
    def is_earning(self) -> bool:
        """Whether it gives right answers, averts sure errors or saves time."""
        return bool(self.earned or self.averted or self.time < 1 - UNCHANGED)


def _signed(more: int, fewer: int) -> str:
    return " ".join(f"{sign}{count}" for sign, count in (("+", more), ("-", fewer)) if count)


@contextmanager
def switched_off(mechanism: Mechanism) -> Iterator[None]:
    """Leave a mechanism out in this process for a while."""
    with ExitStack() as stack:
        for dotted, instead in mechanism.off.items():
            stack.enter_context(mock.patch(dotted, instead))
        yield


@contextmanager
def noted(asked: set[str]) -> Iterator[None]:
    """Put the dotted names of the functions that could be switched off into a set as soon as they are called."""
    with ExitStack() as stack:
        for dotted in {d for m in MECHANISMS for d, instead in m.off.items() if callable(instead)}:
            place, name = dotted.rsplit(".", 1)
            stack.enter_context(mock.patch(dotted, _noting(getattr(pkgutil.resolve_name(place), name), dotted, asked)))
        yield


def _noting(function: Callable[..., Any], dotted: str, asked: set[str]) -> Callable[..., Any]:
    def called(*args: Any, **options: Any) -> Any:
        asked.add(dotted)
        return function(*args, **options)

    return called


def measured(case: Case) -> Outcome:
    """The outcome of a drawing, with the time of the processor."""
    spent = 0.0

    def answered(picture: str) -> Any:
        nonlocal spent
        start = time.process_time()
        try:
            return s2s.reconstruct(picture)
        finally:
            spent = time.process_time() - start

    return replace(measure(case, answered), ms=spent * 1e3)


def compared(case: Case, names: Sequence[str]) -> list[Outcome]:
    """The outcomes of a drawing with the whole heart and without each of some mechanisms."""
    asked: set[str] = set()
    with noted(asked):
        measured(case)
    outcomes = [measured(case)]
    for mechanism in (m for m in MECHANISMS if m.name in names):
        functions = {dotted for dotted, instead in mechanism.off.items() if callable(instead)}
        if functions and functions == mechanism.off.keys() and not functions & asked:
            outcomes.append(outcomes[0])  # it has no say in this drawing
        else:
            with switched_off(mechanism):
                outcomes.append(measured(case))
    return outcomes


Effects = dict[str, dict[str, Effect]]
"""By mechanism, by set."""


def main() -> None:
    args = _arguments()
    names = [m.name for m in MECHANISMS if any(fnmatch.fnmatch(m.name, p) for p in args.mechanisms)]
    effects: Effects = {name: {} for name in names}
    heads, told = [], ""
    with tempfile.TemporaryDirectory() as scratch:
        for of_set in args.sets:
            cases = _spread(collect([of_set], wanted(args, scratch, args.categories)), args.most)
            whole, *without = _runs(cases, names, args.jobs, args.seconds)
            heads.append(f"{of_set}: {sum(o.right is True for o in whole)} of {len(whole)} right")
            for name, outcomes in zip(names, without, strict=True):
                effects[name][of_set] = Effect.of(whole, outcomes)
            told = f"{'; '.join(heads)}.\n\n{effect_table(effects)}\n{idle(effects)}"
            print(heads[-1], flush=True)
            if args.page:
                _write(Path(args.page), told)
    print(told)


def _write(page: Path, told: str) -> None:
    command = shlex.join(["python", "scripts/ablate.py", *_recorded(sys.argv[1:])])
    page.write_text(part_replaced(page.read_text("utf-8"), "ablate", f"    {command}\n\n{told}"), "utf-8")


def _recorded(options: Sequence[str]) -> Iterator[str]:
    """The options for the page, without where things lie on this machine."""
    local = ("--bench", "--page", "--jobs")
    yield from (o for i, o in enumerate(options) if o not in local and (i == 0 or options[i - 1] not in local))


def _spread(cases: Sequence[Case], most: int) -> list[Case]:
    """So many of the drawings, at even distances; all for 0."""
    return [cases[k] for k in np.linspace(0, len(cases) - 1, min(most or len(cases), len(cases))).astype(int)]


def _runs(cases: Sequence[Case], names: Sequence[str], jobs: int, seconds: float) -> list[tuple[Outcome, ...]]:
    """Outcomes of the drawings with the whole heart, and without each mechanism; without those of a lost worker."""
    calls = [(case, names) for case in cases]
    found = []
    for case, answer in zip(cases, in_processes(compared, calls, jobs, seconds * (len(names) + 2)), strict=True):
        if isinstance(answer, Exception):
            print(f"left out: {case.set}: {case.id}  {type(answer).__name__}: {answer}", flush=True)
        else:
            found.append(answer)
            for name, outcome in zip(names, answer[1:], strict=True):
                if outcome.status == "crashed":
                    print(f"crashed without {name}: {case.set}: {case.id}  {outcome.cause}", flush=True)
    return list(zip(*found, strict=True)) if found else [()] * (len(names) + 1)


def effect_table(effects: Effects) -> str:
    """One row a mechanism; three columns a set: right answers, sure errors, time."""
    sets = list(next(iter(effects.values())))
    head = ["mechanism", "room", *(word for name in sets for word in (name, "sure errors", "time"))]
    rooms = {m.name: m.room for m in MECHANISMS}
    rows = [[name, rooms[name], *(c for e in found.values() for c in e.cells)] for name, found in effects.items()]
    return table(head, rows)


def idle(effects: Effects) -> str:
    """Names of the mechanisms that earn nothing on any set."""
    nothing = MECHANISMS[0].name
    names = [name for name, e in effects.items() if name != nothing and not any(x.is_earning for x in e.values())]
    return f"Earn nothing on these drawings: {'; '.join(names) or 'none'}.\n"


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_sets(parser, chosen=["drawings", "hard", "curved", "real"])
    parser.add_argument("--categories", nargs="+", default=["*"], metavar="PATTERN")
    parser.add_argument("--mechanisms", nargs="+", default=["*"], metavar="PATTERN")
    parser.add_argument("--most", type=int, default=0, metavar="N", help="so many drawings of each set, evenly; 0: all")
    add_drawings(parser, seed=7, per_category=1)
    add_work(parser, seconds=30)
    parser.add_argument("--page", default="", help="page whose table is written anew, set after set")
    return parser.parse_args()


if __name__ == "__main__":
    main()
