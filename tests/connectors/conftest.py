"""Small faces a reader can see, and how to compare rings."""

from collections.abc import Callable

import numpy as np
import pytest

from sketch2shape.connectors.polygon import canonical

SHAPES = {
    "triangle": [(0, 0), (4, 0), (1, 3)],
    "square": [(0, 0), (4, 0), (4, 4), (0, 4)],
    "hexagon": [(2, 0), (1, 2), (-1, 2), (-2, 0), (-1, -2), (1, -2)],
    "house": [(0, 0), (4, 0), (4, 3), (2, 5), (0, 3)],
    "L": [(0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)],
    "T": [(0, 6), (0, 4), (2, 4), (2, 0), (5, 0), (5, 4), (7, 4), (7, 6)],
    "U": [(0, 0), (7, 0), (7, 5), (5, 5), (5, 2), (2, 2), (2, 5), (0, 5)],
    "plus": [(2, 0), (4, 0), (4, 2), (6, 2), (6, 4), (4, 4), (4, 6), (2, 6), (2, 4), (0, 4), (0, 2), (2, 2)],
    "I": [(0, 0), (6, 0), (6, 2), (4, 2), (4, 6), (6, 6), (6, 8), (0, 8), (0, 6), (2, 6), (2, 2), (0, 2)],
    "stairs": [(0, 0), (6, 0), (6, 6), (4, 6), (4, 4), (2, 4), (2, 2), (0, 2)],
    "comb": [(0, 0), (10, 0), (10, 6), (8, 6), (8, 2), (6, 2), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)],
}
RECTILINEAR = ("square", "L", "T", "U", "plus", "I", "stairs", "comb")


def shuffled(ring, seed: int = 0):
    """(points in random order, the ring's order of them)."""
    order = np.random.default_rng(seed).permutation(len(ring))
    points = np.empty((len(ring), 2))
    points[order] = ring
    return points, order


def _fixture(value: object) -> Callable[[], object]:
    return pytest.fixture(lambda: value)


shapes = _fixture({name: np.array(ring, dtype=float) for name, ring in SHAPES.items()})
shuffle = _fixture(shuffled)
same_ring = _fixture(lambda a, b: canonical(a) == canonical(b))


def pytest_generate_tests(metafunc):
    for argument, names in (("shape", tuple(SHAPES)), ("rectilinear", RECTILINEAR)):
        if argument in metafunc.fixturenames:
            metafunc.parametrize(argument, names)
