"""Lines through points, and points beside lines."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sketch2shape.model import Floats, Ints


def moments(points: Floats) -> Floats:
    """(..., 6) of points (..., n, 2): count, sums of x, y, x squared, y squared and x times y."""
    x, y = points[..., 0], points[..., 1]
    return np.asarray(np.stack([np.ones_like(x), x, y, x * x, y * y, x * y], axis=-1).sum(axis=-2))


def fit_lines(sums: Floats) -> tuple[Floats, Floats, Floats]:
    """Total-least-squares lines of points with these moments (k, 6).

    Returns centres (k, 2) and unit directions (k, 2), pixels, and the rms distances of the points, (k,) pixels.
    """
    mean = sums[:, 1:] / sums[:, :1]
    x, y = mean[:, 0], mean[:, 1]
    xx, yy, xy = mean[:, 2] - x * x, mean[:, 3] - y * y, mean[:, 4] - x * y
    angle = 0.5 * np.arctan2(2 * xy, xx - yy)
    c, s = np.cos(angle), np.sin(angle)
    across = s * s * xx + c * c * yy - 2 * s * c * xy
    return mean[:, :2], np.stack([c, s], axis=1), np.sqrt(np.maximum(across, 0.0))


def project(points: Floats, starts: Floats, directions: Floats) -> tuple[Floats, Floats]:
    """Points against lines: distance along each line from its start, and distance off it; both (k, m) float, pixels.

    points             : (k, 2) float
    starts, directions : (m, 2) float, directions of unit length
    """
    normals = np.stack([-directions[:, 1], directions[:, 0]], axis=1)
    along = points @ directions.T - (starts * directions).sum(axis=1)
    return along, np.abs(points @ normals.T - (starts * normals).sum(axis=1))


@lru_cache(maxsize=64)
def thinned(count: int, most: int) -> Ints:
    """Indices of about `most` of `count` points, evenly, but without a period that could skip every other line."""
    index = np.arange(count)
    some = index if count <= most else index[(index * 0.6180339887) % 1.0 < most / count]
    some.flags.writeable = False
    return some
