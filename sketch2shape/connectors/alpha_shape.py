"""The alpha-shape of Edelsbrunner, Kirkpatrick and Seidel.

H. Edelsbrunner, D. G. Kirkpatrick, R. Seidel, "On the shape of a set of points in the plane", IEEE Trans. Inf. Theory
29 (1983).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.delaunay import triangulate
from sketch2shape.connectors.graph import single_cycle, widest_ring
from sketch2shape.connectors.polygon import circumradii
from sketch2shape.errors import UsageError
from sketch2shape.model import Floats, Ints


def alpha_shape(points: Floats, *, alpha: float | None = None) -> Walk:
    """Border of the Delaunay triangles of circumradius below 1 / alpha. O(n log n), O(n^2) to find alpha.

    alpha : 1 / largest circumradius kept, in 1 / units of the points; 0 keeps all (the convex hull). None takes the
            largest alpha whose border is a single cycle through all points, or failing that through most of them
    `edges` holds the whole border, `order` its widest ring. Raises UsageError for alpha < 0.
    """
    triangles = triangulate(points)
    radii = circumradii(points, triangles)
    if alpha is not None:
        if alpha < 0:
            raise UsageError(f"expected alpha >= 0, got {alpha!r}")
        return _walk(points, _border(triangles[radii * alpha < 1]), alpha)
    ranked = np.argsort(radii, kind="stable")
    best: Walk | None = None
    for last in np.flatnonzero(np.diff(radii[ranked], append=np.inf) > 0).tolist():
        edges = _border(triangles[ranked[: last + 1]])
        ring = single_cycle(edges)
        if ring is None or (best is not None and len(ring) <= len(best.order)):
            continue
        above = radii[ranked[last + 1]] if last + 1 < len(ranked) else np.inf
        best = _walk(points, edges, float(1 / above) if np.isfinite(above) else 0.0)
        if len(ring) == len(points):
            break
    return best if best is not None else _walk(points, _border(triangles), 0.0)


def _border(triangles: Ints) -> Ints:
    """(k, 2) edges used by one triangle only."""
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, counts = np.unique(sides, axis=0, return_counts=True)
    return np.asarray(edges[counts == 1], dtype=np.intp)


def _walk(points: Floats, edges: Ints, alpha: float) -> Walk:
    order, violated = widest_ring(points, edges)
    return Walk(order, violated=violated, edges=edges, parameters={"alpha": alpha})
