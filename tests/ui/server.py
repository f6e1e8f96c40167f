"""The app as the command starts it, on a free port of this machine."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager


class Address(str):
    """The address of an app, and the process that serves it."""

    pid: int = 0


@contextmanager
def start_app(*options: str) -> Iterator[Address]:
    """Run `sketch2shape ui` and give its address."""
    command = [sys.executable, "-m", "sketch2shape", "ui", "--no-browser", "--port", "0", *options]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            lines = iter(process.stdout.readline, "") if process.stdout else iter(())
            address = Address(next(w for line in lines for w in line.split() if w.startswith("http://")))
            address.pid = process.pid
            yield address
        finally:
            process.terminate()
            process.wait(60)
