"""The real work, except for pictures whose names ask for a crash, a hang or a memory hog."""

from __future__ import annotations

import os
import re
import signal
import sys
import time

from sketch2shape.conversion.convert import Outcome, Task, convert


def work(task: Task) -> Outcome:
    """Misbehave as the name says, or convert."""
    if "crash" in task.name:
        os.kill(os.getpid(), signal.SIGSEGV)
    if "hang" in task.name:
        _hang()
    if "hog" in task.name:
        hoard = [bytearray(2**26) for _ in range(2**14)]
        del hoard
    return convert(task)


def _hang() -> None:
    """A regular expression that takes ages, and holds the interpreter's lock meanwhile."""
    deadline = time.monotonic() + 3600
    while time.monotonic() < deadline:
        re.match(r"(a+)+$", "a" * 40 + "b")


def main() -> int:
    """The command, with this work."""
    from sketch2shape.command.parser import parse
    from sketch2shape.command.run import run
    from sketch2shape.errors import Sketch2ShapeError

    try:
        return run(parse(sys.argv[1:]), work)
    except Sketch2ShapeError as error:
        sys.stderr.write(f"{error.message}\n")
        return error.exit_code


if __name__ == "__main__":
    from benchmarks.faults import misbehave  # so that workers find `work` under its own name

    sys.exit(misbehave.main())
