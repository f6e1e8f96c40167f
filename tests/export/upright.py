"""Solids made by hand that stand upright, as drawings are read: x to the right, y away, z up."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import ArcPlace, Circle, Projection, Solid, two_face_boundary

AXES = np.array([[1.0, 0, 0], [0, 0, 1], [0, 1, 0]])
"""Right, up and away."""

L = np.array([[0, 0], [60, 0], [60, 15], [15, 15], [15, 40], [0, 40.0]])
BOX = np.array([[0, 0], [60, 0], [60, 40], [0, 40.0]])
HOUSE = np.array([[0, 0], [60, 0], [60, 30], [30, 50], [0, 30.0]])
STAR = np.array([[(40 + 20 * (k % 2)) * f(k * np.pi / 5) for f in (np.cos, np.sin)] for k in range(10)])
WINDOW = np.array([[5, 5], [55, 5], [55, 35], [5, 35.0]])
NOTCH = np.array([[5, 4], [10, 4], [10, 10], [5, 10.0]])


def facing(rings, depth=25.0, scale=1.0, foot=None, unit="mm", along="away", arcs=()):
    """A prism, frustum or pyramid with its front face (y up) before the viewer, or lying under it.

    scale : of the back face, about the foot, in the rings' coordinates; None for their middle; 0 for a point
    along : "away" or "up": where the back face is
    arcs  : (ring, start or None, centre x, y, radius, turn: 1 anticlockwise) of curved edges
    """
    front = np.concatenate([np.zeros((0, 2)), *rings])
    foot = np.zeros(2) if not len(front) else front.mean(axis=0) if foot is None else np.array(foot, float)
    back = foot + scale * (front - foot) if scale else foot[None]

    def placed(flat, level):
        flat = np.atleast_2d(flat)
        levels = np.full(len(flat), level)
        return np.c_[flat[:, 0], levels, flat[:, 1]] if along == "away" else np.c_[flat, levels]

    def circle(x, y, radius, turn, level):
        normal = [0, -turn, 0] if along == "away" else [0, 0, turn]
        return Circle(placed([[x, y]], level)[0], np.array(normal, float), radius)

    circles = {}
    for ring, start, x, y, radius, turn in arcs:
        circles[ArcPlace("f1", ring, start)] = circle(x, y, radius, turn, 0.0)
        if scale:
            far = foot + scale * (np.array([x, y]) - foot)
            circles[ArcPlace("f2", ring, start)] = circle(*far, radius * scale, turn, depth)
    points = np.concatenate([placed(front, 0.0), placed(back, depth)])
    boundary = two_face_boundary(points, [len(ring) for ring in rings], circles, pointed=not scale)
    return Solid(boundary, Projection("oblique"), unit, axes=AXES)


def rounded(width=60.0, height=40.0, radius=8.0):
    """A rectangle with rounded corners: its ring, and its arcs as `facing` takes them."""
    w, h, r = width, height, radius
    ring = np.array([[r, 0], [w - r, 0], [w, r], [w, h - r], [w - r, h], [r, h], [0, h - r], [0, r]])
    return ring, [(0, 1, w - r, r, r, 1), (0, 3, w - r, h - r, r, 1), (0, 5, r, h - r, r, 1), (0, 7, r, r, r, 1)]


def arch():
    """A gate with a round top: its ring, and its arcs."""
    ring = np.array([[0, 0], [15, 0], [15, 20], [45, 20], [45, 0], [60, 0], [60, 20], [0, 20.0]])
    return ring, [(0, 2, 30, 20, 15, -1), (0, 6, 30, 20, 30, 1)]


EMPTY = np.zeros((0, 2))

#: solids with curved sides
CURVED = {
    "cylinder": facing([EMPTY], along="up", arcs=[(0, None, 0, 0, 20, 1)], depth=70.0),
    "tube": facing([EMPTY, EMPTY], along="up", arcs=[(0, None, 0, 0, 20, 1), (1, None, 0, 0, 15, -1)]),
    "cone": facing([EMPTY], along="up", arcs=[(0, None, 0, 0, 20, 1)], scale=0.0, depth=50.0),
    "truncated cone": facing([EMPTY], along="up", arcs=[(0, None, 0, 0, 20, 1)], scale=0.4),
    "bucket": facing([EMPTY], along="up", arcs=[(0, None, 0, 0, 20, 1)], scale=1.5),
    "rounded plate": facing([rounded()[0], EMPTY, EMPTY],
        arcs=[*rounded()[1], (1, None, 15, 20, 5, -1), (2, None, 45, 20, 5, -1)]),
    "arch": facing([arch()[0]], arcs=arch()[1]),
    "half cylinder": facing([np.array([[40.0, 0], [0, 0]])], arcs=[(0, 0, 20, 0, 20, 1)]),
    "slot": facing([np.array([[20, 0], [60, 0], [60, 40], [20, 40.0]])],
        arcs=[(0, 1, 60, 20, 20, 1), (0, 3, 20, 20, 20, 1)]),
    "disc segment": facing([np.array([[38.0, 0], [2, 0]])], arcs=[(0, 0, 20, -10, np.hypot(18, 10), 1)]),
}  # fmt: skip
