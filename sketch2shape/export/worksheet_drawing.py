"""A solid as it was drawn, visible and hidden lines, with the lengths of its edges beside them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from sketch2shape.export.parameters import Rounding
from sketch2shape.model import Brief, Floats, Solid
from sketch2shape.sheets import Item, Label, Layer, Stroke, text_width
from sketch2shape.solids import DrawnLine, lines_seen, smooth_edges

LAYERS = (
    Layer("visible", "#000000", 0.5),
    Layer("hidden", "#000000", 0.3, (2.2, 1.4)),
    Layer("dimensions", "#0057b8", 0.18),
)

#: height of the lengths, and their distance from the edge, millimetres
_HEIGHT, _OFF = 3.0, 1.6

#: lengths beside the drawing take so much of its box on each side, millimetres
_BORDER = 12.0

#: most lengths that are written
_MOST = 14

#: right, up and away of a solid that does not tell its own
_UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])

#: across and up of what lies a unit away, in a cabinet drawing
_CABINET = 0.5 * np.sqrt(0.5)


@dataclass(frozen=True, eq=False, repr=False)
class _Told(Brief):
    """A length that may be written.

    text  : what is written
    where : (2,) beside which point, on the sheet
    along : (2,) direction of the edge there
    seen  : is the edge in view?
    """

    text: str
    where: Floats
    along: Floats
    seen: bool


def drawing_items(solid: Solid, box: Floats) -> Iterator[Item]:
    """The drawing within a box (2, 2) of the sheet, its upper left and lower right corner."""
    lines = lines_seen(solid, _camera(solid))
    points = np.concatenate([line.points for line in lines])
    room = box[1] - box[0] - 2 * _BORDER
    scale = float((room / np.maximum(np.ptp(points, axis=0), 1e-9)).min())
    shift = (box[0] + box[1]) / 2 - scale * (points.min(axis=0) + points.max(axis=0)) / 2
    placed = [DrawnLine(scale * line.points + shift, line.visible, line.edge) for line in lines]
    for line in placed:
        yield Stroke("visible" if line.visible else "hidden", line.points)
    yield from _lengths(solid, placed)


def _camera(solid: Solid) -> Floats:
    """The camera that the solid was drawn with, or that of a cabinet drawing."""
    if solid.camera is not None:
        return solid.camera
    right, up, away = _UPRIGHT if solid.axes is None else solid.axes
    camera = np.zeros((3, 4))
    camera[0, :3], camera[1, :3], camera[2, 3] = right + _CABINET * away, -(up + _CABINET * away), 1.0
    return camera


def _lengths(solid: Solid, lines: list[DrawnLine]) -> Iterator[Item]:
    """Each length of each direction once, where it does not cover another."""
    groups: dict[tuple[object, ...], list[_Told]] = {}
    for key, told in _candidates(solid, lines):
        groups.setdefault(key, []).append(told)
    middle = np.concatenate([line.points for line in lines]).mean(axis=0)
    drawn = shapely.MultiLineString([line.points for line in lines])
    taken: list[shapely.Geometry] = []
    for group in list(groups.values())[:_MOST]:
        places = [
            (not told.seen, box.intersects(drawn), -float(np.linalg.norm(told.where - middle)), k, label, box)
            for k, told in enumerate(group)
            for label, box in _places(told, middle)
        ]
        for *_, label, box in sorted(places, key=lambda place: place[:4]):
            if not any(box.intersects(other) for other in taken):
                taken.append(box)
                yield label
                break


def _candidates(solid: Solid, lines: list[DrawnLine]) -> Iterator[tuple[tuple[object, ...], _Told]]:
    """Lengths of edges, grouped by direction and length; diameters and radii of curves."""
    number = Rounding(max(solid.dimensions), 1)
    smooth = smooth_edges(solid.boundary)
    best: dict[int, DrawnLine] = {}
    for line in lines:
        known = best.get(-1 if line.edge is None else line.edge)
        if line.edge is not None and (known is None or (line.visible, _extent(line)) > (known.visible, _extent(known))):
            best[line.edge] = line
    for k, line in sorted(best.items()):
        edge, arc = solid.edges[k], solid.boundary.arc(solid.edges[k])
        half = len(line.points) // 2
        at, along = line.points[half], line.points[half] - line.points[half - 1]
        if arc is None and k not in smooth and edge.start is not None and edge.end is not None:
            vector = solid.vertices[edge.end] - solid.vertices[edge.start]
            length = float(np.linalg.norm(vector))
            text, at = number(length), line.points.mean(axis=0)
            if text == "0":
                continue
            vector = vector / length
            first = np.round(vector, 3) * (np.sign(vector[np.abs(vector).argmax()]) or 1.0) + 0.0
            yield (text, *first.tolist()), _Told(text, at, along, line.visible)
        elif arc is not None:
            whole = edge.start is None
            text = f"Ø {number(2 * arc.circle.radius)}" if whole else f"r {number(arc.circle.radius)}"
            yield (text,), _Told(text, at, along, line.visible)


def _extent(line: DrawnLine) -> float:
    return float(np.ptp(line.points, axis=0).max())


def _places(told: _Told, middle: Floats) -> Iterator[tuple[Label, shapely.Geometry]]:
    """Where the length may stand: on the outer side of its edge, or on the inner one."""
    across = np.array([-told.along[1], told.along[0]])
    across = across / (np.linalg.norm(across) or 1.0)
    outward = across if (told.where - middle) @ across >= 0 else -across
    width = text_width(told.text, _HEIGHT)
    for side in (outward, -outward):
        center = told.where + side * (_OFF + abs(side[0]) * width / 2 + abs(side[1]) * _HEIGHT / 2)
        box = shapely.box(*(center - [width / 2, _HEIGHT / 2]), *(center + [width / 2, _HEIGHT / 2]))
        yield Label("dimensions", told.text, center + [0.0, _HEIGHT / 2], _HEIGHT, "middle"), box
