"""Witnesses: what speaks for and against an answer, from which its confidence follows.

Each is a number that does not depend on the size of the picture. `scripts/fit_confidence.py` weighs them.
"""

from __future__ import annotations

import cv2
import numpy as np

from sketch2shape.evidence.chords import chords, faces_of
from sketch2shape.evidence.energy import Comparison, Energy, near_line, nearest_edges
from sketch2shape.evidence.overlaps import HALF, ONE_WAY, PLACES, beside
from sketch2shape.evidence.score import Evidence
from sketch2shape.evidence.view import MOSTLY, View
from sketch2shape.hypotheses import Frame, Rings, frame
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes import join_ends, trace_skeleton

WITNESSES = (
    "unexplained",
    "attached",
    "closed",
    "loose",
    "weakest",
    "noise",
    "vertices",
    "unseen",
    "bend",
    "flat",
    "shallow",
    "small",
    "doubled",
    "map",
    "chords",
)
"""Names of the witnesses, in order."""
TOUCHING = 0.03
"""Fraction of the drawing's size up to which a path touches the object."""
LEAST_LINE = 0.04
"""Length of a line, as a fraction of the drawing's size, below which it is a letter's or an arrow's."""
LEAST_TOLERANCE, TOLERANCE = 1.5, 0.006
"""Pixels that a line which the object lacks may stray, at least, and as a fraction of the drawing's size."""
SHORT = 0.05
"""Length of an edge over the longest below which it has no direction."""
LEAST_POINTS = 8
"""Points of ink from which the bow of an edge can be told."""
BESIDE = 0.35
"""Pens between two edges drawn along each other."""
BLUR, PEN_BOW = 0.5, 0.1
"""Pixels, and pens more, by which the ink of a straight edge may seem to bow."""
ASIDE = 3.0
"""Standard deviations of the hand by which the ends of an edge lie aside of a line that runs in another direction."""
CORNERS = 4
"""Corners of a table."""
SPANNED = 0.05
"""Variance of a parabola over the ink of an edge from which its bow can be told; over a whole edge it is 0.089."""


def witnesses(rings: Rings, energy: Energy, compared: Comparison, evidence: Evidence) -> Floats:
    """(w,) float, see `WITNESSES`."""
    view = compared.view
    v = rings.vertices
    a, span = rings.segments
    length = np.hypot(span[:, 0], span[:, 1]) + 1e-9
    distance, edge = compared.every
    reach = near_line(energy.noise)
    left = distance > reach
    ink = float(view.length.sum()) + 1e-9
    size = view.size
    m = len(v) // 2
    depth = float(np.median(np.hypot(*(v[m:] - v[:m]).T)))
    return np.array(
        [
            float(view.length[left].sum()) / ink,
            attached(view, left, distance, size) / ink,
            closed(view, left) / size,
            np.log1p(_loose(view, a, span, reach)) if left.any() else 0.0,
            1.0 - evidence.weakest,
            np.log(energy.noise / view.noises[0]),
            np.log(m),
            1.0 - float(evidence.drawn.mean()),
            _bend(_bows(view, ~left & (view.slack == 0), edge, a, span / length[:, None], length), frame(rings.sizes)),
            float(directions(span, length) <= 2),
            np.log(depth / (view.pen + 2 * energy.noise)),
            np.log(size / view.pen),
            doubled(a, span, length, compared.shown, max(2.0, BESIDE * view.pen + energy.noise)),
            energy.shape / energy.vertex / m,
            _chords(rings, view.points[left], reach, size),
        ]
    )


def _chords(rings: Rings, foreign: Floats, reach: float, size: float) -> float:
    """See `chords`."""
    v, n, m = rings.vertices, rings.sizes[0], len(rings.vertices) // 2
    return chords(foreign, v, frame(rings.sizes).edges, lambda: faces_of(v[:n], v[m : m + n]), reach, size)


def attached(view: View, left: Bools, distance: Floats, size: float) -> float:
    """Length of unexplained paths that touch the object, pixels."""
    if not left.any():
        return 0.0
    touching = np.unique(view.path[left & (distance < TOUCHING * size)])
    return float(view.length[left & np.isin(view.path, touching)].sum())


def closed(view: View, left: Bools) -> float:
    """Square root of the area that unexplained ink encloses by itself, pixels."""
    if not left.any():
        return 0.0
    raster = np.zeros(view.skeleton.mask.shape, np.uint8)
    mine = np.unique(view.path[left])
    share = np.bincount(view.path, left, minlength=int(view.path.max(initial=0)) + 1) / np.maximum(
        np.bincount(view.path), 1
    )
    for k in mine[share[mine] > MOSTLY]:
        x, y = np.rint(view.skeleton.paths[k]).astype(np.intp).T
        raster[y, x] = 1
    closed = cv2.dilate(raster, np.ones((3, 3), np.uint8))
    contours, tree = cv2.findContours(closed, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    areas = [cv2.contourArea(c) for c, t in zip(contours, tree[0], strict=True) if t[3] >= 0] if contours else []
    return float(np.sqrt(max(areas, default=0.0)))


def _loose(view: View, a: Floats, span: Floats, reach: float) -> int:
    """Corners off the object where lines meet that it lacks: what else could be a part of something."""
    strokes = trace_skeleton(view.skeleton, max(LEAST_TOLERANCE, TOLERANCE * view.size))
    if not len(strokes.ends):
        return 0
    ends, way = strokes.ends[:, :1], strokes.ends[:, 1:] - strokes.ends[:, :1]
    off, _ = nearest_edges((ends + PLACES * way).reshape(-1, 2), a, span)
    foreign = (off.reshape(len(ends), -1) > reach).mean(axis=1) > MOSTLY
    foreign &= strokes.lengths > LEAST_LINE * view.size
    corners = join_ends(strokes, view.pen)
    meeting = np.bincount(corners.strokes[foreign].ravel(), minlength=len(corners.points)) >= 2
    away, _ = nearest_edges(corners.points, a, span)
    return int(np.count_nonzero(meeting & (away > reach + view.pen)))


def _bend(bows: Floats, rings: Frame) -> float:
    """The most that edges bow as an arc of the object would, as a fraction of the edge: arcs taken for chords.

    bows : (3m,) float, signed, nan where too little of an edge has ink to tell

    An arc is drawn twice, in both faces to the same side, and connecting edges that are arcs are the arcs of faces
    found elsewhere: two beside each other. The bow of an edge whose counterpart is straight is the hand's.
    """
    front, back, rung = bows[rings.fronts], bows[rings.backs], bows[rings.rungs]
    alone = np.isnan(front) ^ np.isnan(back)
    single = np.where(alone, np.fmax(np.abs(front), np.abs(back)), 0.0)
    pairs = (single, _alike(front, back), _alike(rung, rung[rings.after]))
    return float(max(both.max(initial=0.0) for both in pairs))


def _alike(one: Floats, other: Floats) -> Floats:
    """By how much both bow to the same side; 0 where it is not known of either."""
    least = np.where(one * other > 0, np.minimum(np.abs(one), np.abs(other)), 0.0)
    return np.asarray(np.nan_to_num(least))


def _bows(view: View, mine: Bools, edge: Ints, a: Floats, u: Floats, length: Floats) -> Floats:
    """(e,) how much the ink of each edge bows, and to which side, as a fraction of the edge; nan where little is known.

    What the pen may seem to bow is taken off.
    """
    p, e = view.points[mine], edge[mine]
    to = p - a[e]
    t = (to * u[e]).sum(axis=1) / length[e]
    off = to[:, 0] * u[e, 1] - to[:, 1] * u[e, 0]
    shape = 4 * t * (1 - t)
    n = np.bincount(e, minlength=len(a)) + 1e-9
    ms, mo = np.bincount(e, shape, len(a)) / n, np.bincount(e, off, len(a)) / n
    cov, var = np.bincount(e, (shape - ms[e]) * (off - mo[e]), len(a)), np.bincount(e, (shape - ms[e]) ** 2, len(a))
    # ink along a part of an edge says nothing of how the whole bows
    some = (n >= LEAST_POINTS) & (var >= SPANNED * n)
    bow = cov / np.where(some, var, 1.0)
    more = np.maximum(np.abs(bow) - BLUR - PEN_BOW * view.pen, 0.0)
    return np.where(some, np.sign(bow) * more / length, np.nan)


def directions(span: Floats, length: Floats, enough: int | None = None) -> int:
    """Directions that the edges have, to within some six degrees; no more are looked for than are enough."""
    found: list[float] = []
    for k in np.argsort(-length):
        if length[k] < SHORT * length.max() or len(found) == enough:
            break
        angle = float(np.arctan2(span[k, 1], span[k, 0]) % np.pi)
        if all(min(abs(angle - f), np.pi - abs(angle - f)) > ONE_WAY for f in found):
            found.append(angle)
    return len(found)


def is_table(rings: Rings, noise: float, *, is_all: bool) -> bool:
    """Whether all edges run in two directions, to the noise of the hand, pixels: a table is drawn so, and no object.

    The third direction of an object shows even where it is seen nearly along a face. Where it does not, as in an L seen
    along its arm, the outline has more than four sides.

    is_all : whether it explains all there is; else it may be a part of a table
    """
    return _is_crosswise(rings, noise) and (not is_all or _is_four_sided(rings.vertices, noise))


def _is_four_sided(v: Floats, noise: float) -> bool:
    """Whether the hull of vertices (k, 2) is a quadrangle, to the noise of the hand, pixels."""
    hull = cv2.convexHull(v.astype(np.float32))
    return len(cv2.approxPolyDP(hull, ASIDE * noise, True)) <= CORNERS


def _is_crosswise(rings: Rings, noise: float) -> bool:
    edges = frame(rings.sizes).edges
    left = rings.vertices[edges[:, 1]] - rings.vertices[edges[:, 0]]
    for _ in range(2):
        longest = left[int(np.hypot(*left.T).argmax())]
        aside = np.abs(left[:, 0] * longest[1] - left[:, 1] * longest[0]) / (np.hypot(*longest) + 1e-9)
        left = left[aside > ASIDE * noise]
        if not len(left):
            return True
    return False


def doubled(a: Floats, span: Floats, length: Floats, shown: Floats, reach: float) -> float:
    """Fraction of the length of what is seen of edges (shown: (e,), fraction of each) that lies along another."""
    laid = beside(a, span, length, reach) & (shown > HALF)
    if not laid.any():
        return 0.0
    seen = length * shown
    return float((laid.any(axis=2).mean(axis=1) * seen).sum() / (seen.sum() + 1e-9))
