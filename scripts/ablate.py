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

import sketch2shape as s2s
from evaluation.cases import Case, collect
from evaluation.markdown import part_replaced, table
from evaluation.measure import in_processes, measure
from evaluation.options import add_drawings, add_sets, add_work, wanted
from evaluation.outcome import Outcome
from sketch2shape.fit import refinement
from sketch2shape.search import tolerances
from sketch2shape.sweeps import Way

UNCHANGED = 0.2
"""Part by which times may differ by chance: on a busy machine they did by up to so much where nothing had changed."""


HUGE = 1e9
"""Instead of a limit: infinity times nothing is no number."""


class Mechanism(NamedTuple):
    """Something the heart does that it could leave out.

    name : in words
    off  : dotted name of each function or constant -> what stands in for it where the mechanism is switched off
    """

    name: str
    off: dict[str, Any]

    @property
    def room(self) -> str:
        """Where it lives."""
        return next(iter(self.off), "..").split(".")[1]


def _first(first: Any, *_: Any, **__: Any) -> Any:
    return first


def _least_nats(found: Any) -> Any:
    return min(found, key=lambda f: f.nats)


def _first_two(first: Any, second: Any, *_: Any) -> Any:
    return first, second


def _always(value: Any) -> Callable[..., Any]:
    return lambda *_, **__: value


def _only_measured(rings: Any, *how: Any) -> Any:
    return rings, refinement.refine(rings, *how)[1]


def _as_it_is(sweep: Any) -> Any:
    return [sweep]


def _in(module: str, **off: Any) -> dict[str, Any]:
    return {f"sketch2shape.{module}.{name}": value for name, value in off.items()}


def _as_good(stacked: Any, _: Any = None) -> Any:
    """One for each, instead of a bound."""
    return np.ones(len(stacked.vertices))


def _but_the_last(*how: Any) -> Any:
    return tolerances.rounds_for(*how)[:-1]


def _all_simple(polygons: Any) -> Any:
    return np.ones(len(polygons), np.bool_)


def _as_swept(_: Any, backs: Any, *__: Any) -> Any:
    return [None] * len(backs)


def _as_guessed(shift: Any, *_: Any) -> Way:
    return Way(shift)


_NONE, _NO = _always(()), _always(False)
_NO_MAPS = _always(np.zeros((0, 3, 3)))

MECHANISMS = (
    Mechanism("nothing: how far times differ by chance", {}),
    Mechanism("exact reading of ruled vector lines", _in("search.objects", find_exact=_always(None))),
    # the search for straight objects
    Mechanism("wireframes", _in("search.attempts", wire_hypotheses=_NONE)),
    Mechanism("faces of regions", _in("hypotheses.opaque", caps=_NONE)),
    Mechanism("faces of regions without corners", _in("hypotheses.opaque", loose_caps=_NONE)),
    Mechanism("second look", _in("search.search", second_attempts=_NONE)),
    Mechanism("second look: walks", _in("search.attempts", walked=_NONE)),
    Mechanism("second look: unions of regions", _in("search.attempts", united=_NONE)),
    Mechanism("third look: neighbours", _in("search.search", climbed_attempts=_NONE)),
    Mechanism("hidden vertices on the plainest map", _in("search.search", with_hidden=_first)),
    Mechanism("tips ahead of where strokes run into one", _in("hypotheses.opaque", _with_tips=_first_two)),
    Mechanism("edges cut off by the border", _in("search.objects", closed_at_border=_always(None))),
    Mechanism("early rounds for wireframes alone", _in("search.attempts", _early=_always([]))),
    Mechanism("a close look", _in("search.attempts", BENT=np.inf, STEADY=0.0)),
    Mechanism("fine rounds later where lines are known", _in("search.attempts", _likely_first=_first)),
    Mechanism("few ends in threes: no wireframe", _in("search.attempts", FEW_IN_THREES=0.0)),
    Mechanism("rounds limited by narrow ink", _in("search.attempts", COARSEST=np.inf)),
    Mechanism("the last resort", _in("search.attempts", rounds_for=_but_the_last)),
    Mechanism("the last resort has to be good", _in("search.attempts", ROUGH=0.0)),
    Mechanism("gaps at corners bridged", _in("search.search", bridged=_always(None))),
    Mechanism("textures and scribbles given up", _in("search.search", _is_no_drawing=_NO, _is_scribble=_NO)),
    Mechanism("stale searches end", _in("search.search", STALE=np.inf)),
    Mechanism("hidden vertices where dashes meet", _in("search.search", _at_dashes=_first_two)),
    Mechanism("a vertex caught by wrong ink put right", _in("search.search", _put_right=_first_two)),
    Mechanism("dashes told by thin ink", _in("search.search", is_dashed=_NO)),
    Mechanism("a tie goes to the first", _in("search.search", TIE=0.0)),
    Mechanism("one hand", _in("search.search", _hand=_always(np.inf))),
    Mechanism("a plain answer limits vertices", _in("search.search", _is_plainest=_NO)),
    Mechanism("an exact answer ends a round", _in("search.search", _is_exact=_NO)),
    Mechanism("a plain answer ends a source", _in("search.shortlist", _is_plain=_NO)),
    Mechanism("a vain source ends", _in("search.shortlist", VAIN=HUGE)),
    Mechanism("a first look bounds the score", _in("search.shortlist", most_possible=_as_good)),
    Mechanism("shallow objects are none", _in("search.shortlist", SHALLOWEST=0.0)),
    # moving to the ink
    Mechanism(
        "refinement", _in("search.search", refine=_only_measured) | _in("fit.simplification", refine=_only_measured)
    ),
    Mechanism("simplification", _in("search.search", simplified=_first_two)),
    Mechanism("simplification: settled ways", _in("fit.simplification", MOST_SETTLED=0)),
    Mechanism("simplification: unseen bends", _in("fit.simplification", UNSEEN_BEND=0.0)),
    Mechanism("simplification: marks at corners", _in("fit.simplification", MARK=0.0)),
    Mechanism("polishing of sweeps", _in("search.found_sweep", polished=_first)),
    Mechanism("polishing: ratio of circles held", _in("fit.polishing", FIXED_RATIO=0.0)),
    # the judge
    Mechanism("the weakest edge holds a score", _in("evidence.score", _held_by=np.ones_like)),
    Mechanism("edges along others cost", _in("evidence.energy", coincidences=_always(0))),
    Mechanism("gaps at ends are cheap", _in("evidence.energy", GAP_PRICE=1.0)),
    Mechanism("edges explain no more than their length", _in("evidence.energy", CROWDED=HUGE)),
    Mechanism("no more noise than the hand's", _in("evidence.energy", STEADY=HUGE)),
    Mechanism("long foreign strokes are cheaper", _in("evidence.view", STROKE_UNIT=HUGE)),
    Mechanism("strokes across others are told once", _in("evidence.view", MOST_LINKED=0)),
    Mechanism("specks are cheap", _in("evidence.view", SPECK=1.0, DASH=1.0)),
    # sources of straight objects
    Mechanism("back faces pulled to drawn rungs", _in("hypotheses.opaque", _pulled=_as_swept)),
    Mechanism("cut tips of regions sharpened", _in("hypotheses.opaque", sharpened=_first)),
    Mechanism("maps from two rungs", _in("hypotheses.wireframe", _from_two=_NO_MAPS)),
    Mechanism("maps from three rungs", _in("hypotheses.wireframe", _from_three=_NO_MAPS)),
    Mechanism("holes of wireframes", _in("hypotheses.wireframe", with_holes=_always(None))),
    Mechanism("faces are simple polygons", _in("hypotheses.hypothesis", _are_simple=_all_simple)),
    # the search for objects with arcs and points
    Mechanism("sweeps", _in("search.objects", find_sweep=_always(None))),
    Mechanism("a likely sweep stands at once", _in("search.objects", LIKELY=np.inf)),
    Mechanism("sweeps for ink that may be a hole", _in("search.objects", _leaves_some=_NO)),
    Mechanism("bare figures are no answers", _in("search.objects", LACKING=np.inf)),
    Mechanism("sweeps: wireframes", _in("search.sweep_pairs", _coherent=_NONE)),
    Mechanism("sweeps: loops moved", _in("search.sweep_pairs", _moved=_NONE)),
    Mechanism("sweeps: loops drawn together", _in("search.sweep_pairs", _drawn_together=_NONE)),
    Mechanism("sweeps: put together from rungs", _in("search.sweeping", joined=_NONE)),
    Mechanism("shifts told by rungs", _in("search.sweep_pairs", wire_shifts=_always([]))),
    Mechanism(
        "sweeps compared under one hand",
        _in("search.found_sweep", cheapest=_least_nats)
        | _in("search.sweep_improvement", cheapest=_least_nats)
        | _in("search.sweeping", cheapest=_least_nats),
    ),
    Mechanism("sweeps: pyramids", _in("search.sweeping", _likely_pyramids=_always([]))),
    Mechanism("sweeps: ellipses", _in("search.sweep_pairs", ellipses=_always([]))),
    Mechanism("sweeps: enclosed loops", _in("search.sweep_pairs", enclosed_loops=_always([]))),
    Mechanism("close loops replace rough ones", _in("search.sweep_pairs", WHOLE=np.inf)),
    Mechanism("ways settled before they are cut", _in("search.sweep_pairs", settled=_first)),
    Mechanism("shifts settled on wires", _in("search.sweep_pairs", settled_wire=_as_guessed)),
    Mechanism("holes tell the shape of arcs", _in("search.sweep_pairs", MOST_HINTS=0)),
    Mechanism(
        "circles of a face in one frame",
        _in("search.sweep_pairs", in_one_frame=tuple) | _in("search.sweep_improvement", in_one_frame=tuple),
    ),
    Mechanism("a sweep's hand by the median", _in("search.found_sweep", _hand=_always(np.inf))),
    Mechanism("lines at smooth joints", _in("search.found_sweep", _manners=_as_it_is)),
    Mechanism("depth has to be seen", _in("search.sweeping", _shows_depth=_always(True))),
    Mechanism("hidden lines told as dashed", _in("search.sweeping", _dashed=_first)),
    Mechanism("shifts that grow in perspective", _in("search.sweep_improvement", _in_perspective=_first)),
    Mechanism("holes of sweeps", _in("search.sweep_improvement", with_holes=_first)),
    Mechanism("closed lines in faces are likely holes", _in("evidence.energy", LIKELY_HOLE=0.0)),
    Mechanism("needless vertices of sweeps dropped", _in("search.sweep_improvement", _simpler=_first)),
    Mechanism("notches of outlines dropped", _in("search.sweep_improvement", _without_notches=_NONE)),
    Mechanism("outlines put on the ink of both faces", _in("search.sweep_pairs", retraced=_first)),
    Mechanism("straight objects with round holes", _in("search.objects", find_drilled=_always(None))),
    Mechanism("points stand plumb", _in("search.found_sweep", _leaning=_always(0.0))),
    Mechanism("sides of a base cost", _in("search.sweeping", SIDE=0.0)),
    # sources of objects with arcs and points
    Mechanism("sweeps seen from the other side", _in("sweeps.sweep.Sweep", reversed=_first)),
    Mechanism("silhouettes are sure to be seen only whole", _in("sweeps.sweep", _doubtful=_first)),
    Mechanism("regular bases half hidden", _in("sweeps.pyramids", _regular_bases=_NONE)),
    Mechanism("feet of a pyramid by themselves", _in("sweeps.pyramids", _feet=_first)),
)
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
