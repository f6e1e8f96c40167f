"""Profiles for test drawings: named families of simple polygons, and random ones.

A family is a function of a random generator that returns an (n, 2) polygon, x right and y down. `profile` draws from
one of them, removes accidental straight angles and brings the polygon to unit size about its centre.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from shapely import box, unary_union
from shapely.geometry import LineString, MultiPolygon, Polygon

from sketch2shape.model import Floats

Family = Callable[[np.random.Generator], Floats]


def regular(n: int, phase: float = 0.0) -> Floats:
    """Regular polygon of n vertices, first vertex at `phase` radians, unit radius."""
    t = phase + 2 * np.pi * np.arange(n) / n
    points: Floats = np.c_[np.cos(t), np.sin(t)]
    return points


def unit_size(points: Floats) -> Floats:
    """Centre the bounding box on the origin and scale its longer side to 1."""
    low, high = points.min(0), points.max(0)
    small: Floats = (points - (low + high) / 2) / (high - low).max()
    return small


def ring(shape: Polygon) -> Floats:
    """Exterior of a shapely polygon without its straight vertices, (n, 2)."""
    return np.array(shape.simplify(1e-6).exterior.coords[:-1])[:, :2].astype(np.float64)


def without_straight_start(points: Floats) -> Floats:
    """Drop vertices where the ring runs straight on (simplify keeps the first of a ring)."""
    before, after = points - np.roll(points, 1, 0), np.roll(points, -1, 0) - points
    turn = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0])
    keep = turn > 1e-6 * np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    kept: Floats = points[keep]
    return kept


def band(*path: tuple[float, float], thickness: float) -> Floats:
    """Outline of a path of line segments drawn with a broad, square nib."""
    return ring(LineString(path).buffer(thickness / 2, cap_style="flat", join_style="mitre", mitre_limit=20))


def _named(points: list[tuple[float, float]]) -> Floats:
    return np.array(points, float)


def _box(rng: np.random.Generator) -> Floats:
    w, h = 1.0, rng.uniform(0.45, 1.0)
    return _named([(0, 0), (w, 0), (w, h), (0, h)])


def _wedge(rng: np.random.Generator) -> Floats:
    low, high = rng.uniform(0.15, 0.4), rng.uniform(0.6, 0.9)
    return _named([(0, high), (1, high), (1, 0), (0, high - low)])


def _trapezoid(rng: np.random.Generator) -> Floats:
    a, b = rng.uniform(0.1, 0.35, 2)
    return _named([(0, 0.7), (1, 0.7), (1 - a, 0), (b, 0)])


def _parallelogram(rng: np.random.Generator) -> Floats:
    s, h = rng.uniform(0.2, 0.45), rng.uniform(0.45, 0.8)
    return _named([(0, h), (1, h), (1 + s, 0), (s, 0)])


def _triangle(rng: np.random.Generator) -> Floats:
    return _named([(0, 0.8), (1, rng.uniform(0.6, 0.9)), (rng.uniform(0.1, 0.9), 0)])


def _house(rng: np.random.Generator) -> Floats:
    roof, top = rng.uniform(0.25, 0.5), rng.uniform(0.35, 0.65)
    return _named([(0, 1), (1, 1), (1, roof), (top, 0), (0, roof)])


def _arrow(rng: np.random.Generator) -> Floats:
    s, h = rng.uniform(0.15, 0.3), rng.uniform(0.35, 0.55)
    return _named([(0, 0.5 - s), (h, 0.5 - s), (h, 0), (1, 0.5), (h, 1), (h, 0.5 + s), (0, 0.5 + s)])


def _chevron(rng: np.random.Generator) -> Floats:
    t, d = rng.uniform(0.3, 0.5), rng.uniform(0.3, 0.5)
    return _named([(0, 0), (t, 0), (t + d, 0.5), (t, 1), (0, 1), (d, 0.5)])


def _notch(rng: np.random.Generator) -> Floats:
    a, b, d = rng.uniform(0.2, 0.35), rng.uniform(0.6, 0.8), rng.uniform(0.3, 0.6)
    return _named([(0, 0), (a, 0), ((a + b) / 2, d), (b, 0), (1, 0), (1, 0.9), (0, 0.9)])


def _bolt(rng: np.random.Generator) -> Floats:
    s = rng.uniform(-0.04, 0.04)
    return _named([(0.4, 0), (0.9, 0), (0.65, 0.38 + s), (1, 0.38 + s), (0.3, 1), (0.45, 0.55 + s), (0.1, 0.55 + s)])


def _kite(rng: np.random.Generator) -> Floats:
    return _named([(0.5, 0), (1, rng.uniform(0.25, 0.45)), (0.5, 1), (0, rng.uniform(0.25, 0.45))])


def _dart(rng: np.random.Generator) -> Floats:
    return _named([(0.5, 0), (1, 1), (0.5, rng.uniform(0.55, 0.75)), (0, 1)])


def _star(rng: np.random.Generator) -> Floats:
    k = int(rng.integers(4, 8))
    radii = np.where(np.arange(2 * k) % 2, rng.uniform(0.38, 0.6), 1.0)
    return regular(2 * k, -np.pi / 2) * radii[:, None]


def _stairs(rng: np.random.Generator) -> Floats:
    k = int(rng.integers(2, 7))
    x, y = np.linspace(0, 1, k + 1), np.linspace(rng.uniform(0.6, 1.0), 0, k + 1)
    steps = [(0.0, y[0])]
    for i in range(k):
        steps += [(x[i], y[i + 1]), (x[i + 1], y[i + 1])]
    return _named([*steps[1:], (1.0, y[0]), (0.0, y[0])])


def _comb(rng: np.random.Generator) -> Floats:
    k, depth, points = int(rng.integers(2, 6)), rng.uniform(0.4, 0.65), [(0.0, 0.0)]
    edges = np.linspace(0, 1, 2 * k)
    for i in range(1, 2 * k - 1, 2):
        points += [(edges[i], 0.0), (edges[i], depth), (edges[i + 1], depth), (edges[i + 1], 0.0)]
    return _named([*points, (1.0, 0.0), (1.0, 0.9), (0.0, 0.9)])


def _saw(rng: np.random.Generator) -> Floats:
    k, depth, points = int(rng.integers(2, 5)), rng.uniform(0.25, 0.4), []
    for i in range(k):
        points += [(i / k, depth), ((i + rng.uniform(0.6, 0.9)) / k, 0.0)]
    return _named([*points, (1.0, depth), (1.0, 0.85), (0.0, 0.85)])


def _spiral(rng: np.random.Generator) -> Floats:
    turns = int(rng.integers(3, 7))
    step, at, path = 0.36, np.zeros(2), [(0.0, 0.0)]
    for i in range(turns):
        at = at + np.array([(1, 0), (0, 1), (-1, 0), (0, -1)][i % 4]) * step * (1 + (i + 1) // 2)
        path.append((float(at[0]), float(at[1])))
    return band(*path, thickness=rng.uniform(0.13, 0.2))


def _letter(*paths: tuple[tuple[float, float], ...]) -> Family:
    def draw(rng: np.random.Generator) -> Floats:
        thickness = rng.uniform(0.2, 0.3)
        wide = np.array([1.0, rng.uniform(0.85, 1.25)])
        parts = [Polygon(band(*p, thickness=thickness)) for p in paths]
        letter: Floats = ring(unary_union(parts)) * wide
        return letter

    return draw


def random_rectilinear(rng: np.random.Generator) -> Floats:
    """Boundary of a random polyomino on an uneven grid, 6 to 16 vertices."""
    while True:
        xs, ys = (np.cumsum(np.r_[0, rng.uniform(0.18, 0.4, 4)]) for _ in range(2))
        cells = {(int(rng.integers(4)), int(rng.integers(4)))}
        for _ in range(int(rng.integers(3, 9))):
            i, j = sorted(cells)[int(rng.integers(len(cells)))]
            di, dj = [(1, 0), (-1, 0), (0, 1), (0, -1)][int(rng.integers(4))]
            if 0 <= i + di < 4 and 0 <= j + dj < 4:
                cells.add((i + di, j + dj))
        shape = unary_union([box(xs[i], ys[j], xs[i + 1], ys[j + 1]) for i, j in sorted(cells)])
        if isinstance(shape, MultiPolygon) or shape.interiors or not shape.exterior.is_simple:
            continue
        points = without_straight_start(ring(shape))
        if 6 <= len(points) <= 16:
            return points


def random_simple(rng: np.random.Generator) -> Floats:
    """Random simple polygon of 5 to 10 vertices: either seen whole from its centre, or an uncrossed random tour."""
    n = int(rng.integers(5, 11))
    if rng.random() < 0.5:
        t = np.sort(2 * np.pi * (np.arange(n) + rng.uniform(-0.3, 0.3, n)) / n)
        star: Floats = np.c_[np.cos(t), np.sin(t)] * rng.uniform(0.4, 1.0, n)[:, None]
        return star
    points = rng.uniform(0, 1, (n, 2))
    tour = list(range(n))
    changed = True
    while changed:
        changed = False
        for i in range(n - 1):
            for j in range(i + 2, n if i else n - 1):
                a, b, c, d = (points[tour[k]] for k in (i, i + 1, j, (j + 1) % n))
                now = np.linalg.norm(a - b) + np.linalg.norm(c - d)
                if np.linalg.norm(a - c) + np.linalg.norm(b - d) < now - 1e-12:
                    tour[i + 1 : j + 1] = reversed(tour[i + 1 : j + 1])
                    changed = True
    ordered: Floats = points[tour]
    return ordered


FAMILIES: dict[str, Family] = {
    "square": lambda _rng: _named([(0, 0), (1, 0), (1, 1), (0, 1)]),
    "box": _box,
    "wedge": _wedge,
    "trapezoid": _trapezoid,
    "parallelogram": _parallelogram,
    "triangle": _triangle,
    "kite": _kite,
    "dart": _dart,
    "house": _house,
    "arrow": _arrow,
    "chevron": _chevron,
    "notch": _notch,
    "bolt": _bolt,
    "star": _star,
    "stairs": _stairs,
    "comb": _comb,
    "saw": _saw,
    "spiral": _spiral,
    "pentagon": lambda _rng: regular(5, -np.pi / 2),
    "hexagon": lambda rng: regular(6, rng.choice([0, np.pi / 6])),
    "heptagon": lambda _rng: regular(7, -np.pi / 2),
    "octagon": lambda _rng: regular(8, np.pi / 8),
    "decagon": lambda _rng: regular(10),
    "dodecagon": lambda _rng: regular(12, np.pi / 12),
    "L": _letter(((0, 0), (0, 1), (0.7, 1))),
    "T": _letter(((0, 0), (1, 0)), ((0.5, 0), (0.5, 1))),
    "U": _letter(((0, 0), (0, 1), (0.8, 1), (0.8, 0))),
    "I": _letter(((0, 0), (0.8, 0)), ((0.4, 0), (0.4, 1)), ((0, 1), (0.8, 1))),
    "Z": _letter(((0, 0), (0.5, 0), (0.5, 0.7), (1, 0.7))),
    "F": _letter(((0.8, 0), (0, 0), (0, 1.1)), ((0, 0.55), (0.6, 0.55))),
    "E": _letter(((0.8, 0), (0, 0), (0, 1.2), (0.8, 1.2)), ((0, 0.6), (0.7, 0.6))),
    "H": _letter(((0, 0), (0, 1)), ((0.8, 0), (0.8, 1)), ((0, 0.5), (0.8, 0.5))),
    "plus": _letter(((0, 0.5), (1, 0.5)), ((0.5, 0), (0.5, 1))),
    "rectilinear": random_rectilinear,
    "simple": random_simple,
}


def chamfered(points: Floats, sizes: tuple[float, float], rng: np.random.Generator) -> Floats:
    """The ring with one to four corners cut off by small chamfers of a length within `sizes`."""
    n, out = len(points), []
    cut = set(rng.permutation(n)[: int(rng.integers(1, min(n, 4) + 1))].tolist())
    for i, p in enumerate(points):
        if i not in cut:
            out.append(p)
            continue
        for q in (points[i - 1], points[(i + 1) % n]):
            length = float(np.linalg.norm(q - p))
            out.append(p + (q - p) * min(float(rng.uniform(*sizes)) / length, 0.35))
    return np.array(out)


CONVEX = (
    "square",
    "box",
    "wedge",
    "trapezoid",
    "parallelogram",
    "triangle",
    "kite",
    "house",
    "pentagon",
    "hexagon",
    "octagon",
)
EVERYDAY = (
    *CONVEX,
    "heptagon",
    "arrow",
    "chevron",
    "notch",
    "L",
    "T",
    "U",
    "I",
    "Z",
    "plus",
    "stairs",
    "rectilinear",
    "dart",
)
LARGE = (
    "star",
    "spiral",
    "comb",
    "saw",
    "stairs",
    "E",
    "F",
    "H",
    "decagon",
    "dodecagon",
    "rectilinear",
    "simple",
    "bolt",
)


def profile(name: str, rng: np.random.Generator) -> Floats:
    """(n, 2) polygon of the family `name`, longer side 1, centred, x right, y down, sometimes mirrored or turned."""
    points = FAMILIES[name](rng)
    if rng.random() < 0.5:
        points = points * [-1, 1]
    if name in ("L", "T", "U", "Z", "F", "E", "comb", "notch", "stairs", "rectilinear") and rng.random() < 0.4:
        points = points[:, ::-1]
    points = without_straight_start(unit_size(points))
    area = points[:, 0] @ np.roll(points[:, 1], -1) - points[:, 1] @ np.roll(points[:, 0], -1)
    return points[::-1].copy() if area < 0 else points
