"""Writing to what cannot be replaced: standard output, open descriptors, pipes and devices."""

from __future__ import annotations

import contextlib
import os
import re
import stat
import sys
from collections.abc import Iterator

from sketch2shape.errors import WriteError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import BinaryIO

#: names of open descriptors: what is behind them, even a file, is written on from where it stands
_DESCRIPTOR = re.compile(r"/dev/(?:fd/(?P<number>\d+)|(?P<name>stdin|stdout|stderr))|/proc/self/fd/(?P<process>\d+)")
_STANDARD = {"stdin": 0, "stdout": 1, "stderr": 2}


def is_stream(path: str | os.PathLike[str]) -> bool:
    """Whether a path is a pipe, a device or the name of an open descriptor: something to write into, not to replace."""
    if _descriptor(path) is not None:
        return True
    try:
        mode = os.stat(path).st_mode
    except (OSError, ValueError):
        return False
    return not (stat.S_ISREG(mode) or stat.S_ISDIR(mode))


def write_stream(path: str | os.PathLike[str], data: bytes) -> None:
    """Write into a stream (`is_stream`); a reader that has gone away is no error. Raises WriteError."""
    number = _descriptor(path)
    try:
        if number is None and stat.S_ISBLK(os.stat(path).st_mode):
            raise WriteError(f"{os.fspath(path)} is a disk", remedy="a file on it")
        opened = os.dup(number) if number is not None else os.open(path, os.O_WRONLY | getattr(os, "O_NOCTTY", 0))
        with open(opened, "wb") as stream:
            stream.write(data)
    except BrokenPipeError:
        return
    except OSError as error:
        raise WriteError(f"cannot write to {os.fspath(path)} ({error.strerror or error})") from None


def _descriptor(path: str | os.PathLike[str]) -> int | None:
    """The number of the open descriptor that a path names, if it names one."""
    match = _DESCRIPTOR.fullmatch(os.fspath(path))
    if not match:
        return None
    return _STANDARD[match["name"]] if match["name"] else int(match["number"] or match["process"])


def write_stdout(data: bytes, stream: BinaryIO | None = None) -> None:
    """Write the product to standard output; a reader that has gone away (`| head`) is no error. Raises WriteError."""
    out = stream or getattr(sys.stdout, "buffer", None)
    if out is None:
        raise WriteError("standard output is closed", remedy="-o FILE")
    try:
        out.write(data)
        out.flush()
    except BrokenPipeError:
        _silence(out)
    except (OSError, ValueError) as error:
        _silence(out)
        raise WriteError(f"cannot write to standard output ({getattr(error, 'strerror', None) or error})") from None


def tell(line: str) -> None:
    """Write a line to standard error; for the command only. Where nobody listens the work goes on all the same."""
    if sys.stderr is None:
        return
    try:
        sys.stderr.write(line + "\n")
        sys.stderr.flush()
    except (OSError, ValueError):  # else the interpreter's own flush at exit would fail again
        sys.stderr = open(os.devnull, "w")  # noqa: SIM115


def occupy_descriptors() -> None:
    """Put the null device where a standard stream is closed, lest the next file that is opened takes its number."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            with contextlib.suppress(OSError):
                os.open(os.devnull, os.O_RDWR)  # the system gives the lowest number that is free


@contextlib.contextmanager
def quiet_stderr() -> Iterator[None]:
    """Keep libraries in C from writing to standard error meanwhile; those that decode damaged files are talkative.

    For the command only: it acts on the whole process.
    """
    try:
        saved = os.dup(2)
    except OSError:  # there is no standard error
        yield
        return
    try:
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, 2)
        os.close(null)
        yield
    finally:
        os.dup2(saved, 2)
        os.close(saved)


def _silence(out: BinaryIO) -> None:
    """Point a broken stream at nothing, so that the interpreter's own flush at exit does not fail again."""
    with contextlib.suppress(OSError, ValueError):
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, out.fileno())
        os.close(null)
