"""Flat figures as exams and textbooks have them: nothing in them is a solid."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Hand
from synthetic.marks import text
from synthetic.negatives import Negative, Sheet, closed, fit, strokes
from synthetic.pens import Coverage, Pen
from synthetic.profiles import regular

BOX = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])


def _between(p: Floats, q: Floats, t: float) -> Floats:
    point: Floats = p + t * (q - p)
    return point


def _named(out: Coverage, points: Floats, size: Sheet, rng: np.random.Generator, share: float = 0.6) -> Coverage:
    """The ink with a letter beside each point, now and then."""
    if rng.random() < share:
        height, middle = min(size) / 26, points.mean(0)
        for k, p in enumerate(points):
            away = (p - middle) / max(float(np.linalg.norm(p - middle)), 1e-9)
            at = p + away * height
            out = np.maximum(out, text(chr(65 + k), (float(at[0]), float(at[1])), height, size, "print"))
    return out


def rectangles(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A rectangle, upright or not, with inner lines: parallel to a side, a diagonal, a strip, a corner cut out."""
    turn = float(rng.choice([0.0, 0.0, rng.uniform(-0.6, 0.6)]))
    spin = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    ring = fit(BOX * [1, rng.uniform(0.4, 1.0)] @ spin.T, size, float(rng.uniform(0.45, 0.75)))
    a, b, c, d = ring
    paths, (s, t) = [closed(ring)], sorted(rng.uniform(0.15, 0.85, 2))
    kind = str(rng.choice(["one", "two", "three", "cross", "diagonal", "both", "corner", "strip", "parallelogram"]))
    if kind in ("one", "two", "three", "cross"):
        places = {"one": [s], "two": [s, t], "three": [0.25, 0.5, 0.75], "cross": [s]}[kind]
        paths += [np.array([_between(a, b, p), _between(d, c, p)]) for p in places]
    if kind in ("cross", "strip"):
        paths += [np.array([_between(a, d, p), _between(b, c, p)]) for p in ([t] if kind == "cross" else [s, t])]
    if kind in ("diagonal", "both"):
        paths += [np.array([a, c])] + ([np.array([b, d])] if kind == "both" else [])
    if kind == "corner":
        inner = _between(a, b, s) + _between(a, d, t) - a
        paths.append(np.array([_between(a, b, s), inner, _between(a, d, t)]))
    if kind == "parallelogram":
        paths += [
            np.array([_between(a, b, s), _between(d, c, s / 2)]),
            np.array([_between(a, b, t), _between(d, c, t - s / 2)]),
        ]
    return _named(strokes(paths, size, pen, hand, rng), ring, size, rng)


def triangles(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A triangle with altitudes, medians, a midline or its inner circle."""
    ring = fit(np.array([[-0.5, 0.4], [0.5, 0.4], [rng.uniform(-0.6, 0.6), -0.4]]), size, float(rng.uniform(0.5, 0.8)))
    a, b, c = ring
    paths = [closed(ring)]
    along = (b - a) / np.linalg.norm(b - a)
    foot = a + ((c - a) @ along) * along
    up, s = (c - foot) / np.linalg.norm(c - foot), min(size) / 40
    for kind in rng.choice(
        ["altitude", "median", "midline", "parallel", "circle"], int(rng.integers(1, 3)), replace=False
    ):
        if kind == "altitude":
            paths += [np.array([c, foot]), np.array([foot + s * along, foot + s * (along + up), foot + s * up])]
        if kind == "median":
            paths += [np.array([p, (q + r) / 2]) for p, q, r in ((a, b, c), (b, c, a), (c, a, b))][
                : int(rng.integers(1, 4))
            ]
        if kind == "midline":
            paths.append(np.array([(a + c) / 2, (b + c) / 2]))
        if kind == "parallel":
            t = rng.uniform(0.3, 0.7)
            paths.append(np.array([_between(a, c, t), _between(b, c, t)]))
        if kind == "circle":
            sides = np.array([np.linalg.norm(b - c), np.linalg.norm(c - a), np.linalg.norm(a - b)])
            middle = (sides @ ring) / sides.sum()
            radius = abs(float((middle - a) @ np.array([-along[1], along[0]])))
            paths.append(closed(middle + radius * regular(60)))
    return _named(strokes(paths, size, pen, hand, rng), ring, size, rng, 0.8)


def quadrilaterals(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A parallelogram or trapezoid with heights and diagonals."""
    lean, short = rng.uniform(0.1, 0.4), float(rng.choice([1.0, rng.uniform(0.4, 0.8)]))
    ring = fit(np.array([[0, 0.6], [1, 0.6], [lean + short, 0], [lean, 0]]), size, float(rng.uniform(0.5, 0.8)))
    a, b, c, d = ring
    paths = [closed(ring)]
    for p in (d, c)[: int(rng.integers(1, 3))]:
        paths.append(np.array([p, [p[0], a[1]]]))
    if rng.random() < 0.5:
        paths += [np.array([a, c]), np.array([b, d])][: int(rng.integers(1, 3))]
    if rng.random() < 0.3:
        paths.append(np.array([(a + d) / 2, (b + c) / 2]))
    return _named(strokes(paths, size, pen, hand, rng), ring, size, rng)


def circles_and_lines(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A circle with chords, a diameter, a tangent or a polygon in it."""
    radius, middle = float(rng.uniform(0.25, 0.38)) * min(size), np.array(size) / 2
    on = middle + radius * regular(int(rng.integers(3, 7)), rng.uniform(0, 6))
    paths = [closed(middle + radius * regular(90))]
    if rng.random() < 0.6:
        paths.append(closed(on))
    paths += [np.array([middle, p]) for p in on[: int(rng.integers(0, 4))]]
    if rng.random() < 0.4:
        spoke = (on[0] - middle) / radius
        side = np.array([-spoke[1], spoke[0]]) * radius * rng.uniform(0.5, 1.0)
        paths.append(np.array([on[0] - side, on[0] + side]))
    return _named(strokes(paths, size, pen, hand, rng), on, size, rng)


def similar(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Two figures of one shape side by side, smaller or turned: alike, but nothing joins them."""
    k = int(rng.integers(3, 6))
    shape = regular(k, rng.uniform(0, 6)) * rng.uniform(0.6, 1.0, (k, 1))
    turn = float(rng.choice([0.0, rng.uniform(0, 3)]))
    spin = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    one = fit(shape, size, 0.42, (0.28, 0.5))
    two = fit(shape @ spin.T, size, 0.42 * float(rng.choice([1.0, rng.uniform(0.5, 0.8)])), (0.74, 0.5))
    return _named(strokes([closed(one), closed(two)], size, pen, hand, rng), one, size, rng)


def nested_squares(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A square or rectangle within another: turned in it, in its corner, a frame, or two that overlap."""
    ring = fit(BOX * [1, float(rng.choice([1.0, rng.uniform(0.6, 0.9)]))], size, float(rng.uniform(0.5, 0.7)))
    kind, t = str(rng.choice(["turned", "corner", "frame", "overlap"])), rng.uniform(0.25, 0.6)
    if kind == "turned":
        inner = np.array([_between(ring[i], ring[(i + 1) % 4], t) for i in range(4)])
    elif kind == "corner":
        inner = ring[0] + (ring - ring[0]) * t
    elif kind == "frame":
        inner = ring.mean(0) + (ring - ring.mean(0)) * (0.3 + t / 2)
    else:
        inner = ring + (ring[2] - ring[0]) * rng.uniform(0.15, 0.4, 2)
    return _named(strokes([closed(ring), closed(inner)], size, pen, hand, rng), ring, size, rng)


def diagonals(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """A convex polygon, regular or not, with a star or more than that of its diagonals: they cross, as no edges do."""
    n = int(rng.integers(5, 9))
    turn, part = np.sort(rng.uniform(0.0, 0.6, n)) * (rng.random() < 0.5), 2 * np.pi / n
    at = (np.arange(n) + turn) * part + float(rng.choice([-0.5 * np.pi, rng.uniform(0.0, 6.0)]))
    ring = fit(np.c_[np.cos(at), rng.uniform(0.6, 1.0) * np.sin(at)], size, float(rng.uniform(0.5, 0.8)))
    every = [(i, j) for i in range(n) for j in range(i + 2, n) if (i, j) != (0, n - 1)]
    star = [(i, j) for i, j in every if j - i in (2, n - 2)]
    more = [pair for pair in every if pair not in star]
    chosen = star + [more[k] for k in rng.permutation(len(more))[: int(rng.integers(0, len(more) + 1))]]
    return _named(
        strokes([closed(ring), *(ring[list(pair)] for pair in chosen)], size, pen, hand, rng), ring, size, rng
    )


def function_graph(size: Sheet, pen: Pen, hand: Hand, rng: np.random.Generator) -> Coverage:
    """Axes with arrows, perhaps a grid, and a line, parabola, hyperbola, wave or polygon in them."""
    w, h = size
    o = np.array([w * rng.uniform(0.25, 0.6), h * rng.uniform(0.45, 0.8)])
    right, top, step = w * 0.92, h * 0.08, min(size) / rng.uniform(9, 14)
    paths = [np.array([[w * 0.08, o[1]], [right, o[1]]]), np.array([[o[0], h * 0.94], [o[0], top]])]
    paths += [np.array([[right - 9, o[1] - 5], [right, o[1]], [right - 9, o[1] + 5]])]
    paths += [np.array([[o[0] - 5, top + 9], [o[0], top], [o[0] + 5, top + 9]])]
    x = np.linspace(-3, 3, 120)
    curves = {
        "line": rng.uniform(-1.5, 1.5) * x + rng.uniform(-1, 1),
        "parabola": rng.choice([-0.6, 0.6]) * (x - rng.uniform(-1, 1)) ** 2 + rng.uniform(-1, 2),
        "hyperbola": 1.2 / np.where(np.abs(x) < 0.35, np.nan, x),
        "wave": rng.uniform(1, 2) * np.sin(x * rng.uniform(1, 2.5)),
    }
    for name in rng.choice(list(curves), int(rng.integers(1, 3)), replace=False):
        y = curves[str(name)]
        inside = np.abs(y) < 4
        for part in np.split(np.arange(len(x)), np.flatnonzero(np.diff(inside.astype(int))) + 1):
            if inside[part[0]] and len(part) > 3:
                paths.append(o + step * np.c_[x[part], -y[part]])
    if rng.random() < 0.4:
        corners = (
            rng.permutation(np.array([[1, 1], [3, 1], [3, 2], [1, 2.0]]))[:3]
            if rng.random() < 0.5
            else np.array([[1, 0], [1, 2], [3, 2], [3, 0.0]])
        )
        paths.append(closed(o + step * corners * [1, -1]))
    if rng.random() < 0.4:
        paths += [o + step * np.array([[-3.5, k], [3.5, k]]) for k in range(-4, 5) if k]
        paths += [o + step * np.array([[k, -4.2], [k, 4.2]]) for k in range(-3, 4) if k]
    out = strokes(paths, size, pen, hand, rng)
    for name, at in (("x", (right, o[1] + 18)), ("y", (o[0] - 18, top + 6)), ("O", (o[0] - 12, o[1] + 14))):
        out = np.maximum(out, text(name, (float(at[0]), float(at[1])), h / 30, size, "print"))
    return out


FLAT: dict[str, Negative] = {
    "rectangles": rectangles,
    "triangles": triangles,
    "quadrilaterals": quadrilaterals,
    "circles_and_lines": circles_and_lines,
    "similar": similar,
    "nested_squares": nested_squares,
    "diagonals": diagonals,
    "function_graph": function_graph,
}
