"""Files that are there whole or not at all."""

from __future__ import annotations

from sketch2shape.writing.files import FolderLock, exists_error, make_folder, sweep, write_file
from sketch2shape.writing.streams import is_stream, occupy_descriptors, quiet_stderr, tell, write_stdout

__all__ = [
    "FolderLock",
    "exists_error",
    "is_stream",
    "make_folder",
    "occupy_descriptors",
    "quiet_stderr",
    "sweep",
    "tell",
    "write_file",
    "write_stdout",
]
