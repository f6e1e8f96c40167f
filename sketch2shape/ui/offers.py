"""What the page offers to take away and to read."""

from __future__ import annotations

from importlib.util import find_spec

from sketch2shape.writing.formats import FORMATS, ending

#: kinds of files that need a package of the extra `formats`
_READ_BY = {"heic": "pillow_heif", "pdf": "pypdfium2", "svg": "resvg_py"}


def offered_formats() -> list[dict[str, str]]:
    """Every format that is written: its name, what it is, its file ending and its group."""
    return [{"name": name, "what": f.what, "ending": ending(name), "group": f.group} for name, f in FORMATS.items()]


def readable_extras() -> dict[str, bool]:
    """Which kinds of files beyond ordinary pictures can be read here."""
    return {kind: find_spec(package) is not None for kind, package in _READ_BY.items()}
