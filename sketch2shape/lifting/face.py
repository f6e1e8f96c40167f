"""Rings of a face: edges and area."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sketch2shape.model import Floats, Ints


def ring_ends(sizes: list[int]) -> tuple[Ints, Ints]:
    """First and last vertex of each edge of each ring, the rings one after the other; read-only."""
    return _ring_ends(tuple(sizes))


@lru_cache(maxsize=256)
def _ring_ends(sizes: tuple[int, ...]) -> tuple[Ints, Ints]:
    first = np.arange(sum(sizes))
    last, start = first + 1, 0
    for n in sizes:
        last[start + n - 1] = start
        start += n
    first.flags.writeable = last.flags.writeable = False
    return first, last


@lru_cache(maxsize=256)
def all_pairs(k: int) -> tuple[Ints, Ints]:
    """The two indices of each pair among k things; read-only."""
    first, second = np.triu_indices(k, 1)
    first.flags.writeable = second.flags.writeable = False
    return first, second


def edge_rows(sizes: list[int]) -> Floats:
    """(m, m) coefficients that take each edge from the vertices: edges = rows @ vertices; read-only."""
    return _edge_rows(tuple(sizes))


@lru_cache(maxsize=256)
def _edge_rows(sizes: tuple[int, ...]) -> Floats:
    first, last = _ring_ends(sizes)
    rows = np.zeros((len(first), len(first)))
    rows[first, last], rows[first, first] = 1.0, -1.0
    rows.flags.writeable = False
    return rows


def edge_vectors(points: Floats, sizes: list[int]) -> Floats:
    """(m, dimensions) the edges of all rings of (m, dimensions) points."""
    first, last = ring_ends(sizes)
    vectors: Floats = points[last] - points[first]
    return vectors


def ring_area(ring: Floats) -> float:
    """Area inside an (n, 2) ring, >= 0."""
    x, y = (ring - ring[0]).T
    return 0.5 * abs(float(x[:-1] @ y[1:] - y[:-1] @ x[1:]))
