"""Face separator for drawings without (solid) hidden edges: the visible cap and the map to the face behind it.

Strategy. With hidden edges removed or dashed, f1 is seen whole, so it is one of the regions that the solid ink
encloses. For every region its outline is a candidate f1; strokes that leave its vertices outwards are rungs; maps
(`homology`) are guessed from one, two or three of them, and f2 is f1 under the map. Verification chooses.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from itertools import combinations

import cv2
import numpy as np

from sketch2shape.geometry import homology
from sketch2shape.hypotheses.hypothesis import Rings
from sketch2shape.hypotheses.regions import Region, reductions, sharpened
from sketch2shape.hypotheses.wireframe import CornerGraph
from sketch2shape.model import Bools, Floats, Ints

OF_A_UNION = 4
"""Maps that are tried for a union of regions."""
PULL = 2.5
"""How far off its place, over the tolerance of the corners, the end of a rung may pull the back face's vertex."""
SHARP = 0.3
"""Half the angle of a corner, radians, up to which its two strokes run into one well before they meet."""
MOVED = 1.0
"""Pixels by which a back face has to move to be another hypothesis."""


def snap(outline: Floats, graph: CornerGraph, reach: float) -> tuple[Ints, Floats]:
    """Outline with its vertices moved to the corners of the drawing.

    Returns (corner of each vertex or -1, (n, 2) float); vertices that come to lie on one corner or on a straight
    line are dropped.
    """
    if not len(graph.points):
        return np.full(len(outline), -1), outline
    distance = np.linalg.norm(outline[:, None] - graph.points[None], axis=2)
    corner = np.where(distance.min(axis=1) <= reach, distance.argmin(axis=1), -1)
    points = np.where((corner >= 0)[:, None], graph.points[corner], outline)
    keep = np.ones(len(points), bool)
    for i in range(len(points)):
        keep[i] = not (corner[i] >= 0 and corner[i] == corner[i - 1])
    corner, points = corner[keep], points[keep]
    return _without_straight(corner, points, 0.6 * graph.tolerance)


def _without_straight(corner: Ints, points: Floats, tolerance: float) -> tuple[Ints, Floats]:
    """Drop vertices at which the outline runs straight on, the straightest first."""
    while len(points) > 3:
        a, c = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
        u, v = points - a, c - points
        lu, lv = np.linalg.norm(u, axis=1), np.linalg.norm(v, axis=1)
        sine = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / (lu * lv + 1e-9)
        height = np.abs(sine) * np.minimum(lu, lv)
        straight = (height < tolerance) & ((u * v).sum(axis=1) > 0) | (np.minimum(lu, lv) < tolerance)
        if not straight.any():
            break
        k = int(np.where(straight, height, np.inf).argmin())
        corner, points = np.delete(corner, k), np.delete(points, k, axis=0)
    return corner, points


@dataclass(frozen=True)
class Rungs:
    """Connecting edges seen at the vertices of a ring.

    vertex : (k,) int, index into the ring
    end    : (k, 2) float, where the rung ends, pixels
    """

    vertex: Ints
    end: Floats


def rungs_of(corner: Ints, ring: Floats, graph: CornerGraph) -> Rungs:
    """Inked segments that leave the ring at a vertex, to any corner outside."""
    contour = ring.astype(np.float32)[:, None]
    found = []
    for i, c in enumerate(corner):
        if c < 0:
            continue
        for j in np.flatnonzero(graph.inked[c]):
            if j in corner:
                continue
            way = graph.points[j] - ring[i]
            step = ring[i] + way * min(0.5, 3 * graph.tolerance / (np.linalg.norm(way) + 1e-9))
            if cv2.pointPolygonTest(contour, step.tolist(), True) < 0:
                found.append((i, graph.points[j]))
    return _rungs(found)


def _rungs(found: list[tuple[int, Floats]]) -> Rungs:
    return Rungs(np.array([i for i, _ in found], np.intp), np.array([p for _, p in found]).reshape(-1, 2))


def rungs_from_sides(ring: Floats, sides: list[Floats], reach: float) -> Rungs:
    """Rungs of the side faces: a quadrilateral that shares an edge with the ring continues in the two rungs there."""
    n, found = len(ring), []
    for side in sides:
        for i in range(n):
            edge = np.array([ring[i], ring[(i + 1) % n]])
            for k in range(4):
                # neighbours run along their common edge in opposite directions
                shared = np.array([side[(k + 1) % 4], side[k]])
                if np.linalg.norm(shared - edge, axis=1).max() <= reach:
                    found += [(i, side[(k + 2) % 4]), ((i + 1) % n, side[k - 1])]
    return _rungs(found)


def caps(graph: CornerGraph, regions: list[Region], pen: float) -> Iterator[Rings]:
    """Hypotheses from every region; pen is the pen width in pixels."""
    short = 3.0 * pen + graph.tolerance / 2
    for region in regions:
        sharp = Region(sharpened(region.outline, short), tuple(sharpened(p, short) for p in region.islands))
        yield from _from_region(graph, sharp, pen)
        if len(sharp.outline) != len(region.outline):
            yield from _from_region(graph, region, pen)


def united_caps(graph: CornerGraph, unions: Iterable[Region], pen: float) -> Iterator[Rings]:
    """Hypotheses from unions of regions, the likeliest maps of each; pen is the pen width in pixels."""
    short = 3.0 * pen + graph.tolerance / 2
    for region in unions:
        yield from _from_region(graph, Region(sharpened(region.outline, short)), pen, OF_A_UNION)


def loose_caps(graph: CornerGraph, regions: list[Region], pen: float) -> Iterator[Rings]:
    """Hypotheses for drawings too rough for corners: from the shapes of the regions alone."""
    sides = [p for r in regions for p in reductions(r.outline, 0.2) if len(p) == 4]
    reach = 1.5 * graph.tolerance + 1.5 * pen
    for region in regions[:12]:
        for ring in reductions(region.outline):
            if len(ring) > 16:
                continue
            yield from _swept(ring, (), rungs_from_sides(ring, sides, reach), graph, 12)


def _from_region(graph: CornerGraph, region: Region, pen: float, most: int = 24) -> Iterator[Rings]:
    reach = 1.2 * graph.tolerance + 2
    corner, ring = snap(region.outline, graph, reach)
    if not 3 <= len(ring) <= 64:
        return
    # a speck whose vertices all come to lie on one corner is no hole
    islands = tuple(p for p in (snap(q, graph, reach)[1] for q in region.islands) if len(p) >= 3)
    yield from _swept(ring, islands, rungs_of(corner, ring, graph), graph, most)
    ahead, sharp = _with_tips(corner, ring, graph, pen)
    if not np.array_equal(ahead, corner):
        yield from _swept(sharp, islands, rungs_of(ahead, sharp, graph), graph, most)


def _with_tips(corner: Ints, ring: Floats, graph: CornerGraph, pen: float) -> tuple[Ints, Floats]:
    """Corners and vertices of a ring, sharp ones at the farthest corner ahead: their strokes run into one before.

    How far before follows from the pen's width and the angle between them.
    """
    tips, ring = corner.copy(), ring.copy()
    before, after = np.roll(ring, 1, axis=0) - ring, np.roll(ring, -1, axis=0) - ring
    before /= np.hypot(*before.T)[:, None] + 1e-9
    after /= np.hypot(*after.T)[:, None] + 1e-9
    half = 0.5 * np.arccos(np.clip((before * after).sum(axis=1), -1.0, 1.0))
    for i in np.flatnonzero(half < SHARP):
        way = graph.points - ring[i]
        out = -0.5 * (before[i] + after[i]) / np.cos(half[i])
        along, across = way @ out, np.abs(way[:, 0] * out[1] - way[:, 1] * out[0])
        ahead = (across <= graph.tolerance) & (along > 0) & (along * np.sin(half[i]) <= pen)
        ahead[tips[tips >= 0]] = False
        if ahead.any():
            tips[i] = np.where(ahead, along, 0.0).argmax()
            ring[i] = graph.points[tips[i]]
    return tips, ring


def _swept(ring: Floats, islands: tuple[Floats, ...], rungs: Rungs, graph: CornerGraph, most: int) -> Iterator[Rings]:
    """The ring with its images under the maps that its rungs suggest, the best first."""
    maps = _maps(ring, rungs, graph, most)
    backs = homology.apply(maps, ring)
    missed = backs[:, rungs.vertex] - rungs.end
    off = np.hypot(missed[..., 0], missed[..., 1])
    pulls = off < PULL * graph.tolerance
    finite = np.asarray(np.isfinite(backs).all(axis=(1, 2)))
    moves = np.flatnonzero(finite & (pulls & (off >= MOVED)).any(axis=1))
    pulled = dict(zip(moves.tolist(), _pulled(ring, backs[moves], rungs, off[moves], graph), strict=True))
    for k in np.flatnonzero(finite).tolist():
        yield Rings((ring,), (backs[k],))
        if islands:
            yield Rings((ring, *islands), (backs[k], *(homology.apply(maps[k], p) for p in islands)))
        other = pulled.get(k)
        if other is not None:
            yield Rings((ring,), (other,))


def _pulled(ring: Floats, backs: Floats, rungs: Rungs, off: Floats, graph: CornerGraph) -> list[Floats | None]:
    """Back faces (k, n, 2) with vertices at the ends of drawn rungs: a hand rarely draws two faces quite alike.

    off : (k, r) float, pixels by which each face misses the end of each rung

    Back vertices without a rung follow from the map through those that have one. None for faces of which nothing moves.
    """
    if not len(backs):
        return []
    # of the rungs at one vertex the closest comes last and stays
    order = np.argsort(-off, axis=1, kind="stable")
    near = np.take_along_axis(off, order, axis=1) < PULL * graph.tolerance
    face, rung = np.nonzero(near)[0], order[near]
    pulled, seen = backs.copy(), np.zeros(backs.shape[:2], bool)
    pulled[face, rungs.vertex[rung]] = rungs.end[rung]
    seen[face, rungs.vertex[rung]] = True
    way = pulled - backs
    moved = np.hypot(way[..., 0], way[..., 1]).max(axis=1) >= MOVED
    some = np.flatnonzero(moved & ~seen.all(axis=1))
    if len(some):
        pulled[some] = _with_rest(ring, pulled[some], seen[some], graph)
    return [face if any_moved else None for face, any_moved in zip(pulled, moved.tolist(), strict=True)]


def _with_rest(ring: Floats, pulled: Floats, seen: Bools, graph: CornerGraph) -> Floats:
    """Back faces (k, n, 2) with the vertices that are not seen where the plainest map through the seen ones has them.

    Such a vertex lies on a corner if there is one close by.
    """
    image = homology.apply(homology.similarity_of_seen(ring, pulled, seen), ring)
    face, vertex = np.nonzero(~seen)
    rest = image[face, vertex]
    if len(graph.points):
        gap = rest[:, None] - graph.points
        near = np.hypot(gap[..., 0], gap[..., 1])
        close = near.min(axis=1) < graph.tolerance
        rest[close] = graph.points[near.argmin(axis=1)[close]]
    whole = pulled.copy()
    whole[face, vertex] = rest
    return whole


def _maps(ring: Floats, rungs: Rungs, graph: CornerGraph, most: int) -> Floats:
    """Maps from one, two and three rungs, those that carry the most vertices onto their rungs' ends first."""
    vertex, dst = rungs.vertex[:24], rungs.end[:24]
    if not len(vertex):
        return np.zeros((0, 3, 3))
    src = ring[vertex]
    parts = [homology.translation(dst - src)]
    for count, fit, limit in ((2, homology.similarity, 300), (3, homology.homology, 600)):
        chosen = _choices(len(vertex), count)
        owners = np.sort(vertex[chosen], axis=1)
        chosen = chosen[(np.diff(owners, axis=1) > 0).all(axis=1)][:limit]
        if len(chosen):
            parts.append(fit(src[chosen], dst[chosen]))
    maps = np.concatenate(parts)
    with np.errstate(invalid="ignore"):
        off = np.linalg.norm(homology.apply(maps, src) - dst[None], axis=2)
    hits = off <= graph.tolerance
    kind = np.repeat(np.arange(len(parts)), [len(p) for p in parts])
    owner = (vertex[:, None] == np.arange(len(ring))).astype(np.float32)
    vertices = ((hits.astype(np.float32) @ owner) > 0).sum(axis=1)
    # each further degree of freedom explains most of a rung for free
    order = np.argsort(-(vertices - 0.9 * kind), kind="stable")
    return maps[order[:most]]


@cache
def _choices(n: int, count: int) -> Ints:
    """(k, count) int, all ways to choose that many of n, in order."""
    return np.array(list(combinations(range(n), count)), np.intp).reshape(-1, count)
