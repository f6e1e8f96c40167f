"""Solids that no two faces make, as textbooks draw them: sphere, shaft, bolt, bottle, stacked blocks, polyhedra."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import label

from sketch2shape.model import Floats
from synthetic.bodies import Body, Line, convex, cubes, drawn_lines, stacked
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


def seen(body: Body, size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """The body from any side; from below with its hidden lines, as it may hide all that makes it no prism."""
    view = some_view(rng)
    below = view.facts["elevation_deg"] < 0
    return drawn(drawn_lines(body, view), size, pen, hand, rng, str(rng.choice(["wire", "dashed"])) if below else "")


def _lying(body: Body, rng: np.random.Generator, share: float) -> Body:
    if rng.random() < share:
        return replace(body, vertices=body.vertices @ turn_x(np.pi / 2).T)
    return body


def stepped_shaft(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Two or three cylinders with one axis, standing or lying."""
    radii = [0.5, float(rng.uniform(0.22, 0.36))]
    if rng.random() < 0.5:
        radii.append(float(rng.choice([0.5, rng.uniform(0.1, 0.16)])))
    slabs = [
        (r * regular(SIDES), float(rng.uniform(0.35, 0.8))) for r in (radii if rng.random() < 0.7 else radii[::-1])
    ]
    return seen(_lying(stacked(slabs, [True] * len(slabs)), rng, 0.5), size, pen, hand, rng)


def bolt(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A hexagon's head on a round shank."""
    head, shank = (0.5 * regular(6, 0.3), 0.35), (float(rng.uniform(0.2, 0.32)) * regular(SIDES), 1.1)
    body = stacked([head, shank], [False, True]) if rng.random() < 0.5 else stacked([shank, head], [True, False])
    return seen(_lying(body, rng, 0.4), size, pen, hand, rng)


def stacked_blocks(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A block or a disc in the middle of a larger block, and perhaps another upon it."""
    square = regular(4, np.pi / 4) * [1, float(rng.uniform(0.7, 1.0))]
    slabs, curved = [(0.7 * square, float(rng.uniform(0.25, 0.5)))], [False]
    for part in (0.4, 0.2)[: int(rng.integers(1, 3))]:
        curved.append(bool(rng.random() < 0.4))
        slabs.append((part * (0.7 * regular(SIDES) if curved[-1] else square), float(rng.uniform(0.25, 0.6))))
    return seen(stacked(slabs, curved), size, pen, hand, rng)


def bottle(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A bottle: mouth, neck, shoulder, body, and perhaps the level of what is in it."""
    t, flat, neck = np.linspace(0, np.pi, 40), float(rng.uniform(0.15, 0.3)), float(rng.uniform(0.25, 0.4))
    arc, s = np.c_[np.cos(t), np.sin(t)] * [1, flat], np.linspace(0, 1, 30)
    top, bottom = float(rng.uniform(0.5, 0.9)), float(rng.uniform(2.2, 3.0))
    shoulder = np.c_[neck + (1 - neck) * (1 - np.cos(np.pi * s)) / 2, top + 0.6 * s]
    side = np.vstack([[neck, 0], shoulder, [1, bottom]])
    lines = [Line(side * [k, 1], False) for k in (-1, 1)]
    lines += [
        Line(neck * np.vstack([arc, -arc]), False),
        Line(arc + [0, bottom], False),
        Line(-arc + [0, bottom], True),
    ]
    if rng.random() < 0.5:
        level = [0, float(rng.uniform(top + 0.8, bottom - 0.5))]
        lines += [Line(arc + level, False), Line(-arc + level, True)]
    return drawn(lines, size, pen, hand, rng, "dashed" if rng.random() < 0.6 else "removed")


def cup(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A cup with a handle."""
    t, flat, height = np.linspace(0, np.pi, 60), float(rng.uniform(0.2, 0.35)), float(rng.uniform(1.3, 2.0))
    arc, side, foot = np.c_[np.cos(t), np.sin(t)], float(rng.choice([-1, 1])), float(rng.uniform(0.75, 1.0))
    paths = [np.vstack([arc, -arc]) * [1, flat], foot * arc * [1, flat] + [0, height]]
    paths += [np.array([[k, 0], [foot * k, height]]) for k in (-1.0, 1.0)]
    middle = np.array([side * (1 + foot) / 2, height / 2])
    paths += [middle + part * arc[:, ::-1] * [side, height / 2] for part in (0.75, 0.5)]
    return drawn([Line(path, False) for path in paths], size, pen, hand, rng, "removed")


def drawn_sphere(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A circle with the equator, its far half dashed, and perhaps a radius."""
    t, flat = np.linspace(0, np.pi, 40), float(rng.uniform(0.2, 0.4))
    rim = np.c_[np.cos(t), np.sin(t)]
    lines = [Line(np.vstack([rim, -rim]), False), Line(rim * [1, flat], False), Line(-rim * [1, flat], True)]
    if rng.random() < 0.5:
        lines.append(Line(np.array([[0, 0], [float(rng.choice([-1, 1])), 0.0]]), bool(rng.random() < 0.5)))
    return drawn(lines, size, pen, hand, rng, "dashed")


def cubes_stacked(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Cubes in stacks of different heights on a small ground, with or without the lines between them."""
    while True:
        heights = rng.integers(0, 4, (int(rng.integers(1, 4)), int(rng.integers(2, 4))))
        cells = {(x, -y, z) for (x, z), h in np.ndenumerate(heights) for y in range(h)}
        # Stairs that run all one way are a prism.
        bent = np.ptp(heights, axis=0).any() and np.ptp(heights, axis=1).any()
        if bent and len(np.unique(heights[heights > 0])) > 1 and label(heights > 0)[1] == 1:
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
    return seen(convex(points), size, pen, hand, rng)


OTHER_SOLIDS: dict[str, Negative] = {
    "drawn_sphere": drawn_sphere,
    "stepped_shaft": stepped_shaft,
    "bolt": bolt,
    "stacked_blocks": stacked_blocks,
    "bottle": bottle,
    "cup": cup,
    "cubes": cubes_stacked,
    "polyhedron": polyhedron,
}
