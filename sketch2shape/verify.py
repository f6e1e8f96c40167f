"""Verification: draw a hypothesis again and compare it with the ink.

A good answer has ink under every edge that can be seen, treats all hidden edges alike (all drawn, all dashed, or none)
and leaves no large part of the drawing unexplained. Visibility needs no depth: the object is the front face swept along
the connecting lines, so a point of a side or of the back face is hidden exactly if the way back along its connecting
line to the front face crosses the front face's interior.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats, Lines, ring_edges
from sketch2shape.strokes import coverage

SAMPLES = 32
WAY_BACK = 20
SHORTEST_RUNG = 0.1
"""Least length of a connecting edge, as a part of the longest: shorter ones make a side of a pyramid's corner."""
SMALLEST_FACE = 0.03
"""Least area of the smaller face, as a part of the larger one."""


class Rings(NamedTuple):
    """Corresponding rings of a hypothesis: front[k][i] joins back[k][i]; the outer ring first."""

    front: tuple[Floats, ...]
    back: tuple[Floats, ...]

    @property
    def vertices(self) -> Floats:
        """(2m, 2) float."""
        return np.concatenate([*self.front, *self.back])

    def swapped(self) -> Rings:
        """Front and back exchanged."""
        return Rings(self.back, self.front)


@dataclass(frozen=True)
class Evidence:
    """How well a hypothesis agrees with the drawing.

    score     : 0..1, harmonic mean of support and explained, lowered by the weakest edge
    support   : 0..1, part of the length that should be drawn which is
    explained : 0..1, part of the ink that the hypothesis accounts for
    weakest   : 0..1, least support of any edge of notable length
    lines     : how hidden edges are drawn
    drawn     : (m,) bool, back vertices that ink shows
    """

    score: float
    support: float
    explained: float
    weakest: float
    lines: Lines
    drawn: Bools


@dataclass(frozen=True)
class Sheet:
    """What a hypothesis is compared with.

    distance : (h, w) float32, distance to the skeleton, pixels
    points   : (k, 2) float, skeleton pixels that must be explained
    weights  : (k,) float, weight of each
    reach    : pixels a drawn line may be away from the predicted one
    pen      : pen width, pixels
    """

    distance: NDArray[np.float32]
    points: Floats
    weights: Floats
    reach: float
    pen: float

    @property
    def size(self) -> float:
        """Diagonal of the ink's bounding box, pixels."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0))) if len(self.points) else 1.0


def plausible(rings: Rings, least: float) -> bool:
    """Whether the rings could be the faces of an object: simple, alike in size, no edge shorter than least pixels.

    A back face shrunk to almost nothing turns the object into a pyramid, which is none.
    """
    if not np.isfinite(rings.vertices).all() or np.abs(rings.vertices).max() > 1e5:
        return False
    for front, back in zip(rings.front, rings.back, strict=True):
        ratio = abs(_area(back)) / max(abs(_area(front)), 1e-9)
        if not SMALLEST_FACE <= ratio <= 1 / SMALLEST_FACE or _area(front) * _area(back) <= 0:
            return False
        rungs = np.linalg.norm(back - front, axis=1)
        if rungs.min() < max(least, SHORTEST_RUNG * rungs.max()):
            return False
        for ring in (front, back):
            if np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).min() < least or not _is_simple(ring):
                return False
    return True


def _area(ring: Floats) -> float:
    x, y = ring.T
    return 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))


def _is_simple(ring: Floats) -> bool:
    """No two edges of the ring cross."""
    a, b = ring, np.roll(ring, -1, axis=0)
    side_a = _side(a[None], a[:, None], b[:, None])
    side_b = _side(b[None], a[:, None], b[:, None])
    apart = side_a * side_b < -1e-9
    return not bool((apart & apart.T).any())


def _side(p: Floats, a: Floats, b: Floats) -> Floats:
    """On which side of the lines ab the points p lie."""
    u, v = b - a, p - a
    return np.asarray(u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0])


def edge_samples(rings: Rings, samples: int = SAMPLES) -> tuple[Floats, Floats]:
    """Points along every edge and the points of the front face they come from: both (3m, samples, 2)."""
    edges = ring_edges([len(r) for r in rings.front])
    v = rings.vertices
    half = len(v) // 2
    s = ((np.arange(samples) + 0.5) / samples)[None, :, None]
    a, b = v[edges[:, 0], None], v[edges[:, 1], None]
    base_a, base_b = v[edges[:, 0] % half, None], v[edges[:, 1] % half, None]
    return a + s * (b - a), base_a + s * (base_b - base_a)


def worth_judging(rings: Rings, sheet: Sheet) -> bool:
    """A quick first check: the front is always seen whole, and so are two connecting edges and one edge of the back."""
    front, back = np.concatenate(rings.front), np.concatenate(rings.back)
    after = np.concatenate([np.roll(np.arange(n), -1) + s for n, s in _spans(rings)])
    a = np.concatenate([front, front, back])
    b = np.concatenate([front[after], back, back[after]])
    share = coverage(sheet.distance, a, b, sheet.reach, 16).reshape(3, -1)
    length = np.linalg.norm(front[after] - front, axis=1)
    if share[0] @ length < 0.6 * length.sum():
        return False
    return bool((share[1] > 0.35).sum() >= 2 and (share[2] > 0.35).any())


def _spans(rings: Rings) -> list[tuple[int, int]]:
    """Size and start of every ring of one face."""
    sizes = [len(r) for r in rings.front]
    return list(zip(sizes, np.cumsum([0, *sizes[:-1]]).tolist(), strict=True))


def hidden_samples(rings: Rings, margin: float) -> tuple[Bools, Bools]:
    """Which edge samples lie behind the object, surely and perhaps: both (3m, SAMPLES) bool.

    Sure is what lies deeper than margin pixels behind the outline; what is shallower may be a matter of the pen.
    """
    points, base = edge_samples(rings)
    low = np.floor(np.minimum(points.min(axis=(0, 1)), base.min(axis=(0, 1)))) - 3
    high = np.ceil(np.maximum(points.max(axis=(0, 1)), base.max(axis=(0, 1)))) + 3
    factor = min(1.0, 300.0 / max(float((high - low).max()), 1.0))
    inside = _interior(rings, low, high, factor, margin)
    behind = np.concatenate([np.repeat([False, True, True], len(r)) for r in rings.front])
    start = ((base[behind] - low) * factor + 0.5).astype(np.float32)
    way = ((points - base)[behind] * factor).astype(np.float32)
    depth = np.zeros(points.shape[:2], np.uint8)
    # the near end of the way back lies on the outline itself, the far end is the point: its own cap counts too
    s = np.linspace(0.0, 1.0, WAY_BACK, dtype=np.float32)[:, None, None]
    x = (start[..., 0] + s * way[..., 0]).astype(np.int32)
    y = (start[..., 1] + s * way[..., 1]).astype(np.int32)
    depth[behind] = inside[np.clip(y, 0, inside.shape[0] - 1), np.clip(x, 0, inside.shape[1] - 1)].max(axis=0)
    return depth == 2, depth >= 1


def _interior(rings: Rings, low: Floats, high: Floats, factor: float, margin: float) -> NDArray[np.uint8]:
    """The front face, rasterised: 0 outside, 1 within margin pixels of its outline, 2 deeper inside."""
    w, h = (((high - low) * factor).astype(int) + 1).tolist()
    canvas = np.zeros((h, w), np.uint8)
    outlines = [((ring - low) * factor).round().astype(np.int32) for ring in rings.front]
    for k, outline in enumerate(outlines):
        cv2.fillPoly(canvas, [outline], 0 if k else 1)
    deep = canvas.copy()
    rim = max(1, round(margin * factor))
    cv2.polylines(deep, outlines, True, 0, 2 * rim + 1)
    cv2.polylines(canvas, outlines, True, 0, 3)
    return np.asarray(canvas + deep, np.uint8)


def judge(rings: Rings, sheet: Sheet) -> Evidence:
    """Compare a hypothesis with the drawing, under the way its hidden lines seem to have been drawn."""
    points, _ = edge_samples(rings)
    h, w = sheet.distance.shape
    x = np.rint(points[..., 0]).astype(np.intp)
    y = np.rint(points[..., 1]).astype(np.intp)
    outside = (x < 0) | (y < 0) | (x >= w) | (y >= h)
    near = sheet.distance[np.clip(y, 0, h - 1), np.clip(x, 0, w - 1)] <= sheet.reach
    near &= ~outside
    hidden, perhaps = hidden_samples(rings, 1.5 * sheet.reach)
    v = rings.vertices
    edges = ring_edges([len(r) for r in rings.front])
    lengths = np.linalg.norm(v[edges[:, 1]] - v[edges[:, 0]], axis=1)
    lines = _line_style(near, hidden, lengths)
    wanted = np.ones_like(hidden) if lines == "wire" else ~_grown(perhaps, lengths, 5 * sheet.reach)
    support, weakest = _support(near, wanted, lengths)
    dashes = 1.0
    if lines == "dashed":
        behind, faintest = _support(near, hidden, lengths)
        support = min(support, 0.6 * support + 0.4 * min(1.0, behind / 0.45))
        # who dashes hidden edges dashes all of them
        dashes = min(1.0, 0.85 + 0.15 * faintest / 0.25)
    shown = wanted if lines == "removed" else np.ones_like(wanted)
    explained = _explained(points, shown, sheet)
    score = 2 * support * explained / (support + explained + 1e-9)
    score *= min(1.0, 0.5 + 0.5 * weakest / 0.75) * dashes
    drawn = _drawn(near, rings, shown)
    if drawn.sum() < 2:
        # a face alone, with all that would make it an object hidden behind it
        score *= 0.4
    return Evidence(score, support, explained, weakest, lines, drawn)


def _grown(hidden: Bools, lengths: Floats, margin: float) -> Bools:
    """Hidden samples and those within margin pixels of one: where a line dives behind a contour, nobody can say."""
    count = np.ceil(margin * hidden.shape[1] / (lengths + 1e-9)).astype(int)
    total = np.cumsum(np.pad(hidden, ((0, 0), (1, 0))), axis=1)
    at = np.arange(hidden.shape[1])[None]
    low = np.maximum(at - count[:, None], 0)
    high = np.minimum(at + count[:, None] + 1, hidden.shape[1])
    rows = np.arange(len(hidden))[:, None]
    return np.asarray(total[rows, high] > total[rows, low])


def _support(near: Bools, wanted: Bools, lengths: Floats) -> tuple[float, float]:
    """(part of the wanted length that is inked, the same for the weakest edge)."""
    weight = wanted * lengths[:, None] / near.shape[1]
    total = weight.sum(axis=1)
    if total.sum() <= 0:
        return 1.0, 1.0
    share = (near * weight).sum(axis=1) / (total + 1e-9)
    # what is left of a partly hidden edge must be long enough to tell
    notable = total > np.where(wanted.all(axis=1), 0.03, 0.12) * lengths.max()
    return float((near * weight).sum() / total.sum()), float(share[notable].min()) if notable.any() else 1.0


def _line_style(near: Bools, hidden: Bools, lengths: Floats) -> Lines:
    """From how much of the hidden length is inked: nearly all, some, or little."""
    weight = hidden * lengths[:, None]
    if weight.sum() < 0.02 * near.shape[1] * lengths.sum():
        return "wire"
    share = float((near * weight).sum() / weight.sum())
    return "wire" if share > 0.93 else "dashed" if share > 0.3 else "removed"


def is_dashed(rings: Rings, points: Floats, sheet: Sheet) -> bool:
    """Whether the hidden edges have clearly less ink to the pixel than the visible ones.

    points : (k, 2) float, all skeleton pixels
    """
    hidden, perhaps = hidden_samples(rings, 1.5 * sheet.reach)
    v = rings.vertices
    edges = ring_edges([len(r) for r in rings.front])
    a, span = v[edges[:, 0]], v[edges[:, 1]] - v[edges[:, 0]]
    length = np.linalg.norm(span, axis=1) + 1e-9
    u = span / length[:, None]
    q = points[:, None] - a[None]
    along = (q * u).sum(axis=2)
    across = np.abs(q[..., 0] * u[:, 1] - q[..., 1] * u[:, 0])
    mine = (across <= sheet.reach) & (along > 0.1 * length) & (along < 0.9 * length)
    # a skeleton has one pixel for every step along the longer axis
    steps = 0.8 * np.abs(span).max(axis=1) + 1e-9
    density = mine.sum(axis=0) / steps
    back, front = hidden.mean(axis=1) > 0.8, perhaps.mean(axis=1) < 0.1
    long = length > 6 * sheet.reach
    if not (back & long).any() or not (front & long).any():
        return False
    return bool(np.median(density[back & long]) < 0.8 * np.median(density[front & long]))


def _explained(points: Floats, shown: Bools, sheet: Sheet) -> float:
    """Weighted part of the skeleton within reach of the shown parts of the edges."""
    if not len(sheet.points):
        return 0.0
    canvas = np.zeros(sheet.distance.shape, np.uint8)
    thickness = max(1, int(2 * sheet.reach + 1.5))
    step = (points[:, 1] - points[:, 0]) / 2
    low = np.clip(np.rint(points - step[:, None]), -30000, 30000).astype(int)
    high = np.clip(np.rint(points + step[:, None]), -30000, 30000).astype(int)
    for edge in range(len(points)):
        runs = [(0, points.shape[1] - 1)] if shown[edge].all() else _runs(shown[edge])
        for a, b in runs:
            cv2.line(canvas, low[edge, a].tolist(), high[edge, b].tolist(), 1, thickness)
    hit = canvas[sheet.points[:, 1].astype(np.intp), sheet.points[:, 0].astype(np.intp)] > 0
    return float((hit * sheet.weights).sum() / sheet.weights.sum())


def _runs(show: Bools) -> list[tuple[int, int]]:
    """First and last index of every run of True."""
    flips = np.flatnonzero(np.diff(np.concatenate([[False], show, [False]]).astype(np.int8)))
    return [(int(a), int(b) - 1) for a, b in flips.reshape(-1, 2)]


def _drawn(near: Bools, rings: Rings, shown: Bools) -> Bools:
    """Back vertices at which at least two shown edge ends have ink."""
    edges = ring_edges([len(r) for r in rings.front])
    half = sum(len(r) for r in rings.front)
    lit = np.zeros(2 * half, int)
    first = (near & shown)[:, :10].mean(axis=1) > 0.3
    last = (near & shown)[:, -10:].mean(axis=1) > 0.3
    np.add.at(lit, edges[first, 0], 1)
    np.add.at(lit, edges[last, 1], 1)
    return np.asarray(lit[half:] >= 2)


def skeleton_sheet(distance: NDArray[np.float32], points: Floats, weights: Floats, reach: float, pen: float) -> Sheet:
    """A sheet with at most about 1500 of the skeleton's points, evenly thinned out."""
    step = max(1, len(points) // 1500)
    return Sheet(distance, points[::step], weights[::step], reach, pen)
