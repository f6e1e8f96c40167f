"""A second drawing beside the object, that is none: axes, a flat figure, a table, a curve, a circle, lines of text."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sketch2shape.model import Floats
from synthetic.arrows import arrow_ink
from synthetic.layers import Drawn, Layer, some_colour
from synthetic.lettering import written
from synthetic.pens import Coverage
from synthetic.profiles import profile

Box = tuple[Floats, Floats]
"""(2,) middle of the free place and (2,) half its width and height, pixels."""


def beside(drawn: Drawn, rng: np.random.Generator) -> list[Layer]:
    """One of `FIGURES` at the side with the most room, now and then two."""
    places = _free(drawn)
    names = rng.permutation(list(FIGURES))[: 1 if rng.random() < 0.7 else 2]
    layers = []
    for (middle, half), name in zip(places, names, strict=False):
        reach = min(float(half.min()), 0.3 * drawn.diagonal) * float(rng.uniform(0.55, 0.85))
        shift = rng.uniform(-0.5, 0.5, 2) * np.maximum(half - reach, 0)
        layers.append(Layer(FIGURES[str(name)](drawn, middle + shift, reach, rng), some_colour(rng, 0.8)))
    return layers


def _free(drawn: Drawn) -> list[Box]:
    """The strips left, right, above and below the object, the broadest first."""
    (left, top), (right, bottom) = drawn.points.min(0), drawn.points.max(0)
    w, h = drawn.size
    strips = [(0, 0, left, h), (right, 0, w, h), (0, 0, w, top), (0, bottom, w, h)]
    boxes = [(np.array([(x0 + x1) / 2, (y0 + y1) / 2]), np.array([x1 - x0, y1 - y0]) / 2) for x0, y0, x1, y1 in strips]
    return sorted(boxes, key=lambda b: -float(b[1].min()))


def _axes(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """A tripod of axes with its letters."""
    out, turn = np.zeros(drawn.size[::-1], np.float32), rng.uniform(-0.3, 0.3)
    for name, angle in zip("xyz", (np.pi * 0.8, 0.1, -np.pi / 2), strict=True):
        tip = at + reach * np.array([np.cos(angle + turn), np.sin(angle + turn)])
        out = np.maximum(out, arrow_ink(tip, at, 0.16 * reach, str(rng.choice(["open", "filled"])), drawn, rng))
        letter = at + 1.15 * (tip - at)
        out = np.maximum(out, written(name, letter, max(0.2 * reach, 9), drawn.size, rng))
    return out


def _polygon(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """A flat figure of its own."""
    ring = at + 1.8 * reach * profile(str(rng.choice(["triangle", "box", "L", "hexagon", "trapezoid"])), rng)
    return drawn.ink([np.vstack([ring, ring[:1]])], drawn.fine_pen(rng), rng)


def _views(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """Two rectangles one above the other: views of something."""
    w, h = rng.uniform(0.5, 0.9), rng.uniform(0.3, 0.45)
    box = np.array([[-w, -h], [w, -h], [w, h], [-w, h], [-w, -h]]) * reach
    paths = [at + box + [0, s * 0.5 * reach] for s in (-1, 1)]
    x = rng.uniform(-0.6, 0.6) * w * reach
    paths.append(at + np.array([[x, -0.5 * reach - h * reach], [x, -0.5 * reach + h * reach]]))
    return drawn.ink(paths, drawn.fine_pen(rng), rng)


def _table(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """A small table with numbers."""
    rows, columns = int(rng.integers(2, 5)), int(rng.integers(2, 4))
    ys, xs = np.linspace(-0.8, 0.8, rows + 1) * reach, np.linspace(-0.9, 0.9, columns + 1) * reach
    paths = [at + np.array([[xs[0], y], [xs[-1], y]]) for y in ys]
    paths += [at + np.array([[x, ys[0]], [x, ys[-1]]]) for x in xs]
    out = drawn.ink(paths, drawn.fine_pen(rng), rng)
    for i in range(rows):
        cell = at + np.array([(xs[0] + xs[1]) / 2, (ys[i] + ys[i + 1]) / 2])
        out = np.maximum(out, written(str(rng.integers(1, 99)), cell, max(0.9 * reach / rows, 8), drawn.size, rng))
    return out


def _curve(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """A curve between axes."""
    t = np.linspace(0, 1, 40)
    wave = 0.5 + 0.4 * np.sin(2 * np.pi * (rng.uniform(0.6, 1.4) * t + rng.random()))
    corner = np.array([[-0.9, -0.9], [-0.9, 0.9], [0.9, 0.9]])
    paths = [at + reach * corner, at + reach * np.c_[-0.9 + 1.7 * t, 0.9 - 1.6 * wave]]
    return drawn.ink(paths, drawn.fine_pen(rng), rng)


def _circle(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """A circle with a radius or a diameter."""
    turn = np.linspace(0, 2 * np.pi, 60)
    angle = rng.uniform(0, 2 * np.pi)
    spoke = np.array([np.cos(angle), np.sin(angle)]) * 0.8 * reach
    paths = [at + 0.8 * reach * np.c_[np.cos(turn), np.sin(turn)], np.array([at, at + spoke])]
    out = drawn.ink(paths, drawn.fine_pen(rng), rng)
    return np.maximum(out, written("r", at + 0.5 * spoke + [6, -6], max(0.25 * reach, 9), drawn.size, rng))


def _lines_of_text(drawn: Drawn, at: Floats, reach: float, rng: np.random.Generator) -> Coverage:
    """Some handwritten or printed lines."""
    out, height = np.zeros(drawn.size[::-1], np.float32), max(0.22 * reach, 8.0)
    for y, words in zip((-1.6, 0.0, 1.6), ("given: V = 96", "a = 4, h = 6", "find the area"), strict=True):
        if rng.random() < 0.8:
            out = np.maximum(out, written(words, at + [0, y * height], height, drawn.size, rng))
    return out


FIGURES: dict[str, Callable[[Drawn, Floats, float, np.random.Generator], Coverage]] = {
    "axes": _axes,
    "polygon": _polygon,
    "views": _views,
    "table": _table,
    "curve": _curve,
    "circle": _circle,
    "text": _lines_of_text,
}
