"""The split and walk of the paper this package starts from, step by step.

"A Concave Hull Based Algorithm for Object Shape Reconstruction", section III and Fig. 11:

1. *List initialisation*: the list is sorted by x (then y), here by one sort of packed integers.
2. *Seed point*: the leftmost vertex; it belongs to the first region r1 wherever it lies. Of several leftmost the lowest
   value of y is taken, as it comes first in the sorted list.
3. *Region splitting*: r1 holds the vertices with y <= mean y, r2 the others (`axis="x"` exchanges x and y throughout).
4. *Walking*: each region is walked by increasing x. Among the vertices of the next x, the one of smallest
   |atan2(dy, dx)| in degrees from the current vertex comes first. As dx is the same for all of them that is the one
   of the nearest y. The others of that x then all lie at 90 degrees, where the rule is silent: they follow in list
   order, by increasing y. r2 begins its walk as seen from the seed. The first vertices of both regions are joined,
   and so are the last.
5. *Face connection*: see `sketch2shape.connect.faces`.

Linear after the sort, whose integer keys are compared in registers. The answer is the polygon only if both its chains
between the leftmost and the rightmost vertex are x-monotone and the split puts each of them in a region of its own:
`split_walk_preconditions` checks that for an order that is known.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sketch2shape.connect.connection import Walk
from sketch2shape.connect.points import check_distinct
from sketch2shape.errors import UsageError
from sketch2shape.model import Bools, Floats, Ints

Axis = str  # "y" or "x"; a Literal would make every caller cast


@dataclass(frozen=True)
class Preconditions:
    """What split-walk needs of a polygon, checked for one whose order is known.

    monotone   : both chains between the leftmost and the rightmost vertex never turn back in x
    separated  : each chain is one region of the centroid split
    ties_agree : within equal x, the angle rule visits the vertices in ring order
    """

    monotone: bool
    separated: bool
    ties_agree: bool

    @property
    def hold(self) -> bool:
        """Split-walk returns exactly this ring."""
        return self.monotone and self.separated and self.ties_agree

    @property
    def words(self) -> tuple[str, ...]:
        """The preconditions that fail, in words."""
        failing = []
        if not self.monotone:
            failing.append("a chain between the leftmost and the rightmost vertex turns back")
        if not self.separated:
            failing.append("the centroid line does not separate the two chains")
        if not self.ties_agree:
            failing.append("vertices at equal x follow each other against the angle rule")
        return tuple(failing)


def split_walk(points: Floats, *, axis: Axis = "y") -> Walk:
    """Order the points by splitting at the mean y and walking each half by increasing x. O(n) after an integer sort.

    axis : "y" splits at the mean y and walks along x, "x" splits at the mean x and walks along y
    Raises UsageError for another axis, PointsError for duplicates.
    """
    order, columns_tied, middle_empty = _order(*_axes(points, axis))
    met = ["every point is used"]
    violated: list[str] = []
    (violated if columns_tied else met).append(
        "two or more vertices of a region share a coordinate: the angle rule decided"
        if columns_tied
        else "no ties in a region"
    )
    if middle_empty:
        violated.append("the seed alone is in the first region: the split separates nothing")
    return Walk(order, met=tuple(met), violated=tuple(violated), parameters={"axis": axis})


def _columns(axis: Axis) -> tuple[int, int]:
    """Columns of the coordinate that is walked and of the one that is split."""
    if axis not in ("x", "y"):
        raise UsageError(f"expected axis 'x' or 'y', got {axis!r}")
    return (0, 1) if axis == "y" else (1, 0)


def _axes(points: Floats, axis: Axis) -> tuple[Floats, Floats]:
    walk, split = _columns(axis)
    return np.ascontiguousarray(points[:, walk]), np.ascontiguousarray(points[:, split])


def _order(x: Floats, y: Floats) -> tuple[Ints, bool, bool]:
    """The ring order, whether a region had ties, and whether r1 is the seed alone."""
    ranked = sort_by_x_then_y(x, y)
    xs, ys = x[ranked], y[ranked]
    check_distinct(np.column_stack((x, y)), ranked) if bool(_equal_neighbours(xs, ys)) else None
    first = ys <= y.mean()
    lone = not bool(first[1:].any())
    first[0] = True  # the seed is in r1, wherever it lies
    chains, tied = [], False
    for region in (np.flatnonzero(first), np.flatnonzero(~first)):
        walked, ties = _walk(xs[region], ys[region], seed=(float(xs[0]), float(ys[0])))
        tied |= ties
        chains.append(ranked[region] if walked is None else ranked[region[walked]])
    return np.concatenate((chains[0], chains[1][::-1])), tied, lone


def _equal_neighbours(xs: Floats, ys: Floats) -> bool:
    return bool(((xs[1:] == xs[:-1]) & (ys[1:] == ys[:-1])).any())


# ---------------------------------------------------------------- list initialisation


def sort_by_x_then_y(x: Floats, y: Floats) -> Ints:
    """(n,) indices that sort by x, equal x by y.

    Strategy: pack x, y and the index into one unsigned 64-bit number and sort those: no gathers, and linear in
    practice. Coordinates that are not whole numbers, or too wide, are first mapped to as many integer levels as fit;
    only the few that share a level are then sorted exactly.
    """
    n = len(x)
    if n < 256:
        return np.lexsort((y, x))
    index_bits = int(n - 1).bit_length()
    low, span = x.min(), np.ptp(x)
    y_low, y_span = y.min(), np.ptp(y)
    wide, tall = int(span).bit_length(), int(y_span).bit_length()
    if wide + tall + index_bits <= 64 and _whole(x) and _whole(y):
        keys = (x - low).astype(np.uint64)
        keys <<= np.uint64(tall)
        keys |= (y - y_low).astype(np.uint64)
        return _sorted_index(keys, index_bits)
    levels = float(2 ** min(64 - index_bits, 52) - 1)
    order = _sorted_index(((x - low) * (levels / span)).astype(np.uint64), index_bits)
    return _settle_ties(order, x, y, low, levels / span)


def _whole(values: Floats) -> bool:
    return bool(np.array_equal(values, np.rint(values)))


def _sorted_index(keys: NDArray[np.uint64], index_bits: int) -> Ints:
    keys = keys << np.uint64(index_bits)
    keys |= np.arange(len(keys), dtype=np.uint64)
    keys.sort()
    keys &= np.uint64((1 << index_bits) - 1)
    return keys.astype(np.intp)


def _settle_ties(order: Ints, x: Floats, y: Floats, low: float, scale: float) -> Ints:
    """Sort exactly within each run of points that share a level."""
    level = ((x[order] - low) * scale).astype(np.uint64)
    equal = level[1:] == level[:-1]
    tied = np.flatnonzero(np.r_[equal, False] | np.r_[False, equal])
    if len(tied):
        members = order[tied]
        order[tied] = members[np.lexsort((y[members], x[members]))]
    return order


# ---------------------------------------------------------------- walking


def _walk(xs: Floats, ys: Floats, seed: tuple[float, float]) -> tuple[Ints | None, bool]:
    """Reorder a region sorted by x then y by the angle rule: (positions or None for "as it is", ties present).

    Strategy: a column (points of equal x) is entered at the y nearest to the point before it, and left at its highest
    point, or at the second highest if it was entered at the highest. So a column has two states only; how each maps
    the state of the column before it to its own is found for all columns at once, and chained by a running parity.
    """
    n = len(xs)
    if n == 0:
        return None, False
    opens = np.r_[True, xs[1:] != xs[:-1]]
    start = np.flatnonzero(opens)
    if len(start) == n:
        return None, False
    size = np.diff(np.r_[start, n])
    last = start + size - 1
    second = np.maximum(last - 1, start)
    before = np.r_[0, np.arange(len(start) - 1)]  # the column before; the first has the seed before it instead
    entries = []
    for leave in (last, second):
        y_before = ys[leave][before]
        y_before[0] = seed[1] if xs[0] > seed[0] else -np.inf  # beside the seed: 90 degrees for all, so list order
        entries.append(_nearest(ys, y_before, start, size))
    state = _chain_states(entries[0] == last, entries[1] == last, size > 1)
    came_from = np.r_[0, state[:-1]]
    entry = np.where(came_from == 1, entries[1], entries[0])
    return _entries_first(n, start, size, entry), True


def _nearest(ys: Floats, target: Floats, start: Ints, size: Ints) -> Ints:
    """For each column the position whose y is nearest to its target; of two equally near the lower."""
    with np.errstate(invalid="ignore"):
        gap = np.abs(ys - np.repeat(np.where(np.isfinite(target), target, ys[start]), size))
    least = np.repeat(np.minimum.reduceat(gap, start), size)
    position = np.where(gap == least, np.arange(len(ys)), len(ys))
    return np.asarray(np.minimum.reduceat(position, start))


def _chain_states(from_last: Bools, from_second: Bools, several: Bools) -> Ints:
    """1 where a column is left at its second highest point, given that of the column before, for all columns."""
    zero, one = from_last & several, from_second & several
    fixed = zero == one
    fixed[0] = True
    anchor = np.maximum.accumulate(np.where(fixed, np.arange(len(fixed)), 0))
    flips = np.cumsum(~fixed & zero)
    return np.asarray((zero[anchor].astype(np.intp) + flips - flips[anchor]) % 2)


def _entries_first(n: int, start: Ints, size: Ints, entry: Ints) -> Ints:
    """Positions with each column's entry moved to its front, the rest in list order."""
    position = np.arange(n)
    front, head = np.repeat(entry, size), np.repeat(start, size)
    return np.where(position == head, front, np.where(position <= front, position - 1, position))


# ---------------------------------------------------------------- preconditions


def split_walk_preconditions(points: ArrayLike, order: ArrayLike, *, axis: Axis = "y") -> Preconditions:
    """Whether split-walk would return the ring `order` of `points` (n, 2), and if not, why.

    Plain Python in one pass around the ring: for the few vertices of a face that is faster than arrays. O(n).
    Raises UsageError for another axis.
    """
    walk, split = _columns(axis)
    rows = np.asarray(points, dtype=np.float64).tolist()
    ring = [(rows[i][walk], rows[i][split]) for i in np.asarray(order).tolist()]
    seed = ring.index(min(ring))
    ring = ring[seed:] + ring[:seed]
    middle = sum([p[1] for p in ring]) / len(ring)
    far = ring.index(max(ring))
    monotone = _rises(ring[: far + 1]) and _rises([ring[0], *ring[: far - 1 : -1]])
    found = _judge(ring, middle, monotone)
    if found.hold:
        return found
    other = _judge([ring[0], *ring[:0:-1]], middle, monotone)
    return other if other.hold or not found.separated else found


def _judge(ring: list[tuple[float, float]], middle: float, monotone: bool) -> Preconditions:
    """The preconditions of a ring that starts at the seed and runs through r1 first."""
    first = [True] + [p[1] <= middle for p in ring[1:]]
    count = sum(first)
    if not all(first[:count]):
        return Preconditions(monotone, separated=False, ties_agree=True)
    chains = ring[:count], ring[: count - 1 : -1]
    if not (_rises(chains[0]) and _rises(chains[1])):
        return Preconditions(monotone, separated=False, ties_agree=True)
    agree = _follows_rule(chains[0], ring[0]) and _follows_rule(chains[1], ring[0])
    return Preconditions(True, separated=True, ties_agree=agree)


def _rises(chain: list[tuple[float, float]]) -> bool:
    return all(a[0] <= b[0] for a, b in pairwise(chain))


def _follows_rule(chain: list[tuple[float, float]], seed: tuple[float, float]) -> bool:
    """Whether each column of the chain is entered at the nearest y and then followed upwards."""
    current, i = seed, 0
    while i < len(chain):
        column = [p for p in chain[i:] if p[0] == chain[i][0]]
        listed = sorted(column, key=lambda p: p[1])
        if listed[0][0] > current[0]:
            entry = min(listed, key=lambda p: abs(p[1] - current[1]))
            listed.remove(entry)
            listed.insert(0, entry)
        if listed != column:
            return False
        current, i = column[-1], i + len(column)
    return True
