"""A Delaunay triangulation whose border is eaten triangle by triangle: what chi-shape and ec-shape share."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator

import numpy as np

from sketch2shape.errors import PointsError
from sketch2shape.model import Floats, Ints

Edge = tuple[int, int]


def triangulate(points: Floats) -> Ints:
    """(m, 3) Delaunay triangles. Raises PointsError where Qhull cannot triangulate (nearly coincident or collinear)."""
    from scipy.spatial import Delaunay, QhullError

    centred = points - points.mean(axis=0)
    try:
        return np.asarray(Delaunay(centred / np.abs(centred).max()).simplices, dtype=np.intp)
    except QhullError as error:
        raise PointsError("expected points that can be triangulated, got points too nearly on one line") from error


class Border:
    """The border ring of a triangulation, from which triangles can be removed.

    after  : next vertex along the ring, counter-clockwise
    apexes : third vertices of the triangles on each edge that are still there
    """

    def __init__(self, points: Floats, triangles: Ints) -> None:
        """Start from the whole triangulation, whose border is the convex hull."""
        self.points = points
        self.apexes: dict[Edge, list[int]] = {}
        for a, b, c in triangles.tolist():
            for p, q, apex in ((a, b, c), (b, c, a), (c, a, b)):
                self.apexes.setdefault(_key(p, q), []).append(apex)
        self.after: dict[int, int] = {}
        for (a, b), apexes in self.apexes.items():
            if len(apexes) == 1:
                p, q = (a, b) if self._left(a, b, apexes[0]) else (b, a)
                self.after[p] = q

    def _left(self, a: int, b: int, c: int) -> bool:
        (ax, ay), (bx, by), (cx, cy) = self.points[a], self.points[b], self.points[c]
        return bool((bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0)

    def length(self, a: int, b: int) -> float:
        """Length of an edge."""
        return float(np.hypot(*(self.points[b] - self.points[a])))

    def on_border(self, vertex: int) -> bool:
        """Whether a vertex is on the ring."""
        return vertex in self.after

    def apex(self, a: int, b: int) -> int:
        """Third vertex of the triangle behind border edge ab."""
        return self.apexes[_key(a, b)][0]

    def beyond(self, a: int, b: int, apex: int) -> int | None:
        """Third vertex of the triangle on the other side of the inner edge ab as seen from `apex`."""
        others = [c for c in self.apexes[_key(a, b)] if c != apex]
        return others[0] if others else None

    def remove(self, a: int, b: int) -> int:
        """Remove the triangle behind border edge ab; its apex joins the ring."""
        c = self.apex(a, b)
        self.apexes[_key(a, b)].remove(c)
        self.apexes[_key(b, c)].remove(a)
        self.apexes[_key(a, c)].remove(b)
        self.after[a], self.after[c] = c, b
        return c

    def edges_by_length(self) -> Iterator[Edge]:
        """Border edges, longest first, with those that removals add; ties by index, so the answer is repeatable."""
        heap = [(-self.length(a, b), a, b) for a, b in self.after.items()]
        heapq.heapify(heap)
        while heap:
            _, a, b = heapq.heappop(heap)
            yield a, b
            c = self.after[a]
            if c != b:  # removed by the caller
                for p, q in ((a, c), (c, b)):
                    heapq.heappush(heap, (-self.length(p, q), p, q))

    def ring(self) -> Ints:
        """The ring, from its smallest index."""
        start = min(self.after)
        ring = [start]
        while (following := self.after[ring[-1]]) != start:
            ring.append(following)
        return np.array(ring, dtype=np.intp)

    def edge_lengths(self) -> Floats:
        """Lengths of all edges of the triangulation as it is now."""
        pairs = np.array([e for e, apexes in self.apexes.items() if apexes], dtype=np.intp)
        return np.asarray(np.hypot(*(self.points[pairs[:, 0]] - self.points[pairs[:, 1]]).T))


def _key(a: int, b: int) -> Edge:
    return (a, b) if a < b else (b, a)


def eat(border: Border, may_go: Callable[[int, int, int], bool], enough: Callable[[int, int], bool]) -> None:
    """Remove border triangles, the one behind the longest edge first.

    may_go : whether the triangle of border edge ab with apex c may be removed, given that c is not on the border
    enough : whether to stop at border edge ab
    """
    for a, b in border.edges_by_length():
        if enough(a, b):
            return
        c = border.apex(a, b)
        if not border.on_border(c) and may_go(a, b, c):
            border.remove(a, b)
