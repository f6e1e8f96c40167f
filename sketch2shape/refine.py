"""Joint refinement of all vertices against the ink, under the model's own constraints.

Every edge with ink under it gets the total-least-squares line of the skeleton pixels that are its own; a vertex should
lie on the lines of its edges, and the back face should be the front face under one plane map (`homology`). Both are
linear in the vertices once the map is linearised about the present ones, so a few least-squares steps do.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sketch2shape import homology
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.rings import Rings, frame, split
from sketch2shape.strokes import fit_lines, project, thinned

STEPS = 3
MOST_POINTS = 1500
MAP_STEP = 0.02
"""Misfit, as a part of the object's size, that justifies the next richer kind of plane map."""
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
    noise = 0.0
    for step in range(STEPS):
        lines = _measure(v, edges, points, reach if step == 0 else 0.7 * reach)
        noise = lines.noise
        moved = _solve(v, start, edges, lines, drawn, stiffness)
        # a seen vertex that runs away has lost its lines: keep it where verification found it
        far = np.linalg.norm(moved - start, axis=1) > 3 * reach + 4
        far[len(drawn) :] &= drawn
        moved[far] = start[far]
        v = moved
    return split(v, rings.sizes), noise


def _measure(v: Floats, edges: Ints, points: Floats, reach: float) -> EdgeLines:
    """The line under every edge that has enough ink of its own."""
    a, span = v[edges[:, 0]], v[edges[:, 1]] - v[edges[:, 0]]
    length = np.linalg.norm(span, axis=1) + 1e-9
    u = span / length[:, None]
    along, across = project(points, a, u)
    end = np.minimum(1.5 * reach, 0.2 * length)
    inside = (along > end) & (along < length - end) & (across <= reach)
    # ink that two nearly parallel edges could claim tells nothing about either; at a crossing it does no harm
    shared = np.flatnonzero(inside.sum(axis=1) > 1)
    if len(shared):
        nearest = np.where(inside[shared], across[shared], np.inf).argmin(axis=1)
        inside[shared] = False
        inside[shared, nearest] = True
    count = inside.sum(axis=0)
    # skeleton pixels per pixel of length, as the points may have been thinned out
    density = min(1.0, 1.5 * len(points) / float(length.sum()))
    rich = np.flatnonzero(count >= np.maximum(4.0, 0.2 * length * density))
    if not len(rich):
        none = np.zeros(0)
        return EdgeLines(rich, np.zeros((0, 2)), none, none, none)
    centre, direction, spread = _lines_through(points, inside[:, rich])
    ok = np.abs((direction * u[rich]).sum(axis=1)) >= 0.9
    e = rich[ok]
    normal = np.stack([-direction[ok, 1], direction[ok, 0]], axis=1)
    offset = (normal * centre[ok]).sum(axis=1)
    return EdgeLines(e, normal, offset, np.minimum(1.0, count[e] / 20), spread[ok])


def _lines_through(points: Floats, members: Bools) -> tuple[Floats, Floats, Floats]:
    """Total-least-squares line of each column's points: centre (m, 2), direction (m, 2), rms distance (m,)."""
    origin = points.mean(axis=0)
    x, y = (points - origin).T
    sums = members.T.astype(float) @ np.stack([np.ones(len(x)), x, y, x * x, y * y, x * y], axis=1)
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
    limit = 1.0 + 2.0 * lines.noise if k else None
    h = plane_map(v[:m], v[m:], drawn, limit)
    image, slope = homology.apply(h, v[:m]), _jacobian(h, v[:m])
    tied = 2 * k + np.arange(2 * m)
    vertex = np.repeat(np.arange(m), 2)
    a[tied, 2 * m + np.arange(2 * m)] = stiffness
    a[tied, 2 * vertex], a[tied, 2 * vertex + 1] = (-stiffness * slope.reshape(-1, 2)).T
    b[2 * k :] = (stiffness * (image - (slope * v[:m, None]).sum(axis=2))).ravel()
    normal = a.T @ a
    normal[np.diag_indices(4 * m)] += HOLD**2
    free = np.asarray(np.linalg.solve(normal, a.T @ b + HOLD**2 * start.ravel()), float).reshape(-1, 2)
    if not drawn.all():
        free[m:][~drawn] = homology.apply(plane_map(free[:m], free[m:], drawn, limit), free[:m])[~drawn]
    return np.where(np.isfinite(free), free, v)


def _fits(src: Floats, dst: Floats) -> Iterator[tuple[Floats, float]]:
    """Ever richer plane maps from points to points, each with its rms misfit in pixels."""
    fits = (lambda p, q: homology.translation((q - p).mean(axis=0)), homology.similarity, homology.homology)
    for least, fit in enumerate(fits, start=1):
        if len(src) >= least:
            h = fit(src, dst)
            off = homology.apply(h, src) - dst
            yield h, float(np.sqrt((off * off).sum() / len(off)))


def plane_map(front: Floats, back: Floats, drawn: Bools, tolerance: float | None = None) -> Floats:
    """The simplest plane map (3, 3) that carries the drawn front vertices onto their back vertices.

    A richer kind of map must earn its place: it has to fit clearly better than the simpler one.
    """
    seen = drawn if drawn.sum() >= 2 else np.ones(len(front), bool)
    size = float(np.linalg.norm(np.ptp(np.concatenate([front, back]), axis=0)))
    limit = 0.006 * size + 1.0 if tolerance is None else tolerance
    best, least = np.eye(3), np.inf
    for fit, off in _fits(front[seen], back[seen]):
        if np.isfinite(homology.apply(fit, front)).all():
            if off <= limit:
                return fit
            if off < least:
                best, least = fit, off
    return best


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


def map_cost(front: Floats, back: Floats, drawn: Bools) -> float:
    """How elaborate the plane map is: 0 for an exact translation, growing with degrees of freedom and misfit."""
    seen = drawn if drawn.sum() >= 2 else np.ones(len(front), bool)
    size = float(np.linalg.norm(np.ptp(np.concatenate([front, back]), axis=0))) + 1e-9
    least = np.inf
    for k, (_, off) in enumerate(_fits(front[seen], back[seen])):
        if k * MAP_STEP >= least:
            break
        if np.isfinite(off):
            least = min(least, k * MAP_STEP + off / size)
    return float(least)


def _jacobian(h: Floats, points: Floats) -> Floats:
    """(k, 2, 2) derivative of the plane map at points."""
    q = np.c_[points, np.ones(len(points))] @ h.T
    w = q[:, 2, None, None]
    return np.asarray((h[None, :2, :2] - (q[:, :2, None] / w) * h[None, 2:, :2]) / w)
