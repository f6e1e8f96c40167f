"""Named profiles of random proportions: letters, arrows, combs, polygons. Each is a ring of vertices, (n, 2)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Ring = NDArray[np.float64]
Random = np.random.Generator


def regular(n: int) -> Callable[[Random], Ring]:
    def make(_: Random) -> Ring:
        angle = 2 * np.pi * np.arange(n) / n
        return np.column_stack((np.cos(angle), np.sin(angle)))

    return make


def star(rng: Random) -> Ring:
    n, ratio = int(rng.integers(4, 8)), rng.uniform(0.3, 0.6)
    angle = np.pi * np.arange(2 * n) / n
    radius = np.where(np.arange(2 * n) % 2, ratio, 1.0)
    return np.column_stack((radius * np.cos(angle), radius * np.sin(angle)))


def _ring(*rows: tuple[float, float]) -> Ring:
    return np.array(rows, dtype=float)


def rect(rng: Random) -> Ring:
    w, h = 1.0, rng.uniform(0.3, 1.0)
    return _ring((0, 0), (w, 0), (w, h), (0, h))


def triangle(rng: Random) -> Ring:
    return _ring((0, 0), (1, 0), (rng.uniform(-0.2, 1.2), rng.uniform(0.4, 1.2)))


def trapezoid(rng: Random) -> Ring:
    a, b = rng.uniform(0.05, 0.4, 2)
    return _ring((0, 0), (1, 0), (1 - b, 0.5), (a, 0.5))


def wedge(rng: Random) -> Ring:
    return _ring((0, 0), (1, 0), (1, rng.uniform(0.5, 0.9)), (0, rng.uniform(0.1, 0.4)))


def l_shape(rng: Random) -> Ring:
    a, b, h = rng.uniform(0.2, 0.7), rng.uniform(0.2, 0.7), rng.uniform(0.6, 1.3)
    return _ring((0, 0), (1, 0), (1, b * h), (a, b * h), (a, h), (0, h))


def t_shape(rng: Random) -> Ring:
    s, b, h = rng.uniform(0.12, 0.4), rng.uniform(0.2, 0.5), rng.uniform(0.7, 1.2)
    return _ring((0, h), (0, h - b), (s, h - b), (s, 0), (1 - s, 0), (1 - s, h - b), (1, h - b), (1, h))


def u_shape(rng: Random) -> Ring:
    a, c = rng.uniform(0.15, 0.38, 2)
    b, h = rng.uniform(0.15, 0.6), rng.uniform(0.6, 1.2)
    return _ring((0, 0), (1, 0), (1, h), (1 - c, h), (1 - c, b), (a, b), (a, h), (0, h))


def plus(rng: Random) -> Ring:
    a, h = rng.uniform(0.2, 0.42), rng.uniform(0.7, 1.3)
    b = a * h
    return _ring((a, 0), (1 - a, 0), (1 - a, b), (1, b), (1, h - b), (1 - a, h - b), (1 - a, h), (a, h), (a, h - b),
                 (0, h - b), (0, b), (a, b))  # fmt: skip


def z_shape(rng: Random) -> Ring:
    b, c, a = rng.uniform(0.25, 0.6), rng.uniform(0.25, 0.6), rng.uniform(0.25, 0.55)
    d = rng.uniform(a * 0.4, a * 0.95) if rng.random() < 0.5 else rng.uniform(0.2, 0.5)
    return _ring((0, 0), (1 - d, 0), (1 - d, c), (1, c), (1, b + c), (a, b + c), (a, b + c * 0.2), (0, b + c * 0.2))


def i_shape(rng: Random) -> Ring:
    a, b, h = rng.uniform(0.2, 0.42), rng.uniform(0.12, 0.35), rng.uniform(0.8, 1.4)
    b *= h
    return _ring((0, 0), (1, 0), (1, b), (1 - a, b), (1 - a, h - b), (1, h - b), (1, h), (0, h), (0, h - b),
                 (a, h - b), (a, b), (0, b))  # fmt: skip


def h_shape(rng: Random) -> Ring:
    a, b, h = rng.uniform(0.15, 0.38), rng.uniform(0.2, 0.42), rng.uniform(0.7, 1.3)
    return _ring((0, 0), (a, 0), (a, b * h), (1 - a, b * h), (1 - a, 0), (1, 0), (1, h), (1 - a, h), (1 - a, h - b * h),
                 (a, h - b * h), (a, h), (0, h))  # fmt: skip


def house(rng: Random) -> Ring:
    h, r = rng.uniform(0.4, 0.9), rng.uniform(0.2, 0.6)
    return _ring((0, 0), (1, 0), (1, h), (rng.choice([0.5, rng.uniform(0.3, 0.7)]), h + r), (0, h))


def arrow(rng: Random) -> Ring:
    a, head, wide = rng.uniform(0.15, 0.38), rng.uniform(0.25, 0.6), rng.uniform(0.5, 1.0)
    y = wide * (0.5 - a)
    return _ring((0, -y), (1 - head, -y), (1 - head, -wide / 2), (1, 0), (1 - head, wide / 2), (1 - head, y), (0, y))


def double_arrow(rng: Random) -> Ring:
    head, wide, y = rng.uniform(0.2, 0.38), rng.uniform(0.4, 0.8), rng.uniform(0.08, 0.15)
    right = [
        (0, -y),
        (0.5 - head / 2, -y),
        (0.5 - head / 2, -wide / 2),
        (0.8, 0),
        (0.5 - head / 2, wide / 2),
        (0.5 - head / 2, y),
    ]
    left = [(-x, -yy) for x, yy in right[1:-1]]
    return _ring(*right[1:-1], *left)


def chevron(rng: Random) -> Ring:
    d, w, h = rng.uniform(0.2, 0.6), rng.uniform(0.3, 0.9), rng.uniform(0.7, 1.3)
    return _ring((0, 0), (w, 0), (w + d, h / 2), (w, h), (0, h), (d, h / 2))


def notch(rng: Random) -> Ring:
    m, w, d, h = rng.uniform(0.35, 0.65), rng.uniform(0.05, 0.28), rng.uniform(0.2, 0.75), rng.uniform(0.5, 1.0)
    return _ring((0, 0), (1, 0), (1, h), (m + w, h), (m, h - d * h), (m - w, h), (0, h))


def bolt(rng: Random) -> Ring:
    j = rng.uniform(-0.06, 0.06, 4)
    return _ring(
        (0.35 + j[0], 1.0),
        (0.75 + j[1], 1.0),
        (0.55, 0.62),
        (0.9, 0.62),
        (0.1 + j[2], 0),
        (0.4 + j[3], 0.48),
        (0.05, 0.48),
    )


def bolt2(rng: Random) -> Ring:
    j = rng.uniform(-0.07, 0.07, 6)
    return _ring(
        (0.0, 0.0),
        (0.95 + j[0], 0.62 + j[1]),
        (0.6 + j[2], 0.62),
        (0.95 + j[3], 1.0),
        (0.5 + j[4], 1.0),
        (0.1, 0.5 + j[5]),
        (0.42, 0.5 + j[5]),
    )


def stairs(rng: Random) -> Ring:
    k = int(rng.integers(2, 6))
    x, y = np.cumsum(np.r_[0, _steps(rng, k)]), np.cumsum(np.r_[0, _steps(rng, k)])
    rows = [(x[-1], 0.0), (x[-1], y[-1])]
    for i in range(k - 1, -1, -1):
        rows += [(x[i], y[i + 1]), (x[i], y[i])]
    return _ring(*rows)


def _steps(rng: Random, k: int) -> Ring:
    return np.full(k, rng.uniform(0.6, 1.2)) if rng.random() < 0.5 else rng.uniform(0.5, 1.5, k)


def comb(rng: Random) -> Ring:
    k = int(rng.integers(2, 5))
    back, depth, gap = rng.uniform(0.2, 0.5), rng.uniform(0.5, 1.5), rng.uniform(0.5, 1.2)
    rows = [(0.0, 0.0), (0.0, back + depth)]
    x = 0.0
    for i in range(k):
        if i:
            rows += [(x, back), (x + gap, back), (x + gap, back + depth)]
            x += gap
        x += 0.6
        rows += [(x, back + depth)]
    return _ring(*rows, (x, 0.0))


def hook(rng: Random) -> Ring:
    a, b, c = rng.uniform(0.12, 0.24, 3)
    tip, d = rng.uniform(0.2, 0.55), rng.uniform(0.5, 1.0)
    return _ring(
        (0, 0), (1, 0), (1, 1), (1 - tip, 1), (1 - tip, 1 - a), (1 - b, 1 - a), (1 - b, c), (a, c), (a, d), (0, d)
    )


def spiral(rng: Random) -> Ring:
    w = rng.uniform(0.1, 0.16)
    d = rng.uniform(0.45, 0.6)
    return _ring((0, 0), (1, 0), (1, 1), (0.2, 1), (0.2, d - w), (0.7 - w, d - w), (0.7 - w, d), (0.2 + w, d),
                 (0.2 + w, 1 - w), (1 - w, 1 - w), (1 - w, w), (0, w))  # fmt: skip


def chamfered(rng: Random) -> Ring:
    """A rectangle with some corners cut off."""
    w, h, c = 1.0, rng.uniform(0.5, 1.0), rng.uniform(0.08, 0.22)
    rows: list[tuple[float, float]] = []
    for (x, y), (ux, uy), (vx, vy) in (
        ((0, 0), (0, 1), (1, 0)),
        ((w, 0), (-1, 0), (0, 1)),
        ((w, h), (0, -1), (-1, 0)),
        ((0, h), (1, 0), (0, -1)),
    ):
        if rng.random() < 0.5:
            rows += [(x + c * ux, y + c * uy), (x + c * vx, y + c * vy)]
        else:
            rows.append((x, y))
    return _ring(*rows)


def dovetail(rng: Random) -> Ring:
    w, d, s = rng.uniform(0.15, 0.3), rng.uniform(0.2, 0.5), rng.uniform(0.05, 0.12)
    return _ring(
        (0, 0),
        (1, 0),
        (1, 0.8),
        (0.5 + w - s, 0.8),
        (0.5 + w, 0.8 - d),
        (0.5 - w, 0.8 - d),
        (0.5 - w + s, 0.8),
        (0, 0.8),
    )


def keyway(rng: Random) -> Ring:
    """A trapezoidal block with a rectangular slot."""
    w, d, t = rng.uniform(0.08, 0.2), rng.uniform(0.15, 0.45), rng.uniform(0.0, 0.18)
    return _ring(
        (0, 0), (1, 0), (1 - t, 0.7), (0.5 + w, 0.7), (0.5 + w, 0.7 - d), (0.5 - w, 0.7 - d), (0.5 - w, 0.7), (t, 0.7)
    )


def parallelogram(rng: Random) -> Ring:
    s, h = rng.uniform(-0.5, 0.5), rng.uniform(0.3, 0.9)
    return _ring((0, 0), (1, 0), (1 + s, h), (s, h))


def v_shape(rng: Random) -> Ring:
    t, h = rng.uniform(0.12, 0.3), rng.uniform(0.7, 1.2)
    return _ring((0, h), (0.5 - t / 2, 0), (0.5 + t / 2, 0), (1, h), (1 - t, h), (0.5, h * t * 1.3), (t, h))
