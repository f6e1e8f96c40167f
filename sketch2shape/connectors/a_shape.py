"""The A-shape of Melkemi and Djebali, and the crust as one of them.

M. Melkemi and M. Djebali, "Computing the shape of a planar points set", Pattern Recognition 33 (2000);
N. Amenta, M. Bern, D. Eppstein, "The crust and the beta-skeleton", Graph. Models Image Process. 60 (1998).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.delaunay import triangulate
from sketch2shape.connectors.graph import widest_ring
from sketch2shape.connectors.points import as_points
from sketch2shape.geometry import size_of
from sketch2shape.model import Floats, Ints

#: distance of the four far points from the centre, in sizes of the point set
FAR = 20.0


def a_shape(points: Floats, *, A: ArrayLike | None = None) -> Walk:
    """Delaunay edges between points beside a triangle whose apex is in A. O(n log n).

    Strategy: triangulate the points together with A. An edge between two points stays if one of its triangles has
    its third vertex in A: it separates the points from the surroundings that A marks.

    A : (m, 2) marker points; None takes the Voronoi vertices of the points and four far points, which gives the crust
    `edges` holds the graph, `order` its widest ring.
    """
    markers = _voronoi_vertices(points) if A is None else as_points(A, minimum=1)
    triangles = triangulate(np.concatenate((points, markers)))
    edges = _separating(triangles, len(points))
    order, violated = widest_ring(points, edges)
    return Walk(order, violated=violated, edges=edges, parameters={"A": markers})


def _voronoi_vertices(points: Floats) -> Floats:
    """Voronoi vertices near the points, and four far points."""
    from scipy.spatial import Voronoi

    centre, size = points.mean(axis=0), size_of(points)
    triangulate(points)  # a typed error first if Qhull cannot take the points
    vertices = np.asarray(Voronoi((points - centre) / size).vertices, dtype=np.float64)
    vertices = np.unique(vertices[np.hypot(vertices[:, 0], vertices[:, 1]) < FAR].round(12), axis=0)
    far = FAR * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    return np.asarray(np.concatenate((vertices, far)) * size + centre)


def _separating(triangles: Ints, n: int) -> Ints:
    """(k, 2) edges between points (index < n) beside a triangle whose apex is a marker (index >= n)."""
    ranked = np.sort(triangles, axis=1)
    mixed = ranked[(ranked[:, 1] < n) & (ranked[:, 2] >= n)]
    return np.asarray(np.unique(mixed[:, :2], axis=0), dtype=np.intp)
