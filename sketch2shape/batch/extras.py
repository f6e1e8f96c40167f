"""What a run writes besides the outputs of each input: the table, the index and the contact sheet."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterable
from pathlib import Path

from sketch2shape.batch.pages import check_pages, page_files, write_pages
from sketch2shape.batch.plan import Planned
from sketch2shape.batch.table import check_table, encode_table
from sketch2shape.conversion.convert import Outcome
from sketch2shape.conversion.inputs import keep_inputs
from sketch2shape.conversion.options import wants_pages
from sketch2shape.writing import exists_error, write_file


def check_extras(arguments: Namespace) -> None:
    """Raise UsageError for names that no table or page can have."""
    if arguments.report:
        check_table(arguments.report)
    check_pages(arguments)


def keep_files(arguments: Namespace, items: Iterable[Planned]) -> None:
    """Raise UsageError if anything the run writes would replace a picture or the corrections.

    Raises WriteError for a table or a page that is there already, and may not be replaced.
    """
    planned = list(items)
    corrections = list(filter(None, [arguments.vertices]))
    extras = [*filter(None, [arguments.report]), *page_files(arguments, len(planned))]
    for path in extras:
        if os.path.lexists(path) and not (arguments.overwrite or arguments.resume):
            raise exists_error(Path(path))
    keep_inputs([item.path for item in planned] + corrections, extras)
    keep_inputs(corrections, [o.path for item in planned for o in item.outputs])


def write_extras(arguments: Namespace, rows: Iterable[tuple[Planned, Outcome]]) -> None:
    """Write the table and the pages that are asked for. Raises WriteError."""
    outcomes = list(rows)
    if arguments.report:
        data = encode_table(arguments.report, outcomes)
        write_file(arguments.report, data, overwrite=arguments.overwrite or arguments.resume)
    if wants_pages(arguments):
        write_pages(arguments, outcomes)
