"""Which drawings are measured: the sets by name, and each picture of them with its truth."""

from __future__ import annotations

import fnmatch
import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PIL import Image

from synthetic.drawing import draw
from synthetic.recipes import RECIPES

ROOT = Path(__file__).resolve().parent.parent
BENCH = ROOT.parent / "shared" / "bench"
"""Where independent drawings and real pictures lie; they are not part of this repository."""

BY_EYE = ("neg_cylinder", "neg_cone", "neg_pyramid", "neg_curved", "neg_hole", "neg_multi")
"""Kinds of pictures without written truth that may hold a solid: no program tells whether an answer is right."""


@dataclass(frozen=True)
class Case:
    """One picture to be read.

    set     : name of the set, a key of `SETS`
    id      : category/stem
    picture : path of the picture
    truth   : as beside a drawing (see `evaluation.metrics`), always with `category`, `width`, `height`; no `f1` and no
              `objects` but `mesh` where the truth is a file with a mesh; `objects` None where only the eye can tell
    """

    set: str
    id: str
    picture: str
    truth: dict[str, Any]

    @property
    def half(self) -> str:
        """Even or odd, by one character of the stem, as a rule the last (its code, if it is a letter)."""
        place = SETS[self.set].halves_by if self.set in SETS else -1
        return "even" if ord(self.id[place]) % 2 == 0 else "odd"


@dataclass(frozen=True)
class Wanted:
    """What is asked for on the command line.

    bench        : folder of the sets that are not in this repository
    scratch      : folder for drawings made anew
    categories   : patterns of category names
    seed         : of the drawings made anew
    per_category : how many of those
    """

    bench: Path
    scratch: Path
    categories: Sequence[str] = ("*",)
    seed: int = 7
    per_category: int = 4

    def has(self, category: str) -> bool:
        """Whether the category is asked for."""
        return any(fnmatch.fnmatch(category, p) for p in self.categories)


@dataclass(frozen=True)
class DrawingSet:
    """A set of drawings.

    title     : for the page
    cases     : makes or finds them
    halves_by : place of the character of the stem that tells the half
    """

    title: str
    cases: Callable[[str, Wanted], Iterator[Case]]
    halves_by: int = -1


def collect(names: Sequence[str], wanted: Wanted) -> list[Case]:
    """The cases of these sets, in order; a set that does not exist here has none."""
    return [case for name in names for case in SETS[name].cases(name, wanted)]


def case_of(picture: Path, *, of_set: str = "") -> Case:
    """The case of one drawing whose truth lies beside it."""
    truth = json.loads(picture.with_suffix(".json").read_text())
    truth.setdefault("category", picture.parent.name)
    return Case(of_set, f"{picture.parent.name}/{picture.stem}", str(picture), truth | _size(picture))


def _committed(name: str, wanted: Wanted) -> Iterator[Case]:
    yield from _with_rings(name, ROOT / "data" / "synthetic", wanted)


def _fresh(name: str, wanted: Wanted) -> Iterator[Case]:
    folder = wanted.scratch / "fresh"
    for category in filter(wanted.has, RECIPES):
        for index in range(wanted.per_category):
            yield case_of(draw(category, wanted.seed, index).save(folder), of_set=name)


def _bench(name: str, wanted: Wanted) -> Iterator[Case]:
    yield from _with_rings(name, wanted.bench / name, wanted)


def _with_rings(name: str, folder: Path, wanted: Wanted) -> Iterator[Case]:
    for file in sorted(folder.glob("*/*.json")):
        if wanted.has(file.parent.name):
            yield case_of(next(p for p in _pictures(file.parent) if p.stem == file.stem), of_set=name)


def _without_truth(name: str, wanted: Wanted) -> Iterator[Case]:
    for folder in sorted((wanted.bench / name).glob("*")):
        if folder.is_dir() and wanted.has(folder.name):
            truth: dict[str, Any] = {"objects": None if folder.name in BY_EYE else [], "category": folder.name}
            for picture in _pictures(folder):
                yield Case(name, f"{folder.name}/{picture.stem}", str(picture), truth | _size(picture))


def _with_mesh(name: str, wanted: Wanted) -> Iterator[Case]:
    for folder in sorted((wanted.bench / name).glob("*")):
        if folder.is_dir() and wanted.has(folder.name):
            for picture in _pictures(folder):
                mesh = wanted.bench / f"{name}_truth" / f"{picture.stem}.glb"
                truth = {"mesh": str(mesh), "category": folder.name}
                yield Case(name, f"{folder.name}/{picture.stem}", str(picture), truth | _size(picture))


def _pictures(folder: Path) -> list[Path]:
    return [p for p in sorted(folder.iterdir()) if p.suffix.lower() in (".png", ".jpg", ".jpeg")]


def _size(picture: Path) -> dict[str, int]:
    with Image.open(picture) as opened:
        return {"width": opened.width, "height": opened.height}


# The names of all CAD parts end in odd digits: the digit before tells their half.
SETS: dict[str, DrawingSet] = {
    "committed": DrawingSet("Committed drawings (`data/synthetic`)", _committed),
    "fresh": DrawingSet("Fresh drawings (all categories of the generator)", _fresh),
    "drawings": DrawingSet("Independent drawings (another generator, not in this repository)", _bench),
    "hard": DrawingSet("Independent drawings with foreign marks and missing ink (not in this repository)", _bench),
    "real": DrawingSet("Real pictures (textbooks, pens and tablets, CAD, icons; not in this repository)", _bench),
    "real2": DrawingSet("More real pictures (also with auxiliary lines; not in this repository)", _bench),
    "refuse": DrawingSet("Real pictures of something else (not in this repository)", _without_truth),
    "curved": DrawingSet("Independent drawings with arcs and apexes (not in this repository)", _bench),
    "abc": DrawingSet("CAD parts whose truth is a mesh (not in this repository)", _with_mesh, -2),
}
