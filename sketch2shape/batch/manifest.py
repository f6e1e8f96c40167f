"""The record of a run, kept in its output folder, from which a stopped run goes on.

A file of JSON lines: a header with the hash of the options; before any work starts, one line for each input with the
outputs planned for it, so that a later run knows which files are its own; then one line for each input that is done. A
run that comes to its end leaves only the header and the last kind of lines, in the order of the plan and without times,
so that the folder holds the same bytes however often the run was stopped on the way.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import stat
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePath
from typing import IO, Any

from sketch2shape import __version__
from sketch2shape.batch.plan import Plan, Planned
from sketch2shape.conversion.convert import Outcome, Output, Settings
from sketch2shape.conversion.summary import Measures
from sketch2shape.errors import NoObjectError, UnreadableError, UsageError, WriteError
from sketch2shape.writing import write_file

NAME = ".sketch2shape.jsonl"
SCHEMA = "sketch2shape-batch/1"

#: exit codes that the same bytes and options give again; a time limit, say, need not be passed the next time
_LASTING = frozenset({0, UnreadableError.exit_code, NoObjectError.exit_code})


def options_hash(settings: Settings, products: Iterable[str]) -> str:
    """A hash of everything that decides what is written for a given input."""
    return hashlib.sha256(repr((__version__, settings, list(products))).encode()).hexdigest()


@dataclass(frozen=True)
class Past:
    """What an earlier run left in the output folder.

    options : its `options_hash`, "" if there was no run
    planned : input name -> outputs
    done    : input name -> what became of it
    """

    root: str
    options: str = ""
    planned: Mapping[str, tuple[Output, ...]] = field(default_factory=dict)
    done: Mapping[str, Outcome] = field(default_factory=dict)

    @property
    def files(self) -> list[str]:
        """Every path that was or would have been written."""
        return [output.path for outputs in self.planned.values() for output in outputs]

    def check_options(self, options: str) -> None:
        """Raise UsageError if the earlier run had other options."""
        if self.options not in ("", options):
            raise UsageError(
                f"the run in {self.root} had other options", remedy="the same options, or --overwrite without --resume"
            )

    def still_done(self, item: Planned) -> Outcome | None:
        """What became of an input, if it, its fate and its outputs are as they were."""
        outcome = self.done.get(item.name)
        if outcome is None or outcome.exit_code not in _LASTING or not outcome.digest:
            return None
        if digest_file(item.path) != outcome.digest:
            return None
        return outcome if all(digest_file(path) == value for path, value in outcome.written.items()) else None


def digest_file(path: str) -> str:
    """Sha256 of a regular file, "" for anything else."""
    with contextlib.suppress(OSError, ValueError):
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
        with open(descriptor, "rb") as file:
            if stat.S_ISREG(os.fstat(descriptor).st_mode):
                return hashlib.file_digest(file, "sha256").hexdigest()
    return ""


def load_past(root: str) -> Past:
    """Read what an earlier run left; lines that a kill cut short, or that are not ours, are passed over."""
    options, planned, done = "", dict[str, tuple[Output, ...]](), dict[str, Outcome]()
    with contextlib.suppress(OSError), Path(root, NAME).open(encoding="ascii", errors="replace") as file:
        for line in file:
            with contextlib.suppress(ValueError, KeyError, TypeError, AttributeError):
                record = json.loads(line)
                if record.get("schema") == SCHEMA:
                    options = str(record["options"])
                elif "planned" in record:
                    planned[record["planned"]] = _outputs_from(root, record["outputs"])
                elif "done" in record:
                    done[record["done"]] = _outcome_from(root, record)
                    planned[record["done"]] = _outputs_from(root, record["outputs"])
    return Past(root, options, planned, done)


class Manifest:
    """The record of the run in progress."""

    def __init__(self, plan: Plan, options: str) -> None:
        """Name it; nothing is written yet."""
        self.path = Path(plan.root, NAME)
        self._plan, self._header = plan, {"schema": SCHEMA, "version": __version__, "options": options}
        self._outputs = {item.name: item.outputs for item in plan.items}
        self._file: IO[str] | None = None

    def begin(self) -> None:
        """Write down what is planned. Raises WriteError."""
        lines = [
            _line({"planned": item.name, "outputs": _outputs_to(self._plan.root, item.outputs)})
            for item in self._plan.items
        ]
        self._write(lines)
        try:
            self._file = self.path.open("a", encoding="ascii")
        except OSError as error:
            raise WriteError(f"cannot write {self.path} ({error.strerror})") from None

    def add(self, outcome: Outcome) -> None:
        """Write down what became of an input, at once. Raises WriteError."""
        if self._file is not None:
            try:
                self._file.write(_line(_outcome_to(self._plan.root, outcome, self._outputs[outcome.name])))
                self._file.flush()
            except OSError as error:
                raise WriteError(f"cannot write {self.path} ({error.strerror})") from None

    def close(self) -> None:
        """Stop writing; the file stays as it is, for a later run to go on."""
        if self._file is not None:
            with contextlib.suppress(OSError):
                self._file.close()
            self._file = None

    def finish(self) -> None:
        """Keep the header and what became of each input, in the order of the plan. Raises WriteError."""
        self.close()
        with self.path.open(encoding="ascii") as file:
            done = {json.loads(line).get("done"): line for line in file}
        self._write([done[item.name] for item in self._plan.items if item.name in done])

    def _write(self, lines: list[str]) -> None:
        text = "".join([_line(self._header), *lines])
        # a folder from a stranger may hold a link of this name, and no one has asked for what it leads to
        write_file(self.path, text.encode("ascii"), overwrite=True, follow_links=False)


def _line(record: Mapping[str, Any]) -> str:
    return json.dumps(record) + "\n"


def _inside(root: str, path: str) -> str:
    return PurePath(os.path.relpath(path, root)).as_posix()


def _outputs_to(root: str, outputs: Iterable[Output]) -> dict[str, str]:
    return {output.product: _inside(root, output.path) for output in outputs}


def _outputs_from(root: str, outputs: Mapping[str, str]) -> tuple[Output, ...]:
    return tuple(Output(product, os.path.join(root, path)) for product, path in outputs.items())


def _outcome_to(root: str, outcome: Outcome, outputs: Iterable[Output]) -> dict[str, Any]:
    return {
        "done": outcome.name,
        "outputs": _outputs_to(root, outputs),
        "exit_code": outcome.exit_code,
        "message": outcome.message,
        "remedy": outcome.remedy,
        "objects": outcome.objects,
        "confidence": outcome.confidence,
        "found": outcome.found,
        "measures": [list(measures) for measures in outcome.measures],
        "sha256": outcome.digest,
        "written": {_inside(root, path): digest for path, digest in sorted(outcome.written.items())},
    }


def _outcome_from(root: str, record: Mapping[str, Any]) -> Outcome:
    return Outcome(
        record["done"],
        int(record["exit_code"]),
        record["message"],
        record["remedy"],
        int(record["objects"]),
        record["confidence"],
        record["sha256"],
        {os.path.join(root, path): digest for path, digest in record["written"].items()},
        found=str(record.get("found", "")),
        measures=tuple(Measures(*values) for values in record.get("measures", [])),
    )
