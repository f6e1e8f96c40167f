"""What the command does once its options are known: one picture here and now, anything more as a batch."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sketch2shape.command.outputs import outputs_of, settled
from sketch2shape.conversion.convert import Outcome, Settings, Task, convert
from sketch2shape.corrections import read_corrections
from sketch2shape.errors import one_line
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import parse_page
from sketch2shape.writing import is_stream, sweep, write_stdout

if TYPE_CHECKING:
    from sketch2shape.lifting import LiftOptions

Work = Callable[[Task], Outcome]


def run(arguments: Namespace, work: Work = convert) -> int:
    """Do what the options ask for and return the exit code. `work` does one task; tests pass their own.

    Raises UsageError, and WriteError for an output that exists.
    """
    settings = settings_of(arguments)
    inputs = arguments.inputs
    if len(inputs) == 1 and not os.path.isdir(inputs[0]):
        return _run_one(arguments, settings, work)
    from sketch2shape.batch.run import run_batch

    return run_batch(arguments, settings, work)


def settings_of(arguments: Namespace) -> Settings:
    """The settings that the options describe. Raises UsageError."""
    sizes = {"max_pixels": arguments.max_pixels, "max_bytes": arguments.max_bytes}
    limits = Limits(**{name: value for name, value in sizes.items() if value is not None})
    page = parse_page(arguments.pages)
    corrections = ""
    if arguments.vertices:
        many = len(arguments.inputs) > 1 or os.path.isdir(arguments.inputs[0])
        corrections = read_corrections(arguments.vertices, many=many)
    return Settings(limits, page, stage_options(arguments), corrections, mesh_options(arguments), arguments.timings)


def stage_options(arguments: Namespace) -> dict[str, Any]:
    """Keyword arguments of `reconstruct`."""
    named = {"connector": arguments.connector, "detector": arguments.detector}
    options: dict[str, Any] = {name: value for name, value in named.items() if value != "auto"}
    lifting = _lift_options(arguments)
    return options if lifting is None else {**options, "lift": lifting}


def mesh_options(arguments: Namespace) -> dict[str, Any]:
    """Keyword arguments of `encode`."""
    return {"ngons": True} if arguments.ngons else {}


def _lift_options(arguments: Namespace) -> LiftOptions | None:
    """How to lift the object, None if nothing is asked for. Raises UsageError for sizes that make no sense."""
    from sketch2shape.lifting import LiftOptions

    options = LiftOptions(
        projection=arguments.projection,
        width=arguments.width,
        height=arguments.height,
        depth=arguments.depth,
        fit=arguments.fit,
        depth_ratio=arguments.depth_ratio,
        unit=arguments.unit,
        up=arguments.up,
        necker=arguments.necker,
        reading=arguments.reading,
        beautify=not arguments.no_beautify,
    )
    return None if options == LiftOptions() else options


def _run_one(arguments: Namespace, settings: Settings, work: Work) -> int:
    """One picture, in this process; in a worker where a limit on time or memory is asked for."""
    source = arguments.inputs[0]
    outputs = settled(outputs_of(arguments), arguments)
    if arguments.dry_run:
        for output in outputs:
            write_stdout(os.fsencode(f"{source}\t{output.path}\n"))
        return 0
    for folder in {str(Path(o.path).parent) for o in outputs if o.path != "-" and not is_stream(o.path)}:
        sweep(folder)
    name = "stdin" if source == "-" else Path(source).name
    settings = replace(settings, timings=True)
    data = sys.stdin.buffer.read(settings.limits.max_bytes + 1) if source == "-" else None
    task = Task(source, name, tuple(outputs), arguments.overwrite, settings, data)
    outcome = _limited(task, arguments, work) if arguments.timeout or arguments.max_memory else work(task)
    if outcome.message is not None:
        sys.stderr.write(one_line(source, outcome.message, outcome.remedy or "") + "\n")
    return outcome.exit_code


def _limited(task: Task, arguments: Namespace, work: Work) -> Outcome:
    from sketch2shape.batch.pool import run_tasks

    results = run_tasks([task], work, jobs=1, timeout=arguments.timeout, max_memory=arguments.max_memory)
    return next(outcome for _, outcome in results)
