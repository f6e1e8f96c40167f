"""Lines of a tldraw file (.tldr): JSON, a list of records; shapes lie on pages, in frames and in groups.

A shape has x, y and a rotation about that point, relative to its parent, and `props` of its type. Strokes of the pen
have segments of points, or since 2025 the same as base64: three 32-bit floats, then differences as 16-bit floats.
"""

from __future__ import annotations

import base64
import binascii
from collections.abc import Mapping
from typing import Any

import numpy as np

from sketch2shape.errors import UnreadableError
from sketch2shape.model import Floats, VectorLine
from sketch2shape.reading.guarded_xml import MOST_ELEMENTS
from sketch2shape.reading.json_values import listed, mapped, number, points_of
from sketch2shape.reading.painted import Shape
from sketch2shape.reading.shapes import closed, ellipse, moved, rectangle, smooth, turned

MOST_PARENTS = 50
"""Groups within each other."""

#: corners of the shapes of the tool `geo` in a unit square; of regular polygons, how many corners
_CORNERS: Mapping[str, Any] = {
    "triangle": [[0.5, 0], [1, 1], [0, 1]],
    "diamond": [[0.5, 0], [1, 0.5], [0.5, 1], [0, 0.5]],
    "trapezoid": [[0.2, 0], [0.8, 0], [1, 1], [0, 1]],
    "rhombus": [[0.25, 0], [1, 0], [0.75, 1], [0, 1]],
    "rhombus-2": [[0, 0], [0.75, 0], [1, 1], [0.25, 1]],
    "pentagon": 5,
    "hexagon": 6,
    "octagon": 8,
}


def tldraw_shapes(held: Mapping[str, Any]) -> list[Shape]:
    """The shapes of the first page that has any. Raises UnreadableError."""
    records = [mapped(r, "a record") for r in listed(held.get("records"), "records", MOST_ELEMENTS)]
    shapes = {str(r.get("id")): r for r in records if r.get("typeName") == "shape"}
    pages = [str(r.get("id")) for r in sorted(records, key=_index) if r.get("typeName") == "page"]
    chains = {name: _chain(record, shapes) for name, record in shapes.items()}
    drawn: dict[str, list[tuple[tuple[str, ...], Shape]]] = {}
    for name, chain in chains.items():
        shape = _shape(shapes[name], chain)
        if shape is not None:
            order = tuple(_index(record) for record in reversed(chain))
            drawn.setdefault(str(chain[-1].get("parentId")), []).append((order, shape))
    first = next((page for page in [*pages, *drawn] if page in drawn), None)
    return [shape for _, shape in sorted(drawn.get(first or "", []), key=lambda both: both[0])]


def _index(record: Mapping[str, Any]) -> str:
    """Place among its siblings: strings that sort by their characters."""
    return str(record.get("index", ""))


def _chain(record: Mapping[str, Any], shapes: Mapping[str, Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """The shape, what it lies in, and so on up to the page."""
    chain = [record]
    while str(chain[-1].get("parentId")) in shapes:
        chain.append(shapes[str(chain[-1].get("parentId"))])
        if len(chain) > MOST_PARENTS:
            raise UnreadableError("its groups lie within each other without end", remedy="save it again")
    return chain


def _shape(record: Mapping[str, Any], chain: list[Mapping[str, Any]]) -> Shape | None:
    props = mapped(record.get("props", {}), "props")
    lines = _lines(str(record.get("type")), props)
    if not lines:
        return None
    for outer in chain:
        at = [number(outer.get("x", 0), "x"), number(outer.get("y", 0), "y")]
        angle = number(outer.get("rotation", 0), "rotation")
        lines = [moved(turned(line, angle, (0, 0)), at) for line in lines]
    ring = np.concatenate([line.points for line in lines])
    is_closed = bool(np.allclose(ring[0], ring[-1]))
    covers = is_closed and props.get("fill") in ("solid", "semi", "fill") and record.get("opacity", 1) == 1
    return Shape(
        tuple(lines),
        (ring,) if is_closed else (),
        stroke=(0, 0, 0),
        dashed=props.get("dash") in ("dashed", "dotted"),
        fill=(128, 128, 128) if covers else None,
    )


def _lines(kind: str, props: Mapping[str, Any]) -> list[VectorLine]:
    """In the shape's own coordinates; none for text, notes, pictures and arrows."""
    if kind == "draw":
        return _pulls(props)
    if kind == "line":
        points = _line_points(props)
        return [smooth(points) if props.get("spline") == "cubic" else VectorLine(points)] if len(points) else []
    if kind == "geo":
        return _geo(props)
    if kind == "arrow" and props.get("arrowheadStart", "none") == props.get("arrowheadEnd") == "none":
        ends = [mapped(props.get(end), end) for end in ("start", "end")]
        return [VectorLine(points_of(ends))] if all("x" in end for end in ends) else []
    return []


def _pulls(props: Mapping[str, Any]) -> list[VectorLine]:
    """One pull of the pen; straight segments, made with a key held down, join the free ones."""
    parts = [_segment(mapped(s, "a segment")) for s in listed(props.get("segments"), "segments")]
    parts = [part for part in parts if len(part)]
    if not parts:
        return []
    points = np.concatenate(parts) * [number(props.get(key, 1), key) for key in ("scaleX", "scaleY")]
    if props.get("isClosed") is True:
        points = np.concatenate([points, points[:1]])
    return [VectorLine(points)]


def _segment(segment: Mapping[str, Any]) -> Floats:
    packed = segment.get("path")
    return points_of(segment.get("points")) if packed is None else unpacked(packed)


def unpacked(packed: Any) -> Floats:
    """(n, 2) points of base64: x, y, pressure as 32-bit floats, then their differences as 16-bit floats."""
    try:
        data = base64.b64decode(packed, validate=True)
    except (binascii.Error, TypeError, ValueError):
        raise UnreadableError("its strokes are no base64", remedy="save it again") from None
    if len(data) < 12 or len(data) % 6:
        raise UnreadableError("its strokes are cut short", remedy="save it again")
    first = np.frombuffer(data, "<f4", 3).astype(np.float64)
    steps = np.frombuffer(data, "<f2", offset=12).astype(np.float64).reshape(-1, 3)
    return np.asarray(np.cumsum(np.concatenate([first[None], steps]), axis=0)[:, :2])


def _line_points(props: Mapping[str, Any]) -> Floats:
    """Points of the tool `line`: by their index, or as older versions have them, by handles."""
    given = props.get("points", props.get("handles"))
    if isinstance(given, list):
        return points_of(given)
    named = [mapped(p, "a point") for p in mapped(given, "points").values()]
    return points_of(sorted((p for p in named if p.get("type", "vertex") == "vertex"), key=_index))


def _geo(props: Mapping[str, Any]) -> list[VectorLine]:
    w = number(props.get("w"), "w")
    h = number(props.get("h"), "h") + number(props.get("growY", 0), "growY")
    kind = str(props.get("geo"))
    if kind in ("ellipse", "oval"):
        return [ellipse(w, h)]
    corners = _CORNERS.get(kind)
    if isinstance(corners, int):
        return [closed(_regular(corners) * [w, h])]
    if corners is not None:
        return [closed(np.array(corners, np.float64) * [w, h])]
    return rectangle(w, h) if kind in ("rectangle", "x-box", "check-box") else []


def _regular(corners: int) -> Floats:
    """A regular polygon with a corner on top, or an octagon with a side on top, stretched to a unit square."""
    start = -np.pi / 2 + (np.pi / corners if corners == 8 else 0.0)
    angles = start + 2 * np.pi * np.arange(corners) / corners
    ring = np.c_[np.cos(angles), np.sin(angles)]
    return np.asarray((ring - ring.min(axis=0)) / np.ptp(ring, axis=0))
