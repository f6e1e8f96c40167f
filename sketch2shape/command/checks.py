"""What can be said of the words of a command before any work: inputs that are none, options that change nothing."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Sequence

from sketch2shape.conversion.options import products_of
from sketch2shape.errors import UnreadableError, UsageError
from sketch2shape.reading.read import SUFFIXES as PICTURE_ENDINGS
from sketch2shape.writing.formats import FORMATS, named

_LENGTH_UNITS = frozenset({"px", "mm", "cm", "m", "in", "inch"})


def check_inputs(inputs: Sequence[str]) -> None:
    """Look at what is given as inputs, where there are several: a word that is no file was mostly meant otherwise.

    Raises UsageError. A missing picture among others is left to the run, which tells it apart from the rest.
    """
    for word in inputs if len(inputs) > 1 else ():
        ending = os.path.splitext(word)[1].lower()
        # strokes of a pen are JSON, as reports are: what is there is meant
        is_picture = ending in PICTURE_ENDINGS or ending == ".json"
        if _is_output(ending) and not (is_picture and os.path.lexists(word)):
            raise UsageError(
                f"{word} is an output by its name, not a picture", remedy=f"give the output with -o {word}"
            )
        if not ending and not os.path.lexists(word) and word != "-":
            if word.lower() in _LENGTH_UNITS:
                raise UsageError(f"there is no file called {word}", remedy="a length in one word, as in --width 40mm")
            raise UsageError(
                f"there is no file or folder called {word}", remedy="sketch2shape INPUT -o OUT, without other words"
            )


def check_input(source: str) -> None:
    """Raise UnreadableError if a single input is not there, before anything is said of its outputs."""
    if source != "-" and not os.path.lexists(source):
        raise UnreadableError("no such file or directory", remedy="check the path")


def check_effects(arguments: Namespace, products: Sequence[str] | None = None) -> None:
    """Raise UsageError for an option that would change nothing; `products` are those of a single picture."""
    written = products_of(arguments) if products is None else products
    if arguments.ngons and "obj" not in written:
        raise UsageError("--ngons has no effect without OBJ", remedy="--format obj")
    if arguments.tolerance is not None and not set(written) & (set(named("solid")) - {"step"}):
        raise UsageError("--tolerance has no effect without a mesh", remedy="--format stl")
    if arguments.paper and not {*named("plan")} & {*written}:
        raise UsageError("--paper has no effect without a plan", remedy=f"--format {named('plan')[0]}")
    if arguments.angle and not any(product.startswith("views.") for product in written):
        raise UsageError("--angle has no effect without views", remedy="--format views.svg")
    if arguments.timings and "json" not in written:
        raise UsageError("--timings has no effect without a report", remedy="--json")
    idle = [name for name in ("jobs", "max_memory") if arguments.scheduler and getattr(arguments, name)]
    if idle:
        raise UsageError(
            f"--{idle[0].replace('_', '-')} has no effect on a cluster", remedy="the options of dask worker"
        )


def _is_output(ending: str) -> bool:
    """Whether a file of this ending is something that is written."""
    return ending.removeprefix(".") in {end for format in FORMATS.values() for end in format.endings}
