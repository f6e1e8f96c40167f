"""Rings of a face: edges and area."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats, Ints


def ring_ends(sizes: list[int]) -> tuple[Ints, Ints]:
    """First and last vertex of each edge of each ring, the rings one after the other."""
    first = np.arange(sum(sizes))
    starts = np.cumsum([0, *sizes[:-1]])
    last = np.concatenate([s + np.roll(np.arange(n), -1) for s, n in zip(starts, sizes, strict=True)])
    return first, last


def edge_vectors(points: Floats, sizes: list[int]) -> Floats:
    """(m, dimensions) the edges of all rings of (m, dimensions) points."""
    first, last = ring_ends(sizes)
    vectors: Floats = points[last] - points[first]
    return vectors


def ring_area(ring: Floats) -> float:
    """Area inside an (n, 2) ring, >= 0."""
    x, y = (ring - ring[0]).T
    return abs(float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))))
