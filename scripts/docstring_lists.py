"""For the site: lines `name : meaning` in docstrings become lists. Used by mkdocstrings, see mkdocs.yml."""

from __future__ import annotations

import re
from typing import Any

import griffe

ENTRY = re.compile(r"^([\w*]+(?:, [\w*]+)*)\s*: (\S.*)$")


def with_lists(text: str) -> str:
    """The text with each run of entries as a Markdown list; indented lines go on with the entry above."""
    out: list[str] = []
    inside = False
    for line in text.splitlines():
        entry = ENTRY.match(line)
        if entry and (inside or not out or not out[-1].strip()):
            out.append(f"- **{entry[1]}**: {entry[2]}")
            inside = True
        else:
            inside = inside and line.startswith(" ")
            out.append("    " + line.strip() if inside else line)
    return "\n".join(out)


class DocstringLists(griffe.Extension):
    """Rewrites the docstring of every object that is loaded."""

    def on_instance(self, *, obj: griffe.Object, **_: Any) -> None:
        """Called once for each module, class, function and attribute."""
        if obj.docstring:
            obj.docstring.value = with_lists(obj.docstring.value)
