"""Inputs are never replaced, whatever the options say and by whatever name an output would reach them."""

from __future__ import annotations

import os
import unicodedata
from collections.abc import Iterable

from sketch2shape.errors import UsageError
from sketch2shape.writing import is_stream


def keep_inputs(inputs: Iterable[str], outputs: Iterable[str]) -> None:
    """Raise UsageError if an output would replace an input: by the same name, or by a link to the same file."""
    inputs = [path for path in inputs if path != "-"]
    names = {fold(os.path.abspath(path)) for path in inputs}
    files = {_identity(path) for path in inputs} - {None}
    for path in outputs:
        if path == "-" or is_stream(path):
            continue
        if fold(os.path.abspath(path)) in names or _identity(path) in files:
            raise UsageError(f"{path} would replace an input", remedy="another name or folder with -o")


def fold(path: str) -> str:
    """One key for all spellings that some file system holds to be the same name."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFD", path).casefold())


def _identity(path: str) -> tuple[int, int] | None:
    """Device and number of the file behind a name, links followed; None where there is none."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_dev, status.st_ino
