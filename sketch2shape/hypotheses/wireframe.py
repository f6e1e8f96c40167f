"""Face separator for drawings in which all edges are drawn: which corners form f1 and which f2.

Strategy. A connecting edge is a rung between the two faces, and all rungs obey one plane map (`homology`). Maps are
guessed from one rung (translation), two neighbouring rungs (similarity) or three (homology), and scored by how many
inked segments between corners they carry onto each other. Under a map every corner pair (c, H c) with ink between is a
rung; two rungs are neighbours if both face edges between them are inked. The faces are the simple cycles of that
graph: rungs of one object form a closed ladder.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice

import cv2
import numpy as np

from sketch2shape.geometry import homology
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.model import Bools, Floats, Ints

LIKELY_MAPS = 400
"""Maps looked at closely, those that carry the most rungs."""
MOST_RUNGS = 800
"""A scribble, in which nearly every two corners have ink between them, is no wireframe; drawings have a few hundred."""
RUNGS_OF_A_CORNER = 5
"""Where there are very many corners, so many rungs to a corner are allowed: a vertex of a wireframe has three."""


@dataclass(frozen=True)
class CornerGraph:
    """Corners and the ink between them.

    points    : (k, 2) float, pixels
    inked     : (k, k) bool, symmetric, whether the straight segment between two corners is drawn
    tolerance : pixels by which a corner may be misplaced
    """

    points: Floats
    inked: Bools
    tolerance: float


@dataclass(frozen=True)
class Ladder:
    """Rungs under one map.

    map   : (3, 3) float, carries f1 onto f2
    rungs : (m, 2) int, corner of f1 and corner of f2
    links : (m, m) bool, rungs joined by an inked edge in both faces
    """

    map: Floats
    rungs: Ints
    links: Bools


def ladders(graph: CornerGraph, most: int = 12) -> Iterator[Ladder]:
    """Candidate ladders: of translations first, then of similarities, then of homologies; each the richest first."""
    rungs = np.argwhere(graph.inked)
    if not 6 <= len(rungs) <= max(MOST_RUNGS, RUNGS_OF_A_CORNER * len(graph.points)):
        return
    links = _links(graph, rungs)
    seen: set[bytes] = set()
    for guess in (_from_one, _from_two, _from_three):
        maps = _best_maps(graph, rungs, links, guess(graph, rungs, links), 2 * most)
        rich = sorted(_closed(graph, rungs, links, maps), key=lambda x: -len(x.rungs))
        for ladder in rich[:most]:
            key = ladder.rungs.tobytes()
            if key not in seen:
                seen.add(key)
                yield ladder


def _links(graph: CornerGraph, rungs: Ints) -> Bools:
    """(m, m): whether rungs (a, a') and (b, b') have ink from a to b and from a' to b'."""
    a, b = rungs[:, 0], rungs[:, 1]
    return np.asarray(graph.inked[np.ix_(a, a)] & graph.inked[np.ix_(b, b)])


def _from_one(graph: CornerGraph, rungs: Ints, links: Bools) -> Floats:
    """A translation for each rung that has two neighbours; of a rung and its reverse, one."""
    some = (links.sum(axis=1) >= 2) & (rungs[:, 0] < rungs[:, 1])
    return homology.translation(graph.points[rungs[some, 1]] - graph.points[rungs[some, 0]])


def _from_two(graph: CornerGraph, rungs: Ints, links: Bools, most: int = 1200) -> Floats:
    """A similarity for each pair of linked rungs whose face edges are parallel."""
    i, j = np.nonzero(np.triu(links, 1))
    p = graph.points
    u = p[rungs[j, 0]] - p[rungs[i, 0]]
    v = p[rungs[j, 1]] - p[rungs[i, 1]]
    cross = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    lu, lv = np.linalg.norm(u, axis=1), np.linalg.norm(v, axis=1)
    slack = 0.03 * lu * lv + 1.5 * graph.tolerance * np.minimum(lu, lv)
    ok = (cross <= slack) & ((u * v).sum(axis=1) > 0) & (rungs[i, 0] < rungs[i, 1])
    i, j = i[ok][:most], j[ok][:most]
    src = p[np.stack([rungs[i, 0], rungs[j, 0]], axis=1)]
    dst = p[np.stack([rungs[i, 1], rungs[j, 1]], axis=1)]
    return homology.similarity(src, dst) if len(i) else np.zeros((0, 3, 3))


def _from_three(graph: CornerGraph, rungs: Ints, links: Bools, most: int = 2000) -> Floats:
    """A homology for each chain of three linked rungs."""
    chain = _chains(rungs, links)
    if not len(chain):
        return np.zeros((0, 3, 3))
    src, dst = graph.points[rungs[chain, 0]], graph.points[rungs[chain, 1]]
    ok = (_spread(src) > 3 * graph.tolerance) & (_spread(dst) > 3 * graph.tolerance)
    ok &= _same_turn(src, dst)
    step = max(1, int(ok.sum()) // most)
    src, dst = src[ok][::step], dst[ok][::step]
    return homology.homology(src, dst) if len(src) else np.zeros((0, 3, 3))


def _chains(rungs: Ints, links: Bools, widest: int = 12) -> Ints:
    """(k, 3): rungs in a row, all six corners different but for one that may serve in both faces."""
    middle = np.flatnonzero(rungs[:, 0] < rungs[:, 1])
    of, near = np.nonzero(links[middle])
    # each middle rung's neighbours in a row, the first few of them
    rank = np.arange(len(of)) - np.searchsorted(of, of)
    some = rank < widest
    beside = np.full((len(middle), widest), -1)
    beside[of[some], rank[some]] = near[some]
    a, b = np.triu_indices(widest, 1)
    first, last = beside[:, a], beside[:, b]
    row, column = np.nonzero(last >= 0)
    chain = np.stack([first[row, column], middle[row], last[row, column]], axis=1)
    ends = rungs[chain]
    ok = (ends[:, 0] != ends[:, 2]).all(axis=1) & (ends[:, 0] != ends[:, 1]).all(axis=1)
    return np.asarray(chain[ok & (ends[:, 1] != ends[:, 2]).all(axis=1)])


def _turn(t: Floats) -> Floats:
    u, v = t[:, 1] - t[:, 0], t[:, 2] - t[:, 1]
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


def _spread(t: Floats) -> Floats:
    """Height of each triangle over its longest side."""
    longest = np.linalg.norm(t - np.roll(t, 1, axis=1), axis=2).max(axis=1)
    return np.asarray(np.abs(_turn(t)) / (longest + 1e-9))


def _same_turn(src: Floats, dst: Floats) -> Bools:
    return np.asarray(np.sign(_turn(src)) == np.sign(_turn(dst)))


def _matches(graph: CornerGraph, rungs: Ints, maps: Floats) -> Bools:
    """(maps, rungs): whether the map carries the rung's first corner onto its second."""
    image = homology.apply(maps, graph.points).astype(np.float32)
    first, (x, y) = rungs[:, 0], graph.points[rungs[:, 1]].T.astype(np.float32)
    with np.errstate(invalid="ignore", over="ignore"):
        dx = image[..., 0].take(first, axis=1)
        dx -= x
        dy = image[..., 1].take(first, axis=1)
        dy -= y
        dx *= dx
        dy *= dy
        dx += dy
        return np.asarray(dx <= graph.tolerance**2)


def _best_maps(graph: CornerGraph, rungs: Ints, links: Bools, maps: Floats, most: int) -> Floats:
    """The maps with the most linked rungs, one of each kind."""
    hits = _matches(graph, rungs, maps)
    likely = np.argsort(-hits.sum(axis=1), kind="stable")[:LIKELY_MAPS]
    hits = hits[likely]
    linked = hits & ((hits.astype(np.float32) @ links.astype(np.float32)) >= 2)
    starts = np.zeros((len(rungs), len(graph.points)), np.float32)
    starts[np.arange(len(rungs)), rungs[:, 0]] = 1
    count = ((linked.astype(np.float32) @ starts) > 0).sum(axis=1)
    keys = np.packbits(linked, axis=1)
    kept: list[int] = []
    seen: set[bytes] = set()
    for k in np.argsort(-count, kind="stable"):
        if count[k] < 3 or len(kept) >= most:
            break
        key = keys[k].tobytes()
        if key not in seen:
            seen.add(key)
            kept.append(int(likely[k]))
    return maps[kept]


def _closed(graph: CornerGraph, rungs: Ints, links: Bools, maps: Floats) -> list[Ladder]:
    """Refit each map to all its rungs, take its rungs again, and drop those that cannot be part of a cycle."""
    for _ in range(2):
        mine = _pruned(_matches(graph, rungs, maps), links)
        some = mine.sum(axis=1) >= 3
        maps, mine = maps[some], mine[some]
        maps = _refitted(graph, rungs, mine, maps)
    mine = _pruned(_matches(graph, rungs, maps), links)
    index = [np.flatnonzero(own) for own in mine]
    return [Ladder(h, rungs[i], links[np.ix_(i, i)]) for h, i in zip(maps, index, strict=True) if len(i) >= 3]


def _pruned(mine: Bools, links: Bools) -> Bools:
    """(maps, rungs), without rungs that have fewer than two neighbours, again and again."""
    weights = links.astype(np.float32)
    while True:
        left = mine & ((mine.astype(np.float32) @ weights) >= 2)
        if (left == mine).all():
            return mine
        mine = left


def _refitted(graph: CornerGraph, rungs: Ints, mine: Bools, maps: Floats) -> Floats:
    """For each map the simplest kind that fits its rungs, mine (maps, rungs)."""
    src, dst = graph.points[rungs[:, 0]], graph.points[rungs[:, 1]]
    limit = 0.6 * graph.tolerance
    fitted = maps.copy()
    todo = np.arange(len(maps))
    for fit in (_translations, _similarities, _homologies):
        if not len(todo):
            break
        own = mine[todo]
        found = fit(src, dst, own)
        off = homology.apply(found, src) - dst
        fits = np.where(own, np.hypot(off[..., 0], off[..., 1]), 0.0).max(axis=1, initial=0.0) <= limit
        fitted[todo[fits]] = found[fits]
        todo = todo[~fits]
    return fitted


def _translations(src: Floats, dst: Floats, mine: Bools) -> Floats:
    weight = mine / mine.sum(axis=1, keepdims=True)
    return homology.translation(weight @ (dst - src))


def _similarities(src: Floats, dst: Floats, mine: Bools) -> Floats:
    weight = mine / mine.sum(axis=1, keepdims=True)
    p, q = weight @ src, weight @ dst
    along = weight @ (src * dst).sum(axis=1) - (p * q).sum(axis=1)
    within = weight @ (src * src).sum(axis=1) - (p * p).sum(axis=1)
    scale = np.maximum(along / (within + 1e-12), 1e-3)
    maps = homology.translation(q - scale[:, None] * p)
    maps[:, 0, 0] = maps[:, 1, 1] = scale
    return maps


def _homologies(src: Floats, dst: Floats, mine: Bools) -> Floats:
    """Identities, which fit nothing, where there are too few rungs."""
    maps = np.tile(np.eye(3), (len(mine), 1, 1))
    some = mine.sum(axis=1) >= 4
    if some.any():
        maps[some] = homology.homology(src, dst, mine[some].astype(float))
    return maps


def likely_cycles(ladder: Ladder, graph: CornerGraph, budget: int, steps: Iterator[int]) -> Iterator[Ints]:
    """Cycles without links that run on through a rung between, then, where there are such links, all cycles.

    budget : most steps of one search
    steps  : what is left of the steps for all ladders
    """
    through = _runs_through(ladder, graph)
    if through.any():
        yield from cycles(replace(ladder, links=ladder.links & ~through), islice(steps, budget))
    yield from cycles(ladder, islice(steps, budget))


def _runs_through(ladder: Ladder, graph: CornerGraph) -> Bools:
    """(m, m): links that pass a third rung's corner in both faces, where that rung is linked to both ends."""
    links, m = ladder.links, len(ladder.rungs)
    through = np.zeros((m, m), bool)
    faces = [graph.points[ladder.rungs[:, f]] for f in (0, 1)]
    if m > 60:
        return through
    k, j = np.nonzero(np.triu(links, 1))
    between = links[k] & links[j]
    for p in faces:
        span = p[j] - p[k]
        length = np.linalg.norm(span, axis=1)[:, None] + 1e-9
        q = p[None] - p[k][:, None]
        along = (q * span[:, None]).sum(axis=2) / length
        across = np.abs(q[..., 0] * span[:, None, 1] - q[..., 1] * span[:, None, 0]) / length
        between &= (across < 0.6 * graph.tolerance) & (along > 1e-6) & (along < length - 1e-6)
    through[k, j] = through[j, k] = between.any(axis=1)
    return through


def cycles(ladder: Ladder, steps: Iterator[int]) -> Iterator[Ints]:
    """Simple cycles of rungs, (n,) indices into ladder.rungs; the search ends when there are no steps left.

    No corner serves twice in one face; one may serve once in each (coincident vertices). The first corners taken are
    those of rungs with the fewest neighbours, where there is least to choose.
    """
    order = np.argsort(ladder.links.sum(axis=1), kind="stable")
    rank = np.empty(len(order), np.intp)
    rank[order] = np.arange(len(order))
    near = [[int(k) for k in np.flatnonzero(row)] for row in ladder.links]
    taken = [(1 << int(a), 1 << int(b)) for a, b in ladder.rungs]
    for start in order.tolist():
        # each cycle is found one way round, the one that does not begin at the last neighbour
        ahead = [k for k in near[start] if rank[k] > rank[start]]
        stack = [(start, (start,), *taken[start])]
        while stack:
            node, path, front, back = stack.pop()
            if next(steps, None) is None:
                return
            for after in ahead[:-1] if node == start else near[node]:
                if after == start and len(path) >= 3 and path[1] < path[-1]:
                    yield np.array(path)
                    continue
                a, b = taken[after]
                if rank[after] > rank[start] and not front & a and not back & b:
                    stack.append((after, (*path, after), front | a, back | b))


def ring_pair(ladder: Ladder, graph: CornerGraph, cycle: Ints) -> Rings:
    """The two rings of a cycle of rungs."""
    pair = ladder.rungs[cycle]
    return Rings((graph.points[pair[:, 0]],), (graph.points[pair[:, 1]],))


def with_holes(outer: Rings, others: list[Rings]) -> Rings | None:
    """The outer rings with every other pair that lies inside both of them as a hole, the largest first."""
    front, back = [*outer.front], [*outer.back]
    for other in sorted(others, key=lambda r: -_area(r.front[0])):
        a, b = other.front[0], other.back[0]
        if _inside(a, front[0]) and _inside(b, back[0]) and not any(_overlap(a, f) for f in front[1:]):
            front.append(a)
            back.append(b)
    return Rings(tuple(front), tuple(back)) if len(front) > 1 else None


def _area(ring: Floats) -> float:
    return float(cv2.contourArea(ring.astype(np.float32)))


def _inside(points: Floats, ring: Floats) -> bool:
    contour = ring.astype(np.float32)[:, None]
    return all(cv2.pointPolygonTest(contour, (float(x), float(y)), True) > 1 for x, y in points)


def _overlap(a: Floats, b: Floats) -> bool:
    """Whether a vertex of one ring lies in or on the other."""
    pairs = ((a, b), (b, a))
    return any(
        cv2.pointPolygonTest(ring.astype(np.float32)[:, None], (float(x), float(y)), False) >= 0
        for points, ring in pairs
        for x, y in points
    )
