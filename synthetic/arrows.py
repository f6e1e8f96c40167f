"""Arrows and leaders that touch the object or enter it."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats
from synthetic.layers import Drawn, Layer, across, area, some_colour, unit
from synthetic.lettering import height_of, written

TAILS = ("front", "F", "view", "A", "push", "1", "load", "here", "10 N", "top")


def arrows(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """One to three arrows from outside: open, filled or block ones, some with a word at the tail."""
    colour, layers = some_colour(rng), []
    kind = str(rng.choice(["open", "filled", "block"]))
    for _ in range(int(rng.integers(1, 4))):
        tip, outside = target(drawn, rng)
        length = float(rng.uniform(0.14, 0.34)) * drawn.diagonal
        head = max(float(rng.uniform(0.025, 0.06)) * drawn.diagonal, 3.5 * drawn.pen.width)
        tip = tip - outside * rng.choice([-1.0, 0.0, 1.0]) * rng.uniform(0, 1) * head
        tail = tip + outside * (length + head)
        layers += _block(tip, tail, head, colour, drawn, rng) if kind == "block" else []
        if kind != "block":
            layers.append(Layer(arrow_ink(tip, tail, head, kind, drawn, rng), colour))
        if rng.random() < 0.55:
            height = height_of(drawn, rng)
            at = tail + outside * height * 1.1
            layers.append(Layer(written(str(rng.choice(TAILS)), at, height, drawn.size, rng), colour))
    return layers


def target(drawn: Drawn, rng: np.random.Generator) -> tuple[Floats, Floats]:
    """Where an arrow points, on an edge, at a vertex or into a face, and the direction it comes from."""
    where = str(rng.choice(["edge", "edge", "vertex", "face"]))
    if where == "vertex":
        point = drawn.points[int(rng.integers(len(drawn.points)))]
    elif where == "edge":
        edges = drawn.drawn_edges()
        a, b = edges[int(rng.integers(len(edges)))]
        point = drawn.points[a] + rng.uniform(0.15, 0.85) * (drawn.points[b] - drawn.points[a])
    else:
        ring = drawn.points[: drawn.scene.sizes[0]]
        i = int(rng.integers(len(ring)))
        point = ring[i] + rng.uniform(0.2, 0.45) * (ring.mean(0) - ring[i])
    return point, drawn.outward(point, rng, 0.9)


def head_paths(tip: Floats, away: Floats, head: float, narrow: float = 0.38) -> Floats:
    """(3, 2) barbs and tip of an arrow head; `away` points from the tip along the shaft."""
    side = narrow * head * across(away)
    barbs: Floats = np.array([tip + head * away + side, tip, tip + head * away - side])
    return barbs


def arrow_ink(
    tip: Floats, tail: Floats, head: float, kind: str, drawn: Drawn, rng: np.random.Generator
) -> np.ndarray[tuple[int, ...], np.dtype[np.float32]]:
    """A line with an open or a filled head."""
    away = unit(tail - tip)
    barbs = head_paths(tip, away, head, float(rng.uniform(0.25, 0.5)))
    pen = drawn.fine_pen(rng)
    if kind == "open":
        return drawn.ink([np.array([tail, tip]), barbs], pen, rng)
    shaft = drawn.ink([np.array([tail, tip + 0.8 * head * away])], pen, rng)
    return np.maximum(shaft, area([barbs], drawn.size))


def _block(
    tip: Floats, tail: Floats, head: float, colour: tuple[int, int, int] | None, drawn: Drawn, rng: np.random.Generator
) -> list[Layer]:
    """A broad arrow: its outline, hollow, white or filled."""
    away, broad = unit(tail - tip), 1.6 * head
    neck, side = tip + broad * away, across(away)
    half = float(rng.uniform(0.2, 0.3)) * broad
    wide = half * float(rng.uniform(1.8, 2.4))
    ring = np.array(
        [tail + half * side, neck + half * side, neck + wide * side, tip]
        + [neck - wide * side, neck - half * side, tail - half * side]
    )
    closed = ring if rng.random() < 0.2 else np.vstack([ring, ring[:1]])
    layers = []
    inside = str(rng.choice(["hollow", "white", "filled"]))
    if inside == "white":
        layers.append(Layer(area([ring], drawn.size), drawn.ground))
    if inside == "filled":
        layers.append(Layer(area([ring], drawn.size), colour or (90, 90, 90)))
    return [*layers, Layer(drawn.ink([closed], drawn.fine_pen(rng), rng), colour)]


def callouts(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """Numbers or words with a bent or curved line that ends on an edge or inside a face, in a dot or an arrow."""
    colour, layers = some_colour(rng, 0.8), []
    ending = str(rng.choice(["none", "dot", "open", "filled"]))
    for _ in range(int(rng.integers(2, 5))):
        tip, outside = target(drawn, rng)
        far = tip + outside * float(rng.uniform(0.16, 0.32)) * drawn.diagonal
        height = height_of(drawn, rng)
        shelf = far + np.array([np.copysign(1.5 * height, outside[0]), 0.0])
        if rng.random() < 0.5:
            path = np.array([tip, far, shelf])
            at = shelf + np.array([np.copysign(1.3 * height, outside[0]), 0.0])
        else:
            bend = (tip + far) / 2 + across(outside) * rng.uniform(-0.3, 0.3) * np.linalg.norm(far - tip)
            t = np.linspace(0, 1, 14)[:, None]
            path = (1 - t) ** 2 * tip + 2 * t * (1 - t) * bend + t**2 * far
            at = far + outside * height
        ink = drawn.ink([path], drawn.fine_pen(rng), rng)
        head = max(0.6 * height, 3 * drawn.pen.width)
        if ending == "dot":
            turn = np.linspace(0, 2 * np.pi, 24)
            ink = np.maximum(ink, area([tip + 0.25 * head * np.c_[np.cos(turn), np.sin(turn)]], drawn.size))
        elif ending != "none":
            ink = np.maximum(ink, arrow_ink(tip, path[1], head, ending, drawn, rng))
        words = str(rng.integers(1, 140)) if rng.random() < 0.7 else str(rng.choice(TAILS))
        layers.append(Layer(np.maximum(ink, written(words, at, height, drawn.size, rng)), colour))
    return layers
