"""Solids that are no prisms, as textbooks draw them: cylinder, cone, sphere, pyramid, stacked cubes, polyhedra."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.model import Floats
from synthetic.bodies import Body, Line, convex, cubes, drawn_lines, turned
from synthetic.hand import Hand, Stroke, wandering
from synthetic.negatives import Negative, Sheet
from synthetic.pens import Coverage, Pen, coverage
from synthetic.profiles import regular
from synthetic.projecting import View, axonometric, turn_x

SIDES = 64
"""Flat faces that stand for a round one."""


def drawn(lines: list[Line], size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator, style: str = "") -> Coverage:
    """The lines fitted into the sheet; hidden ones solid, dashed or not at all ("wire", "dashed", "removed")."""
    style = style or str(rng.choice(["wire", "dashed", "dashed", "removed"]))
    points = np.vstack([line.path for line in lines])
    low, high = points.min(0), points.max(0)
    scale = float((np.array(size) * rng.uniform(0.5, 0.75) / (high - low)).min())
    room = (np.array(size) - scale * (high - low)) / 2
    shift = np.array(size) / 2 - scale * (low + high) / 2 + rng.uniform(-0.5, 0.5, 2) * room
    strokes = [
        Stroke(wandering(scale * line.path + shift, hand, rng), line.hidden and style == "dashed")
        for line in lines
        if not line.hidden or style != "removed"
    ]
    return coverage(strokes, replace(pen, dash=pen.dash or (1.6, 1.1)), size, rng)


def some_view(rng: np.random.Generator) -> View:
    """A parallel view, from above as a rule."""
    elevation = float(np.radians(rng.uniform(14, 42))) * (-1 if rng.random() < 0.12 else 1)
    return axonometric("trimetric", float(np.radians(rng.uniform(15, 75))) * float(rng.choice([-1, 1])), elevation)


def _lying(body: Body, rng: np.random.Generator, share: float) -> Body:
    if rng.random() < share:
        return replace(body, vertices=body.vertices @ turn_x(np.pi / 2).T)
    return body


def drawn_cylinder(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A cylinder, standing or lying."""
    body = _lying(turned((0.5, 0.5), float(rng.uniform(0.6, 1.8)), SIDES), rng, 0.3)
    return drawn(drawn_lines(body, some_view(rng)), size, pen, hand, rng)


def drawn_cone(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A cone or a truncated cone."""
    top = float(rng.choice([0.0, rng.uniform(0.15, 0.4)]))
    return drawn(
        drawn_lines(turned((0.5, top), float(rng.uniform(0.8, 1.6)), SIDES), some_view(rng)), size, pen, hand, rng
    )


def drawn_sphere(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A circle with the equator, its far half dashed, and perhaps a radius."""
    t, flat = np.linspace(0, np.pi, 40), float(rng.uniform(0.2, 0.4))
    rim = np.c_[np.cos(t), np.sin(t)]
    lines = [Line(np.vstack([rim, -rim]), False), Line(rim * [1, flat], False), Line(-rim * [1, flat], True)]
    if rng.random() < 0.5:
        lines.append(Line(np.array([[0, 0], [float(rng.choice([-1, 1])), 0.0]]), bool(rng.random() < 0.5)))
    return drawn(lines, size, pen, hand, rng, "dashed")


def drawn_pyramid(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A pyramid or a truncated one whose faces are no match, with or without its height."""
    n = int(rng.integers(3, 7))
    base = np.insert(0.6 * regular(n, rng.uniform(0, 6)) * [1, rng.uniform(0.7, 1)], 1, 0.4, axis=1)
    apex = np.array([[*rng.uniform(-0.15, 0.15, 1), -rng.uniform(0.4, 0.9), 0.0]])
    view = some_view(rng)
    lines = drawn_lines(convex(np.vstack([base, apex])), view)
    if rng.random() < 0.4:
        foot = np.array([[apex[0, 0], 0.4, apex[0, 2]]])
        lines.append(Line(view(np.vstack([apex, foot]))[:, :2], True))
    return drawn(lines, size, pen, hand, rng)


def cubes_stacked(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Cubes in stacks of different heights on a small ground, with or without the lines between them."""
    while True:
        heights = rng.integers(0, 4, (int(rng.integers(1, 4)), int(rng.integers(2, 4))))
        cells = {(x, -y, z) for (x, z), h in np.ndenumerate(heights) for y in range(h)}
        if len(cells) > 2 and len(np.unique(heights[heights > 0])) > 1:
            break
    body = cubes(cells, ruled=bool(rng.random() < 0.6))
    view = axonometric(
        "isometric",
        float(rng.choice([-1, 1])) * np.radians(rng.uniform(30, 60)),
        float(np.radians(rng.uniform(22, 40))),
    )
    return drawn(drawn_lines(body, view), size, pen, hand, rng, "removed")


def polyhedron(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A box with a corner cut off, a hipped roof, an octahedron, an antiprism, a few random corners."""
    box = np.array([[x, y, z] for x in (-0.6, 0.6) for y in (-0.4, 0.4) for z in (-0.5, 0.5)])
    kind = str(rng.choice(["cut", "roof", "octahedron", "antiprism", "random"]))
    if kind == "cut":
        corner, (a, b, c) = box[0], rng.uniform(0.3, 0.75, 3)
        points: Floats = np.vstack([box[1:], corner + [1.2 * a, 0, 0], corner + [0, 0.8 * b, 0], corner + [0, 0, c]])
    elif kind == "roof":
        ridge = rng.uniform(0.1, 0.45)
        points = np.vstack([box, [[-ridge, -0.85, 0.0], [ridge, -0.85, 0.0]]])
    elif kind == "octahedron":
        points = np.vstack([np.eye(3), -np.eye(3)]) * [0.5, rng.uniform(0.5, 0.9), 0.5]
    elif kind == "antiprism":
        n = int(rng.integers(3, 6))
        points = np.vstack([np.insert(0.5 * regular(n, k * np.pi / n), 1, (k - 0.5) * 0.8, axis=1) for k in (0, 1)])
    else:
        points = rng.normal(0, 1, (int(rng.integers(6, 9)), 3))
        points = points / np.linalg.norm(points, axis=1)[:, None] * [0.6, 0.5, 0.6]
    return drawn(drawn_lines(convex(points), some_view(rng)), size, pen, hand, rng)


OTHER_SOLIDS: dict[str, Negative] = {
    "drawn_cylinder": drawn_cylinder,
    "drawn_cone": drawn_cone,
    "drawn_sphere": drawn_sphere,
    "drawn_pyramid": drawn_pyramid,
    "cubes": cubes_stacked,
    "polyhedron": polyhedron,
}
