"""Neighbours: hypotheses that differ from another by one vertex.

A thick pen, a careless hand, a mark at a corner: the sources then put a vertex on the wrong corner, leave one out or
add one. From a hypothesis that explains a part of the drawing the search climbs to better ones, a vertex at a time
(steepest ascent; S. Russell, P. Norvig, "Artificial Intelligence", section on local search).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import permutations
from typing import TypeAlias

import numpy as np

from sketch2shape.evidence import Evidence, Sheet, judge_stack, most_possible
from sketch2shape.geometry import cross, homology
from sketch2shape.hypotheses import Rings, Stack, split, stack, which_plausible
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.search.shortlist import Judged

MOST_CLIMBED = 6
"""Steps of a climb."""
FARTHEST = 0.2
"""Way of a vertex in one step, as a fraction of the drawing's size."""
CHAMFER = 0.4
"""Way of a vertex that becomes two, over that of one that moves."""
BENT = 1.5
"""Distance of an added vertex from its edge, over the reach of a line: one on the edge is where a foreign line ends."""
NEAREST = 6
"""Corners that are tried for a vertex, the nearest."""
VERTEX = 0.012
"""Score that a vertex has to bring: a little more than simplification gives for one."""
GAIN = 0.003
"""Score that a step has to bring."""
MOST_VERTICES = 12
"""Vertices of a face from which no search climbs: with more of them a curve is a polygon."""
SMALLEST, LARGEST = 0.4, 2.5
"""Size of the back face over the front face's where its hidden vertices are placed."""
MOVED = 1.0
"""Pixels by which a vertex has to move to be elsewhere."""


_Neighbours: TypeAlias = Callable[[Rings, Evidence, Floats, Sheet], Iterator[Stack]]


def climbed(known: list[Judged], sheet: Sheet, corners: Floats) -> list[Judged]:
    """A better hypothesis than the best one known, if there is one; corners (k, 2): where vertices may be, pixels."""
    start = next((judged for judged in known if max(judged[0].sizes) <= MOST_VERTICES), None)
    top = None if start is None else _climbed(start, sheet, corners, neighbours)
    return [] if top is None else [top]


def grown(best: Judged, sheet: Sheet, corners: Floats) -> list[Judged]:
    """The hypothesis with as many more vertices as it gains by, if any; corners (k, 2): where they may be, pixels."""
    top = _climbed(best, sheet, corners, _with_one_more)
    return [] if top is None else [top]


def _climbed(best: Judged, sheet: Sheet, corners: Floats, kinds: _Neighbours) -> Judged | None:
    """The top of the climb from a hypothesis, if there is one; faces with holes stay as they are."""
    found = None
    for _ in range(MOST_CLIMBED if len(best[0].sizes) == 1 and len(corners) else 0):
        above = [_best_of(moves, sheet, _worth(best)) for moves in kinds(*best, corners, sheet)]
        higher = [judged for judged in above if judged is not None]
        if not higher:
            break
        best = max(higher, key=_worth)
        found = best
    return found


def _worth(judged: Judged) -> float:
    return judged[1].score - VERTEX * len(judged[1].drawn)


def _best_of(moves: Stack, sheet: Sheet, worth: float) -> Judged | None:
    """The best of some hypotheses, if it is clearly worth more."""
    least = worth + GAIN + VERTEX * sum(moves.sizes)
    some = moves.some(np.flatnonzero(which_plausible(moves, 1.5 * sheet.pen)))
    if not len(some):
        return None
    some = some.some(np.flatnonzero(most_possible(some, sheet) >= least))
    if not len(some):
        return None
    judged = judge_stack(some, sheet)
    k = max(range(len(judged)), key=lambda k: judged[k].score)
    return (split(some.vertices[k], some.sizes), judged[k]) if judged[k].score >= least else None


def neighbours(rings: Rings, evidence: Evidence, corners: Floats, sheet: Sheet) -> Iterator[Stack]:
    """Hypotheses with a vertex elsewhere, one less, or one more; of faces without holes, one stack for each kind.

    corners : (k, 2) float, pixels, k >= 1: where vertices may be
    """
    front, back = rings.front[0], rings.back[0]
    n = len(front)
    yield _moved(front, back, evidence.drawn, corners, FARTHEST * sheet.size)
    if n > 3:
        yield stack([Rings((np.delete(front, i, 0),), (np.delete(back, i, 0),)) for i in range(n)])
    yield from _with_one_more(rings, evidence, corners, sheet)


def _with_one_more(rings: Rings, _: Evidence, corners: Floats, sheet: Sheet) -> Iterator[Stack]:
    """Hypotheses with an edge that goes by way of a corner beside it, or with two corners for a vertex: a chamfer."""
    front, back = rings.front[0], rings.back[0]
    n, far, least = len(front), FARTHEST * sheet.size, BENT * sheet.reach
    after = np.roll(np.arange(n), -1)
    span = front[after] - front
    length = np.hypot(*span.T)
    edge, by = _near((front + front[after]) / 2, corners, np.maximum(0.75 * length, far))
    is_bent = np.abs(cross(corners[by] - front[edge], span[edge])) > least * length[edge]
    way = back - front
    more = [
        Rings((np.insert(front, i + 1, c, 0),), (np.insert(back, i + 1, c + (way[i] + way[after[i]]) / 2, 0),))
        for i, c in zip(edge[is_bent].tolist(), corners[by[is_bent]], strict=True)
    ]
    vertex, near = _near(front, corners, np.full(n, CHAMFER * far))
    for i in range(n):
        for p, q in permutations(corners[near[vertex == i]], 2):
            cut = np.insert(front, i, p, 0)
            cut[i + 1] = q
            ways = np.insert(way, i, way[i], 0)
            more.append(Rings((cut,), (cut + ways,)))
    if more and n < MOST_VERTICES:
        yield stack(more)


def _moved(front: Floats, back: Floats, seen: Bools, corners: Floats, far: float) -> Stack:
    """Hypotheses with one vertex, or a connecting edge, elsewhere; hidden vertices follow."""
    n = len(front)
    i, c = _near(front, corners, np.full(n, far))
    j, d = _near(back, corners, np.full(n, far))
    count = 2 * len(i) + len(j) + n
    fronts, backs = np.repeat(front[None], count, 0), np.repeat(back[None], count, 0)
    shown = np.repeat(seen[None], count, 0)
    alone, along = np.arange(len(i)), len(i) + np.arange(len(i))
    behind, lost = 2 * len(i) + np.arange(len(j)), count - n + np.arange(n)
    fronts[alone, i] = fronts[along, i] = corners[c]
    backs[along, i] += corners[c] - front[i]
    backs[behind, j] = corners[d]
    shown[behind, j] = True
    shown[lost, np.arange(n)] = False
    return Stack(np.concatenate([fronts, _completed(fronts, backs, shown)], axis=1), (n,))


def _near(points: Floats, corners: Floats, far: Floats) -> tuple[Ints, Ints]:
    """Pairs of a point and a corner near it, no further off than far (one for each point), by their numbers."""
    gap = np.hypot(*np.moveaxis(points[:, None] - corners, -1, 0))
    order = np.argsort(gap, axis=1)[:, :NEAREST]
    near = np.take_along_axis(gap, order, axis=1)
    point, rank = np.nonzero((near <= far[:, None]) & (near > MOVED))
    return point, order[point, rank]


def _completed(front: Floats, back: Floats, seen: Bools) -> Floats:
    """Back faces (k, n, 2) whose vertices that are not seen (k, n) lie where the best similarity has them."""
    placed = homology.apply(homology.similarity_of_seen(front, back, seen, SMALLEST, LARGEST), front)
    hidden = ~seen & seen.any(axis=1, keepdims=True)
    return np.asarray(np.where(hidden[..., None], placed, back))
