"""What the command does once its options are known: one picture here and now, anything more as a batch."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sketch2shape.conversion.convert import Outcome, Output, Settings, Task, convert
from sketch2shape.conversion.products import PICTURES, infixed, product_of, products_of, suffix
from sketch2shape.corrections import read_corrections
from sketch2shape.errors import UsageError, one_line
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import parse_page
from sketch2shape.writing import exists_error, sweep, write_stdout

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
    outputs = _settle(_outputs_of(arguments), arguments)
    if arguments.dry_run:
        for output in outputs:
            write_stdout(os.fsencode(f"{source}\t{output.path}\n"))
        return 0
    for folder in {str(Path(o.path).parent) for o in outputs if o.path != "-"}:
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


def _outputs_of(arguments: Namespace) -> list[Output]:
    """The outputs of a single picture: each OUT, and the report beside it."""
    source = arguments.inputs[0]
    outs = arguments.output or (["-"] if source == "-" else [os.path.dirname(source) or "."])
    wanted = [output for out in outs for output in _outputs_at(out, source, arguments)]
    if arguments.json:
        files = [o for o in wanted if o.path != "-"]
        if not files:
            raise UsageError("--json has no file to be written beside", remedy="-o FILE, or --format json -o -")
        wanted += [Output("json", _stem(o) + ".json") for o in files]
    wanted += [Output(kind, getattr(arguments, kind)) for kind in PICTURES if getattr(arguments, kind)]
    unique = list(dict.fromkeys(wanted))
    if len({o.path for o in unique}) < len(unique):
        raise UsageError("two outputs have the same name", remedy="another -o or --format")
    return unique


def _stem(output: Output) -> str:
    """The path without the ending: "a" for "a.obj" and for "a.face.svg"."""
    ending = suffix(output.product)
    known = output.path.lower().endswith(ending)
    return output.path[: -len(ending)] if known else os.path.splitext(output.path)[0]


def _outputs_at(out: str, source: str, arguments: Namespace) -> list[Output]:
    """What one OUT stands for: standard output, a folder (products by --format) or a file (product by its name)."""
    products = [p for p in products_of(arguments) if p != "json" or "json" in arguments.format]
    if out == "-":
        if len(products) != 1 or arguments.pages == "all":
            raise UsageError("standard output takes one file", remedy="a single --format and page, or -o FOLDER")
        return [Output(products[0], "-")]
    if os.path.isdir(out) or out.endswith(("/", os.sep)) or not os.path.splitext(out)[1]:
        stem = "stdin" if source == "-" else Path(source).stem
        return [Output(product, os.path.join(out, stem + suffix(product))) for product in products]
    product = product_of(out)
    if arguments.format and len(products) == 1 and suffix(products[0]) == suffix(product):
        product = products[0]  # --format picks among formats of the same ending
    elif arguments.format and product not in products:
        raise UsageError(f"{out} contradicts --format {','.join(arguments.format)}", remedy="one of the two")
    return [Output(product, out)]


def _settle(outputs: list[Output], arguments: Namespace) -> list[Output]:
    """Refuse or rename outputs that exist already. Raises WriteError."""
    taken = [o.path for o in outputs if o.path != "-" and os.path.lexists(o.path)]
    if not taken or arguments.overwrite:
        return outputs
    if not arguments.versioned:
        raise exists_error(Path(taken[0]))
    version = 2
    while any(os.path.lexists(infixed(o.path, o.product, f".{version}")) for o in outputs if o.path != "-"):
        version += 1
    return [replace(o, path=infixed(o.path, o.product, f".{version}")) for o in outputs]
