"""Dimensions: lines along edges of the object, outside or inside, with extension lines from its vertices."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats
from synthetic.arrows import head_paths
from synthetic.layers import Drawn, Layer, across, area, some_colour, unit
from synthetic.lettering import height_of, readable, written
from synthetic.pens import Coverage

UNITS = ("", "", "", " cm", " mm", " m", "x", '"')


def dimensioned(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """One to four dimensions in one style: arrows, ticks or dots; extension lines that touch or stop short."""
    edges = drawn.drawn_edges()
    order = rng.permutation(len(edges))[: int(rng.integers(1, 5))]
    ends = str(rng.choice(["open", "filled", "ticks", "dots"]))
    gap = float(rng.choice([0.0, rng.uniform(1.0, 3.0)])) * drawn.pen.width
    height, suffix, colour = height_of(drawn, rng), str(rng.choice(UNITS)), some_colour(rng, 0.7)
    ink = np.zeros(drawn.size[::-1], np.float32)
    for k in order:
        a, b = edges[int(k)]
        number = f"{int(rng.integers(2, 250))}{suffix}"
        ink = np.maximum(ink, _dimension(drawn, (drawn.points[a], drawn.points[b]), ends, gap, number, height, rng))
    return [Layer(ink, colour)]


def _dimension(
    drawn: Drawn,
    edge: tuple[Floats, Floats],
    ends: str,
    gap: float,
    number: str,
    height: float,
    rng: np.random.Generator,
) -> Coverage:
    """One dimension of an edge, moved off it outwards (seldom inwards), at a right angle or askew."""
    p, q = edge
    along = unit(q - p)
    off = across(along)
    off = off if off @ ((p + q) / 2 - drawn.centre) > 0 else -off
    off = unit(off + along * float(rng.choice([0.0, 0.0, rng.uniform(-0.6, 0.6)])))
    away = float(rng.uniform(0.05, 0.13)) * drawn.diagonal * (1 if rng.random() < 0.85 else -1)
    u, v = p + away * off, q + away * off
    reach = away + np.copysign(0.4 * height, away)
    paths = [np.array([e + np.copysign(gap, away) * off, e + reach * off]) for e in (p, q)]
    head = max(0.7 * height, 3.0 * drawn.pen.width)
    middle, room = (u + v) / 2, (0.45 * len(number) + 0.4) * height
    broken = rng.random() < 0.5 and np.linalg.norm(v - u) > 2 * room + 2 * head
    paths += (
        [np.array([u, middle - room * along]), np.array([middle + room * along, v])] if broken else [np.array([u, v])]
    )
    filled: list[Floats] = []
    for end, inward in ((u, along), (v, -along)):
        if ends in ("open", "filled"):
            (paths if ends == "open" else filled).append(head_paths(end, inward, head, 0.3))
        elif ends == "ticks":
            paths.append(np.array([end - 0.4 * head * (off + along), end + 0.4 * head * (off + along)]))
        else:
            turn = np.linspace(0, 2 * np.pi, 20)
            filled.append(end + 0.2 * head * np.c_[np.cos(turn), np.sin(turn)])
    ink = np.maximum(drawn.ink(paths, drawn.fine_pen(rng), rng), area(filled, drawn.size))
    at = middle if broken else middle + np.copysign(0.9 * height, away) * off
    angle = readable(along) if rng.random() < 0.5 else 0.0
    return np.maximum(ink, written(number, at, height, drawn.size, rng, angle))
