"""Which inputs there are and where their outputs go, settled before any work starts."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePath

from sketch2shape.conversion.convert import Output
from sketch2shape.conversion.inputs import fold, keep_inputs
from sketch2shape.errors import UnreadableError, UsageError, WriteError
from sketch2shape.pipeline.products import infixed, suffix
from sketch2shape.reading.read import SUFFIXES


@dataclass(frozen=True, slots=True)
class Planned:
    """One input and its outputs.

    path    : where it is read
    name    : its path below the common folder, with /, which reports and messages use
    outputs : what will be written
    """

    path: str
    name: str
    outputs: tuple[Output, ...]


@dataclass(frozen=True)
class Plan:
    """All inputs of a run, sorted by name.

    root    : folder that receives the outputs
    renamed : how many outputs carry more than their input's stem, because another input has the same
    """

    root: str
    items: tuple[Planned, ...]
    renamed: int = 0


def make_plan(inputs: Sequence[str], out: str | None, products: Sequence[str], *, ours: Collection[str] = ()) -> Plan:
    """Find the pictures in `inputs` and name their outputs.

    inputs : files and folders; folders are searched through, links to folders are not followed
    out    : folder for the outputs, which keeps the tree below the inputs' common folder; None: beside the inputs
    ours   : paths that are outputs of an earlier run, and no inputs

    An output takes its input's stem. Where that would give two outputs one name (a.png and a.jpg; or names that only
    some file systems tell apart: A.png and a.png, two Unicode forms), they carry the full name: a.png.obj, a.jpg.obj.

    Raises UnreadableError if there are no pictures, UsageError if an output would replace an input.
    """
    base = common_folder(inputs)
    found = pictures_in(inputs, out, ours=ours)
    if not found:
        raise UnreadableError("no pictures in it", remedy="a folder with PNG, JPEG, WebP, TIFF, BMP, GIF or PNM files")
    pairs = sorted((PurePath(os.path.relpath(path, base)).as_posix(), path) for path in found)
    names = [name for name, _ in pairs]
    endings = [suffix(product) for product in products]
    if len(set(endings)) < len(endings):
        twice = next(e for e in endings if endings.count(e) > 1)
        both = " and ".join(p for p, e in zip(products, endings, strict=True) if e == twice)
        raise UsageError(f"{both} would both be written to NAME{twice}", remedy="a run for each of them")
    stems = name_outputs(names, endings)
    root = base if out is None else out
    items = []
    for (name, path), stem in zip(pairs, stems, strict=True):
        files = (os.path.join(root, stem + ending) for ending in endings)
        items.append(Planned(path, name, tuple(map(Output, products, files))))
    keep_inputs((item.path for item in items), (o.path for item in items for o in item.outputs))
    return Plan(root, tuple(items), sum(stem != _stem(name) for stem, name in zip(stems, names, strict=True)))


def pictures_in(inputs: Sequence[str], out: str | None, *, ours: Collection[str] = ()) -> set[str]:
    """The pictures that inputs stand for; parameters as for `make_plan`."""
    skip = None if out is None or _same(out, common_folder(inputs)) else out
    return {path for one in inputs for path in _pictures(one, skip, frozenset(map(os.path.abspath, ours)))}


def common_folder(inputs: Sequence[str]) -> str:
    """The folder below which the tree is kept: the one input folder, or what several inputs have in common."""
    if len(inputs) == 1 and Path(inputs[0]).is_dir():
        return inputs[0]
    folders = [os.path.dirname(os.path.abspath(one)) for one in inputs]
    try:
        common = os.path.commonpath(folders)
    except ValueError:
        raise UsageError("the inputs lie on different drives", remedy="one run for each drive") from None
    return common if any(map(os.path.isabs, inputs)) else os.path.relpath(common)


def _pictures(start: str, skip: str | None, ours: frozenset[str]) -> Iterator[str]:
    """Files of a folder that are pictures by their names, and folders that cannot be read; a file stands for itself."""
    if not os.path.isdir(start):
        yield start
        return
    stack = [start]
    while stack:
        folder = stack.pop()
        try:
            entries = list(os.scandir(folder))
        except OSError:
            yield folder  # reading it will say why
            continue
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                if skip is None or not _same(entry.path, skip):
                    stack.append(entry.path)
            elif _is_picture(entry.name) and os.path.abspath(entry.path) not in ours:
                yield entry.path


def _stem(name: str) -> str:
    return os.path.splitext(name)[0]


def _is_picture(name: str) -> bool:
    """By its ending; the companions "._NAME" that a Mac leaves in archives only look like pictures."""
    return os.path.splitext(name)[1].lower() in SUFFIXES and not name.startswith("._")


def _same(one: str, other: str) -> bool:
    try:
        return os.path.samefile(one, other)
    except OSError:
        return os.path.abspath(one) == os.path.abspath(other)


def name_outputs(names: Sequence[str], endings: Sequence[str]) -> list[str]:
    """A stem for each input so that no two outputs share a name on any file system."""
    stems = [_stem(name) for name in names]
    twins = Counter(map(fold, stems))
    alone = [twins[fold(stem)] == 1 for stem in stems]
    taken = set[str]()
    for i in sorted(range(len(names)), key=lambda i: not alone[i]):
        for stem in _candidates(stems[i], names[i], alone[i]):
            keys = {fold(stem + ending) for ending in endings}
            if taken.isdisjoint(keys):
                taken |= keys
                stems[i] = stem
                break
    return stems


def _candidates(short: str, name: str, alone: bool) -> Iterator[str]:
    if alone:
        yield short
    yield name
    number = 2
    while True:
        yield f"{name}~{number}"
        number += 1


def settle(plan: Plan, *, versioned: bool, ours: Collection[str] = ()) -> Plan:
    """Refuse outputs that exist, or move them aside to free names if `versioned`. `ours` may be replaced.

    Raises WriteError, but UnreadableError if an input is missing, too: that is said first.
    """
    mine = frozenset(ours)
    taken = [o.path for item in plan.items for o in item.outputs if o.path not in mine and os.path.lexists(o.path)]
    if not taken:
        return plan
    if not versioned:
        missing = next((item.path for item in plan.items if not os.path.lexists(item.path)), None)
        if missing is not None:  # a word that is no picture was hardly meant to be one, and says more than what exists
            raise UnreadableError(f"{missing}: no such file or directory", remedy="check the path")
        more = f" and {len(taken) - 1} more" if len(taken) > 1 else ""
        raise WriteError(f"{taken[0]}{more} exists already", remedy="--resume, --overwrite, --versioned, or another -o")
    planned = {fold(o.path) for item in plan.items for o in item.outputs}
    return replace(plan, items=tuple(_free_version(item, planned) for item in plan.items))


def _free_version(item: Planned, planned: set[str]) -> Planned:
    """The item with the first version number that is free for all of its outputs; the names are added to `planned`."""
    version, outputs = 1, item.outputs
    planned.difference_update(fold(o.path) for o in outputs)
    while any(os.path.lexists(o.path) or fold(o.path) in planned for o in outputs):
        version += 1
        outputs = tuple(Output(o.product, infixed(o.path, o.product, f".{version}")) for o in item.outputs)
    planned.update(fold(o.path) for o in outputs)
    return replace(item, outputs=outputs)
