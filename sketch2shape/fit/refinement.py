"""Joint refinement of all vertices against the ink, under the model's own constraints.

Every edge with ink under it gets the total-least-squares line of the skeleton pixels that are its own; a vertex should
lie on the lines of its edges, and the back face should be the front face under one plane map (`homology`). Both are
linear in the vertices once the map is linearised about the present ones, so a few least-squares steps do.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sketch2shape.geometry import fit_lines, homology, plane_map, thinned
from sketch2shape.hypotheses import Rings, frame, split
from sketch2shape.model import Bools, Floats, Ints

STEPS = 3
"""Least-squares steps at most."""
MOST_POINTS = 1500
"""Skeleton pixels that edges look for their lines in."""
CLAIM_AGAIN = 0.6
"""Way of a vertex, as a part of the reach, after which edges look for their ink anew."""
SETTLED = 0.25
"""Pixels; no step follows one that moves no vertex by more."""
BLUR, FINE = 1.0, 0.15
"""Pixels by which vertices may miss a simpler plane map than the drawing's, and where lines are known exactly."""
EXACT = 0.05
"""Noise of lines, pixels, that no pen on paper and no pixels have: they came as vectors, drawn by a ruler."""
HOLD = 0.03
"""Weight that holds every vertex to where it started, so that the equations are always well posed."""


@dataclass(frozen=True)
class EdgeLines:
    """Lines measured under the edges of a hypothesis.

    edge   : (k,) int, index of the edge
    normal : (k, 2) float, unit normal of its line
    offset : (k,) float, pixels
    weight : (k,) float, 0..1
    spread : (k,) float, rms distance of the pixels from their line
    """

    edge: Ints
    normal: Floats
    offset: Floats
    weight: Floats
    spread: Floats

    @property
    def noise(self) -> float:
        """Rms distance of all edges' pixels from their lines, pixels; 0 without lines."""
        return float(np.sqrt((self.spread**2).mean())) if len(self.spread) else 0.0


def refine(rings: Rings, points: Floats, reach: float, drawn: Bools, stiffness: float = 0.5) -> tuple[Rings, float]:
    """Rings moved to the ink, and the rms distance between model and ink in pixels.

    points    : (k, 2) float, skeleton pixels
    reach     : pixels, how far an edge looks for its ink
    drawn     : (m,) bool, back vertices that ink shows; the others follow from the plane map alone
    stiffness : weight of the plane map against the ink
    """
    edges = frame(rings.sizes).edges
    start = v = rings.vertices
    points = points[thinned(len(points), MOST_POINTS)]
    noise, strayed = 0.0, np.inf
    for step in range(STEPS):
        if strayed > CLAIM_AGAIN * reach:
            claims, strayed = _claims(v, edges, points, (CLAIM_AGAIN + 0.7) * reach), 0.0
        lines = _measure(v, edges, points, claims, reach if step == 0 else 0.7 * reach)
        noise = lines.noise
        moved = _solve(v, start, edges, lines, drawn, stiffness)
        # a seen vertex that runs away has lost its lines: keep it where verification found it
        far = np.hypot(*(moved - start).T) > 3 * reach + 4
        far[len(drawn) :] &= drawn
        moved[far] = start[far]
        by = float(np.abs(moved - v).max())
        v, strayed = moved, strayed + by
        if by < SETTLED:
            break
    return split(v, rings.sizes), noise


class _Claims(NamedTuple):
    """Which edges could claim which points: pairs in the order of the points."""

    point: Ints
    edge: Ints


def _claims(v: Floats, edges: Ints, points: Floats, reach: float) -> _Claims:
    """All points that lie beside an edge, no further than reach pixels off."""
    # single precision places a point to a thousandth of a pixel, in half the time
    p, ends = points.astype(np.float32), v[edges].astype(np.float32)
    middle, half = (ends[:, 0] + ends[:, 1]) / 2, (ends[:, 1] - ends[:, 0]) / 2
    length = np.hypot(half[:, 0], half[:, 1]) + np.float32(1e-9)
    u = half / length[:, None]
    normal = np.stack([-u[:, 1], u[:, 0]], axis=1)
    along = np.abs(p @ u.T - (middle * u).sum(axis=1))
    across = np.abs(p @ normal.T - (middle * normal).sum(axis=1))
    point, edge = np.divmod(np.flatnonzero((across <= reach) & (along < length)), len(edges))
    return _Claims(point, edge)


def _measure(v: Floats, edges: Ints, points: Floats, claims: _Claims, reach: float) -> EdgeLines:
    """The line under every edge that has enough ink of its own."""
    a, span = v[edges[:, 0]], v[edges[:, 1]] - v[edges[:, 0]]
    length = np.hypot(span[:, 0], span[:, 1]) + 1e-9
    u = span / length[:, None]
    point, edge = claims
    to, way = points[point] - a[edge], u[edge]
    along = to[:, 0] * way[:, 0] + to[:, 1] * way[:, 1]
    across = np.abs(to[:, 0] * way[:, 1] - to[:, 1] * way[:, 0])
    end = np.minimum(1.5 * reach, 0.2 * length)
    inside = np.flatnonzero((across <= reach) & (along > end[edge]) & (along < (length - end)[edge]))
    point, edge, across = point[inside], edge[inside], across[inside]
    # ink that two nearly parallel edges could claim tells nothing about either; at a crossing it does no harm
    if len(point):
        first = np.flatnonzero(np.diff(point, prepend=-1))
        nearest = np.minimum.reduceat(across, first)
        own = across <= np.repeat(nearest, np.diff(first, append=len(point)))
        point, edge = point[own], edge[own]
    count = np.bincount(edge, minlength=len(edges))
    # skeleton pixels per pixel of length, as the points may have been thinned out
    density = min(1.0, 1.5 * len(points) / float(length.sum()))
    rich = count >= np.maximum(4.0, 0.2 * length * density)
    centre, direction, spread = _lines_through(points[point], edge, len(edges))
    e = np.flatnonzero(rich & (np.abs((direction * u).sum(axis=1)) >= 0.9))
    normal = np.stack([-direction[e, 1], direction[e, 0]], axis=1)
    offset = (normal * centre[e]).sum(axis=1)
    return EdgeLines(e, normal, offset, np.minimum(1.0, count[e] / 20), spread[e])


def _lines_through(points: Floats, edge: Ints, count: int) -> tuple[Floats, Floats, Floats]:
    """Total-least-squares line of each edge's points: centre (m, 2), direction (m, 2), rms distance (m,), pixels.

    points, edge : (k, 2) and (k,), each point and the edge it belongs to, of `count` edges
    """
    origin = points.sum(axis=0) / max(len(points), 1)
    x, y = (points - origin).T
    weights = (np.ones(len(x)), x, y, x * x, y * y, x * y)
    sums = np.stack([np.bincount(edge, w, count) for w in weights], axis=1).astype(float)
    sums[:, 0] = np.maximum(sums[:, 0], 1.0)
    centre, direction, spread = fit_lines(sums)
    return centre + origin, direction, spread


def _solve(v: Floats, start: Floats, edges: Ints, lines: EdgeLines, drawn: Bools, stiffness: float) -> Floats:
    """One linear least-squares step for all vertices."""
    m, k = len(v) // 2, len(lines.edge)
    # both ends of an edge lie on its line
    a = np.zeros((2 * k + 2 * m, 4 * m))
    ends = edges[lines.edge].T.reshape(-1)
    own = np.tile(lines.normal * lines.weight[:, None], (2, 1))
    rows = np.arange(2 * k)
    a[rows, 2 * ends], a[rows, 2 * ends + 1] = own[:, 0], own[:, 1]
    b = np.empty(2 * k + 2 * m)
    b[: 2 * k] = np.tile(lines.weight * lines.offset, 2)
    # the back is the front under the map; a clean drawing tells a similarity from a homology, a rough one does not
    limit = (BLUR if lines.noise > EXACT else FINE) + 2.0 * lines.noise if k else None
    h = plane_map(v[:m], v[m:], drawn, limit)
    image, slope = homology.apply(h, v[:m]), _jacobian(h, v[:m])
    tied = 2 * k + np.arange(2 * m)
    vertex = np.repeat(np.arange(m), 2)
    a[tied, 2 * m + np.arange(2 * m)] = stiffness
    a[tied, 2 * vertex], a[tied, 2 * vertex + 1] = (-stiffness * slope.reshape(-1, 2)).T
    b[2 * k :] = (stiffness * (image - (slope * v[:m, None]).sum(axis=2))).ravel()
    normal = a.T @ a
    normal.flat[:: 4 * m + 1] += HOLD**2
    free = np.asarray(np.linalg.solve(normal, a.T @ b + HOLD**2 * start.ravel()), float).reshape(-1, 2)
    if not drawn.all():
        free[m:][~drawn] = homology.apply(plane_map(free[:m], free[m:], drawn, limit), free[:m])[~drawn]
    return np.where(np.isfinite(free), free, v)


def on_map(rings: Rings, drawn: Bools, least: float) -> list[Rings]:
    """The rings with the pair of vertices that fits the plane map worst put right, at the back or at the front.

    least : pixels; a pair that misses the map of all others by less, or by hardly more than others do, is left alone
    """
    vertices, m = rings.vertices, len(drawn)
    seen = np.flatnonzero(drawn)
    if len(seen) < 4:
        return []
    off = np.full(m, -1.0)
    off[seen] = _misses(vertices[:m], vertices[m:], drawn)[seen]
    worst = int(off.argmax())
    others = drawn.copy()
    others[worst] = False
    h = plane_map(vertices[:m], vertices[m:], others, least)
    misses = np.linalg.norm(homology.apply(h, vertices[:m]) - vertices[m:], axis=1)
    if not misses[worst] > max(least, 3.0 * float(np.median(misses[others]))):
        return []
    ways = []
    for at, other, way in ((m + worst, worst, h), (worst, m + worst, np.asarray(np.linalg.inv(h), float))):
        put = vertices.copy()
        put[at] = homology.apply(way, vertices[other : other + 1])[0]
        if np.isfinite(put).all():
            ways.append(split(put, rings.sizes))
    return ways


def _misses(front: Floats, back: Floats, drawn: Bools) -> Floats:
    """(m,) float, pixels: by how much each vertex misses the similarity through all drawn ones."""
    h = homology.similarity(front[drawn], back[drawn])
    return np.asarray(np.linalg.norm(homology.apply(h, front) - back, axis=1))


def _jacobian(h: Floats, points: Floats) -> Floats:
    """(k, 2, 2) derivative of the plane map at points."""
    q = points @ h[:, :2].T + h[:, 2]
    w = q[:, 2, None, None]
    return np.asarray((h[None, :2, :2] - (q[:, :2, None] / w) * h[None, 2:, :2]) / w)
