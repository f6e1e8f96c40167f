"""Reading what `--vertices` names: one corrections file, or a folder of those that the web app saves."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path, PurePath
from typing import Any

from sketch2shape.corrections.corrections import SCHEMA, corrections_from, entry_for
from sketch2shape.errors import UsageError

ENDING = ".corrections.json"
_MOST_BYTES = 64 * 2**20


def read_corrections(path: str, *, many: bool) -> str:
    """The text of the corrections, ready for `parse_corrections`; those of a folder are gathered under "pictures".

    many : whether they are for several pictures, which must then be told apart

    Raises UsageError if the file cannot be read or is not of the form.
    """
    target = Path(path)
    try:
        data = _gathered(target) if target.is_dir() else _decoded(target)
    except OSError as error:
        raise UsageError(
            f"cannot read {path}: {error.strerror or error}", remedy="another file for --vertices"
        ) from error
    pictures = data.get("pictures") if isinstance(data, dict) else None
    if many and not isinstance(pictures, dict):
        raise UsageError(
            f'{path} is for one picture, there are several: it has no "pictures"',
            remedy='one entry for each picture under "pictures", or a folder of files from the web app',
        )
    for name in pictures if isinstance(pictures, dict) else [""]:
        corrections_from(data, name)  # says now what is wrong, not in the middle of a run
    return json.dumps(data)


def check_pictures(text: str, path: str, names: Sequence[str]) -> str | None:
    """A word on corrections that name pictures other than `names`, None if there is nothing to say.

    text : what `read_corrections` returned for `path`

    Raises UsageError if all of them are for other pictures.
    """
    data = json.loads(text)
    pictures = data.get("pictures")
    if not isinstance(pictures, dict):
        return _made_for(data.get("source"), path, names)
    used = {entry_for(pictures, name) for name in names}
    others = [name for name in pictures if name not in used]
    if pictures and used == {None}:
        raise UsageError(
            f"{path} corrects {_listed(others)}, not {_listed(names)}",
            remedy='the name of the picture under "pictures", or another file for --vertices',
        )
    return f"{path} corrects {_listed(others)} too: no input is called so" if others and len(names) > 1 else None


def _made_for(source: Any, path: str, names: Sequence[str]) -> str | None:
    """A word where corrections for one picture say that they were made for another."""
    named = isinstance(source, str) and bool(PurePath(source).suffix) and names[0] != "stdin"
    if not named or PurePath(source.replace("\\", "/")).name == PurePath(names[0]).name:
        return None
    return f"{path} was made for {source}; it is used for {names[0]}"


def _listed(names: Sequence[str], most: int = 3) -> str:
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def _decoded(file: Path) -> Any:
    if file.stat().st_size > _MOST_BYTES:
        raise UsageError(f"{file} is larger than {_MOST_BYTES // 2**20} MB", remedy="a corrections file")
    try:
        return json.loads(file.read_bytes())
    except (ValueError, RecursionError) as error:
        raise UsageError(f"{file} is not JSON", remedy="a corrections file or a report") from error


def _gathered(folder: Path) -> dict[str, Any]:
    """One entry for each file saved by the web app, under the picture it was saved for, beside it in the tree."""
    pictures = {}
    for file in sorted(folder.rglob("*" + ENDING)):
        data = _decoded(file)
        source = data.get("source") if isinstance(data, dict) else None
        if not isinstance(source, str) or not source:
            raise UsageError(f'{file} does not tell its picture ("source")', remedy="a file saved by sketch2shape ui")
        pictures[(file.relative_to(folder).parent / PurePath(source).name).as_posix()] = data
    if not pictures:
        raise UsageError(f"{folder} holds no file NAME{ENDING}", remedy="files saved by sketch2shape ui")
    return {"schema": SCHEMA, "pictures": pictures}
