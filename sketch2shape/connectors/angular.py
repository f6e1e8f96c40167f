"""Order by angle about the centroid: the polygon that is star-shaped from there."""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.model import Floats, Ints


def by_angle(points: Floats, centre: Floats) -> Ints:
    """(n,) indices by angle about a centre, nearer first where two share an angle."""
    arms = points - centre
    return np.lexsort((np.hypot(arms[:, 0], arms[:, 1]), np.arctan2(arms[:, 1], arms[:, 0])))


def angular(points: Floats) -> Walk:
    """Sort by angle about the mean of the points. Right if the polygon is star-shaped from there. O(n log n)."""
    return Walk(by_angle(points, points.mean(axis=0)), met=("every point is used",))
