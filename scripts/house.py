#!/usr/bin/env python3
"""How the package is laid out, counted from its imports; all of them, those within functions and for type checkers too.

    python scripts/house.py [--list]                      what there is; --list names every import past a face
    python scripts/house.py --before REV                  the same of a git revision beside it
    python scripts/house.py --picture docs/architecture.svg

A *room* is a package right below the root or a module in the root. A room's *face* is its `__init__`. The root's own
`__init__` names what the rooms make public and lends them the version; it is no room, so it has no edges here.
"""

from __future__ import annotations

import argparse
import ast
import subprocess
import sys
import tarfile
import tempfile
import tomllib
from collections.abc import Hashable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TypeVar

from repository import ROOT

from evaluation.markdown import table

Node = TypeVar("Node", bound=Hashable)

PACKAGE = "sketch2shape"


@dataclass(frozen=True)
class House:
    """The modules of the package and who imports whom."""

    modules: Mapping[str, Path]
    """dotted name -> file; a package goes by its own name"""
    imports: frozenset[tuple[str, str]]
    """(module, module it imports), the root's `__init__` left out at both ends"""

    def room(self, module: str) -> str:
        """The room a module lies in."""
        return module.split(".")[1]

    @property
    def rooms(self) -> list[str]:
        """All rooms, `__main__` left out: it only starts the command."""
        return sorted({self.room(m) for m in self.modules if m != PACKAGE} - {"__main__"})

    @property
    def at_root(self) -> list[str]:
        """Modules that lie flat in the root."""
        return sorted(m for m, file in self.modules.items() if m.count(".") == 1 and file.name != "__init__.py")

    @property
    def edges(self) -> set[tuple[str, str]]:
        """(room, room it imports from)."""
        pairs = {(self.room(a), self.room(b)) for a, b in self.imports}
        return {(a, b) for a, b in pairs if a != b and a != "__main__"}

    @property
    def past_faces(self) -> list[tuple[str, str]]:
        """Imports of another room's inner module instead of its face."""
        return sorted((a, b) for a, b in self.imports if self.room(a) != self.room(b) and b.count(".") > 1)

    @property
    def leaving(self) -> list[tuple[str, str]]:
        """Imports from another room."""
        return [(a, b) for a, b in self.imports if self.room(a) != self.room(b)]


def read(root: Path) -> House:
    """The house whose package lies in the folder `root`."""
    files = sorted((root / PACKAGE).rglob("*.py"))
    modules = {_name(file.relative_to(root)): file for file in files}
    pairs = {(m, target) for m, file in modules.items() for target in _imported(m, file, modules)}
    return House(modules, frozenset((a, b) for a, b in pairs if PACKAGE not in (a, b) and a != b))


def _name(file: Path) -> str:
    parts = file.with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _imported(module: str, file: Path, modules: Mapping[str, Path]) -> Iterator[str]:
    package = module if file.name == "__init__.py" else module.rpartition(".")[0]
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            yield from (a.name for a in node.names if a.name in modules)
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
            source = ".".join([*above, *([node.module] if node.module else [])])
            for alias in node.names:
                inner = f"{source}.{alias.name}"
                yield from (name for name in [inner if inner in modules else source] if name in modules)


def reachable(edges: Iterable[tuple[Node, Node]]) -> dict[Node, set[Node]]:
    """Node -> all nodes that its edges lead to, however far."""
    near: dict[Node, set[Node]] = {}
    for a, b in edges:
        near.setdefault(a, set()).add(b)
    far = {}
    for start in near:
        seen: set[Node] = set()
        todo = list(near[start])
        while todo:
            node = todo.pop()
            if node not in seen:
                seen.add(node)
                todo.extend(near.get(node, ()))
        far[start] = seen
    return far


def circles(edges: Iterable[tuple[Node, Node]]) -> list[list[Node]]:
    """The groups of nodes in which each leads to each."""
    far = reachable(edges)
    groups = {frozenset(b for b in far[a] if a in far.get(b, ())) for a in far if a in far[a]}
    return sorted(sorted(group, key=str) for group in groups)


def layers(root: Path) -> list[list[str]]:
    """The layers that pyproject.toml asks for, from the top; rooms of one layer do not know of each other."""
    with (root / "pyproject.toml").open("rb") as file:
        contracts = tomllib.load(file)["tool"]["importlinter"]["contracts"]
    rows = next(contract["layers"] for contract in contracts if contract["type"] == "layers")
    return [row.split(" | ") for row in rows]


def climbing(edges: Iterable[tuple[str, str]], rows: list[list[str]]) -> list[tuple[str, str]]:
    """Edges that do not lead down the layers; rooms that no layer names are passed over."""
    level = {room: at for at, row in enumerate(rows) for room in row}
    return sorted((a, b) for a, b in edges if a in level and b in level and level[a] >= level[b])


def at_revision(revision: str, folder: Path) -> House:
    """The house as it was at a git revision; its files are put into `folder`."""
    packed = subprocess.run(["git", "archive", revision, PACKAGE], cwd=ROOT, check=True, capture_output=True).stdout
    with tarfile.open(fileobj=BytesIO(packed)) as archive:
        archive.extractall(folder, filter="data")
    return read(folder)


def figures(house: House) -> dict[str, str]:
    """What is counted, by name."""
    return {
        "modules": str(len(house.modules)),
        "of them flat in the root, besides `__init__` and `__main__`": str(len(set(house.at_root) - {_MAIN})),
        "rooms": str(len(house.rooms)),
        "edges between rooms": str(len(house.edges)),
        "imports between modules": str(len(house.imports)),
        "of them into another room": str(len(house.leaving)),
        "of them past the room's face": str(len(house.past_faces)),
        "circles of modules": _named(circles(house.imports)),
        "circles of rooms": _named(circles(house.edges)),
    }


_MAIN = f"{PACKAGE}.__main__"


def _named(found: list[list[str]]) -> str:
    shown = "; ".join(" <-> ".join(name.removeprefix(PACKAGE + ".") for name in circle) for circle in found)
    return f"{len(found)} ({shown})" if found else "0"


def main() -> int:
    """Print the figures or draw the picture."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--before", metavar="REV", help="a git revision to set beside")
    parser.add_argument("--picture", metavar="FILE.svg", type=Path, help="draw the rooms and their edges")
    parser.add_argument("--list", action="store_true", help="name every import that reaches past a face")
    options = parser.parse_args()
    house = read(ROOT)
    if options.picture:
        from house_picture import picture

        options.picture.write_text(picture(house, layers(ROOT)), "utf-8")
        return 0
    columns = [figures(house)]
    if options.before:
        with tempfile.TemporaryDirectory() as folder:
            columns.insert(0, figures(at_revision(options.before, Path(folder))))
    head = ["", *([options.before] if options.before else []), "now"]
    sys.stdout.write(table(head, [[name, *(column[name] for column in columns)] for name in columns[0]]))
    if options.list:
        sys.stdout.write("".join(f"{a} -> {b}\n" for a, b in house.past_faces))
    return 0


if __name__ == "__main__":
    sys.exit(main())
