"""Sheets that hold no picture of a solid: tables, boards, nets, sheets of views, single faces, formulas."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Hand, Stroke, freehand
from synthetic.marks import text
from synthetic.negatives import Negative, Sheet, closed, fit, strokes
from synthetic.pens import Coverage, Pen, coverage
from synthetic.profiles import EVERYDAY, profile, regular

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
CUBE_NETS = (
    ((0, 1), (1, 1), (2, 1), (3, 1), (1, 0), (1, 2)),
    ((0, 1), (1, 1), (2, 1), (3, 1), (0, 0), (3, 2)),
    ((0, 1), (1, 1), (2, 1), (3, 1), (0, 0), (1, 2)),
    ((0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (3, 2)),
    ((0, 0), (1, 0), (2, 0), (2, 1), (3, 1), (4, 1)),
    ((0, 1), (1, 1), (2, 1), (2, 0), (3, 0), (1, 2)),
)
"""Cells (column, row) of some of the eleven nets of a cube."""
FORMULAS = (
    "V = a b c",
    "A = 1/2 (a + c) h",
    "x^2 + 3x - 4 = 0",
    "sin 30 = 0.5",
    "S = 2(ab + bc + ca)",
    "= 24 cm",
    "f(x) = 2x - 1",
)


def numbers_table(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Rows and columns, some merged, with numbers in them."""
    rows, columns = int(rng.integers(2, 7)), int(rng.integers(2, 6))
    tall, broad = rng.choice([1.0, 1.0, 1.6], rows), rng.uniform(0.7, 1.3, columns)
    ys = np.cumsum(np.r_[0.18, 0.64 * tall / tall.sum()]) * size[1]
    xs = np.cumsum(np.r_[0.14, 0.7 * broad / broad.sum()]) * size[0]
    paths = [np.array([[xs[0], y], [xs[-1], y]]) for y in ys]
    top = ys[1] if rng.random() < 0.3 else ys[0]
    paths += [np.array([[x, ys[0] if k in (0, columns) else top], [x, ys[-1]]]) for k, x in enumerate(xs)]
    out = strokes(paths, size, pen, hand, rng)
    if rng.random() < 0.7:
        for i in range(rows):
            for j in range(columns):
                at = (float(xs[j] + xs[j + 1]) / 2, float(ys[i] + ys[i + 1]) / 2)
                out = np.maximum(out, text(str(rng.integers(0, 999)), at, size[1] / 30, size, "print"))
    return out


def board(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A grid of squares, some of them filled, or a rectangle ruled into a few."""
    columns, rows = int(rng.integers(2, 9)), int(rng.integers(1, 9))
    cells = np.array([(i, j) for i in range(columns) for j in range(rows)], float)
    out = _cells(cells, size, pen, hand, rng)
    if rng.random() < 0.4:
        low, side = _placing(cells, size)
        for i, j in cells[rng.random(len(cells)) < 0.4]:
            x0, y0 = np.round(low + side * np.array([i, j])).astype(int)
            out[y0 : y0 + round(side), x0 : x0 + round(side)] = np.maximum(
                out[y0 : y0 + round(side), x0 : x0 + round(side)], 0.45
            )
    return out


def _placing(cells: Floats, size: Sheet, part: float = 0.7) -> tuple[Floats, float]:
    """Where the corner of cell (0, 0) lies and how long a cell's side is, so that all fit."""
    span = np.ptp(cells, axis=0) + 1
    side = float((np.array(size) * part / span).min())
    low: Floats = np.array(size) / 2 - side * span / 2 - side * cells.min(0)
    return low, side


def _cells(cells: Floats, size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Unit squares at (column, row), common sides once."""
    low, side = _placing(cells, size)
    sides = {
        tuple(sorted((tuple(np.round(c + SQUARE[k], 6)), tuple(np.round(c + SQUARE[(k + 1) % 4], 6)))))
        for c in cells
        for k in range(4)
    }
    return strokes([low + side * np.array(s) for s in sorted(sides)], size, pen, hand, rng)


def cube_net(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A net of a cube, or a part of one, with or without signs on it."""
    cells = np.array(CUBE_NETS[int(rng.integers(len(CUBE_NETS)))], float)
    if rng.random() < 0.3:
        cells = cells[: int(rng.integers(3, 6))]
    if rng.random() < 0.5:
        cells = cells[:, ::-1]
    out = _cells(cells, size, pen, hand, rng)
    if rng.random() < 0.5:
        low, side = _placing(cells, size)
        for k, c in enumerate(cells):
            at = low + side * (c + 0.5)
            out = np.maximum(out, text(str(k + 1), (float(at[0]), float(at[1])), side / 4, size, "print"))
    return out


def box_net(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """The net of a box a x b x c: four sides in a row, two lids."""
    a, b, c = rng.uniform(0.4, 1.2, 3)
    x = np.cumsum([0, a, b, a, b])
    boxes = [(x[k], 0.0, x[k + 1], c) for k in range(4)] + [(0.0, -b, a, 0.0), (0.0, c, a, c + b)]
    corners = np.array([[[x0, y0], [x1, y0], [x1, y1], [x0, y1]] for x0, y0, x1, y1 in boxes])
    placed = fit(corners.reshape(-1, 2), size, 0.85).reshape(-1, 4, 2)
    return strokes([closed(r) for r in placed], size, pen, hand, rng)


def prism_net(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """The net of a regular prism: sides in a row, a polygon above and below."""
    n, h = int(rng.integers(3, 7)), rng.uniform(1.0, 2.5)
    boxes = [np.array([[k, 0], [k + 1, 0], [k + 1, h], [k, h]], float) for k in range(n)]
    lid = regular(n, np.pi / 2 + np.pi / n) / (2 * np.sin(np.pi / n))
    lid = lid - [lid[:, 0].mean(), lid[:, 1].max()] + [1.5, 0]
    rings = [*boxes, lid, np.array([0, h]) + lid * [1, -1]]
    sizes = np.cumsum([len(r) for r in rings])[:-1]
    placed = np.split(fit(np.vstack(rings), size, 0.85), sizes)
    return strokes([closed(r) for r in placed], size, pen, hand, rng)


def view_sheet(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Two or three views of a stepped block, aligned as drawing rules want it, with dashed and centre lines."""
    a, b, c = rng.uniform(0.6, 1.2, 3)
    s, t = a * rng.uniform(0.25, 0.75), c * rng.uniform(0.25, 0.75)
    gap = rng.uniform(0.2, 0.5)
    front = [np.array([[0, 0], [a, 0], [a, -t], [s, -t], [s, -c], [0, -c], [0, 0]])]
    top = [SQUARE * [a, b] + [0, gap], np.array([[s, gap], [s, gap + b]])]
    side = [SQUARE * [b, -c] + [a + gap, 0], np.array([[a + gap, -t], [a + gap + b, -t]])]
    views = [front, top, side] if rng.random() < 0.7 else [front, [top, side][int(rng.integers(2))]]
    paths = [closed(p) if len(p) == 4 else p for view in views for p in view]
    sizes = np.cumsum([len(p) for p in paths])[:-1]
    placed = np.split(fit(np.vstack(paths), size, 0.8), sizes)
    hidden = rng.random(len(placed)) < [0.5 if len(p) == 2 else 0.0 for p in placed]
    made = [Stroke(freehand(p, hand, rng), bool(d)) for p, d in zip(placed, hidden, strict=True)]
    out = coverage(made, replace(pen, dash=pen.dash or (1.6, 1.1), faint=0.0), size, rng)
    if rng.random() < 0.4:
        low, high = np.vstack(placed).min(0), np.vstack(placed).max(0)
        words = str(rng.choice(["front view", "main view", "Fig. 3", "1 : 10"]))
        out = np.maximum(
            out, text(words, (float(low[0] + high[0]) / 2, float(high[1]) + 22), size[1] / 30, size, "print")
        )
    return out


def single_face(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """One polygon, plain or with its dimensions, seldom askew as a face of a solid is."""
    ring = profile(str(rng.choice(EVERYDAY)), rng)
    if rng.random() < 0.4:
        ring = ring @ np.array([[1.0, rng.uniform(-0.4, 0.4)], [0.0, rng.uniform(0.5, 0.9)]])
    ring = fit(ring, size, float(rng.uniform(0.45, 0.75)))
    out = strokes([closed(ring)], size, pen, hand, rng)
    if rng.random() < 0.5:
        for p, q in zip(ring, np.roll(ring, -1, 0), strict=True):
            off = (p + q) / 2 - ring.mean(0)
            at = (p + q) / 2 + off / max(float(np.linalg.norm(off)), 1e-9) * size[1] / 26
            out = np.maximum(
                out, text(str(rng.integers(2, 60)), (float(at[0]), float(at[1])), size[1] / 32, size, "print")
            )
    return out


def formulas(size: Sheet, _pen: Pen, _hand: Hand, rng: np.random.Generator) -> Coverage:
    """Some lines of mathematics, large."""
    out = np.zeros(size[::-1], np.float32)
    lines = rng.permutation(FORMULAS)[: int(rng.integers(1, 5))]
    height = min(size) / float(rng.uniform(9, 18))
    for k, line in enumerate(lines):
        y = size[1] / 2 + (k - len(lines) / 2) * 2 * height
        out = np.maximum(out, text(str(line), (size[0] / 2, y), height, size, str(rng.choice(["vector", "print"]))))
    return out


SHEETS: dict[str, Negative] = {
    "numbers_table": numbers_table,
    "board": board,
    "cube_net": cube_net,
    "box_net": box_net,
    "prism_net": prism_net,
    "view_sheet": view_sheet,
    "single_face": single_face,
    "formulas": formulas,
}
