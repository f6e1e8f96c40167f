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
5. *Face connection*: see `sketch2shape.connectors.two_faces`.

Linear after the sort, whose integer keys are compared in registers. The answer is the polygon only if both its chains
between the leftmost and the rightmost vertex are x-monotone and the split puts each of them in a region of its own:
`split_walk_preconditions` checks that for an order that is known.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.points import check_distinct
from sketch2shape.connectors.sorting import sorted_pieces
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
    walk, split = _columns(axis)
    order, columns_tied, middle_empty = _order(points[:, walk], points[:, split])
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


def _order(x: Floats, y: Floats) -> tuple[Ints, bool, bool]:
    """The ring order, whether a region had ties, and whether r1 is the seed alone.

    Piece by piece, so that what is worked on stays in the processor's caches: all that a walk needs to go on in the
    next piece is where it is. r1 fills the order from the front, r2 from the back.
    """
    middle = float(y.mean())
    order = np.empty(len(x), dtype=np.intp)
    taken, tied, here = [0, 0], False, list[tuple[float, float]]()
    for members, xs, ys in sorted_pieces(x, y):
        if _equal_neighbours(xs, ys):
            check_distinct(np.column_stack((x, y)))
        first = ys <= middle
        if not here:
            first[0] = True  # the seed is in r1, wherever it lies
            here = [(float(xs[0]), float(ys[0]))] * 2
        for k, region in enumerate((first, ~first)):
            chain, across, up = members[region], xs[region], ys[region]
            if not len(chain):
                continue
            walked = _walk(across, up, seed=here[k])
            tied |= walked is not None
            here[k] = (float(across[-1]), float(up[-1 if walked is None else walked[-1]]))
            _fill(order, chain if walked is None else chain[walked], taken[k], backwards=k == 1)
            taken[k] += len(chain)
    return order, tied, taken[0] == 1


def _fill(order: Ints, chain: Ints, taken: int, *, backwards: bool) -> None:
    """Write a chain into the order, after `taken` places from the front, or backwards before those from the end."""
    if backwards:
        end = len(order) - taken
        order[end - len(chain) : end] = chain[::-1]
    else:
        order[taken : taken + len(chain)] = chain


def _equal_neighbours(xs: Floats, ys: Floats) -> bool:
    return bool(((xs[1:] == xs[:-1]) & (ys[1:] == ys[:-1])).any())


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
