"""The files that the options ask for, where the input is a single picture."""

from __future__ import annotations

import os
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from sketch2shape.conversion.convert import Output
from sketch2shape.conversion.inputs import keep_inputs
from sketch2shape.conversion.options import formats_of, wants_pages
from sketch2shape.errors import UsageError
from sketch2shape.pipeline.products import PICTURES, SUFFIXES, infixed, product_of, suffix
from sketch2shape.writing import exists_error, is_stream


def outputs_of(arguments: Namespace) -> list[Output]:
    """The outputs of a single picture: each OUT, the report beside it, the pictures. Raises UsageError."""
    source = arguments.inputs[0]
    outs = arguments.output or (["-"] if source == "-" else [os.path.dirname(source) or "."])
    wanted = [output for out in outs for output in _outputs_at(out, source, arguments)]
    files = [o for o in wanted if not _flows(o.path)]
    if arguments.json:
        if not files:
            raise UsageError("--json has no file to be written beside", remedy="-o FILE, or --format json -o -")
        wanted += [Output("json", _stem(o) + ".json") for o in files]
    if wants_pages(arguments) and files and not arguments.overlay:
        wanted.append(Output("overlay", _stem(files[0]) + suffix("overlay")))
    wanted += [_picture(kind, getattr(arguments, kind)) for kind in PICTURES if getattr(arguments, kind)]
    unique = list(dict.fromkeys(wanted))
    if len({o.path for o in unique}) < len(unique):
        raise UsageError("two outputs have the same name", remedy="another -o or --format")
    return unique


def settled(outputs: list[Output], arguments: Namespace) -> list[Output]:
    """Refuse or rename outputs that exist already. Raises WriteError, and UsageError for one that is an input."""
    inputs = [arguments.inputs[0], *filter(None, [arguments.vertices])]
    if not arguments.versioned:
        keep_inputs(inputs, (o.path for o in outputs))
    taken = [o.path for o in outputs if not _flows(o.path) and os.path.lexists(o.path)]
    if not taken or arguments.overwrite:
        return outputs
    if not arguments.versioned:
        raise exists_error(Path(taken[0]))
    version = 2
    while any(os.path.lexists(infixed(o.path, o.product, f".{version}")) for o in outputs if not _flows(o.path)):
        version += 1
    return [o if _flows(o.path) else replace(o, path=infixed(o.path, o.product, f".{version}")) for o in outputs]


def _flows(path: str) -> bool:
    """Whether what is written there is no file of its own: standard output, a pipe, a device."""
    return path == "-" or is_stream(path)


def _picture(kind: str, path: str) -> Output:
    """The output that --overlay FILE and its like ask for. Raises UsageError if the name promises another format."""
    ending = "." + SUFFIXES[kind].rpartition(".")[2]
    if not _flows(path) and not path.lower().endswith(ending):
        raise UsageError(f"--{kind} {path}: what is written is {ending[1:].upper()}", remedy=f"--{kind} NAME{ending}")
    return Output(kind, path)


def _stem(output: Output) -> str:
    """The path without the ending: "a" for "a.obj" and for "a.face.svg"."""
    ending = suffix(output.product)
    known = output.path.lower().endswith(ending)
    return output.path[: -len(ending)] if known else os.path.splitext(output.path)[0]


def _outputs_at(out: str, source: str, arguments: Namespace) -> list[Output]:
    """What one OUT stands for: a stream, a folder (products by --format) or a file (product by its name)."""
    products = formats_of(arguments)
    if out == "-" or (is_stream(out) and not os.path.splitext(out)[1]):
        if len(products) != 1 or arguments.pages == "all":
            name = "standard output" if out == "-" else out
            raise UsageError(f"{name} takes one file", remedy="a single --format and page, or -o FOLDER")
        return [Output(products[0], out)]
    if os.path.isdir(out) or out.endswith(("/", os.sep)) or not os.path.splitext(out)[1]:
        stem = "stdin" if source == "-" else Path(source).stem
        return [Output(product, os.path.join(out, stem + suffix(product))) for product in products]
    product = product_of(out)
    if arguments.format and len(products) == 1 and suffix(products[0]) == suffix(product):
        product = products[0]  # --format picks among formats of the same ending
    elif arguments.format and product not in products:
        raise UsageError(f"{out} contradicts --format {','.join(arguments.format)}", remedy="one of the two")
    return [Output(product, out)]
