"""Pictures that hold no two-face object, drawn with the same pens and papers as those that do."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Hand, Stroke, freehand, wandering
from synthetic.marks import text
from synthetic.pens import Coverage, Pen, coverage
from synthetic.profiles import profile, random_simple, regular, unit_size

Sheet = tuple[int, int]
Negative = Callable[[Sheet, Pen, Hand, np.random.Generator], Coverage]

WORDS = (
    *("drawing", "solid", "face", "edge", "corner", "prism", "plane", "angle", "measure", "the", "of", "and"),
    *("to", "a", "paper", "line", "length", "width", "volume"),
)


def strokes(paths: list[Floats], size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Ink of polylines drawn by hand."""
    return coverage([Stroke(freehand(p, hand, rng)) for p in paths], pen, size, rng)


def closed(points: Floats) -> Floats:
    """The ring with its first point again at the end."""
    return np.vstack([points, points[:1]])


def fit(points: Floats, size: Sheet, part: float, at: tuple[float, float] = (0.5, 0.5)) -> Floats:
    """Points scaled to `part` of the sheet's shorter side about the relative place `at`."""
    fitted: Floats = unit_size(points) * part * min(size) + np.array(size) * at
    return fitted


def blank(size: Sheet, _pen: Pen, _hand: Hand, _rng: np.random.Generator) -> Coverage:
    """Nothing at all."""
    return np.zeros(size[::-1], np.float32)


def words(size: Sheet, _pen: Pen, _hand: Hand, rng: np.random.Generator) -> Coverage:
    """A few words."""
    some = " ".join(rng.choice(WORDS, 3))
    return text(some, (size[0] / 2, size[1] / 2), size[0] / 28, size, str(rng.choice(["vector", "print"])))


def page_of_text(size: Sheet, _pen: Pen, _hand: Hand, rng: np.random.Generator) -> Coverage:
    """A full page of small print."""
    out, height = np.zeros(size[::-1], np.float32), size[1] / 48
    font = str(rng.choice(["vector", "print"]))
    for y in np.arange(height * 2, size[1] - height, height * 1.8):
        line = " ".join(rng.choice(WORDS, 13))
        out = np.maximum(out, text(line, (size[0] / 2, float(y)), height, size, font))
    return out


def lone_polygon(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """One polygon."""
    name = str(rng.choice(["triangle", "box", "hexagon", "L", "star", "arrow", "simple", "stairs"]))
    return strokes([closed(fit(profile(name, rng), size, rng.uniform(0.4, 0.8)))], size, pen, hand, rng)


def two_polygons(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Two polygons that have nothing to do with each other."""
    k = int(rng.integers(3, 6))
    a = fit(regular(k, rng.uniform(0, 6)), size, 0.35, (0.27, 0.5))
    b = fit(regular(k + 2, rng.uniform(0, 6)), size, 0.45, (0.72, 0.5))
    return strokes([closed(a), closed(b)], size, pen, hand, rng)


def scribble(size: Sheet, pen: Pen, _hand: Hand, rng: np.random.Generator) -> Coverage:
    """A child's scribble: one long, curling line."""
    t = np.linspace(0, 1, 900)
    xy = [
        sum(
            rng.normal(0, 1 / k**0.7) * np.sin(2 * np.pi * (k * t * rng.uniform(1.2, 2.4) + rng.random()))
            for k in range(1, 9)
        )
        for _ in range(2)
    ]
    path = fit(np.c_[xy[0], xy[1]], size, 0.8)
    return coverage([Stroke(path)], pen, size, rng)


def zigzag(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Hatching back and forth."""
    k = int(rng.integers(12, 40))
    x = np.linspace(0, 1, k) + rng.normal(0, 0.01, k)
    y = (np.arange(k) % 2) + rng.normal(0, 0.08, k)
    return strokes([fit(np.c_[x, y * 0.6], size, 0.8)], size, pen, hand, rng)


def circles(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """One to three circles or ellipses."""
    paths = []
    for _ in range(int(rng.integers(1, 4))):
        ring = regular(90) * [1, rng.uniform(0.5, 1)]
        paths.append(closed(fit(ring, size, rng.uniform(0.2, 0.6), (rng.uniform(0.3, 0.7), rng.uniform(0.35, 0.65)))))
    del hand
    return coverage([Stroke(p) for p in paths], pen, size, rng)


def torus(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A ring: its outline and the rim of its hole, which are curves parallel to an ellipse."""
    t, flat = np.linspace(0, 2 * np.pi, 120), float(rng.uniform(0.55, 0.8))
    outwards = np.c_[flat * np.cos(t), np.sin(t)]
    outwards /= np.linalg.norm(outwards, axis=1)[:, None]
    # The ellipse is nowhere bent more than by a radius of flat ** 2: a thinner ring shows its hole whole.
    tube = flat**2 * float(rng.uniform(0.5, 0.8))
    middle = np.c_[np.cos(t), flat * np.sin(t)]
    return curves([middle + tube * outwards, middle - tube * outwards], size, pen, hand, rng)


def spring(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A coil of wire."""
    turns, flat, pitch = int(rng.integers(4, 8)), float(rng.uniform(0.2, 0.35)), float(rng.uniform(0.35, 0.6))
    t = np.linspace(0, 2 * np.pi * turns, 40 * turns)
    return curves([np.c_[np.cos(t), flat * np.sin(t) - pitch * t / (2 * np.pi)]], size, pen, hand, rng)


def curves(paths: list[Floats], size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Ink of curves drawn together by hand, fitted into the sheet."""
    low, high = np.vstack(paths).min(0), np.vstack(paths).max(0)
    scale = 0.7 * min(size) / float((high - low).max())
    fitted = [scale * (p - (low + high) / 2) + np.array(size) / 2 for p in paths]
    return coverage([Stroke(wandering(p, hand, rng)) for p in fitted], pen, size, rng)


def noise(size: Sheet, _pen: Pen, _hand: Hand, rng: np.random.Generator) -> Coverage:
    """Salt and pepper."""
    return (rng.random(size[::-1]) < rng.uniform(0.02, 0.2)).astype(np.float32)


def texture(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Thousands of short strokes all over the sheet."""
    count = int(rng.integers(700, 1600))
    at = rng.uniform(0, 1, (count, 2)) * size
    turn = rng.uniform(0, 2 * np.pi, count)
    d = np.c_[np.cos(turn), np.sin(turn)] * rng.uniform(6, 22, count)[:, None]
    del hand
    return coverage(
        [Stroke(np.array([p, p + e])) for p, e in zip(at, d, strict=True)], Pen(min(pen.width, 2.5)), size, rng
    )


def flowchart(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Boxes joined by arrows, words inside."""
    paths, boxes, out = [], [], np.zeros(size[::-1], np.float32)
    for k in range(int(rng.integers(3, 6))):
        middle = np.array([size[0] * (0.25 + 0.25 * (k % 3)), size[1] * (0.25 + 0.42 * (k // 3))])
        half = np.array([size[0] * 0.085, size[1] * rng.uniform(0.06, 0.1)])
        ring = middle + half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        boxes.append((middle, half))
        paths.append(closed(ring))
        out = np.maximum(out, text(str(rng.choice(WORDS)), (middle[0], middle[1]), size[0] / 60, size, "print"))
    for (a, ha), (b, hb) in itertools.pairwise(boxes):
        u = (b - a) / np.linalg.norm(b - a)
        p, q = a + u * (1 / np.max(np.abs(u) / ha)), b - u * (1 / np.max(np.abs(u) / hb))
        side = np.array([-u[1], u[0]])
        paths += [np.array([p, q]), np.array([q - 9 * u + 5 * side, q, q - 9 * u - 5 * side])]
    return np.maximum(out, strokes(paths, size, pen, hand, rng))


def graph(size: Sheet, pen: Pen, _hand: Hand, rng: np.random.Generator) -> Coverage:
    """A plot: axes, ticks, a curve, labels."""
    w, h = size
    o = np.array([w * 0.15, h * 0.85])
    paths = [np.array([o, [w * 0.9, o[1]]]), np.array([o, [o[0], h * 0.1]])]
    for k in range(1, 8):
        x, y = o[0] + k * w * 0.09, o[1] - k * h * 0.09
        paths += [np.array([[x, o[1]], [x, o[1] + 6]]), np.array([[o[0] - 6, y], [o[0], y]])]
    t = np.linspace(0, 1, 200)
    curve = 0.5 + 0.35 * np.sin(2 * np.pi * (t * rng.uniform(0.8, 2) + rng.random())) * t
    paths.append(np.c_[o[0] + t * w * 0.7, o[1] - curve * h * 0.7])
    ink = coverage([Stroke(p) for p in paths], pen, size, rng)
    return np.maximum(ink, text("time", (w * 0.8, h * 0.93), h / 35, size, "print"))


def arrows(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Loose arrows in all directions."""
    paths = []
    for _ in range(int(rng.integers(3, 9))):
        p, q = rng.uniform(0.1, 0.9, (2, 2)) * size
        u = (q - p) / max(float(np.linalg.norm(q - p)), 1.0)
        side = np.array([-u[1], u[0]])
        paths += [np.array([p, q]), np.array([q - 14 * u + 8 * side, q, q - 14 * u - 8 * side])]
    return strokes(paths, size, pen, hand, rng)


def network(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Random points joined at random."""
    k = int(rng.integers(5, 10))
    at = rng.uniform(0.12, 0.88, (k, 2)) * size
    pairs = [(i, j) for i in range(k) for j in range(i)]
    chosen = rng.choice(len(pairs), min(len(pairs), k + 3), replace=False)
    return strokes([at[list(pairs[c])] for c in chosen], size, pen, hand, rng)


def table(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Rows and columns."""
    rows, columns = int(rng.integers(3, 7)), int(rng.integers(3, 6))
    ys, xs = np.linspace(0.2, 0.8, rows) * size[1], np.linspace(0.15, 0.85, columns) * size[0]
    paths = [np.array([[xs[0], y], [xs[-1], y]]) for y in ys] + [np.array([[x, ys[0]], [x, ys[-1]]]) for x in xs]
    return strokes(paths, size, pen, hand, rng)


def crossing_lines(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Long lines across the sheet."""
    paths = []
    for turn in rng.uniform(0, np.pi, int(rng.integers(2, 8))):
        middle = rng.uniform(0.35, 0.65, 2) * size
        reach = np.array([np.cos(turn), np.sin(turn)]) * min(size) * rng.uniform(0.3, 0.45)
        paths.append(np.array([middle - reach, middle + reach]))
    return strokes(paths, size, pen, hand, rng)


def flat_figure(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A polygon with its diagonals: plane geometry."""
    ring = fit(random_simple(rng) if rng.random() < 0.3 else regular(5, -np.pi / 2), size, 0.7)
    n = len(ring)
    paths = [closed(ring)] + [ring[[i, (i + 2) % n]] for i in range(0, n, int(rng.integers(1, 3)))]
    return strokes(paths, size, pen, hand, rng)


NEGATIVES: dict[str, Negative] = {
    "blank": blank,
    "words": words,
    "page_of_text": page_of_text,
    "lone_polygon": lone_polygon,
    "two_polygons": two_polygons,
    "scribble": scribble,
    "zigzag": zigzag,
    "circles": circles,
    "torus": torus,
    "spring": spring,
    "noise": noise,
    "texture": texture,
    "flowchart": flowchart,
    "graph": graph,
    "arrows": arrows,
    "network": network,
    "table": table,
    "crossing_lines": crossing_lines,
    "flat_figure": flat_figure,
}
