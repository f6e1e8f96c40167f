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
    ranked, xs, ys = sort_by_x_then_y(x, y)
    if _equal_neighbours(xs, ys):
        check_distinct(np.column_stack((x, y)), ranked)
    first = ys <= y.mean()
    lone = not bool(first[1:].any())
    first[0] = True  # the seed is in r1, wherever it lies
    chains, tied = [], False
    for region in (first, ~first):
        members = ranked[region]
        walked = _walk(xs[region], ys[region], seed=(float(xs[0]), float(ys[0])))
        tied |= walked is not None
        chains.append(members if walked is None else members[walked])
    return np.concatenate((chains[0], chains[1][::-1])), tied, lone


def _equal_neighbours(xs: Floats, ys: Floats) -> bool:
    return bool(((xs[1:] == xs[:-1]) & (ys[1:] == ys[:-1])).any())


# ---------------------------------------------------------------- list initialisation


def sort_by_x_then_y(x: Floats, y: Floats) -> tuple[Ints, Floats, Floats]:
    """(n,) indices that sort by x, equal x by y; and the sorted x and y.

    Strategy: pack x, y and the index into one unsigned 64-bit number and sort those: no gathers, and linear in
    practice. Coordinates that are not whole numbers, or too wide, are first mapped to as many integer levels as fit;
    only the few that share a level are then sorted exactly.
    """
    n = len(x)
    if n < 256:
        order = np.lexsort((y, x))
        return order, x[order], y[order]
    bits, low, y_low = int(n - 1).bit_length(), x.min(), y.min()
    span, tall = x.max() - low, int(y.max() - y_low).bit_length()
    if int(span).bit_length() + tall + bits <= 64:
        across, up = _whole(x, low), _whole(y, y_low)
        if across is not None and up is not None:
            return _sort_packed(across, up, tall, bits, (low, y_low))
    scale = float(2 ** min(64 - bits, 52) - 1) / span
    keys = _sorted_keys(((x - low) * scale).astype(np.uint64), bits)
    order = _settle_ties((keys & np.uint64((1 << bits) - 1)).astype(np.intp), keys >> np.uint64(bits), x, y)
    return order, x[order], y[order]


def _whole(values: Floats, low: float) -> NDArray[np.uint64] | None:
    """The values above the lowest as whole numbers, or None if some are not whole."""
    above = (values - low).astype(np.uint64)
    return above if float(low).is_integer() and bool((above + low == values).all()) else None


def _sort_packed(
    x: NDArray[np.uint64], y: NDArray[np.uint64], tall: int, bits: int, low: tuple[float, float]
) -> tuple[Ints, Floats, Floats]:
    x <<= np.uint64(tall)
    x |= y
    keys = _sorted_keys(x, bits)
    order = (keys & np.uint64((1 << bits) - 1)).astype(np.intp)
    keys >>= np.uint64(bits)
    ys = (keys & np.uint64((1 << tall) - 1)).astype(np.float64) + low[1]
    keys >>= np.uint64(tall)
    return order, keys.astype(np.float64) + low[0], ys


def _sorted_keys(keys: NDArray[np.uint64], bits: int) -> NDArray[np.uint64]:
    """Sorted keys, each with its index in the lowest bits. Overwrites `keys`."""
    keys <<= np.uint64(bits)
    keys |= np.arange(len(keys), dtype=np.uint64)
    keys.sort()
    return keys


def _settle_ties(order: Ints, level: NDArray[np.uint64], x: Floats, y: Floats) -> Ints:
    """Sort exactly within each run of points that share a level."""
    equal = level[1:] == level[:-1]
    tied = np.flatnonzero(np.r_[equal, False] | np.r_[False, equal])
    if len(tied):
        members = order[tied]
        order[tied] = members[np.lexsort((y[members], x[members]))]
    return order


# ---------------------------------------------------------------- walking


def _walk(xs: Floats, ys: Floats, seed: tuple[float, float]) -> Ints | None:
    """Positions that put a region sorted by x then y into walking order, or None if it has no ties.

    Strategy: only columns (runs of equal x) of two or more points need thought. Such a column is entered at the y
    nearest to the point before it, and left at its highest point, or at the second highest if it was entered at the
    highest: it has two states only. How each column maps the state of the one before it to its own is found for all
    columns at once, and chained by a running parity.
    """
    n = len(xs)
    opens = np.flatnonzero(xs[1:] != xs[:-1]) + 1
    if len(opens) >= n - 1:
        return None
    start = np.concatenate((np.zeros(1, dtype=np.intp), opens))
    size = np.diff(start, append=n)
    tied = np.flatnonzero(size > 1)
    start, size = start[tied], size[tied]
    last = start + size - 1
    follows = np.concatenate(([False], (np.diff(tied) == 1)))  # the column before it is tied as well
    y_last, y_second = ys[start - 1], ys[start - 1 - follows]  # of the column before: highest, second highest
    if tied[0] == 0:  # the column before is the seed; beside the seed all lie at 90 degrees: list order
        y_last[0] = y_second[0] = seed[1] if xs[0] > seed[0] else ys[0]
    left_at_second = _chain_states(_highest_nearest(ys, y_last, last), _highest_nearest(ys, y_second, last), follows)
    came_from_second = np.concatenate(([False], left_at_second[:-1])) & follows
    return _entries_first(n, start, _nearest(ys, np.where(came_from_second, y_second, y_last), start, size))


def _highest_nearest(ys: Floats, target: Floats, last: Ints) -> Bools:
    """Whether the highest point of each column is nearest to its target; equally near points yield to the lower."""
    return np.asarray(np.abs(ys[last] - target) < np.abs(ys[last - 1] - target))


def _inside(start: Ints, size: Ints) -> Ints:
    """Positions of all members of columns, one column after the other."""
    begin = np.cumsum(size) - size
    return np.asarray(np.arange(int(size.sum())) + np.repeat(start - begin, size))


def _nearest(ys: Floats, target: Floats, start: Ints, size: Ints) -> Ints:
    """For each column the position whose y is nearest to its target; of two equally near the lower."""
    low = ys[_inside(start, size)] < np.repeat(target, size)
    above = start + np.add.reduceat(low, np.cumsum(size) - size, dtype=np.intp)  # the first not below the target
    upper, lower = np.minimum(above, start + size - 1), np.maximum(above - 1, start)
    return np.where(np.abs(ys[lower] - target) <= np.abs(ys[upper] - target), lower, upper)


def _chain_states(zero: Bools, one: Bools, follows: Bools) -> Bools:
    """Which columns are left at their second highest point.

    zero, one : whether a column is, if the one before it was left at its highest, at its second highest point
    follows   : whether there is a choice, that is whether the column before it is tied
    """
    fixed = (zero == one) | ~follows
    anchor = np.maximum.accumulate(np.where(fixed, np.arange(len(fixed)), 0))
    flips = np.cumsum(~fixed & zero)
    return np.asarray((zero[anchor] + flips - flips[anchor]) % 2 == 1)


def _entries_first(n: int, start: Ints, entry: Ints) -> Ints:
    """Positions with each column's entry moved to its front, the rest in list order."""
    walked = np.arange(n)
    moved = entry != start
    start, size, entry = start[moved], entry[moved] - start[moved] + 1, entry[moved]
    members = _inside(start, size)  # from the front of the column to its entry
    walked[members] = members - 1
    walked[start] = entry
    return walked


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
