"""Dimensions as drawings show them: lines with arrows, chains of them, diameters and radii (after ISO 129)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from sketch2shape.model import Floats
from sketch2shape.sheets import Item, Label, Stroke, text_width

#: layer that all of this is on
LAYER = "dimensions"

#: length and half the width of arrows, height of the numbers, gap between number and line, millimetres
_ARROW, _HALF, HEIGHT, _LIFT = 2.6, 0.45, 2.6, 0.9

#: extension lines begin so far from the object and end so far beyond the dimension line, millimetres
_GAP, _BEYOND = 0.8, 1.2

#: numbers that do not fit between their arrows stand so much higher in turn, millimetres
_STEP = 3.4

#: distance of the first dimension line from the object, and of the next one from it, millimetres
FIRST, NEXT = 8.0, 7.5

#: lengths of the slanted and the level part of a leader, millimetres
_LEADER, _SHELF = 6.0, 3.0


def chain(at: Sequence[float], texts: Sequence[str], line: float, start: float, *, level: bool) -> Iterator[Item]:
    """Dimensions side by side.

    at    : where they begin and end, in order; x if level, else y (downward)
    texts : one for each
    line  : y (or x) of the dimension line
    start : y (or x) of the object, from where extension lines come
    """
    way = 1.0 if line > start else -1.0
    for place in at:
        yield Stroke(LAYER, _points([(place, start + way * _GAP), (place, line + way * _BEYOND)], level))
    raised = 0
    for a, b, text in zip(at, at[1:], texts, strict=False):
        width, length = text_width(text, HEIGHT), abs(b - a)
        inside = length > 2 * _ARROW + 1.0
        yield Stroke(LAYER, _points([(a, line), (b, line)], level))
        for tip, other in ((a, b), (b, a)):
            away = math.copysign(1.0, other - tip) * (1.0 if inside else -1.0)
            yield _arrow(_points([(tip, line)], level)[0], _points([(away, 0.0)], level)[0])
        raised = 0 if width < length - 0.6 else raised % 2 + 1
        lift = _LIFT + _STEP * raised
        middle = _points([((a + b) / 2, line - lift)], level)[0]
        yield Label(LAYER, text, middle, HEIGHT, "middle", 0.0 if level else 90.0)


def around(center: Floats, radius: float, angle: float, text: str, beyond: float = 0.0) -> Iterator[Item]:
    """The diameter or radius of a circle: a leader with an arrow at it, and the number.

    angle  : where the arrow points to the circle, radians anticlockwise from the right
    beyond : how far from it larger circles about the same centre end
    """
    out = np.array([math.cos(angle), -math.sin(angle)])
    tip = center + radius * out
    knee = tip + (beyond + _LEADER) * out
    side = 1.0 if out[0] >= -1e-9 else -1.0
    yield Stroke(LAYER, np.array([tip, knee, knee + [side * _SHELF, 0.0]]))
    yield _arrow(tip, out)
    where = knee + [side * (_SHELF + 0.8), HEIGHT / 2]
    yield Label(LAYER, text, where, HEIGHT, "start" if side > 0 else "end")


def _points(places: Sequence[tuple[float, float]], level: bool) -> Floats:
    """Points from coordinates along and across a dimension line."""
    points = np.array(places)
    return points if level else points[:, ::-1]


def _arrow(tip: Floats, back: Floats) -> Stroke:
    """An arrow head; `back` is the direction from its tip to its foot."""
    foot, side = tip + _ARROW * back, _HALF * np.array([-back[1], back[0]])
    return Stroke(LAYER, np.array([tip, foot + side, foot - side]), closed=True, filled=True)
