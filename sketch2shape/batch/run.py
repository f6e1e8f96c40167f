"""A whole batch from the options to the exit code."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

from sketch2shape.batch.plan import Plan, make_plan, settle
from sketch2shape.batch.pool import run_tasks
from sketch2shape.command import products_of
from sketch2shape.convert import Outcome, Settings, Task
from sketch2shape.errors import UsageError, one_line

Work = Callable[[Task], Outcome]

_TIMEOUT = 120.0
_MEMORY = 4 * 2**30


def run_batch(arguments: Namespace, settings: Settings, work: Work) -> int:
    """Plan, work, tell. Returns 0, or 3 if some inputs failed.

    Raises UsageError, UnreadableError and WriteError before any work starts.
    """
    plan = make_plan(arguments.inputs, _out(arguments), products_of(arguments))
    if not arguments.overwrite:
        plan = settle(plan, versioned=arguments.versioned)
    if arguments.dry_run:
        for item in plan.items:
            for output in item.outputs:
                sys.stdout.write(f"{item.path}\t{output.path}\n")
        return 0
    Path(plan.root).mkdir(parents=True, exist_ok=True)
    counts: Counter[int] = Counter()
    for task, outcome in run_tasks(
        _tasks(plan, arguments, settings),
        work,
        jobs=arguments.jobs,
        timeout=arguments.timeout or _TIMEOUT,
        max_memory=arguments.max_memory or _MEMORY,
    ):
        counts[outcome.exit_code] += 1
        if outcome.message is not None:
            sys.stderr.write(one_line(task.source, outcome.message, outcome.remedy or "") + "\n")
    return 3 if set(counts) - {0} else 0


def _out(arguments: Namespace) -> str | None:
    """The one output folder. Raises UsageError."""
    if not arguments.output:
        return None
    out = arguments.output[0]
    if len(arguments.output) > 1:
        raise UsageError("several inputs take one -o", remedy="-o FOLDER, and --format for several formats")
    if out == "-" or "-" in arguments.inputs:
        raise UsageError("standard input and output are for a single picture", remedy="-o FOLDER")
    if Path(out).exists() and not Path(out).is_dir():
        raise UsageError(f"{out} is a file, several inputs need a folder", remedy="-o FOLDER")
    return str(out)


def _tasks(plan: Plan, arguments: Namespace, settings: Settings) -> Iterator[Task]:
    for item in plan.items:
        yield Task(item.path, item.name, item.outputs, arguments.overwrite, settings)
