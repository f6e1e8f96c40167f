"""Converting pictures as they appear in a folder."""

from __future__ import annotations

import os
import time
from argparse import Namespace
from collections.abc import Callable

from sketch2shape.batch.manifest import load_past
from sketch2shape.batch.plan import common_folder, pictures_in
from sketch2shape.batch.run import Work, run_batch
from sketch2shape.conversion.convert import Settings
from sketch2shape.errors import InterruptedRunError, UsageError

#: seconds between two looks at the folder; a picture that has not changed between them has been written to its end
_PAUSE = 1.0

State = dict[str, tuple[int, int]]


def watch(
    arguments: Namespace, settings: Settings, work: Work, *, pause: Callable[[], None] = lambda: time.sleep(_PAUSE)
) -> int:
    """Convert what is in the folder, then what is new or has changed, until interrupted. Returns the exit code.

    Each time is a run with --resume: what is done stays as it is.

    Raises what `run_batch` raises.
    """
    if not all(map(os.path.isdir, arguments.inputs)):
        raise UsageError("--watch looks at folders", remedy="a folder as INPUT")
    again = Namespace(**{**vars(arguments), "resume": True})
    done: State = {}
    before: State = {}
    while True:
        now = _state(again)
        if now and now == before and now != done:
            code = run_batch(again, settings, work)
            if code == InterruptedRunError.exit_code or (code and arguments.fail_fast):
                return code
            done = now
        before = now
        pause()


def _state(arguments: Namespace) -> State:
    """Time and size of every picture in the folders, less what the runs themselves have written."""
    out = arguments.output[0] if arguments.output else None
    ours = load_past(out or common_folder(arguments.inputs)).files
    state: State = {}
    for path in pictures_in(arguments.inputs, out, ours=ours):
        try:
            status = os.stat(path)
        except OSError:  # gone again
            continue
        state[path] = (status.st_mtime_ns, status.st_size)
    return state
