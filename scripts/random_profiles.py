"""Random polygons without a name: rectilinear, star-shaped, and simple ones. Each is a ring of vertices, (n, 2)."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).parent))
from named_profiles import Random, Ring, l_shape


def rectilinear(rng: Random) -> Ring:
    """A random rectilinear polygon: rectangles glued to, or cut from, a staircase-free start."""
    for _ in range(200):
        ring = _random_rectilinear(rng)
        if ring is not None:
            return ring
    return l_shape(rng)


def _random_rectilinear(rng: Random) -> Ring | None:
    k = int(rng.integers(2, 5))
    xs, ys = np.cumsum(rng.uniform(0.3, 1.2, k + 1)), np.cumsum(rng.uniform(0.3, 1.2, k + 1))
    cells = np.zeros((k, k), dtype=bool)
    cells[int(rng.integers(k)), int(rng.integers(k))] = True
    for _ in range(int(rng.integers(2, k * k))):
        grown = np.zeros_like(cells)
        grown[1:] |= cells[:-1]
        grown[:-1] |= cells[1:]
        grown[:, 1:] |= cells[:, :-1]
        grown[:, :-1] |= cells[:, 1:]
        free = np.argwhere(grown & ~cells)
        if len(free):
            cells[tuple(free[rng.integers(len(free))])] = True
    return _outline(cells, xs, ys)


def _outline(cells: NDArray[np.bool_], xs: Ring, ys: Ring) -> Ring | None:
    padded = np.pad(cells, 1)
    after: dict[tuple[int, int], tuple[int, int]] = {}
    for i, j in np.argwhere(padded).tolist():
        sides = (((i, j), (i + 1, j), (i, j - 1)), ((i + 1, j), (i + 1, j + 1), (i + 1, j)),
                 ((i + 1, j + 1), (i, j + 1), (i, j + 1)), ((i, j + 1), (i, j), (i - 1, j)))  # fmt: skip
        for a, b, beyond in sides:
            if not padded[beyond]:
                if a in after:
                    return None
                after[a] = b
    start = next(iter(after))
    ring = [start]
    while after[ring[-1]] != start:
        ring.append(after[ring[-1]])
    if len(ring) != len(after):
        return None
    corners = [p for q, p, r in zip([ring[-1], *ring[:-1]], ring, [*ring[1:], ring[0]], strict=True)
               if (q[0] - p[0]) * (r[1] - p[1]) != (q[1] - p[1]) * (r[0] - p[0])]  # fmt: skip
    if not 6 <= len(corners) <= 16:
        return None
    return np.array([(xs[i - 1], ys[j - 1]) for i, j in corners])


def star_shaped(rng: Random) -> Ring:
    """Random angles and radii about a centre."""
    n = int(rng.integers(5, 11))
    angle = np.sort(2 * np.pi * (np.arange(n) + rng.uniform(-0.4, 0.4, n)) / n)
    radius = rng.uniform(0.35, 1.0, n)
    return np.column_stack((radius * np.cos(angle), radius * np.sin(angle)))


def blob(rng: Random) -> Ring:
    """Random radii at random angles about a centre that is not the middle; no gap between angles above 150 degrees."""
    n = int(rng.integers(5, 10))
    while True:
        angle = np.sort(rng.uniform(0, 2 * np.pi, n))
        gaps = np.diff(angle, append=angle[0] + 2 * np.pi)
        if gaps.max() < 2.6 and gaps.min() > 0.1:
            radius = rng.uniform(rng.uniform(0.15, 0.5), 1.0, n)
            radius *= 1 + rng.uniform(0, 0.7) * np.cos(angle - rng.uniform(0, 2 * np.pi))  # the mean is not the centre
            return np.column_stack((radius * np.cos(angle), radius * np.sin(angle)))


def simple(rng: Random) -> Ring:
    """Random points joined at random and uncrossed."""
    n = int(rng.integers(5, 13))
    points = rng.uniform(0, 1, (n, 2))
    order = list(rng.permutation(n))
    changed = True
    while changed:
        changed = False
        for i in range(n - 1):
            for j in range(i + 2, n if i else n - 1):
                a, b, c, d = (points[order[k % n]] for k in (i, i + 1, j, j + 1))
                if _meet(a, b, c, d):
                    order[i + 1 : j + 1] = order[i + 1 : j + 1][::-1]
                    changed = True
    return points[order]


def _meet(a: Ring, b: Ring, c: Ring, d: Ring) -> bool:
    def side(p: Ring, q: Ring, r: Ring) -> float:
        return float((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0
