"""Formats that hold lines: what is read of each, and which of their files are pictures all the same."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.model import Picture
from sketch2shape.reading.excalidraw import excalidraw_shapes
from sketch2shape.reading.extra_formats import inflated, opened_pdf, svg_size, xml_text
from sketch2shape.reading.inkml import inkml_lines
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.painted import OutlinedStrokesError, Shape, visible_lines
from sketch2shape.reading.pen_strokes import from_json
from sketch2shape.reading.sheet import picture_of
from sketch2shape.reading.svg_lines import svg_shapes
from sketch2shape.reading.tldraw import tldraw_shapes

#: values in a JSON file that are read at most: as many as the largest drawing has, with time and pressure
_MOST_VALUES = 600_000
#: lines of a page of a PDF from which on it holds a drawing; a frame and a rule or two are a page of text
_FEWEST = 6


def read_vectors(name: str, data: bytes, limits: Limits, page: int, source: str) -> Picture | None:
    """The lines of a vector drawing; None where it is to be read as a picture.

    name : "JSON", "INKML", "SVG" or "PDF"

    Raises UnreadableError, LimitError, MissingPackageError.
    """
    if name == "JSON":
        return _json(data, source)
    if name == "INKML":
        return picture_of(inkml_lines(data), source=source)
    try:
        return _svg(data, limits, source) if name == "SVG" else _pdf(data, page, source)
    except OutlinedStrokesError:
        return None


def _json(data: bytes, source: str) -> Picture:
    if data.count(b",") > _MOST_VALUES:
        raise LimitError("it holds too many points", remedy="a drawing, not a data set")
    try:
        held: Any = json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:
        reason = (str(error).splitlines() or [""])[0][:80]
        raise UnreadableError(f"damaged JSON ({reason})", remedy="save it again") from None
    if isinstance(held, dict):
        if held.get("type") in ("excalidraw", "excalidraw/clipboard"):
            return _whiteboard(excalidraw_shapes(held), source)
        if "tldrawFileFormatVersion" in held:
            return _whiteboard(tldraw_shapes(held), source)
    if isinstance(held, list) or (isinstance(held, dict) and "strokes" in held):
        return from_json(held, source)
    raise UnreadableError("JSON that holds no drawing", remedy='{"strokes": [[[x, y], ...], ...]}')


def _whiteboard(shapes: Sequence[Shape], source: str) -> Picture:
    try:
        return picture_of(visible_lines(shapes), source=source)
    except OutlinedStrokesError:
        raise LimitError("it has too many filled shapes", remedy="a drawing of one object, without fillings") from None


def _svg(data: bytes, limits: Limits, source: str) -> Picture | None:
    text = xml_text(inflated(data, limits))
    size = svg_size(text)
    lines = visible_lines(svg_shapes(text, size))
    return picture_of(lines, page=size, source=source) if lines else None


def _pdf(data: bytes, page: int, source: str) -> Picture | None:
    from sketch2shape.reading.pdf_lines import page_shapes

    document = opened_pdf(data)
    try:
        if page >= len(document):
            return None
        sheet = document[page]
        shapes = page_shapes(sheet)
        lines = [] if shapes is None else visible_lines(shapes)
        return picture_of(lines, page=sheet.get_size(), source=source) if len(lines) >= _FEWEST else None
    finally:
        document.close()
