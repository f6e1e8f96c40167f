"""Lines of the exercise, not of the object: diagonals, sections, heights, midlines, axes; dots; edges that run on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.model import Floats
from synthetic.layers import Drawn, Layer, area, some_colour, unit
from synthetic.lettering import height_of, written


def auxiliary(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """One to three figures of auxiliary lines between points of the object, dashed or solid, with dots and letters."""
    layers: list[Layer] = []
    for name in rng.choice(list(FIGURES), int(rng.integers(1, 4)), replace=False):
        paths, extra = FIGURES[str(name)](drawn, rng)
        pen = drawn.fine_pen(rng)
        dashed = name == "axis" or bool(rng.random() < 0.5)
        if dashed:
            pen = replace(pen, dash=(float(rng.uniform(0.9, 1.9)), float(rng.uniform(0.6, 1.1))))
        colour = some_colour(rng, 0.75)
        if name == "section" and rng.random() < 0.4:
            tint = colour or (120, 190, 230)
            layers.append(Layer(np.asarray(0.35 * area([paths[0]], drawn.size), np.float32), tint, under=True))
        layers.append(Layer(drawn.ink(paths, pen, rng, dashed), colour))
        if rng.random() < 0.5:
            layers += _named_points(extra, drawn, rng)
    return layers


def _named_points(points: list[Floats], drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    height, out = height_of(drawn, rng), np.zeros(drawn.size[::-1], np.float32)
    turn = np.linspace(0, 2 * np.pi, 20)
    for k, p in enumerate(points):
        out = np.maximum(out, area([p + 1.3 * drawn.pen.width * np.c_[np.cos(turn), np.sin(turn)]], drawn.size))
        at = p + drawn.outward(p, rng, 1.0) * height
        out = np.maximum(out, written("MNEFPQ"[k % 6], at, height, drawn.size, rng))
    return [Layer(out)]


def _rings(drawn: Drawn) -> tuple[Floats, Floats]:
    n, half = drawn.scene.sizes[0], drawn.scene.half
    return drawn.points[:n], drawn.points[half : half + n]


def _on_edge(drawn: Drawn, rng: np.random.Generator) -> Floats:
    """A point of an edge that is drawn: the middle, or anywhere."""
    edges = drawn.drawn_edges()
    a, b = edges[int(rng.integers(len(edges)))]
    t = 0.5 if rng.random() < 0.6 else float(rng.uniform(0.2, 0.8))
    point: Floats = drawn.points[a] + t * (drawn.points[b] - drawn.points[a])
    return point


def _diagonals(drawn: Drawn, rng: np.random.Generator) -> tuple[list[Floats], list[Floats]]:
    """Diagonals of a face or of the body."""
    f1, f2 = _rings(drawn)
    n, paths = len(f1), []
    for _ in range(int(rng.integers(1, 4))):
        i = int(rng.integers(n))
        ends = [f1[i], f2[(i + 1) % n], f1[(i + n // 2) % n], f2[(i + n // 2) % n]]
        paths.append(np.array([ends[0], ends[int(rng.integers(1, 4)) if n > 3 else int(rng.choice([1, 3]))]]))
    return paths, []


def _section(drawn: Drawn, rng: np.random.Generator) -> tuple[list[Floats], list[Floats]]:
    """A closed cut: across all connecting edges, or a triangle through points of the object."""
    f1, f2 = _rings(drawn)
    if rng.random() < 0.4 and len(f1) <= 6:
        t = np.full((len(f1), 1), rng.uniform(0.25, 0.75))
        ring = f1 + t * (f2 - f1)
    else:
        corner = drawn.points[int(rng.integers(len(drawn.points)))]
        ring = np.array([corner, _on_edge(drawn, rng), _on_edge(drawn, rng)])
    return [np.vstack([ring, ring[:1]])], list(ring[1:3])


def _height(drawn: Drawn, rng: np.random.Generator) -> tuple[list[Floats], list[Floats]]:
    """A line from a vertex of the front face to the opposite edge, with the square of a right angle."""
    f1, _ = _rings(drawn)
    n, i = len(f1), int(rng.integers(len(f1)))
    a, b = f1[(i + n // 2) % n], f1[(i + n // 2 + 1) % n]
    along = unit(b - a)
    foot = a + np.clip((f1[i] - a) @ along, 0.15 * np.linalg.norm(b - a), 0.85 * np.linalg.norm(b - a)) * along
    up, s = unit(f1[i] - foot), 0.035 * drawn.diagonal
    square = np.array([foot + s * along, foot + s * (along + up), foot + s * up])
    return [np.array([f1[i], foot]), square], [foot]


def _midlines(drawn: Drawn, rng: np.random.Generator) -> tuple[list[Floats], list[Floats]]:
    """One to three lines between points of edges and vertices, some from one point."""
    hub = _on_edge(drawn, rng)
    paths = []
    for _ in range(int(rng.integers(1, 4))):
        other = _on_edge(drawn, rng) if rng.random() < 0.5 else drawn.points[int(rng.integers(len(drawn.points)))]
        paths.append(np.array([hub, other]))
    return paths, [hub]


def _axis(drawn: Drawn, rng: np.random.Generator) -> tuple[list[Floats], list[Floats]]:
    """The line through the middles of both faces, running on beyond them, or the centre lines of the front face."""
    f1, f2 = _rings(drawn)
    p, q = f1.mean(0), f2.mean(0)
    if rng.random() < 0.6:
        return [np.array([p - 0.3 * (q - p), q + 0.3 * (q - p)])], []
    i, n = int(rng.integers(len(f1))), len(f1)
    m = (f1[i] + f1[(i + 1) % n]) / 2
    return [np.array([m + 0.15 * (m - p), p - 1.2 * (m - p)])], []


FIGURES = {
    "diagonals": _diagonals,
    "section": _section,
    "height": _height,
    "midlines": _midlines,
    "axis": _axis,
}


def vertex_dots(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """Dots, rings, crosses or squares on all vertices or some, seldom on middles of edges as well."""
    kind = str(rng.choice(["dot", "dot", "ring", "cross", "square"]))
    share, colour = float(rng.choice([1.0, 0.6])), some_colour(rng, 0.7)
    radius = max(float(rng.uniform(1.2, 3.2)) * drawn.pen.width, 2.5)
    at = [p for p in drawn.points if rng.random() < share]
    if rng.random() < 0.25:
        at += [_on_edge(drawn, rng) for _ in range(3)]
    turn = np.linspace(0, 2 * np.pi, 28)
    disc = radius * np.c_[np.cos(turn), np.sin(turn)]
    box = radius * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1.0]])
    if kind == "cross":
        arms = radius * 1.3 * np.array([[-1, -1], [1, 1.0]])
        paths = [p + arms * flip for p in at for flip in ([1, 1], [1, -1])]
        return [Layer(drawn.ink(paths, drawn.fine_pen(rng), rng), colour)]
    if kind == "ring":
        hollow = Layer(area([p + disc for p in at], drawn.size), drawn.ground)
        return [hollow, Layer(drawn.ink([p + disc for p in at], drawn.fine_pen(rng), rng), colour)]
    return [Layer(area([p + (box if kind == "square" else disc) for p in at], drawn.size), colour)]


def run_on(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """Construction lines: edges that run on beyond their corners, faint or as dark as the object."""
    faint = float(rng.choice([1.0, rng.uniform(0.2, 0.6)]))
    share, far = float(rng.uniform(0.4, 1.0)), float(rng.choice([0.12, 0.3, 1.5]))
    paths = []
    for a, b in drawn.drawn_edges():
        if rng.random() < share:
            p, q = drawn.points[a], drawn.points[b]
            beyond = rng.uniform(0.4, 1.0, 2) * min(far * float(np.linalg.norm(q - p)), 0.3 * drawn.diagonal)
            paths.append(np.array([p - beyond[0] * unit(q - p), q + beyond[1] * unit(q - p)]))
    if not paths:
        return []
    ink = drawn.ink(paths, replace(drawn.fine_pen(rng), uneven=0.0), rng)
    return [Layer(np.asarray(faint * ink, np.float32), under=True)]
