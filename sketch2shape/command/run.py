"""What the command does once its options are known: one picture here and now, anything more as a batch."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sketch2shape.command.checks import check_effects, check_input, check_inputs
from sketch2shape.command.outputs import outputs_of, settled
from sketch2shape.conversion.convert import Outcome, Output, Settings, Task, convert
from sketch2shape.conversion.options import wants_pages
from sketch2shape.conversion.telling import Teller
from sketch2shape.corrections import check_pictures, read_corrections
from sketch2shape.errors import UnreadableError
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import parse_page
from sketch2shape.writing import is_stream, sweep, tell, write_stdout

if TYPE_CHECKING:
    from sketch2shape.batch.plan import Planned
    from sketch2shape.lifting import LiftOptions

Work = Callable[[Task], Outcome]


def run(arguments: Namespace, work: Work = convert) -> int:
    """Do what the options ask for and return the exit code. `work` does one task; tests pass their own.

    Raises UsageError, and WriteError for an output that exists.
    """
    inputs = arguments.inputs
    check_inputs(inputs)
    settings = settings_of(arguments)
    if (
        len(inputs) == 1
        and not os.path.isdir(inputs[0])
        and not (arguments.resume or arguments.scheduler or arguments.watch)
    ):
        return _run_one(arguments, settings, work)
    from sketch2shape.batch.run import run_batch

    check_effects(arguments)
    if arguments.watch:
        from sketch2shape.batch.watch import watch

        return watch(arguments, settings, work)
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
    if arguments.min_confidence is not None:
        options["min_confidence"] = arguments.min_confidence
    lifting = _lift_options(arguments)
    return options if lifting is None else {**options, "lift": lifting}


def mesh_options(arguments: Namespace) -> dict[str, Any]:
    """Keyword arguments of `encode`. Raises UsageError for a tolerance that is no length."""
    from sketch2shape.pipeline.options import tolerance_of

    tolerance_of(arguments.tolerance, "mm")
    options: dict[str, Any] = {"ngons": True} if arguments.ngons else {}
    given = {name: getattr(arguments, name) for name in ("tolerance", "paper", "angle")}
    return options | {name: value for name, value in given.items() if value is not None}


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
    outputs = outputs_of(arguments)
    check_effects(arguments, [o.product for o in outputs])
    check_input(source)
    outputs = settled(outputs, arguments)
    extras = _Extras(arguments, outputs)
    if arguments.dry_run:
        for output in outputs:
            write_stdout(os.fsencode(f"{source}\t{output.path}\n"))
        return 0
    name = "stdin" if source == "-" else Path(source).name
    say = (lambda _: None) if arguments.quiet else tell
    note = check_pictures(settings.corrections, arguments.vertices, [name]) if settings.corrections else None
    if note:
        say(f"{source}: {note}")
    for folder in {str(Path(o.path).parent) for o in outputs if o.path != "-" and not is_stream(o.path)}:
        sweep(folder)
    task = Task(
        source, name, tuple(outputs), arguments.overwrite, replace(settings, timings=True), _stdin_of(arguments)
    )
    outcome = _limited(task, arguments, work) if arguments.timeout or arguments.max_memory else work(task)
    if outcome.message is not None:
        tell(Teller().failure(task, outcome))
    else:
        for line in Teller().success(task, outcome):
            say(line)
    extras.write(outcome)
    return outcome.exit_code


class _Extras:
    """The table and the pages, of a single picture."""

    def __init__(self, arguments: Namespace, outputs: Sequence[Output]) -> None:
        """Check their names. Raises UsageError and WriteError."""
        self._arguments = arguments
        self._wanted = bool(arguments.report or wants_pages(arguments))
        self._outputs = tuple(outputs)
        if self._wanted:
            from sketch2shape.batch.extras import check_extras, keep_files

            check_extras(arguments)
            keep_files(arguments, [self._planned()])

    def write(self, outcome: Outcome) -> None:
        """Write them. Raises WriteError."""
        if self._wanted:
            from sketch2shape.batch.extras import write_extras

            write_extras(self._arguments, [(self._planned(), outcome)])

    def _planned(self) -> Planned:
        from sketch2shape.batch.plan import Planned

        source = self._arguments.inputs[0]
        return Planned(source, "stdin" if source == "-" else Path(source).name, self._outputs)


def _stdin_of(arguments: Namespace) -> bytes | None:
    """The picture on standard input, None if it is not there. Raises UnreadableError."""
    if arguments.inputs[0] != "-":
        return None
    if sys.stdin is None:
        raise UnreadableError("standard input is closed", remedy="a file, or a picture on standard input")
    limits = Limits() if arguments.max_bytes is None else Limits(max_bytes=arguments.max_bytes)
    return sys.stdin.buffer.read(limits.max_bytes + 1)


def _limited(task: Task, arguments: Namespace, work: Work) -> Outcome:
    from sketch2shape.batch.pool import run_tasks

    limits = {"timeout": arguments.timeout, "max_memory": arguments.max_memory}
    results = run_tasks([task], work, jobs=1, **limits, notice=lambda text: tell(f"sketch2shape: {text}"))
    return next(outcome for _, outcome in results)
