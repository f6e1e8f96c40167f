"""Verification: draw a hypothesis again and compare it with the ink.

A good answer has ink under every edge that can be seen (`visibility`), treats all hidden edges alike (all drawn, all
dashed, or none) and leaves no large part of the drawing unexplained.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import NamedTuple

import cv2
import numpy as np

from sketch2shape.evidence.sheet import Sheet
from sketch2shape.evidence.visibility import edge_samples, hidden_depth, hidden_samples, in_picture
from sketch2shape.geometry import project
from sketch2shape.hypotheses import Frame, Rings, Stack, stack
from sketch2shape.model import Bools, Floats, Ints, Lines

STYLES: tuple[Lines, Lines, Lines] = ("wire", "dashed", "removed")
PERFECT = 0.995
"""Score that leaves nothing to be found."""
FIRST_LOOK = 16
"""Samples of an edge at the first, quick look."""
ALL_DRAWN, EACH_DRAWN = 0.97, 0.8
"""Part of the length that should be drawn, and of that of each edge, from which on it is."""
WHOLE = 0.75
"""Fraction of an edge with ink from which on it is drawn."""
DOUBTFUL = 0.1
"""Fraction of an edge by which a first look at a few samples may miss its ink."""
NOTABLE = 0.06
"""Length of a front edge, as a part of the longest, below which its ink is not asked for."""
SLACK = 1.3
"""How much more ink an edge may cover than the part of its length with ink: crossings, the ends of other lines."""
_FIRST = ((np.arange(FIRST_LOOK) + 0.5) / FIRST_LOOK)[:, None]


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

    @property
    def is_all_drawn(self) -> bool:
        """Whether all that should have been drawn has, whatever else has been drawn."""
        return self.support > ALL_DRAWN and self.weakest > EACH_DRAWN


def most_possible(stacked: Stack, sheet: Sheet) -> Floats:
    """(b,) float, at a quick first look: the score that each hypothesis can reach at most.

    The front is always seen whole, so its weakest edge limits the score; ink of which the edges touch little is not
    explained. Two connecting edges and one of the back have to be drawn.
    """
    v, after = stacked.vertices, stacked.frame.after
    m = v.shape[1] // 2
    around = np.arange(m)
    # front edges, connecting edges, back edges
    start = np.concatenate([around, around, around + m])
    end = np.concatenate([after, around + m, after + m])
    a, span = v[:, start, None], v[:, end] - v[:, start]
    share, seen = _first_look(a + _FIRST * span[:, :, None], sheet)
    share, seen = share.reshape(len(v), 3, m), seen.reshape(-1, 3, m)
    length = seen * np.sqrt(np.einsum("...k,...k", span, span)).reshape(len(v), 3, m)
    front = length[:, 0]
    whole = (share[:, 0] * front).sum(axis=1) >= 0.6 * front.sum(axis=1)
    ok = whole & ((share[:, 1] > 0.35).sum(axis=1) >= 2) & (share[:, 2] > 0.35).any(axis=1)
    weakest = np.where(front > NOTABLE * front.max(axis=1, keepdims=True), share[:, 0], 1.0).min(axis=1)
    explained = np.minimum(1.0, SLACK * (share * length).sum(axis=(1, 2)) / sheet.ink)
    return np.asarray(ok * 2 * explained / (1 + explained) * _held_by(weakest + DOUBTFUL))


def _first_look(points: Floats, sheet: Sheet) -> tuple[Floats, Floats]:
    """(b, 3m) part of each edge with ink, of what the picture shows of it, and that as a part of the edge."""
    inked = sheet.inked(points)
    if sheet.cut is None:
        return inked.mean(axis=2), np.ones((1, inked.shape[1]))
    seen = in_picture(points, sheet.cut).mean(axis=2)
    return np.where(seen > 0, inked.mean(axis=2) / np.maximum(seen, 1e-9), 1.0), seen


def _held_by(weakest: Floats) -> Floats:
    """(b,) factor on the score of hypotheses whose weakest edges have so much ink: one edge without any halves it."""
    return np.minimum(1.0, 0.5 + 0.5 * weakest / WHOLE)


def judge(rings: Rings, sheet: Sheet) -> Evidence:
    """Compare a hypothesis with the drawing, under the way its hidden lines seem to have been drawn."""
    return judge_stack(stack([rings]), sheet)[0]


def judge_all(rings: list[Rings], sheet: Sheet) -> list[Evidence]:
    """Compare many hypotheses with the drawing."""
    order = sorted(range(len(rings)), key=lambda k: rings[k].sizes)
    found: dict[int, Evidence] = {}
    for _, alike in groupby(order, key=lambda k: rings[k].sizes):
        same = list(alike)
        found.update(zip(same, judge_stack(stack([rings[k] for k in same]), sheet), strict=True))
    return [found[k] for k in range(len(rings))]


def judge_stack(stacked: Stack, sheet: Sheet) -> list[Evidence]:
    """Compare hypotheses with rings of the same sizes with the drawing."""
    points = edge_samples(stacked)
    near = sheet.inked(points)
    depth = hidden_depth(stacked, 1.5 * sheet.reach)
    v, edges = stacked.vertices, stacked.frame.edges
    span = v[:, edges[:, 1]] - v[:, edges[:, 0]]
    lengths = np.hypot(span[..., 0], span[..., 1])
    shows = True if sheet.cut is None else in_picture(points, sheet.cut)
    hidden = (depth == 2) & shows
    behind = _inked_part(near, hidden, lengths)
    style = _line_styles(behind, lengths)
    wire, dashed, removed = style == 0, style == 1, style == 2
    wanted = (wire[:, None, None] | ~grown(depth >= 1, lengths, 5 * sheet.reach)) & shows
    support, weakest = _support(_inked_part(near, wanted, lengths), wanted.all(axis=2), lengths)
    dashes, faintest = _support(behind, hidden.all(axis=2), lengths)
    with_dashes = np.minimum(support, 0.6 * support + 0.4 * np.minimum(1.0, dashes / 0.45))
    support = np.where(dashed, with_dashes, support)
    shown = wanted | ~removed[:, None, None]
    explained = _explained(points, shown, sheet)
    drawn = drawn_vertices(near & shown, stacked.frame)
    score = 2 * support * explained / (support + explained + 1e-9)
    score *= _held_by(weakest)
    # who dashes hidden edges dashes all of them
    score *= np.where(dashed, np.minimum(1.0, 0.85 + 0.15 * faintest / 0.25), 1.0)
    # a face alone, with all that would make it an object hidden behind it
    score *= np.where(drawn.sum(axis=1) < 2, 0.4, 1.0)
    figures = (x.tolist() for x in (score, support, explained, weakest))
    lines = [STYLES[k] for k in style.tolist()]
    return [Evidence(a, b, c, d, e, f) for a, b, c, d, e, f in zip(*figures, lines, drawn, strict=True)]


def grown(hidden: Bools, lengths: Floats, margin: float) -> Bools:
    """Hidden samples and those within margin pixels of one: where a line dives behind a contour, nobody can say."""
    n = hidden.shape[2]
    count = np.ceil(margin * n / (lengths + 1e-9))[..., None]
    at = np.arange(float(n))
    last = np.maximum.accumulate(np.where(hidden, at, -np.inf), axis=2)
    after = np.minimum.accumulate(np.where(hidden, at, np.inf)[..., ::-1], axis=2)[..., ::-1]
    return np.asarray((at - last <= count) | (after - at <= count))


class _InkedPart(NamedTuple):
    """Of the wanted samples of edges, (b, 3m) float, pixels: the length of all and of those with ink."""

    total: Floats
    inked: Floats


def _inked_part(near: Bools, wanted: Bools, lengths: Floats) -> _InkedPart:
    each = lengths / near.shape[2]
    return _InkedPart(wanted.sum(axis=2) * each, (near & wanted).sum(axis=2) * each)


def _support(part: _InkedPart, whole: Bools, lengths: Floats) -> tuple[Floats, Floats]:
    """(b,) part of the wanted length that is inked, and (b,) the same for the weakest edge; 1 if nothing is wanted.

    whole : (b, 3m), edges that are wanted from end to end
    """
    # what is left of a partly hidden edge must be long enough to tell
    notable = part.total > np.where(whole, 0.03, 0.12) * lengths.max(axis=1, keepdims=True)
    weakest = np.where(notable, part.inked / (part.total + 1e-9), 1.0).min(axis=1)
    every = part.total.sum(axis=1)
    nothing = every <= 0
    support = np.where(nothing, 1.0, part.inked.sum(axis=1) / np.where(nothing, 1.0, every))
    return support, np.where(nothing, 1.0, weakest)


def _line_styles(hidden: _InkedPart, lengths: Floats) -> Ints:
    """(b,) index into STYLES, from how much of the hidden length is inked: nearly all, some, or little."""
    length = hidden.total.sum(axis=1)
    share = hidden.inked.sum(axis=1) / (length + 1e-9)
    few = length < 0.02 * lengths.sum(axis=1)
    return np.where(few | (share > 0.93), 0, np.where(share > 0.3, 1, 2))


def is_dashed(rings: Rings, sheet: Sheet) -> bool:
    """Whether the hidden edges have clearly less ink to the pixel than the visible ones."""
    hidden, perhaps = hidden_samples(rings, 1.5 * sheet.reach)
    back, front = hidden.mean(axis=1) > 0.8, perhaps.mean(axis=1) < 0.1
    a, span = rings.segments
    length = np.linalg.norm(span, axis=1) + 1e-9
    long = length > 6 * sheet.reach
    if not (back & long).any() or not (front & long).any():
        return False
    along, across = project(sheet.points, a, span / length[:, None])
    mine = (across <= sheet.reach) & (along > 0.1 * length) & (along < 0.9 * length)
    # a skeleton has one pixel for every step along the longer axis
    density = mine.sum(axis=0) / (np.abs(span).max(axis=1) + 1e-9)
    return bool(np.median(density[back & long]) < 0.8 * np.median(density[front & long]))


def _explained(points: Floats, shown: Bools, sheet: Sheet) -> Floats:
    """(b,) weighted part of the skeleton within reach of the shown parts of the edges (points: their samples)."""
    found = np.zeros(len(points))
    if not len(sheet.points):
        return found
    thickness = max(1, int(2 * sheet.reach + 1.5))
    weights = sheet.weights / sheet.weights.sum()
    canvas = np.zeros(sheet.skeleton.mask.shape, np.uint8)
    owner, edge, first, last = _runs(shown)
    half = (points[:, :, 1] - points[:, :, 0]) / 2
    runs = np.stack([points[owner, edge, first] - half[owner, edge], points[owner, edge, last] + half[owner, edge]], 1)
    segments = np.clip(np.rint(runs), -30000, 30000).astype(np.int32)
    cuts = np.searchsorted(owner, np.arange(len(points) + 1)).tolist()
    for k, (a, b) in enumerate(pairwise(cuts)):
        canvas.fill(0)
        cv2.polylines(canvas, list(segments[a:b]), False, 1, thickness)
        found[k] = canvas.ravel().take(sheet.places) @ weights
    return found


def _runs(show: Bools) -> tuple[Ints, ...]:
    """Every run of True along the last axis of show (b, e, n), (k,) each: its b, its e, its first and last index."""
    b, e, n = show.shape
    padded = np.zeros((b, e, n + 2), bool)
    padded[..., 1:-1] = show
    flat = padded.ravel()
    flips = np.flatnonzero(flat[1:] != flat[:-1]).reshape(-1, 2)
    row, first = np.divmod(flips[:, 0], n + 2)
    return row // e, row % e, first, flips[:, 1] % (n + 2) - 1


def drawn_vertices(lit: Bools, frame: Frame) -> Bools:
    """(b, m) back vertices at which at least two shown edge ends have ink (lit: samples shown and inked)."""
    first, last = lit[..., :10].sum(axis=2) > 3, lit[..., -10:].sum(axis=2) > 3
    starts, ends, rungs = first[:, frame.backs], last[:, frame.backs[frame.before]], last[:, frame.rungs]
    return np.asarray((starts & ends) | (starts & rungs) | (ends & rungs))
