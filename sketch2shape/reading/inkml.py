"""Strokes of InkML (W3C Recommendation, 20 September 2011): XML, a trace for each pull of a pen.

A trace is a list of points, parted by commas, with a value for each channel of its format, X and Y first unless that
says otherwise. Values may be differences: ' begins first and " second differences, ! ends them.
"""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element

import numpy as np

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.model import Floats, VectorLine
from sketch2shape.reading.guarded_xml import local, parsed

MOST_VALUES = 300_000
"""Values of all traces together."""
_VALUE = re.compile(r"([!'\"]?)\s*(-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|#[0-9a-fA-F]+|[TF*?])")
_MARKS = {"!": 0, "'": 1, '"': 2}
_ID = "{http://www.w3.org/XML/1998/namespace}id"


def inkml_lines(data: bytes) -> list[VectorLine]:
    """The traces that a pen left on the sheet. Raises UnreadableError, LimitError."""
    root = parsed(data)
    if local(root.tag) != "ink":
        raise UnreadableError("XML that holds no ink", remedy="InkML or SVG")
    formats = _formats(root)
    lines, budget = [], MOST_VALUES
    for trace in (e for e in root.iter() if local(e.tag) == "trace"):
        if trace.get("type", "penDown") != "penDown":
            continue
        columns = formats.get(trace.get("contextRef", "").lstrip("#"), formats[""])
        points, count = _points("".join(trace.itertext()), columns)
        budget -= count
        if budget < 0:
            raise LimitError("its traces have too many points", remedy="a drawing, not a notebook")
        if len(points):
            lines.append(VectorLine(points))
    return lines


class _Columns:
    """Where x and y stand among the values of a point, and which way they count."""

    def __init__(self, channels: list[Element]) -> None:
        names = [channel.get("name", "") for channel in channels] or ["X", "Y"]
        if "X" not in names or "Y" not in names:
            raise UnreadableError("its traces have no X and Y", remedy="another InkML file")
        self.x, self.y = names.index("X"), names.index("Y")
        self.signs = np.array([_sign(channels, names, name) for name in ("X", "Y")])


def _sign(channels: list[Element], names: list[str], name: str) -> float:
    given = channels[names.index(name)].get("orientation", "+ve") if channels else "+ve"
    return -1.0 if given == "-ve" else 1.0


def _formats(root: Element) -> dict[str, _Columns]:
    """The columns of each context, by its name and that of its format; "" for traces that name none."""
    found: dict[str, _Columns] = {}
    for element in root.iter():
        if local(element.tag) not in ("context", "traceFormat", "inkSource"):
            continue
        channels = [e for e in element.iter() if local(e.tag) == "channel"]
        refers = element.get("traceFormatRef", element.get("inkSourceRef", "")).lstrip("#")
        columns = _Columns(channels) if channels else found.get(refers)
        if columns is not None:
            found.setdefault("", columns)
            found.setdefault(element.get(_ID) or element.get("id") or "", columns)
    found.setdefault("", _Columns([]))
    return found


def _points(text: str, columns: _Columns) -> tuple[Floats, int]:
    """(n, 2) points of a trace, and how many values were read."""
    rows, count = [], 0
    order: list[int] = []
    now: list[float] = []
    speed: list[float] = []
    for sample in text.split(","):
        values = _VALUE.findall(sample)
        if len(values) <= max(columns.x, columns.y):
            if sample.strip():
                raise UnreadableError(f"a point of its traces is {sample.strip()[:20]!r}", remedy="save it again")
            continue
        count += len(values)
        missing = len(values) - len(now)
        order, now, speed = order + [0] * missing, now + [0.0] * missing, speed + [0.0] * missing
        for k, (mark, word) in enumerate(values):
            order[k] = _MARKS.get(mark, order[k])
            _step(k, _number(word, now[k]), order[k], now, speed)
        rows.append([now[columns.x], now[columns.y]])
    return np.array(rows, np.float64).reshape(-1, 2) * columns.signs, count


def _step(k: int, value: float, order: int, now: list[float], speed: list[float]) -> None:
    """Take a value of a channel: itself, a first or a second difference."""
    if order == 0:
        speed[k], now[k] = value - now[k], value
        return
    speed[k] = value if order == 1 else speed[k] + value
    now[k] += speed[k]


def _number(word: str, before: float) -> float:
    """A value; T, F, * (as before) and ? (unknown) are no places."""
    if word in ("T", "F"):
        return float(word == "T")
    if word in ("*", "?"):
        return before
    return float(int(word[1:], 16)) if word[0] == "#" else float(word)
