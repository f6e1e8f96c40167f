"""Connect-the-dots for rectilinear polygons, and the same in any parallel view.

J. O'Rourke, "Uniqueness of orthogonal connect-the-dots", in G. T. Toussaint (ed.), Computational Morphology, 1988: if
every turn is a right angle, the vertices on a vertical line pair up 1-2, 3-4, ... from its end, the same on every
horizontal line, and those pairs are the edges. So the polygon is unique if it exists. A parallel view only replaces
the two directions by two others.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.polygon import canonical, ring_is_simple
from sketch2shape.errors import PointsError, UsageError
from sketch2shape.geometry import cross, size_of
from sketch2shape.model import Floats, Ints

#: points within this part of the size of a common line are on it
TOLERANCE = 0.02
#: directions are taken from so many points to all others; each point has an edge in both directions, more help
#: under noise
ANCHORS = 4
#: so many pairings, the straightest, are combined
MOST = 30


@dataclass(frozen=True)
class Pairing:
    """The points in pairs along one direction.

    partner : (n,) the point each point is paired with
    spread  : rms distance of the points from their common lines
    """

    partner: Ints
    spread: float


def orthogonal(points: Floats, *, tolerance: float = TOLERANCE, directions: Literal["axes", "any"] = "any") -> Walk:
    """Pair the points along two directions; the pairs are the edges. O(n log n) for each direction, O(n) directions.

    tolerance  : how far from a common line a point may be, as a part of the size of the points, 0 <= tolerance < 0.5
    directions : "axes" for horizontal and vertical only (O'Rourke), "any" to look for two directions (the affine form)
    Raises PointsError if there is no such polygon, UsageError for other options. Of several
    solutions the one of least residual is given, the others are `alternatives`.
    """
    if directions not in ("axes", "any") or not 0 <= tolerance < 0.5:
        raise UsageError(
            f"expected directions 'axes' or 'any' and 0 <= tolerance < 0.5, got {directions!r} and {tolerance!r}"
        )
    solutions: dict[tuple[int, ...], float] = {}
    for pencils in _pencil_sets(points, directions):
        for spread, order in solve(points, pairings(points, pencils, tolerance)):
            key = canonical(order)
            solutions[key] = min(spread, solutions.get(key, np.inf))
        if solutions:
            break
    if not solutions:
        where = "the axes" if directions == "axes" else "two directions"
        raise PointsError(
            f"expected points that pair up into one simple ring along {where}, got {len(points)} points that do not",
            remedy="method='auto', or a larger tolerance",
        )
    ranked = sorted(solutions, key=lambda key: solutions[key])
    orders = [np.array(key, dtype=np.intp) for key in ranked]
    return Walk(
        orders[0],
        met=("the points pair up along two directions",),
        alternatives=tuple(orders[1:]),
        parameters={"tolerance": tolerance, "directions": directions},
    )


def _pencil_sets(points: Floats, directions: str) -> list[Pencils]:
    axes = Pencils(np.tile(points.mean(axis=0), (2, 1)), np.eye(2), np.zeros(2))
    return [axes] if directions == "axes" else [axes, candidate_pencils(points)]


@dataclass(frozen=True)
class Pencils:
    """Families of lines: parallel ones, or those through one vanishing point.

    origin    : (m, 2) a point on one line of each family
    direction : (m, 2) unit vector of that line
    converge  : (m,) inverse distance of the vanishing point along it from the origin, 0 for parallel lines
    """

    origin: Floats
    direction: Floats
    converge: Floats


def candidate_pencils(points: Floats, converge: tuple[float, ...] = (0.0,), anchors: int = ANCHORS) -> Pencils:
    """Families with a line through one of a few points and any other point.

    converge : inverse distances of the vanishing point to try, in sizes of the points
    """
    n = len(points)
    chosen = np.unique(np.linspace(0, n - 1, anchors).astype(int))
    first, second = (grid.ravel() for grid in np.meshgrid(chosen, np.arange(n), indexing="ij"))
    first, second = first[first != second], second[first != second]
    vectors = points[second] - points[first]
    vectors /= np.hypot(vectors[:, 0], vectors[:, 1])[:, None]
    count = len(converge)
    return Pencils(
        np.repeat(points[first], count, axis=0),
        np.repeat(vectors, count, axis=0),
        np.tile(np.array(converge) / size_of(points), len(first)),
    )


def pairings(points: Floats, pencils: Pencils, tolerance: float) -> list[Pairing]:
    """All pairings of the points along the families of lines in which every line holds an even number of points."""
    n = len(points)
    if n % 2 or n < 4:
        return []
    near = tolerance * size_of(points)
    arms = points[None] - pencils.origin[:, None]
    along = (arms * pencils.direction[:, None]).sum(axis=2)
    scale = 1.0 - along * pencils.converge[:, None]
    across = cross(pencils.direction[:, None], arms) / np.maximum(scale, 0.2)
    ranked = np.argsort(across, axis=1, kind="stable")
    offsets = np.take_along_axis(across, ranked, axis=1)
    breaks = np.diff(offsets, axis=1) > near
    line = np.concatenate((np.zeros((len(breaks), 1), dtype=np.intp), np.cumsum(breaks, axis=1)), axis=1)
    # a line that ends after an odd number of points leaves a break at an odd position
    even = ~breaks[:, ::2].any(axis=1) & (scale.min(axis=1) > 0.2)
    found: dict[bytes, Pairing] = {}
    for k in np.flatnonzero(even).tolist():
        if _widest(offsets[k], line[k]) > 2 * near:
            continue  # a chain of near points, not a line
        where = ranked[k][np.lexsort((along[k][ranked[k]], line[k]))]
        pairs = where.reshape(-1, 2)
        partner = np.empty(n, dtype=np.intp)
        partner[pairs[:, 0]], partner[pairs[:, 1]] = pairs[:, 1], pairs[:, 0]
        spread = _spread(offsets[k], line[k])
        key = partner.tobytes()
        if key not in found or spread < found[key].spread:
            found[key] = Pairing(partner, spread)
    return sorted(found.values(), key=lambda pairing: pairing.spread)[:MOST]


def _widest(offsets: Floats, line: Ints) -> float:
    """Largest extent of a line across itself."""
    first = np.flatnonzero(np.diff(line, prepend=-1))
    return float((np.append(offsets[first[1:] - 1], offsets[-1]) - offsets[first]).max())


def _spread(offsets: Floats, line: Ints) -> float:
    sizes = np.bincount(line)
    means = np.bincount(line, weights=offsets) / sizes
    return float(np.sqrt(((offsets - means[line]) ** 2).mean()))


def solve(points: Floats, found: list[Pairing]) -> list[tuple[float, Ints]]:
    """(spread, order) of every two pairings whose union is one simple ring."""
    answers = []
    for first, second in combinations(found, 2):
        order = _one_ring(first.partner, second.partner)
        if order is not None and ring_is_simple(points[order]):
            answers.append((float(np.hypot(first.spread, second.spread)), order))
    return answers


def _one_ring(first: Ints, second: Ints) -> Ints | None:
    """The ring that alternates between two pairings, or None if it misses points."""
    a, b = first.tolist(), second.tolist()
    ring = [0]
    while True:
        ring.append(a[ring[-1]])
        following = b[ring[-1]]
        if following == 0:
            return np.array(ring, dtype=np.intp) if len(ring) == len(a) else None
        if len(ring) >= len(a):
            return None
        ring.append(following)
