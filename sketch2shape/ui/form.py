"""A file in a form (multipart/form-data, RFC 7578)."""

from __future__ import annotations

import re

from sketch2shape.ui.guard import Refusal

_BOUNDARY = re.compile(r'boundary\s*=\s*(?:"([^"]{1,70})"|([^\s;,"]{1,70}))', re.IGNORECASE)
_MOST_PARTS = 32


def file_of(body: bytes, content_type: str) -> bytes:
    """The bytes of the field "file", else of the first part that has a file name. Raises Refusal."""
    match = _BOUNDARY.search(content_type)
    if match is None:
        raise Refusal(400, "the form has no boundary", "send the picture itself, or a form with a file")
    fence = b"\r\n--" + (match[1] or match[2]).encode("latin-1")
    files: dict[str, bytes] = {}
    for part in (b"\r\n" + body).split(fence, _MOST_PARTS)[1:]:
        head, blank, content = part.partition(b"\r\n\r\n")
        fields = head.decode("utf-8", "replace")
        name = re.search(r'(?<!file)name="([^"]*)"', fields)
        if blank and name and (name[1] == "file" or "filename" in fields):
            files.setdefault(name[1], content)
    if not files:
        raise Refusal(400, "the form holds no file", 'a field called "file"')
    return files.get("file", next(iter(files.values())))
