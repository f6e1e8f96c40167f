"""Face separator for drawings without (solid) hidden edges: the visible cap and the map to the face behind it.

Strategy. With hidden edges removed or dashed, f1 is seen whole, so it is one of the regions that the solid ink
encloses. For every region its outline is a candidate f1; strokes that leave its vertices outwards are rungs; maps
(`homology`) are guessed from one, two or three of them, and f2 is f1 under the map. Verification chooses.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape import homology
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.separate import CornerGraph
from sketch2shape.verify import Rings


@dataclass(frozen=True)
class Region:
    """A region that the ink encloses.

    outline : (n, 2) float, pixels, its border along the middle of the strokes
    islands : borders of what lies inside it: holes, letters
    """

    outline: Floats
    islands: tuple[Floats, ...] = ()


def enclosed_regions(mask: Bools, pen: float, tolerance: float, most: int = 40) -> list[Region]:
    """Regions that the ink encloses, the largest first.

    mask : (h, w) bool, the ink
    """
    grown = cv2.copyMakeBorder(mask.astype(np.uint8), 2, 2, 2, 2, cv2.BORDER_CONSTANT)
    close = max(1, int(tolerance))
    if close > 1:
        grown = cv2.dilate(grown, _disc(close - 1))
    _, label, stats, _ = cv2.connectedComponentsWithStats(1 - grown, connectivity=4)
    diagonal = np.hypot(*mask.shape)
    least = max(3 * pen * pen, 1e-4 * diagonal**2)
    outside = label[0, 0]
    order = [k for k in np.argsort(-stats[:, cv2.CC_STAT_AREA]) if k not in (0, outside)]
    regions = []
    for k in [k for k in order if stats[k, cv2.CC_STAT_AREA] >= least][:most]:
        region = _region(label, stats[k], int(k), pen + 2 * (close - 1), tolerance)
        if region is not None:
            regions.append(region)
    return regions


def _disc(radius: int) -> NDArray[np.uint8]:
    return np.asarray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1)), np.uint8)


def _region(label: NDArray[Any], stat: NDArray[Any], k: int, pen: float, tolerance: float) -> Region | None:
    """One region's polygons, their borders moved to the middle of the strokes, thin intrusions closed."""
    margin = int(3 * pen) + 4
    x, y, w, h = (int(v) for v in stat[:4])
    x0, y0 = max(x - margin, 0), max(y - margin, 0)
    part = (label[y0 : y + h + margin, x0 : x + w + margin] == k).astype(np.uint8)
    part = cv2.copyMakeBorder(part, margin, margin, margin, margin, cv2.BORDER_CONSTANT)
    out, back = max(1, round(1.5 * pen)), max(0, round(1.0 * pen))
    part = cv2.dilate(part, _disc(out))
    if back:
        part = cv2.erode(part, _disc(back))
    contours, tree = cv2.findContours(part, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    # two pixels of border were added before the regions were labelled
    shift = np.array([x0 - margin - 2.0, y0 - margin - 2.0])
    areas = [cv2.contourArea(c) for c in contours]
    outer = max((i for i in range(len(contours)) if tree[0, i, 3] < 0), key=lambda i: areas[i])
    inner = [i for i in range(len(contours)) if tree[0, i, 3] == outer and areas[i] > 0.004 * areas[outer]]
    polygons = [cv2.approxPolyDP(contours[i], tolerance + 0.35 * pen, True)[:, 0] + shift for i in [outer, *inner[:8]]]
    if not 3 <= len(polygons[0]) <= 64:
        return None
    return Region(polygons[0], tuple(p for p in polygons[1:] if 3 <= len(p) <= 64))


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


def rungs_of(corner: Ints, outline: Floats, graph: CornerGraph) -> list[tuple[int, int]]:
    """(vertex of the outline, corner of the graph) for every inked segment that leaves the outline at a vertex."""
    ring = outline.astype(np.float32)[:, None]
    found = []
    for i, c in enumerate(corner):
        if c < 0:
            continue
        for j in np.flatnonzero(graph.inked[c]):
            if j in corner:
                continue
            way = graph.points[j] - outline[i]
            step = outline[i] + way * min(0.5, 3 * graph.tolerance / (np.linalg.norm(way) + 1e-9))
            if cv2.pointPolygonTest(ring, step.tolist(), True) < 0:
                found.append((i, int(j)))
    return found


def caps(graph: CornerGraph, regions: list[Region], most: int = 24) -> Iterator[Rings]:
    """Hypotheses from every region, each region's best maps first."""
    reach = 1.2 * graph.tolerance + 2
    for region in regions:
        corner, ring = snap(region.outline, graph, reach)
        if not 3 <= len(ring) <= 64:
            continue
        islands = [snap(p, graph, reach)[1] for p in region.islands]
        rungs = rungs_of(corner, ring, graph)
        for h in _maps(ring, rungs, graph, most):
            back = homology.apply(h, ring)
            if not np.isfinite(back).all():
                continue
            yield Rings((ring,), (back,))
            if islands:
                yield Rings((ring, *islands), (back, *(homology.apply(h, p) for p in islands)))


def _maps(ring: Floats, rungs: list[tuple[int, int]], graph: CornerGraph, most: int) -> Floats:
    """Maps from one, two and three rungs, those that carry the most vertices onto their rungs' ends first."""
    if not rungs:
        return np.zeros((0, 3, 3))
    r = np.array(rungs[:24])
    src, dst = ring[r[:, 0]], graph.points[r[:, 1]]
    parts = [homology.translation(dst - src)]
    pairs = np.array([p for p in combinations(range(len(r)), 2) if r[p[0], 0] != r[p[1], 0]], int).reshape(-1, 2)
    if len(pairs):
        parts.append(homology.similarity(src[pairs], dst[pairs]))
    triples = np.array([t for t in combinations(range(len(r)), 3) if len({*r[list(t), 0]}) == 3][:600], int).reshape(
        -1, 3
    )
    if len(triples):
        parts.append(homology.homology(src[triples], dst[triples]))
    maps = np.concatenate(parts)
    image = homology.apply(maps, src)
    with np.errstate(invalid="ignore"):
        off = np.linalg.norm(image - dst[None], axis=2)
    hits = off <= graph.tolerance
    # simpler maps come first among equals
    kind = np.repeat(np.arange(len(parts)), [len(p) for p in parts])
    vertices = np.array([len(set(r[h, 0])) for h in hits])
    # each extra degree of freedom explains half a rung for free
    order = np.argsort(-(vertices - 0.9 * kind), kind="stable")
    return maps[order[:most]]
