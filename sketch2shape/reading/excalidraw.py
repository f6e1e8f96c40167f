"""Lines of an Excalidraw file (.excalidraw): JSON, elements in the order they are painted.

https://docs.excalidraw.com/docs/codebase/json-schema. An element has x, y, width, height, an angle about its middle and
a stroke style; lines and strokes of the pen have points relative to x, y. The sketchy look is made on the screen: the
file has the exact shapes.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from sketch2shape.model import VectorLine
from sketch2shape.reading.guarded_xml import MOST_ELEMENTS
from sketch2shape.reading.json_values import listed, mapped, number, points_of
from sketch2shape.reading.painted import Shape
from sketch2shape.reading.shapes import closed, ellipse, moved, rectangle, smooth, turned

RADIUS, ROUNDED = 32.0, 0.25
"""Radius of round corners, pixels, and as a part of the shorter side where that is less."""


def excalidraw_shapes(held: Mapping[str, Any]) -> list[Shape]:
    """The shapes of a file. Raises UnreadableError."""
    shapes = []
    for given in listed(held.get("elements"), "elements", MOST_ELEMENTS):
        element = mapped(given, "an element")
        lines = [] if element.get("isDeleted") is True else _lines(element)
        if lines:
            shapes.append(_shape(element, lines))
    return shapes


def _lines(element: Mapping[str, Any]) -> list[VectorLine]:
    """In the drawing's coordinates; none for text, pictures, frames and arrows."""
    kind = element.get("type")
    if kind in ("line", "freedraw") or (kind == "arrow" and _has_no_head(element)):
        lines = [_polyline(element)]
    elif kind in ("rectangle", "diamond", "ellipse"):
        lines = _box(str(kind), element)
    else:
        return []
    lines = [line for line in lines if len(line.points)]
    if not lines:
        return []
    points = np.concatenate([line.points for line in lines])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    at = [number(element.get("x"), "x"), number(element.get("y"), "y")]
    angle = number(element.get("angle", 0), "angle")
    return [moved(turned(line, angle, middle), at) for line in lines]


def _has_no_head(element: Mapping[str, Any]) -> bool:
    return element.get("startArrowhead") is None and element.get("endArrowhead") is None


def _polyline(element: Mapping[str, Any]) -> VectorLine:
    points = points_of(element.get("points"))
    is_smooth = element.get("type") != "freedraw" and element.get("roundness") is not None
    return smooth(points) if is_smooth else VectorLine(points)


def _box(kind: str, element: Mapping[str, Any]) -> list[VectorLine]:
    w, h = number(element.get("width"), "width"), number(element.get("height"), "height")
    if kind == "ellipse":
        return [ellipse(w, h)]
    if kind == "diamond":
        return [closed([[w / 2, 0], [w, h / 2], [w / 2, h], [0, h / 2]])]
    is_round = element.get("roundness") is not None
    return rectangle(w, h, min(RADIUS, ROUNDED * min(abs(w), abs(h))) if is_round else 0.0)


def _shape(element: Mapping[str, Any], lines: list[VectorLine]) -> Shape:
    visible = element.get("strokeColor", "#1e1e1e") != "transparent"
    style = element.get("strokeStyle", "solid")
    filled = element.get("backgroundColor", "transparent") != "transparent" and element.get("fillStyle") == "solid"
    ring = np.concatenate([line.points for line in lines])
    is_closed = bool(np.allclose(ring[0], ring[-1]))
    opaque = number(element.get("opacity", 100), "opacity") >= 95
    return Shape(
        tuple(lines),
        (ring,) if is_closed else (),
        stroke=(0, 0, 0) if visible else None,
        dashed=style in ("dashed", "dotted"),
        fill=(128, 128, 128) if filled and opaque and is_closed else None,
    )
