"""Writing a file so that it is there whole or not at all, and never over another by accident.

The bytes go to a temporary file beside the target, are flushed to the disk, and then take the target's name in one
step: by a hard link where nothing may be replaced (it fails if the name is taken), by a rename otherwise. While a
temporary file is being written it is locked, so that a later run can tell a leftover from one in use.

A file that is replaced hands its permissions on, and its owner where the system allows it. A symbolic link is followed:
the file it leads to is replaced, the link stays. A pipe or a device is written into, it cannot be replaced.
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import time
from pathlib import Path

from sketch2shape.errors import WriteError
from sketch2shape.writing.streams import is_stream, write_stream

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

_PREFIX, _SUFFIX = ".sketch2shape-", ".tmp"
#: a temporary file this old is a leftover where the system has no locks to tell, seconds: writing takes a few at most
_ABANDONED = 600.0
_PERMISSIONS = 0o7777


def write_file(
    path: str | os.PathLike[str], data: bytes, *, overwrite: bool = False, follow_links: bool = True
) -> None:
    """Write `data` to `path`, creating its folders. Raises WriteError; then `path` is as it was before.

    overwrite    : whether a file that is there may be replaced
    follow_links : whether a symbolic link that is there leads to the file to replace; otherwise it is itself replaced
    """
    if is_stream(path):
        write_stream(path, data)
        return
    target = Path(path)
    try:
        if overwrite and follow_links:
            target = _behind_links(target)
        make_folder(target.parent)
        _put(target, data, overwrite)
    except FileExistsError:
        raise exists_error(Path(path)) from None
    except (OSError, ValueError) as error:
        raise WriteError(f"cannot write {path} ({getattr(error, 'strerror', None) or error})") from None


def _behind_links(target: Path) -> Path:
    """The file that a symbolic link leads to; anything else is itself. Raises OSError for links in a circle."""
    if not target.is_symlink():
        return target
    end = Path(os.path.realpath(target))
    if end.is_symlink():
        raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
    return end


def _put(target: Path, data: bytes, overwrite: bool) -> None:
    """Write a temporary file beside the target and let it take the target's name."""
    old = _status(target) if overwrite else None
    temporary = target.parent / f"{_PREFIX}{os.urandom(8).hex()}{_SUFFIX}"
    # the system takes the umask's bits away, and no moment exists in which more people may read it than in the end
    mode = 0o666 if old is None else stat.S_IMODE(old.st_mode) & 0o666
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
    try:
        with open(os.open(temporary, flags, mode), "wb") as file:
            _lock(file.fileno())
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
            if old is not None:
                _hand_on(temporary, old)
            if fcntl is not None:  # with the lock still held; other systems do not rename an open file
                _take_name(temporary, target, overwrite)
        if fcntl is None:
            _take_name(temporary, target, overwrite)
    finally:
        temporary.unlink(missing_ok=True)


def _status(target: Path) -> os.stat_result | None:
    """What is known of a regular file that is there; None for anything else."""
    with contextlib.suppress(FileNotFoundError):
        status = os.lstat(target)
        if stat.S_ISREG(status.st_mode):
            return status
    return None


def _hand_on(temporary: Path, old: os.stat_result) -> None:
    """Give the new file the owner and the permissions of the old one, as far as this user may."""
    with contextlib.suppress(OSError, AttributeError):
        os.chown(temporary, old.st_uid, old.st_gid)
    with contextlib.suppress(OSError):
        os.chmod(temporary, old.st_mode & _PERMISSIONS)


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
        found = [e for e in os.scandir(folder) if e.name.startswith(_PREFIX) and e.name.endswith(_SUFFIX)]
    except OSError:
        return 0
    for path in (Path(entry.path) for entry in found if entry.is_file(follow_symlinks=False)):
        with contextlib.suppress(OSError):
            if _abandoned(path):
                path.unlink()
                removed += 1
    return removed


def _abandoned(path: Path) -> bool:
    """Whether nobody writes to a temporary file any more: no one holds its lock or, without locks, it is old."""
    if fcntl is None:
        return time.time() - path.stat().st_mtime > _ABANDONED
    with path.open("rb") as file:
        return _lock(file.fileno())


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
