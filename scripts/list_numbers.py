"""List the numbers that the heart was tuned with: name, value, place, and meaning, from the code as it stands.

python scripts/list_numbers.py            the table of docs/heart.md written anew
python scripts/list_numbers.py --print    on the screen
"""

from __future__ import annotations

import argparse
import ast
from collections.abc import Iterator
from itertools import zip_longest
from pathlib import Path
from typing import NamedTuple

from repository import ROOT

from evaluation.markdown import part_replaced, table

PAGE = ROOT / "docs" / "heart.md"
ROOMS = ("search", "evidence", "hypotheses", "fit", "sweeps")
FITTED = ("weights", "rival_weights", "sweep_weights")
"""Modules of numbers that a fit has written."""
PLAIN = (0, 1, 2, 0.5)
"""Numbers that need no name: ends of ranges, halves and pairs."""


class Number(NamedTuple):
    """A named number, or some that are told together.

    names   : as in the code
    value   : as in the code
    module  : its name
    meaning : with its unit; "" if nothing is said of it
    """

    names: tuple[str, ...]
    value: str
    module: str
    meaning: str


def numbers_of(module: Path) -> Iterator[Number]:
    """The numbers that a module names."""
    body = ast.parse(module.read_text("utf-8")).body
    for node, after in zip_longest(body, body[1:]):
        target = node.targets[0] if isinstance(node, ast.Assign) else getattr(node, "target", None)
        if target is None or not _is_number(node.value):
            continue
        names = tuple(n.id for n in ast.walk(target) if isinstance(n, ast.Name))
        if all(n.isupper() for n in names) and not (names[0].startswith("_") and _follows(node.value)):
            value = ast.unparse(node.value)
            yield Number(names, value[1:-1] if len(names) > 1 else value, module.stem, _said(after))


def _is_number(value: ast.expr | None) -> bool:
    return value is not None and any(
        isinstance(n, ast.Constant) and type(n.value) in (int, float) for n in ast.walk(value)
    )


def _follows(value: ast.expr) -> bool:
    """Whether a value is worked out from that of another name."""
    return any(isinstance(n, ast.Name) and n.id.isupper() for n in ast.walk(value))


def _said(after: ast.stmt | None) -> str:
    """The words that stand behind a number."""
    if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) and isinstance(after.value.value, str):
        return " ".join(after.value.value.split())
    return ""


def unnamed_in(module: Path) -> int:
    """How many numbers stand in a module's functions without a name, but for the plainest."""
    found = 0
    for node in ast.parse(module.read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            for n in ast.walk(node):
                found += isinstance(n, ast.Constant) and type(n.value) in (int, float) and n.value not in PLAIN
    return found


def modules_of(room: str) -> list[Path]:
    """The modules of a room, without those that a fit has written."""
    return [f for f in sorted((ROOT / "sketch2shape" / room).glob("*.py")) if f.stem not in FITTED]


def listing() -> str:
    """How many numbers each room has, and all that have names."""
    counts, parts = [], []
    for room in ROOMS:
        modules = modules_of(room)
        found = [number for module in modules for number in numbers_of(module)]
        counts.append([room, sum(len(n.names) for n in found), sum(map(unnamed_in, modules))])
        cells = [[f"`{', '.join(n.names)}`", n.module, f"`{n.value}`", n.meaning] for n in found]
        parts.append(f"### {room}\n\n{table(['name', 'module', 'value', 'meaning'], cells, words=True)}")
    counts.append(["all", *(sum(row[k] for row in counts) for k in (1, 2))])
    head = table(["room", "with a name", "without"], [list(map(str, row)) for row in counts])
    return "\n".join([head, *parts])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--print", action="store_true", help="print the list, write nothing")
    if parser.parse_args().print:
        print(listing())
    else:
        PAGE.write_text(part_replaced(PAGE.read_text("utf-8"), "numbers", listing()), "utf-8")


if __name__ == "__main__":
    main()
