"""Writing a file so that it is there whole or not at all, and never over another by accident.

The bytes go to a temporary file beside the target, are flushed to the disk, and then take the target's name in one
step: by a hard link where nothing may be replaced (it fails if the name is taken), by a rename otherwise. While a
temporary file is being written it is locked, so that a later run can tell a leftover from one in use.
"""

from __future__ import annotations

import contextlib
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

from sketch2shape.errors import WriteError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

_PREFIX, _SUFFIX = ".sketch2shape-", ".tmp"


def write_file(path: str | os.PathLike[str], data: bytes, *, overwrite: bool = False) -> None:
    """Write `data` to `path`, creating its folders. Raises WriteError; then `path` is as it was before."""
    target = Path(path)
    try:
        make_folder(target.parent)
        with tempfile.NamedTemporaryFile(dir=target.parent, prefix=_PREFIX, suffix=_SUFFIX, delete=False) as file:
            temporary = Path(file.name)
            try:
                _lock(file.fileno())
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
                os.chmod(temporary, 0o666 & ~_umask())
                _take_name(temporary, target, overwrite)
            finally:
                temporary.unlink(missing_ok=True)
    except FileExistsError:
        raise exists_error(target) from None
    except (OSError, ValueError) as error:
        raise WriteError(f"cannot write {target} ({getattr(error, 'strerror', None) or error})") from None


def make_folder(folder: str | os.PathLike[str]) -> None:
    """Make a folder and those above it, if they are not there. Raises WriteError."""
    try:
        os.makedirs(folder, exist_ok=True)
    except (OSError, ValueError) as error:
        raise WriteError(f"cannot make the folder {folder} ({getattr(error, 'strerror', None) or error})") from None


def exists_error(path: os.PathLike[str]) -> WriteError:
    """The error for an output that is there already."""
    return WriteError(f"{os.fspath(path)} exists already", remedy="--overwrite, --versioned, or another -o")


def _take_name(temporary: Path, target: Path, overwrite: bool) -> None:
    if overwrite:
        os.replace(temporary, target)
        return
    try:
        os.link(temporary, target)
    except FileExistsError:
        raise
    except OSError:  # a file system without hard links: look first, then rename
        if os.path.lexists(target):
            raise FileExistsError(str(target)) from None
        os.replace(temporary, target)


def _umask() -> int:
    """The process's umask; it can only be read by setting it."""
    mask = os.umask(0o022)
    os.umask(mask)
    return mask


def _lock(descriptor: int) -> bool:
    """Lock an open file; False if another process holds it."""
    if fcntl is None:
        return True
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks
        return True
    return True


def sweep(folder: str | os.PathLike[str]) -> int:
    """Remove temporary files that killed runs left in a folder; return how many. Files being written are left alone."""
    removed = 0
    try:
        names = [e.name for e in os.scandir(folder) if e.name.startswith(_PREFIX) and e.name.endswith(_SUFFIX)]
    except OSError:
        return 0
    for name in names:
        path = Path(folder, name)
        with contextlib.suppress(OSError), path.open("rb") as file:
            if _lock(file.fileno()):
                path.unlink()
                removed += 1
    return removed


class FolderLock:
    """Keeps a second run out of the same output folder for as long as it is held."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """Name the folder; it must exist when the lock is taken."""
        self.folder = Path(folder)
        self._descriptor: int | None = None

    def __enter__(self) -> FolderLock:
        """Take the lock. Raises WriteError if another run holds it."""
        if fcntl is not None:
            self._descriptor = os.open(self.folder, os.O_RDONLY)
            if not _lock(self._descriptor):
                os.close(self._descriptor)
                raise WriteError(f"another run is writing to {self.folder}", remedy="wait for it, or another -o")
        return self

    def __exit__(self, *_: object) -> None:
        """Let go."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None


def write_stdout(data: bytes, stream: BinaryIO | None = None) -> None:
    """Write the product to standard output; a reader that has gone away (`| head`) is no error. Raises WriteError."""
    out = stream or sys.stdout.buffer
    try:
        out.write(data)
        out.flush()
    except BrokenPipeError:
        _silence(out)
    except (OSError, ValueError) as error:
        _silence(out)
        raise WriteError(f"cannot write to standard output ({getattr(error, 'strerror', None) or error})") from None


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
