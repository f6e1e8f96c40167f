"""Ordering: which connector gives a face the order that the ink shows.

A connector sees nothing but points, so its order counts only where the drawing agrees. The ring is known from the ink
by now; asked is whether a connector would have found it: first the paper's `split-walk`, then the connect-the-dots rule
of rectilinear faces (`orthogonal`), then the sort by angle (`angular`). The preconditions of each are checked on the
ring itself, which takes microseconds and says the same as running it.
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.angular import by_angle
from sketch2shape.connectors.orthogonal import TOLERANCE
from sketch2shape.connectors.polygon import canonical
from sketch2shape.connectors.registry import find_method
from sketch2shape.connectors.split_walk import split_walk_preconditions
from sketch2shape.connectors.stage import connect
from sketch2shape.errors import LimitError, PointsError
from sketch2shape.geometry import cross, size_of
from sketch2shape.model import Floats

INK = "ink"
"""The name given where no connector finds the order and the drawing itself decides."""
UPRIGHT = 0.01
"""Part of a face's size by which the ends of an upright (or level) drawn line differ in x (or y) by the hand alone."""


def check_connector(name: str) -> None:
    """Raise UsageError unless `name` is "ink" or a method of `connect` ("auto" among them)."""
    if name != INK:
        find_method(name)


def connector_of(ring: Floats, connector: str = "auto") -> str:
    """Name of the connector that finds the order of a face, or "ink".

    ring      : (n, 2) float, pixels, the face's vertices in the order that the ink shows
    connector : "auto" tries split-walk, orthogonal and angular in this order; the name of a method tries that one
                alone; "ink" none
    A ring of fewer than three vertices, which arcs close, has only the order that the ink shows. Points along an arc
    are no vertices, its two ends are.

    Raises UsageError for an unknown connector, MissingPackageError if the named one needs an optional package.
    """
    check_connector(connector)
    if connector == INK or len(ring) < 3:
        return INK
    if connector == "auto":
        known = (("split-walk", by_split_walk), ("orthogonal", by_pairing), ("angular", by_centre))
        return next((name for name, finds in known if finds(ring)), INK)
    finds = by_split_walk(ring) if connector == "split-walk" else by_method(ring, connector)
    return connector if finds else INK


def by_split_walk(ring: Floats) -> bool:
    """Whether the paper's split and walk returns this ring, split at the mean y or at the mean x.

    The paper takes vertices on whole pixels, where the ends of an upright line share their x. Fitted vertices never
    do, so nearly equal coordinates are made equal if the ring as it is does not meet the preconditions.
    """
    order = np.arange(len(ring))
    for points in (ring, levelled(ring)):
        if any(split_walk_preconditions(points, order, axis=axis).hold for axis in ("y", "x")):
            return True
    return False


def levelled(ring: Floats) -> Floats:
    """The ring with coordinates that differ by less than the hand's noise made equal: (n, 2) float."""
    return np.column_stack([_levels(ring[:, k], UPRIGHT * size_of(ring)) for k in (0, 1)])


def _levels(values: Floats, gap: float) -> Floats:
    """Each value replaced by the mean of its run; runs are parted by gaps."""
    ranked = np.argsort(values, kind="stable")
    run = np.zeros(len(values), np.intp)
    run[ranked[1:]] = np.cumsum(np.diff(values[ranked]) > gap)
    return np.asarray((np.bincount(run, values) / np.bincount(run))[run])


def by_pairing(ring: Floats) -> bool:
    """Whether pairing the vertices along two directions returns this ring (O'Rourke 1988, in its affine form).

    That is so if the edges alternate between two directions, and no two edges on a common line overlap.
    """
    n = len(ring)
    if n < 4 or n % 2:
        return False
    span = np.roll(ring, -1, axis=0) - ring
    noise = TOLERANCE * size_of(ring)
    return all(_pairs_up(ring, span, first, noise) for first in (0, 1))


def _pairs_up(ring: Floats, span: Floats, first: int, noise: float) -> bool:
    """Whether every other edge, from `first` on, joins neighbours 1-2, 3-4, ... on lines of one direction."""
    mine = span[first::2]
    longest = mine[int(np.argmax((mine * mine).sum(axis=1)))]
    u = longest / np.hypot(*longest)
    if np.abs(cross(mine, u)).max() > noise:
        return False
    partner = np.arange(len(ring)) + np.where(np.arange(len(ring)) % 2 == first, 1, -1)
    partner %= len(ring)
    across = cross(u, ring)
    ranked = np.argsort(across, kind="stable")
    line = np.zeros(len(ring), np.intp)
    line[ranked[1:]] = np.cumsum(np.diff(across[ranked]) > noise)
    pairs = np.lexsort((ring @ u, line)).reshape(-1, 2)
    return bool((partner[pairs[:, 0]] == pairs[:, 1]).all())


def by_centre(ring: Floats) -> bool:
    """Whether sorting by angle about the mean of the vertices returns this ring."""
    return canonical(by_angle(ring, ring.mean(axis=0))) == tuple(range(len(ring)))


def by_method(ring: Floats, method: str) -> bool:
    """Whether `connect` returns this ring for its points, given to it in an order that betrays nothing."""
    ranked = np.lexsort((ring[:, 1], ring[:, 0]))
    try:
        found = connect(ring[ranked], method)
    except (PointsError, LimitError):
        return False
    return canonical(ranked[found]) == tuple(range(len(ring)))
