"""Spans: lines and arcs from one end of a rung to another that are drawn on both faces of a wireframe."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sketch2shape.geometry import cross
from sketch2shape.model import Floats, Ints
from sketch2shape.sweeps.outlines import Frame, arcs_between
from sketch2shape.sweeps.rungs import looked_up

WIDELY = 0.8
"""Reaches within which a span lies on ink: lines that meet at small angles draw each other's ends aside."""
DRAWN = 0.93
"""Part of a span that must lie on ink of both faces."""
ASIDE = 8.0
"""Pixels from either end of a span within which other lines may draw its own aside: a quarter of it at most."""
MOST_LINES = 200
"""Lines on both faces of a wireframe: some 100 were seen of 30 rungs; in a texture there are many more."""
LOOKS = 32
"""Points of a span that are looked up."""
LEAST_BULGE, MOST_BULGE = 0.04, 6.0
"""Bulges of arcs: less is a line, more a circle that is nearly whole."""
APEXES = 128
"""Places to either side of a chord at which the top of an arc is looked for."""
LEAST_RATIO, RATIOS = 0.1, 24
"""Least ratio of circles as seen, and how many are tried up to circles seen face on."""
SUMMITS = 3
"""Ratios that are looked at more closely."""
FINER = 0.03
"""Change of the best ratio, as a fraction, by which two more are tried."""
CELL, BETWEEN = 4.0, 3
"""Side of the cells, pixels, in which ink is counted once, and parts into which the way between two points is cut."""

STRAY = 0.1
"""Square pixels of misfit for a square pixel by which a span is shifted."""
FARTHEST, END_STEP = 6, 1.5
"""Pixels by which a span may be shifted to lie on ink, and steps of its ends."""
PARTS = np.arange(LOOKS) / LOOKS
"""Where on a span its points lie."""
_STEPS = END_STEP * np.arange(-2, 3)
END_SHIFTS = (_STEPS[:, None, None] * (1 - PARTS) + _STEPS[:, None] * PARTS).reshape(-1, LOOKS)
"""(c, LOOKS) shifts of the ends of a span."""
ARC_SHIFTS = (END_SHIFTS[:, None] + np.array([-3.0, -1.5, 0.0, 1.5, 3.0])[:, None] * 4 * PARTS * (1 - PARTS)).reshape(
    -1, LOOKS
)
"""The same with shifts of the top of an arc."""


@dataclass(frozen=True, eq=False)
class Field:
    """A wireframe seen from its front face.

    off   : (h, w) pixels to the ink of both faces
    nodes : (n, 2) front ends of rungs
    reach : pixels within which a place is on ink
    size  : of the drawing, pixels
    """

    off: NDArray[np.float32]
    nodes: Floats
    reach: float
    size: float


class Spans(NamedTuple):
    """Edges that the front face may have.

    first, second : (e,) int, the nodes at which each begins and ends
    bulges : (e,) float, 0 where it is straight
    misfit : (e,) float, mean squared distance to ink, square pixels
    points : (e, LOOKS, 2) float, pixels
    """

    first: Ints
    second: Ints
    bulges: Floats
    misfit: Floats
    points: Floats

    def at(self, some: Ints) -> Spans:
        """Some of them."""
        return Spans(self.first[some], self.second[some], self.bulges[some], self.misfit[some], self.points[some])


def spans_of(field: Field, along: Floats) -> list[tuple[Frame, Spans]]:
    """Lines and arcs between nodes, in the frames that explain more ink than those nearly like them, the best first.

    along : (2,) float of unit length, the direction in which circles are seen shortened

    None of a texture.
    """
    lines = _aside(_lines(field), along, field)
    if len(lines.first) > MOST_LINES:
        return []

    def told(ratio: float) -> tuple[float, Frame, Spans]:
        frame = Frame(along, ratio)
        both = _joined(lines, _aside(_arcs(field, frame), along, field))
        return _explained(both, field), frame, both

    every = [told(float(r)) for r in np.geomspace(LEAST_RATIO, 1.0, RATIOS)]
    value = np.pad([v for v, _, _ in every], 1)
    summits = np.flatnonzero((value[1:-1] >= value[:-2]) & (value[1:-1] > value[2:]))
    best = sorted((every[k] for k in summits.tolist()), key=lambda t: -t[0])[:SUMMITS]
    fine = [max((b, *(told(b[1].ratio * (1.0 + by)) for by in (-FINER, FINER))), key=lambda t: t[0]) for b in best]
    return [(frame, spans) for _, frame, spans in fine]


def _aside(spans: Spans, along: Floats, field: Field) -> Spans:
    """Those that do not run along the way to the back: their sides would be seen edge-on, as all are in a flat grid."""
    off = cross(spans.points - spans.points[:, :1], along)
    return spans.at(np.flatnonzero(np.ptp(off, axis=1) > field.reach))


def _joined(a: Spans, b: Spans) -> Spans:
    return Spans(
        np.concatenate([a.first, b.first]),
        np.concatenate([a.second, b.second]),
        np.concatenate([a.bulges, b.bulges]),
        np.concatenate([a.misfit, b.misfit]),
        np.concatenate([a.points, b.points]),
    )


def _lines(field: Field) -> Spans:
    """Straight lines between two nodes."""
    i, j = np.triu_indices(len(field.nodes), 1)
    p, q = field.nodes[i], field.nodes[j]
    points = p[:, None] + PARTS[:, None] * (q - p)[:, None]
    return _settled(Spans(i, j, np.zeros(len(i)), np.zeros(len(i)), points), field, END_SHIFTS)


def _settled(spans: Spans, field: Field, shifts: Floats) -> Spans:
    """Those that lie on ink when their ends, and the height of an arc, are shifted a little, with their misfit.

    shifts : (c, LOOKS) pixels along the normal that are tried
    """
    step = np.diff(spans.points, axis=1, append=2 * spans.points[:, -1:] - spans.points[:, -2:-1])
    normal = np.stack([-step[..., 1], step[..., 0]], axis=-1) / (np.hypot(step[..., 0], step[..., 1])[..., None] + 1e-9)
    places = np.arange(-FARTHEST, FARTHEST + 1)
    off = looked_up(field.off, spans.points[:, :, None] + places[:, None] * normal[:, :, None])
    likely = np.flatnonzero((off.min(axis=2) <= field.reach).mean(axis=1) >= DRAWN)
    off = off[likely]
    told = off[:, np.arange(LOOKS), np.rint(shifts).astype(np.intp) + FARTHEST]
    square = np.minimum(told, 2 * field.reach) ** 2
    long = np.hypot(step[likely, :-1, 0], step[likely, :-1, 1]).sum(axis=1)
    # where lines meet they draw each other aside
    inner = np.minimum(PARTS, 1 - PARTS) * long[:, None] > np.minimum(ASIDE, 0.25 * long)[:, None]
    misfit = (square * inner[:, None]).sum(axis=2) / inner.sum(axis=1)[:, None] + STRAY * (shifts**2).mean(axis=1)
    best, own = misfit.argmin(axis=1), np.arange(len(likely))
    drawn = ((told[own, best] <= field.reach) & inner).sum(axis=1) >= DRAWN * inner.sum(axis=1)
    return spans._replace(misfit=_filled(misfit[own, best], likely, len(spans.first))).at(likely[drawn])


def _filled(values: Floats, at: Ints, size: int) -> Floats:
    filled = np.zeros(size)
    filled[at] = values
    return filled


def _arcs(field: Field, frame: Frame) -> Spans:
    """Arcs between two nodes, of circles that this frame shows as circles."""
    nodes = frame.flat(field.nodes)
    i, j, bulge = _tops(field, frame, nodes)
    rough = looked_up(field.off, frame.seen(arcs_between(nodes[i], nodes[j], bulge, 8)))
    likely = (rough <= 2 * field.reach).all(axis=1)
    i, j, bulge = i[likely], j[likely], bulge[likely]
    points = frame.seen(arcs_between(nodes[i], nodes[j], bulge, LOOKS))
    found = _settled(Spans(i, j, bulge, np.zeros(len(i)), points), field, ARC_SHIFTS)
    half = 0.5 * np.hypot(*(nodes[found.second] - nodes[found.first]).T)
    return found.at(_distinct(found, half, field))


def _tops(field: Field, frame: Frame, nodes: Floats) -> tuple[Ints, Ints, Floats]:
    """Pairs of nodes with bulges of arcs between them whose top lies on ink."""
    i, j = np.triu_indices(len(nodes), 1)
    half = 0.5 * (nodes[j] - nodes[i])
    long = np.hypot(*half.T) + 1e-9
    far = np.minimum(MOST_BULGE, field.size / (long * max(frame.ratio, 0.3)))
    bulge = far[:, None] * np.linspace(-1.0, 1.0, 2 * APEXES)
    normal = np.stack([-half[:, 1], half[:, 0]], axis=1)
    top = frame.seen((nodes[i] + half)[:, None] + bulge[..., None] * normal[:, None])
    off = np.pad(looked_up(field.off, top), ((0, 0), (1, 1)), constant_values=np.inf)
    inner = off[:, 1:-1]
    nearest = (inner <= 2 * field.reach) & (inner < off[:, :-2]) & (inner <= off[:, 2:]) & (np.abs(bulge) > LEAST_BULGE)
    pair, place = np.nonzero(nearest)
    return i[pair], j[pair], bulge[pair, place]


def _distinct(found: Spans, half: Floats, field: Field) -> Ints:
    """The arcs that lie nearest to ink of those that are nearly one."""
    kept: list[int] = []
    height = found.bulges * half
    for e in np.argsort(found.misfit, kind="stable").tolist():
        same = [k for k in kept if found.first[k] == found.first[e] and found.second[k] == found.second[e]]
        if all(abs(height[k] - height[e]) > 3 * field.reach for k in same):
            kept.append(e)
    return np.array(sorted(kept), np.intp)


def cells_of(spans: Spans, field: Field) -> NDArray[np.float32]:
    """(e, high, wide) 1 for the cells that each span runs through, 0 for others."""
    high, wide = (int(n / CELL) + 2 for n in field.off.shape)
    step = np.diff(spans.points, axis=1, append=spans.points[:, -1:])
    part = np.arange(BETWEEN) / BETWEEN
    at = (spans.points[:, :, None] + part[:, None] * step[:, :, None]).reshape(len(step), LOOKS * BETWEEN, 2)
    x, y = np.clip(at / CELL, 0, [wide - 1, high - 1]).astype(np.intp).transpose(2, 0, 1)
    cells = np.zeros((len(step), high, wide), np.float32)
    cells[np.arange(len(step))[:, None], y, x] = 1.0
    return cells


def worth_of(spans: Spans, field: Field) -> Floats:
    """(e,) how closely each span lies on ink, 0..1."""
    return np.asarray(np.maximum(1.0 - spans.misfit / field.reach**2, 0.0))


def _explained(spans: Spans, field: Field) -> float:
    """How much ink the spans lie on, each piece once, and how closely."""
    if not len(spans.first):
        return 0.0
    return float((cells_of(spans, field) * worth_of(spans, field)[:, None, None]).max(axis=0).sum())
