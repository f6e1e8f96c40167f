"""Joint refinement of all vertices against the ink, under the model's own constraints.

Every edge with ink under it gets the total-least-squares line of the skeleton pixels that are its own; a vertex should
lie on the lines of its edges, and the back face should be the front face under one plane map (`homology`). Both are
linear in the vertices once the map is linearised about the present ones, so a few least-squares steps do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape import homology
from sketch2shape.model import Bools, Floats, Ints, ring_edges
from sketch2shape.strokes import fit_line
from sketch2shape.verify import Rings

STEPS = 3
MAP_STEP = 0.02
"""Misfit, as a part of the object's size, that justifies the next richer kind of plane map."""


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


def refine(rings: Rings, points: Floats, reach: float, drawn: Bools, stiffness: float = 0.5) -> tuple[Rings, float]:
    """Rings moved to the ink, and the rms distance between model and ink in pixels.

    points    : (k, 2) float, skeleton pixels
    reach     : pixels, how far an edge looks for its ink
    drawn     : (m,) bool, back vertices that ink shows; the others follow from the plane map alone
    stiffness : weight of the plane map against the ink
    """
    sizes = [len(r) for r in rings.front]
    edges = ring_edges(sizes)
    start = v = rings.vertices
    points = points[:: max(1, len(points) // 1500)]
    lines = None
    for step in range(STEPS):
        lines = _measure(v, edges, points, reach if step == 0 else 0.7 * reach)
        moved = _solve(v, start, edges, lines, drawn, stiffness)
        # a seen vertex that runs away has lost its lines: keep it where verification found it
        far = np.linalg.norm(moved - start, axis=1) > 3 * reach + 4
        far[len(drawn) :] &= drawn
        moved[far] = start[far]
        v = moved
    spread = lines.spread if lines is not None and len(lines.spread) else np.zeros(1)
    return split(v, sizes), float(np.sqrt((spread**2).mean()))


def split(vertices: Floats, sizes: list[int]) -> Rings:
    """Vertices (2m, 2) in the order of the contract back into rings."""
    cuts = np.cumsum(sizes + sizes)[:-1]
    parts = np.split(vertices, cuts)
    return Rings(tuple(parts[: len(sizes)]), tuple(parts[len(sizes) :]))


def _measure(v: Floats, edges: Ints, points: Floats, reach: float) -> EdgeLines:
    """The line under every edge that has enough ink of its own."""
    a, span = v[edges[:, 0]], v[edges[:, 1]] - v[edges[:, 0]]
    length = np.linalg.norm(span, axis=1) + 1e-9
    u = span / length[:, None]
    q = points[:, None] - a[None]
    along = (q * u).sum(axis=2)
    across = np.abs(q[..., 0] * u[:, 1] - q[..., 1] * u[:, 0])
    end = np.minimum(1.5 * reach, 0.2 * length)
    inside = (along > end) & (along < length - end) & (across <= reach)
    across = np.where(inside, across, np.inf)
    nearest = across.argmin(axis=1)
    # skeleton pixels per pixel of length, as the points may have been thinned out
    density = min(1.0, 1.5 * len(points) / float(length.sum()))
    # ink that two nearly parallel edges could claim tells nothing about either; at a crossing it does no harm
    claims = inside.sum(axis=1)
    found = []
    for e in range(len(edges)):
        mine = inside[:, e] & ((claims == 1) | (nearest == e))
        if mine.sum() < max(4.0, 0.2 * length[e] * density):
            continue
        own = points[mine]
        centre, direction = fit_line(own)
        if abs(direction @ u[e]) < 0.9:
            continue
        normal = np.array([-direction[1], direction[0]])
        spread = float(np.sqrt((((own - centre) @ normal) ** 2).mean()))
        found.append((e, normal, float(normal @ centre), min(1.0, len(own) / 20), spread))
    if not found:
        none = np.zeros(0)
        return EdgeLines(np.zeros(0, np.intp), np.zeros((0, 2)), none, none, none)
    e, n, c, w, s = zip(*found, strict=True)
    return EdgeLines(np.array(e), np.array(n), np.array(c), np.array(w), np.array(s))


def _solve(v: Floats, start: Floats, edges: Ints, lines: EdgeLines, drawn: Bools, stiffness: float) -> Floats:
    """One linear least-squares step for all vertices."""
    m = len(v) // 2
    rows, right = [], []
    for e, normal, offset, weight in zip(lines.edge, lines.normal, lines.offset, lines.weight, strict=True):
        for k in edges[e]:
            row = np.zeros(4 * m)
            row[2 * k : 2 * k + 2] = weight * normal
            rows.append(row)
            right.append(weight * offset)
    # a clean drawing tells a similarity from a homology; a rough one does not
    limit = 1.0 + 2.0 * float(np.sqrt((lines.spread**2).mean())) if len(lines.spread) else None
    h = plane_map(v[:m], v[m:], drawn, limit)
    image, slope = homology.apply(h, v[:m]), _jacobian(h, v[:m])
    for i in range(m):
        for axis in range(2):
            row = np.zeros(4 * m)
            row[2 * (m + i) + axis] = stiffness
            row[2 * i : 2 * i + 2] = -stiffness * slope[i, axis]
            rows.append(row)
            right.append(stiffness * (image[i, axis] - slope[i, axis] @ v[i]))
    # held lightly to where it started, so that the normal equations are always well posed
    hold = 0.03
    a, b = np.array(rows), np.array(right)
    normal = a.T @ a + hold**2 * np.eye(4 * m)
    free = np.linalg.solve(normal, a.T @ b + hold**2 * start.ravel()).reshape(-1, 2)
    free[m:][~drawn] = homology.apply(plane_map(free[:m], free[m:], drawn, limit), free[:m])[~drawn]
    return np.where(np.isfinite(free), free, v)


def plane_map(front: Floats, back: Floats, drawn: Bools, tolerance: float | None = None) -> Floats:
    """The simplest plane map (3, 3) that carries the drawn front vertices onto their back vertices.

    A richer kind of map must earn its place: it has to fit clearly better than the simpler one.
    """
    seen = drawn if drawn.sum() >= 2 else np.ones(len(front), bool)
    src, dst = front[seen], back[seen]
    size = float(np.linalg.norm(np.ptp(np.concatenate([front, back]), axis=0)))
    limit = 0.006 * size + 1.0 if tolerance is None else tolerance
    fits = [homology.translation((dst - src).mean(axis=0))]
    if len(src) >= 2:
        fits.append(homology.similarity(src, dst))
    if len(src) >= 3:
        fits.append(homology.homology(src, dst))
    misfit = [float(np.sqrt((np.linalg.norm(homology.apply(f, src) - dst, axis=1) ** 2).mean())) for f in fits]
    for fit, off in zip(fits, misfit, strict=True):
        if off <= limit and np.isfinite(homology.apply(fit, front)).all():
            return fit
    usable = [k for k, f in enumerate(fits) if np.isfinite(homology.apply(f, front)).all()]
    return fits[min(usable, key=lambda k: misfit[k])]


def map_cost(front: Floats, back: Floats, drawn: Bools) -> float:
    """How elaborate the plane map is: 0 for an exact translation, growing with degrees of freedom and misfit."""
    seen = drawn if drawn.sum() >= 2 else np.ones(len(front), bool)
    src, dst = front[seen], back[seen]
    size = float(np.linalg.norm(np.ptp(np.concatenate([front, back]), axis=0))) + 1e-9
    fits = [homology.translation((dst - src).mean(axis=0)), homology.similarity(src, dst)]
    if len(src) >= 3:
        fits.append(homology.homology(src, dst))
    off = [np.sqrt((np.linalg.norm(homology.apply(f, src) - dst, axis=1) ** 2).mean()) for f in fits]
    return float(min(k * MAP_STEP + o / size for k, o in enumerate(off) if np.isfinite(o)))


def _jacobian(h: Floats, points: Floats) -> Floats:
    """(k, 2, 2) derivative of the plane map at points."""
    q = np.c_[points, np.ones(len(points))] @ h.T
    w = q[:, 2, None, None]
    return np.asarray((h[None, :2, :2] - (q[:, :2, None] / w) * h[None, 2:, :2]) / w)
