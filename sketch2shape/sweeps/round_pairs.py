"""Round pairs: two ellipses of a drawing as the faces of a round object in perspective, or a tapered one.

The faces of such an object lie in parallel planes, so that a plane homology takes one to the other: its centre is where
the sides meet, which are the tangents of both ellipses, and along each ray from there both ellipses are met in turn.
How much nearer to the centre the second is met is linear in the place of the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations

import cv2
import numpy as np

from sketch2shape.geometry import cross, line_crossings
from sketch2shape.model import Floats
from sketch2shape.sweeps.outlines import Outline, ellipse_through
from sketch2shape.sweeps.sweep import Sweep, Way

FARTHEST = 200.0
"""Inverse of the angle, radians, between sides that are parallel."""
LEAST_SIDE = 2.0
"""Pixels of a side, and of the way from it to the centre, at least."""
BRIDGES = 2
"""Sides of a round object."""
RAYS = np.linspace(0.06, 0.94, 12)
"""Parts of the angle between the sides at which both ellipses are looked at."""
LEAST_TAPER = 0.01
"""Part by which the back face comes nearer to the centre, at least."""


def round_pairs(lines: Sequence[Floats]) -> Iterator[Sweep]:
    """Round objects whose nearer face is one of some ellipses and whose other face is another.

    lines : (k, 2) float each, pixels, points of an ellipse
    """
    rings = [ellipse_through(line) for line in lines]
    for front, back in permutations(range(len(rings)), 2):
        centre = _centre(lines[front], lines[back])
        way = None if centre is None else _way(rings[front], rings[back], *centre)
        if way is not None:
            yield Sweep((rings[front],), way)


def _centre(a: Floats, b: Floats) -> tuple[Floats, Floats] | None:
    """(2,) where the outer tangents of two closed lines meet, and (2, 2) from there to where they touch the first."""
    hull = cv2.convexHull(np.concatenate([a, b]).astype(np.float32), returnPoints=False)[:, 0]
    first = hull < len(a)
    bridges = np.flatnonzero(first != np.roll(first, -1))
    if len(bridges) != BRIDGES:
        return None
    ends = np.stack([hull[bridges], np.roll(hull, -1)[bridges]], axis=1)
    on_a = a[ends.min(axis=1)]
    on_b = b[ends.max(axis=1) - len(a)]
    span = on_b - on_a
    if abs(cross(*span)) < float(np.hypot(*span.T).prod()) / FARTHEST or np.hypot(*span.T).min() < LEAST_SIDE:
        return None
    s, _ = line_crossings(on_a[:1], span[:1], on_a[1:], span[1:])
    centre = on_a[0] + s[0] * span[0]
    sides = on_a - centre
    return (centre, sides) if np.hypot(*sides.T).min() > LEAST_SIDE else None


def _way(front: Outline, back: Outline, centre: Floats, sides: Floats) -> Way | None:
    """The homology with this centre that takes one ellipse to the other; None if there is none."""
    u = (1.0 - RAYS[:, None]) * sides[0] + RAYS[:, None] * sides[1]
    at, to = _met(front, centre, u), _met(back, centre, u)
    if at is None or to is None or (at * to <= 0).any():
        return None
    points = (centre + at.T[..., None] * u).reshape(-1, 2)
    nearer = (at / to - 1.0).T.ravel()
    origin = front.middle
    rows = np.column_stack([np.ones(len(points)), points - origin])
    told = np.linalg.lstsq(rows, nearer, rcond=None)[0]
    if abs(told[0]) < LEAST_TAPER or told[0] < LEAST_TAPER - 1.0:
        return None
    return Way(np.zeros(2), centre, float(1.0 / (1.0 + told[0])), told[1:] / told[0], origin)


def _met(ring: Outline, start: Floats, along: Floats) -> Floats | None:
    """(k, 2) how far along rays (k, 2) from a point an ellipse is met, the lesser first; None where it is not."""
    if ring.circle is None:
        return None
    p, u = ring.frame.flat(start) - ring.circle.centre, ring.frame.flat(along)
    square, half, rest = (u * u).sum(axis=1), u @ p, float(p @ p) - ring.circle.radius**2
    root = half**2 - square * rest
    if (root < 0).any():
        return None
    return np.asarray((-half[:, None] + np.sqrt(root)[:, None] * [-1.0, 1.0]) / square[:, None])
