"""The pictures of a whole batch: an HTML index and a contact sheet, made of the overlays that were written."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterable, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING

from sketch2shape.batch.plan import Planned
from sketch2shape.conversion.convert import Outcome
from sketch2shape.errors import NoObjectError, Sketch2ShapeError, UsageError
from sketch2shape.writing import write_file

if TYPE_CHECKING:
    from sketch2shape.pictures import Entry
    from sketch2shape.pictures.canvas import Pixels

Rows = Iterable[tuple[Planned, Outcome]]


def check_pages(arguments: Namespace) -> None:
    """Raise UsageError if the pages cannot be written under the names given."""
    for path, ending in ((arguments.index, ".html"), (arguments.contact_sheet, ".png")):
        if path and not path.lower().endswith(ending):
            raise UsageError(f"{path} does not end in {ending}", remedy=f"FILE{ending}")


def page_files(arguments: Namespace, count: int) -> list[str]:
    """The files that the pages of `count` inputs are written to."""
    return [*filter(None, [arguments.index]), *_sheet_files(arguments.contact_sheet, count)]


def _sheet_files(path: str | None, count: int) -> list[str]:
    """NAME.png for the first sheet, NAME.p2.png and so on for the others, as for the pages of a document."""
    if not path:
        return []
    from sketch2shape.pictures import count_sheets

    stem, ending = os.path.splitext(path)
    return [path] + [f"{stem}.p{k}{ending}" for k in range(2, count_sheets(count) + 1)]


def write_pages(arguments: Namespace, rows: Rows) -> None:
    """Write the index and the contact sheet that are asked for. Raises WriteError."""
    from sketch2shape.pictures import contact_sheets, encode_png, folder_index

    outcomes = list(rows)
    again = arguments.overwrite or arguments.resume
    if arguments.index:
        entries = _entries(outcomes, os.path.dirname(os.path.abspath(arguments.index)))
        title = ", ".join(PurePath(os.path.abspath(i)).name for i in arguments.inputs[:3])
        write_file(arguments.index, folder_index(entries, title).encode("utf-8"), overwrite=again)
    if arguments.contact_sheet:
        files = _sheet_files(arguments.contact_sheet, len(outcomes))
        for file, sheet in zip(files, contact_sheets(_entries(outcomes, ".")), strict=True):
            write_file(file, encode_png(sheet), overwrite=again)


def _entries(rows: Sequence[tuple[Planned, Outcome]], base: str) -> Iterable[Entry]:
    """One entry for each input, thumbnails read as they are needed; links are relative to the folder `base`."""
    from sketch2shape.pictures import Entry

    for item, outcome in rows:
        overlays = [o.path for o in item.outputs if o.product == "overlay"]
        shown = [path for path in overlays[:1] if outcome.exit_code == 0 or path in outcome.written]
        if outcome.exit_code == NoObjectError.exit_code and not shown:
            shown = [item.path]
        thumbnail = _thumbnail(shown[0]) if shown else None
        links = [
            (o.product, PurePath(os.path.relpath(o.path, base)).as_posix())
            for o in item.outputs
            if outcome.exit_code == 0 and os.path.exists(o.path)
        ]
        yield Entry(item.name, thumbnail, outcome.confidence, outcome.message, links)


def _thumbnail(path: str) -> Pixels | None:
    """The overlay that the run wrote, or a drawing in which nothing was found, reduced; None where there is none."""
    from sketch2shape.pictures.canvas import fit
    from sketch2shape.reading.read import read_picture

    try:
        return fit(read_picture(path, reduced=True).pixels, 600, 440)[0]
    except Sketch2ShapeError:
        return None
