"""The concave hull of the optional package `concave-hull`, a C++ port of concaveman (itself after Park and Oh)."""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.errors import MissingPackageError, UsageError
from sketch2shape.model import Floats


def concave_hull(points: Floats, *, concavity: float = 2.0, length_threshold: float = 0.0) -> Walk:
    """Concave hull by the package `concave-hull`; points inside are left out. O(n log n).

    concavity        : ratio of edge length to the distance dug, >= 1 in practice; lower digs deeper (2, the package's
                       default, leaves a plain L at its convex hull)
    length_threshold : edges shorter than this are left alone, in units of the points
    Raises MissingPackageError without the package, UsageError for negative values.
    """
    if not (concavity > 0 and length_threshold >= 0):
        raise UsageError(
            f"expected concavity > 0 and length_threshold >= 0, got {concavity!r} and {length_threshold!r}"
        )
    try:
        from concave_hull import concave_hull_indexes
    except ImportError as error:
        raise MissingPackageError(
            "method 'concave-hull' needs the package concave-hull", remedy="pip install 'sketch2shape[connectors]'"
        ) from error
    order = np.asarray(
        concave_hull_indexes(points, concavity=concavity, length_threshold=length_threshold), dtype=np.intp
    )
    left_out = len(points) - len(order)
    violated = (f"{left_out} points were left out",) if left_out else ()
    return Walk(order, violated=violated, parameters={"concavity": concavity, "length_threshold": length_threshold})
