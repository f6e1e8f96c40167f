"""Clocks: calls and commands timed in turn, so that what slows the machine down slows all of them down."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

Call = Callable[[], object]


@dataclass(frozen=True)
class Table:
    """A table of the page: a title, words, column heads and rows of text."""

    title: str
    words: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True)
class Plot:
    """A log-log plot: name of the file, axis labels, curves {label: (x, y)}."""

    name: str
    x: str
    y: str
    curves: Mapping[str, tuple[Sequence[float], Sequence[float]]]


@dataclass(frozen=True)
class Report:
    """What a part of the benchmark found."""

    tables: Sequence[Table] = ()
    plots: Sequence[Plot] = field(default=())


def in_turn(calls: Mapping[str, Call], rounds: int) -> dict[str, float]:
    """Median seconds of each call; in each round every call runs once. One round before is not counted."""
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for number in range(rounds + 1):
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            if number:
                seconds[name].append(time.perf_counter() - start)
    return {name: float(np.median(s)) for name, s in seconds.items()}


def command(*words: str, codes: Sequence[int] = (0,)) -> Call:
    """A call that runs a command and raises unless it ends with one of the exit codes; a failure is no figure."""

    def call() -> None:
        done = subprocess.run(words, capture_output=True, text=True, check=False, env=_as_installed())
        if done.returncode not in codes:
            raise RuntimeError(f"{words} ended with {done.returncode}: {done.stderr[-500:]}")

    return call


def _as_installed() -> dict[str, str]:
    """The environment of a command that finds its modules compiled, as those of installed packages are."""
    own = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    return {"PYTHONPYCACHEPREFIX": os.path.join(tempfile.gettempdir(), "sketch2shape-benchmarks"), **own}


def python(code: str) -> Call:
    """A call that runs a line of Python in a fresh interpreter."""
    return command(sys.executable, "-c", code)


def tool(*words: str, codes: Sequence[int] = (0,)) -> Call:
    """A call that runs `sketch2shape` as installed beside the interpreter."""
    return command(str(Path(sys.executable).parent / "sketch2shape"), *words, codes=codes)


def exponent(x: Sequence[float], y: Sequence[float]) -> float:
    """Slope of the line through (log x, log y)."""
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])


def steepest(x: Sequence[float], y: Sequence[float]) -> float:
    """Largest slope between neighbours among (log x, log y)."""
    return float((np.diff(np.log(y)) / np.diff(np.log(x))).max())


def times(ratio: float) -> str:
    """A ratio as text."""
    return f"{ratio:.2f}" if ratio < 10 else f"{ratio:.0f}"
