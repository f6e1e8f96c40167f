"""Judge the points given to a connector before any method sees them.

Every method relies on the same facts: at least three distinct finite points that do not all lie on one line, small
enough in value that products of four coordinates neither overflow nor lose the shape to rounding.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.errors import LimitError, PointsError
from sketch2shape.geometry import cross
from sketch2shape.model import Floats

#: largest |coordinate|; beyond it, differences of pixels drown in rounding (a double holds 15.9 digits)
LARGEST = 1e12
#: of all pairs tried: cross products below this part of the squared size count as zero
FLAT = 1e-12


def as_points(points: ArrayLike, *, minimum: int = 3, limit: int | None = None, method: str = "connect") -> Floats:
    """The points, (n, 2) or OpenCV's (n, 1, 2), as a contiguous (n, 2) float array.

    Raises PointsError unless they are `minimum` or more finite pairs of reasonable size, LimitError (before any is
    looked at) if they are more than `limit`, the most that `method` can order in reasonable time.
    """
    try:
        array = np.asarray(points)
    except ValueError as error:
        raise PointsError("expected an (n, 2) array of numbers, got rows of different lengths") from error
    if array.ndim == 3 and array.shape[1:] == (1, 2):  # as OpenCV gives contours and corners
        array = array[:, 0]
    if array.dtype.kind not in "iuf":
        raise PointsError(f"expected an (n, 2) array of real numbers, got elements of type {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 2:
        raise PointsError(f"expected shape (n, 2), got {array.shape}")
    if len(array) < minimum:
        raise PointsError(f"expected at least {minimum} points, got {len(array)}")
    if limit is not None and len(array) > limit:
        raise LimitError(
            f"expected at most {limit:,} points for method {method!r}, got {len(array):,}",
            remedy="method='split-walk', which is linear in the number of points, or fewer points",
        )
    floats = np.ascontiguousarray(array, dtype=np.float64)
    _check_values(floats)
    return floats


def _check_values(points: Floats) -> None:
    low, high = points.min(), points.max()
    if not (np.isfinite(low) and np.isfinite(high)):
        bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
        raise PointsError(
            f"expected finite coordinates, got {points[bad[0]].tolist()} at row {bad[0]} ({len(bad)} such rows)"
        )
    if max(-low, high) > LARGEST:
        raise PointsError(
            f"expected coordinates within +-{LARGEST:g}, got {max(-low, high):g}",
            remedy="subtract the mean of the points and choose a larger unit",
        )


def check_spread(points: Floats) -> None:
    """Raise PointsError if all points lie on one line (within rounding)."""
    for sample in (points[:64], points):  # a corner among the first few settles it for most inputs
        centred = sample - sample[0]
        far = centred[np.argmax(np.abs(centred).max(axis=1))]
        size = float(np.abs(far).max())
        rounding = 4 * np.finfo(float).eps * float(np.abs(sample[0]).max())
        if float(np.abs(cross(centred, far)).max()) > size * (FLAT * size + rounding):
            return
    raise PointsError(f"expected points that span an area, got {len(points)} points on one line")


def check_distinct(points: Floats, order: np.ndarray | None = None) -> None:
    """Raise PointsError if a point occurs twice; `order` sorts them by x then y if that is known already."""
    if order is None:
        if len(points) <= 64 and len(set(map(tuple, points.tolist()))) == len(points):
            return
        order = np.lexsort((points[:, 1], points[:, 0]))
    ranked = points[order]
    same = (ranked[1:] == ranked[:-1]).all(axis=1)
    if same.any():
        first = int(np.argmax(same))
        i, j = sorted((int(order[first]), int(order[first + 1])))
        raise PointsError(
            f"expected distinct points, got {ranked[first].tolist()} at rows {i} and {j} ({same.sum()} duplicates)",
            remedy="drop duplicates, for instance numpy.unique(points, axis=0)",
        )


def check_points(points: ArrayLike, *, limit: int | None = None, method: str = "connect") -> Floats:
    """All of the above: the points as floats, or a typed error saying what was expected and what was given."""
    floats = as_points(points, limit=limit, method=method)
    check_spread(floats)
    check_distinct(floats)
    return floats
