"""What became of the inputs of a batch, as a table: a file with a line for each, and a summary of a few lines."""

from __future__ import annotations

import csv
import io
import json
from collections import Counter
from collections.abc import Iterable
from typing import Any, TextIO

from sketch2shape.batch.plan import Planned
from sketch2shape.conversion.convert import Outcome
from sketch2shape.conversion.summary import Measures
from sketch2shape.errors import UsageError

_COLUMNS = (
    "name", "status", "exit_code", "message", "remedy", "objects", "confidence", "found", *Measures._fields, "seconds",
    "outputs",
)  # fmt: skip

_MEANING = {
    0: "done",
    1: "stopped by a bug or a crash",
    2: "asked for something impossible",
    4: "unreadable or not an image",
    5: "no two-face object found",
    6: "limit exceeded",
    7: "output not written",
    8: "optional package missing",
    130: "not started",
}


def check_table(path: str) -> None:
    """Raise UsageError if no table can be written under this name."""
    if not path.lower().endswith((".jsonl", ".csv")):
        raise UsageError(f"--report {path} is neither .jsonl nor .csv", remedy="--report FILE.jsonl")


def encode_table(path: str, rows: Iterable[tuple[Planned, Outcome]]) -> bytes:
    """The table as JSON lines or CSV, by the name of the file; one line for each input, in the order of the plan."""
    records = [_record(item, outcome) for item, outcome in rows]
    if path.lower().endswith(".jsonl"):
        return "".join(json.dumps(record) + "\n" for record in records).encode("ascii")
    out = io.StringIO(newline="")
    writer = csv.DictWriter(out, _COLUMNS, lineterminator="\n")
    writer.writeheader()
    for record in records:
        solids = record.pop("solids")
        sizes = {name: "|".join(str(solid[name]) for solid in solids) for name in Measures._fields}
        cells = {**record, **sizes, "outputs": "|".join(record["outputs"])}
        writer.writerow({column: _cell(value) for column, value in cells.items()})
    return out.getvalue().encode("utf-8", "backslashreplace")


def _cell(value: Any) -> Any:
    """A cell that no spreadsheet takes for a formula: a text that looks like one gets an apostrophe, as in `'=1+1.png`.

    Source: OWASP, CSV Injection.
    """
    return "'" + value if isinstance(value, str) and value.startswith(("=", "+", "-", "@", "\t", "\r")) else value


def _record(item: Planned, outcome: Outcome) -> dict[str, Any]:
    return {
        "name": item.name,
        "status": outcome.status,
        "exit_code": outcome.exit_code,
        "message": outcome.message,
        "remedy": outcome.remedy,
        "objects": outcome.objects,
        "confidence": None if outcome.confidence is None else round(outcome.confidence, 4),
        "found": outcome.found,
        "solids": [measures._asdict() for measures in outcome.measures],
        "seconds": round(outcome.seconds, 3),
        "outputs": sorted(outcome.written),
    }


def summary(outcomes: Iterable[Outcome], seconds: float) -> list[tuple[str, str]]:
    """Rows (number, meaning): how many inputs came to which end, all of them last."""
    counts = Counter(outcome.exit_code for outcome in outcomes)
    total = sum(counts.values())
    rows = [(str(counts[code]), f"{_MEANING.get(code, 'failed')} ({code})") for code in sorted(counts)]
    return [*rows, (str(total), f"inputs in {seconds:.1f} s")]


def show_summary(rows: list[tuple[str, str]], out: TextIO) -> None:
    """Print the summary: as a table on a terminal, else as plain lines."""
    if not out.isatty():
        width = max(len(number) for number, _ in rows)
        out.write("".join(f"{number:>{width}}  {meaning}\n" for number, meaning in rows))
        return
    from rich.console import Console
    from rich.table import Table

    table = Table(show_header=False)
    table.add_column(justify="right")
    for row in rows:
        table.add_row(*row)
    Console(file=out).print(table)
