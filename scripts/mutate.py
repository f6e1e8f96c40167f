"""Change one operator or constant at a time and see whether the tests of that room notice: mutants that live are holes.

    python scripts/mutate.py                                     25 mutants of the modules that decide
    python scripts/mutate.py --rooms evidence --sample 100       more of one room
    python scripts/mutate.py --modules 'search/obj*' --sample 0  every mutant of some modules

Needs the extra `mutate` (cosmic-ray, which knows how to change code). The tree is copied first, so that nothing is
changed here. A place in the code has one vote in the sample, however many mutants it has.
"""

from __future__ import annotations

import argparse
import ast
import fnmatch
import os
import random
import shlex
import shutil
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from repository import ROOT

from evaluation.markdown import table

PACKAGE = "sketch2shape"
ROOMS = ("evidence", "hypotheses", "search")
"""Rooms that decide."""
PASSED_OVER = ("__init__", "weights", "rival_weights", "sweep_weights")
"""Modules without decisions: names, and numbers that a fit has written."""
COPIED = (PACKAGE, "tests", "pyproject.toml")
"""What the copy has of its own; all else is linked."""
SWAPS = (
    *("Add_Sub", "Sub_Add", "Mul_Div", "Div_Mul", "Pow_Mul", "FloorDiv_Mul", "Mod_Mul"),
    *("BitAnd_BitOr", "BitOr_BitAnd"),
)
TURNS = (
    *("Lt_LtE", "Lt_GtE", "LtE_Lt", "LtE_Gt", "Gt_GtE", "Gt_LtE", "GtE_Gt", "GtE_Lt"),
    *("Eq_NotEq", "NotEq_Eq", "Is_IsNot", "IsNot_Is"),
)
OPERATORS = (
    *("NumberReplacer", "AddNot", "ReplaceAndWithOr", "ReplaceOrWithAnd", "ReplaceTrueWithFalse"),
    *("ReplaceFalseWithTrue", "ReplaceBreakWithContinue", "ReplaceContinueWithBreak", "ZeroIterationForLoop"),
    *(f"ReplaceUnaryOperator_Delete_{name}" for name in ("Not", "USub", "Invert")),
    *(f"ReplaceBinaryOperator_{swap}" for swap in SWAPS),
    *(f"ReplaceComparisonOperator_{turn}" for turn in TURNS),
)
"""Operators of cosmic-ray that make what a slip of the pen could have written."""

Place = tuple[int, int]
"""Line, from 1, and column, from 0."""


class Mutant(NamedTuple):
    """One change of one module.

    module     : its path from the root
    place      : where the change is
    operator   : what makes it
    occurrence : number of the change among all that the operator can make in the module
    """

    module: Path
    place: Place
    operator: str
    occurrence: int

    @property
    def room(self) -> str:
        return self.module.parts[1]


def main() -> int:
    args = _arguments()
    modules = [m for room in args.rooms for m in modules_of(room) if _is_named(m, args.modules)]
    chosen = sample([mutant for module in modules for mutant in mutants(module)], args.sample, args.seed)
    with tempfile.TemporaryDirectory() as scratch:
        copy = copied(Path(scratch))
        for room in dict.fromkeys(m.room for m in chosen):
            start = time.monotonic()
            if tested(room, None, args.seconds) != "survived":
                print(f"the tests of {room} fail, or take longer than {args.seconds:g} s, as they are")
                return 1
            print(f"the tests of {room} take {time.monotonic() - start:.0f} s", flush=True)
        fates: dict[str, Counter[str]] = defaultdict(Counter)
        for mutant in chosen:
            change, fate = tried(copy, mutant, args.seconds)
            fates[mutant.room][fate] += 1
            if fate == "survived" or args.all:
                print(f"{fate}: {mutant.module}:{mutant.place[0]}\n{change}", flush=True)
    print(summary(fates))
    return 0


def modules_of(room: str) -> list[Path]:
    """The modules of a room, paths from the root."""
    files = sorted((ROOT / PACKAGE / room).glob("*.py"))
    return [f.relative_to(ROOT) for f in files if f.stem not in PASSED_OVER]


def _is_named(module: Path, patterns: Sequence[str]) -> bool:
    inside = module.relative_to(PACKAGE).with_suffix("").as_posix()
    return any(fnmatch.fnmatch(inside, p) for p in patterns)


def mutants(module: Path) -> Iterator[Mutant]:
    """Every change that can be made in a module, but for those of types, which change nothing that runs."""
    from cosmic_ray.ast import ast_nodes, get_ast
    from cosmic_ray.plugins import get_operator

    text = (ROOT / module).read_text("utf-8")
    spared = types_in(text)
    for name in OPERATORS:
        operator = get_operator(f"core/{name}")()
        places = (place for node in ast_nodes(get_ast(text)) for place, _ in operator.mutation_positions(node))
        for occurrence, place in enumerate(places):
            if not any(begin <= place < end for begin, end in spared):
                yield Mutant(module, place, f"core/{name}", occurrence)


def types_in(text: str) -> list[tuple[Place, Place]]:
    """Where the types of arguments, results and variables begin and end."""
    found: list[ast.expr | None] = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.arg | ast.AnnAssign):
            found.append(node.annotation)
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            found.append(node.returns)
    return [
        ((e.lineno, e.col_offset), (e.end_lineno or e.lineno, e.end_col_offset or e.col_offset))
        for e in found
        if e is not None
    ]


def sample(every: Sequence[Mutant], most: int, seed: int) -> list[Mutant]:
    """So many mutants, each of another place, in the order of the code; all there are for `most` 0."""
    if not most:
        return sorted(every)
    places: dict[tuple[Path, Place], list[Mutant]] = defaultdict(list)
    for mutant in every:
        places[mutant.module, mutant.place].append(mutant)
    rng = random.Random(seed)
    return sorted(rng.choice(places[place]) for place in rng.sample(sorted(places), min(most, len(places))))


def copied(folder: Path) -> Path:
    """A copy of the tree in which modules can be changed, entered and put on the import path of what is run there."""
    copy = folder / "tree"
    copy.mkdir()
    for entry in ROOT.iterdir():
        if entry.name in COPIED:
            (shutil.copytree if entry.is_dir() else shutil.copy)(entry, copy / entry.name)
        elif not entry.name.startswith("."):
            (copy / entry.name).symlink_to(entry)
    os.chdir(copy)
    os.environ["PYTHONPATH"] = str(copy)
    return copy


def tried(copy: Path, mutant: Mutant, seconds: float) -> tuple[str, str]:
    """The changed lines, before and after, and what became of the mutant."""
    from cosmic_ray.mutating import use_mutation
    from cosmic_ray.plugins import get_operator

    operator = get_operator(mutant.operator)()
    with use_mutation(copy / mutant.module, operator, mutant.occurrence) as (before, after):
        return changed(before, after), tested(mutant.room, mutant.module.stem, seconds)


def changed(before: str, after: str) -> str:
    """The lines that differ; a change touches no line's number."""
    pairs = zip(before.splitlines(), after.splitlines(), strict=False)
    return "\n".join(f"  - {a.strip()}\n  + {b.strip()}" for a, b in pairs if a != b)


def tested(room: str, module: str | None, seconds: float) -> str:
    """What the tests of a room, the module's first, say of the tree one stands in: "survived", "killed", "timeout"."""
    from cosmic_ray.testing import run_tests

    first = Path("tests", room, f"test_{module}.py")
    files = [*([str(first)] if first.exists() else []), f"tests/{room}"]
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "--hypothesis-seed=0", *files]
    outcome, output = run_tests(shlex.join(command), seconds)
    return "timeout" if output == "timeout" else str(outcome.value)


def summary(fates: dict[str, Counter[str]]) -> str:
    """How many mutants of each room were tried and lived."""
    kinds = ("survived", "killed", "timeout", "incompetent")
    rows = [[room, str(sum(counts.values())), *(str(counts[k]) for k in kinds)] for room, counts in fates.items()]
    return table(["room", "mutants", *kinds], rows)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rooms", nargs="+", default=ROOMS, metavar="ROOM", help="rooms whose tests lie in tests/ROOM")
    parser.add_argument("--modules", nargs="+", default=["*"], metavar="PATTERN", help="ROOM/MODULE")
    parser.add_argument("--sample", type=int, default=25, metavar="N", help="mutants at most; 0: all")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument(
        "--seconds", type=float, default=180, help="for the tests of one mutant; out of time is noticed"
    )
    parser.add_argument("--all", action="store_true", help="show those that the tests noticed, too")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
