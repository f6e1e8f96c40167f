"""How many threads linear algebra starts: told by environment variables, before it is loaded."""

from __future__ import annotations

import os

NAMES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def compute_in_one_thread(*, whatever_was_asked: bool = False) -> None:
    """Ask for one thread, for a process of our own: for small matrices more only cost time.

    whatever_was_asked : also if the user asked for another number; workers themselves fill the cores
    """
    for name in NAMES:
        if whatever_was_asked:
            os.environ[name] = "1"
        else:
            os.environ.setdefault(name, "1")
