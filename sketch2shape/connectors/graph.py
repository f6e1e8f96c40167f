"""From a graph of edges to one ring: for methods that answer with edges rather than an order."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from sketch2shape.model import Floats, Ints

Neighbours = dict[int, set[int]]


def neighbours_of(edges: Ints) -> Neighbours:
    """Adjacency of an edge list (k, 2)."""
    graph: Neighbours = defaultdict(set)
    for a, b in edges.tolist():
        graph[a].add(b)
        graph[b].add(a)
    return dict(graph)


def single_cycle(edges: Ints) -> Ints | None:
    """The ring if the edges form exactly one cycle, else None."""
    graph = neighbours_of(edges)
    if not graph or any(len(beside) != 2 for beside in graph.values()):
        return None
    ring = _follow(graph, min(graph))
    return ring if len(ring) == len(graph) else None


def _follow(graph: Neighbours, start: int) -> Ints:
    """The cycle through `start` in a graph whose vertices all have two neighbours."""
    ring, previous, current = [start], start, min(graph[start])
    while current != start:
        ring.append(current)
        a, b = graph[current]
        previous, current = current, (b if a == previous else a)
    return np.array(ring, dtype=np.intp)


def widest_ring(points: Floats, edges: Ints) -> tuple[Ints, tuple[str, ...]]:
    """One ring out of a planar graph, and in words what it had to leave.

    Strategy: cut dangling edges; if one cycle is left that is it. Otherwise walk along the outer side of each part
    and keep the walk over most vertices.
    """
    graph = neighbours_of(edges)
    dangling = _cut_dangling(graph)
    if not graph:
        return np.empty(0, dtype=np.intp), ("the edges enclose nothing",)
    said = ["some edges dangle"] if dangling else []
    rings = [_outer_walk(points, graph, part) for part in _parts(graph)]
    if len(rings) > 1:
        said.append(f"the edges fall into {len(rings)} parts")
    if any(len(beside) > 2 for beside in graph.values()):
        said.append("the edges branch")
    best = max(rings, key=len)
    if len(best) < len(points):
        said.append(f"{len(points) - len(best)} points were left out")
    return best, tuple(said)


def _cut_dangling(graph: Neighbours) -> bool:
    ends = [v for v, beside in graph.items() if len(beside) < 2]
    found = bool(ends)
    while ends:
        v = ends.pop()
        for w in graph.pop(v, set()):
            graph[w].discard(v)
            if len(graph[w]) < 2:
                ends.append(w)
    return found


def _parts(graph: Neighbours) -> list[list[int]]:
    parts, seen = [], set[int]()
    for start in sorted(graph):
        if start in seen:
            continue
        part, todo = [], [start]
        seen.add(start)
        while todo:
            v = todo.pop()
            part.append(v)
            fresh = graph[v] - seen
            seen |= fresh
            todo.extend(fresh)
        parts.append(part)
    return parts


def _outer_walk(points: Floats, graph: Neighbours, part: list[int]) -> Ints:
    """Walk around a part with the outside always on one hand; each vertex once."""
    start = min(part, key=lambda i: (points[i, 0], points[i, 1]))
    order, current, arm = [start], start, np.pi
    first: tuple[int, int] | None = None
    while True:
        beside = sorted(graph[current])
        vectors = points[beside] - points[current]
        swept = np.mod(arm - np.arctan2(vectors[:, 1], vectors[:, 0]), 2 * np.pi)
        swept[swept < 1e-12] = 2 * np.pi
        following = beside[int(np.argmin(swept))]
        if first == (current, following):
            return np.array(list(dict.fromkeys(order)), dtype=np.intp)
        first = first or (current, following)
        order.append(following)
        arm = float(np.arctan2(*(points[current] - points[following])[::-1]))
        current = following
