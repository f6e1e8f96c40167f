"""`connect` and its richer form: check the points, run the method, judge the ring."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from sketch2shape.connectors.connection import Connection, Walk
from sketch2shape.connectors.points import as_points, check_distinct, check_spread
from sketch2shape.connectors.polygon import ring_is_simple
from sketch2shape.connectors.registry import find_method
from sketch2shape.model import Floats, Ints


def connect(points: ArrayLike, method: str = "auto", **parameters: Any) -> Ints:
    """Order the unordered vertices of a face into its polygon.

    points     : (n, 2) numbers (or (n, 1, 2), as OpenCV has them), n >= 3, distinct, not all on one line
    method     : a name from `methods()`
    parameters : what the method takes, see its docstring

    Returns the (n,) indices of the points in ring order; methods that leave points out return a shorter order.
    Raises PointsError for points that cannot be a face, LimitError for more points than the method can order,
    UsageError for an unknown method or parameter, MissingPackageError if the method needs an optional package.

    >>> connect([[0, 0], [2, 2], [2, 0], [0, 2]], method="split-walk").tolist()
    [0, 2, 1, 3]
    """
    return _run(points, method, parameters)[1].order


def connect_detailed(points: ArrayLike, method: str = "auto", **parameters: Any) -> Connection:
    """As `connect`, but also say how far the ring can be trusted: preconditions, sureness, alternatives.

    Takes and raises what `connect` does.
    """
    floats, walk = _run(points, method, parameters)
    complete = len(walk.order) == len(floats)
    simple = ring_is_simple(floats[walk.order])
    violated = walk.violated if simple else (*walk.violated, "the ring crosses or touches itself")
    return Connection(
        points=floats,
        order=walk.order,
        method=method,
        complete=complete,
        simple=simple,
        met=walk.met,
        violated=violated,
        sureness=walk.sureness,
        alternatives=walk.alternatives,
        rings=walk.rings,
        edges=walk.edges,
        parameters=walk.parameters,
    )


def _run(points: ArrayLike, method: str, parameters: dict[str, Any]) -> tuple[Floats, Walk]:
    entry = find_method(method)
    floats = as_points(points, limit=entry.limit, method=entry.name)
    check_spread(floats)
    entry.check(parameters)
    if method != "split-walk":  # which finds duplicates in its own sorted list
        check_distinct(floats)
    return floats, entry.function(floats, **parameters)
