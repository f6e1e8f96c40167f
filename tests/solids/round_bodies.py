"""Round and pointed solids made by hand, with what geometry books say of them."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from sketch2shape.model import ArcPlace, Circle, Projection, Solid, two_face_boundary

PROJECTION = Projection("axonometric")
SQUARE = np.array([[-4, -4], [4, -4], [4, 4], [-4, 4.0]])


def disc(z, radius, x=0.0, y=0.0, turn=1.0):
    return Circle(np.array([x, y, z], float), np.array([0, 0, turn]), radius)


def solid(flat, sizes, arcs, depth=3.0, scale=1.0, apex=None, unit="mm"):
    """arcs: (ring, start or None, centre x, y, radius, turn); the back face is `scale` times as large."""
    flat = np.array(flat, float).reshape(-1, 2)
    near = np.c_[flat, np.zeros(len(flat))]
    far = np.c_[flat * scale, np.full(len(flat), depth)] if apex is None else np.array([apex], float)
    circles = {}
    for ring, start, x, y, radius, turn in arcs:
        circles[ArcPlace("f1", ring, start)] = disc(0.0, radius, x, y, turn)
        if apex is None:
            circles[ArcPlace("f2", ring, start)] = disc(depth, radius * scale, x * scale, y * scale, turn)
    boundary = two_face_boundary(np.concatenate([near, far]), sizes, circles, pointed=apex is not None)
    return Solid(boundary, PROJECTION, unit)


#: name -> the solid, its volume, its area, its holes, the kinds of its surfaces
ROUND = {
    "cylinder": (solid([], [0], [(0, None, 0, 0, 2, 1)]), 12 * pi, 20 * pi, 0, "PPC"),
    "tube": (
        solid([], [0, 0], [(0, None, 0, 0, 2, 1), (1, None, 0.5, 0, 1, -1)]), 9 * pi, 24 * pi, 1, "PPCC",
    ),
    "cone": (
        solid([], [0], [(0, None, 0, 0, 2, -1)], apex=[0, 0, 3]), 4 * pi, pi * (4 + 2 * sqrt(13)), 0, "PK",
    ),
    "truncated cone": (
        solid([], [0], [(0, None, 0, 0, 2, 1)], scale=0.5), 7 * pi, pi * (5 + 3 * sqrt(10)), 0, "PPK",
    ),
    "half cylinder": (
        solid([[2, 0], [-2, 0]], [2], [(0, 0, 0, 0, 2, 1)]), 6 * pi, 4 * pi + 6 * pi + 12, 0, "PPPC",
    ),
    "half cone": (
        solid([[2, 0], [-2, 0]], [2], [(0, 0, 0, 0, 2, 1)], apex=[0, 0, 3]), 2 * pi, 2 * pi + 6 + pi * sqrt(13), 0,
        "PPK",
    ),
    "plate with two holes": (
        solid(SQUARE, [4, 0, 0], [(1, None, 2, 2, 1, 1), (2, None, -2, 2, 1, 1)], depth=1.0),
        64 - 2 * pi, 128 - 4 * pi + 32 + 4 * pi, 2, "PPPPPPCC",
    ),
    "groove": (
        solid([[-3, 0], [-1, 0], [1, 0], [3, 0], [3, 4], [-3, 4]], [6], [(0, 1, 0, 0, 1, -1)], depth=2.0),
        48 - pi, 48 - pi + 2 * (2 + 2 + 4 + 6 + 4) + 2 * pi, 0, "PPPPPPCP",
    ),
    "slot": (
        solid([[-2, -1], [2, -1], [2, 1], [-2, 1]], [4], [(0, 1, 2, 0, 1, 1), (0, 3, -2, 0, 1, 1)]),
        3 * (8 + pi), 2 * (8 + pi) + 3 * (8 + 2 * pi), 0, "PPCPPC",
    ),
}  # fmt: skip

KINDS = {"P": "Plane", "C": "Cylinder", "K": "Cone"}
