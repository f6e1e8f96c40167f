"""The chi-shape (characteristic shape) of Duckham and others, our own and GEOS's.

M. Duckham, L. Kulik, M. Worboys, A. Galton, "Efficient generation of simple polygons for characterizing the shape of
a set of points in the plane", Pattern Recognition 41 (2008).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.delaunay import Border, eat, triangulate
from sketch2shape.errors import UsageError
from sketch2shape.model import Floats, Ints


def chi_shape(points: Floats, *, length: float | None = None, ratio: float | None = None) -> Walk:
    """Delaunay triangulation less the border triangles behind long edges. O(n log n).

    Strategy: while the longest border edge is longer than l and the apex of its triangle is not on the border, remove
    that triangle; the border stays one simple ring.

    length : l in units of the points, >= 0
    ratio  : instead of length, l = min + ratio (max - min) over all edges of the triangulation, 0..1
    Without either, digging stops as soon as every point is on the border (or when nothing is left to dig).
    Raises UsageError if both are given or out of range.
    """
    if length is not None and ratio is not None:
        raise UsageError("expected length or ratio, got both")
    if (length is not None and length < 0) or (ratio is not None and not 0 <= ratio <= 1):
        raise UsageError(f"expected length >= 0 or ratio in 0..1, got length={length!r}, ratio={ratio!r}")
    border = Border(points, triangulate(points))
    if ratio is not None:
        lengths = border.edge_lengths()
        length = float(lengths.min() + ratio * (lengths.max() - lengths.min()))
    limit = 0.0 if length is None else length
    until_all = length is None

    def enough(a: int, b: int) -> bool:
        return border.length(a, b) <= limit or (until_all and len(border.after) == len(points))

    eat(border, lambda *_: True, enough)
    return Walk(border.ring(), violated=left_out(points, border.ring()), parameters={"length": length})


def left_out(points: Floats, order: Ints) -> tuple[str, ...]:
    """In words, how many points the ring leaves out."""
    missing = len(points) - len(order)
    return (f"{missing} points were left out",) if missing else ()


def chi_shape_shapely(points: Floats, *, ratio: float = 0.3) -> Walk:
    """`shapely.concave_hull`, GEOS's form of the chi-shape: l = min + ratio (max - min). O(n log n).

    ratio : 0..1; 1 is the convex hull
    Raises UsageError for another ratio.
    """
    import shapely

    if not 0 <= ratio <= 1:
        raise UsageError(f"expected ratio in 0..1, got {ratio!r}")
    hull = shapely.concave_hull(shapely.multipoints(points), ratio=ratio)
    index = {(x, y): i for i, (x, y) in enumerate(points.tolist())}
    order = np.array([index[(x, y)] for x, y in shapely.get_coordinates(hull).tolist()[:-1]], dtype=np.intp)
    return Walk(order, violated=left_out(points, order), parameters={"ratio": ratio})
