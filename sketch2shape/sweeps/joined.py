"""Joined: wireframes put together from lines and arcs that run from rung to rung on both faces.

Where lines cross, or run into each other, closed lines cannot be followed over pixels. But the ends of rungs are seen,
and each vertex has two edges: of all lines and arcs that both faces show, those are chosen that explain the most ink
and leave two at each vertex or none (a 2-factor of most weight, by integer programming).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import cv2
import numpy as np

from sketch2shape.model import Floats, Ints
from sketch2shape.strokes import Skeleton
from sketch2shape.sweeps.outlines import Frame, Outline
from sketch2shape.sweeps.pieces import rounded
from sketch2shape.sweeps.rungs import off_both, reach_of, rung_ends
from sketch2shape.sweeps.spans import WIDELY, Field, Spans, cells_of, spans_of, worth_of
from sketch2shape.sweeps.sweep import Sweep, Way

MOST_NODES = 64
"""Ends of rungs of a wireframe that is put together."""
FRAMES = 2
"""Frames that are tried, the best."""
LINE_PRICE, ARC_PRICE = 0.017, 0.03
"""Length of ink over the drawing's size that a line, or an arc, has to explain to be told."""
SHARED = 0.5
"""Part of a span beside another from which on both are the same ink."""
MOST_STEPS = 4000
"""Nodes of the search for the best choice."""
MOST_SHARED = 4000
"""Pairs of spans on the same ink beyond which none is chosen: wireframes that are read have some 1,600 at most. With
15,000 the solver takes seconds, with 326,000, of a hatched cube, it had made no end in ten minutes."""
SMOOTH = 0.3
"""Angle, radians, up to which a line and an arc, or two arcs, run into each other smoothly."""


def joined(skeleton: Skeleton, at: Floats, shifts: Sequence[Floats], size: float) -> Iterator[Sweep]:
    """Objects put together from what a wireframe shows on both faces.

    at     : (k, 2) float, pixels, where lines meet
    shifts : (2,) each, pixels, that may lead to the back face
    size   : of the drawing, pixels
    """
    for shift in shifts:
        nodes = rung_ends(skeleton, at, shift, size)
        if not 2 <= len(nodes) <= MOST_NODES:
            continue
        field = Field(off_both(skeleton, shift), nodes, WIDELY * reach_of(skeleton, size), size)
        told = [(frame, spans, *_choice(spans, field)) for frame, spans in spans_of(field, shift / np.hypot(*shift))]
        for frame, spans, chosen, _ in sorted(told, key=lambda t: -t[3])[:FRAMES]:
            rings = _nested([_outlined(r, frame, field) for r in _rings(spans.at(chosen))])
            if rings:
                yield Sweep(rings, Way(shift))


def _rings(chosen: Spans) -> list[tuple[Ints, Floats]]:
    """Vertices and bulges of the rings that spans close."""
    ends = list(zip(chosen.first.tolist(), chosen.second.tolist(), chosen.bulges.tolist(), strict=True))
    rings: list[tuple[Ints, Floats]] = []
    while ends:
        start, at, bulge = ends.pop(0)
        vertices, bulges = [start], [bulge]
        while at != start:
            k = next(k for k, end in enumerate(ends) if at in end[:2])
            first, second, bulge = ends.pop(k)
            vertices.append(at)
            bulges.append(bulge if first == at else -bulge)
            at = second if first == at else first
        rings.append((np.array(vertices), np.array(bulges)))
    return rings


def _choice(spans: Spans, field: Field) -> tuple[Ints, float]:
    """The spans that explain the most ink, two at a node or none, none of it twice, and how much that is.

    None if too many are on the same ink.
    """
    from scipy.optimize import Bounds, LinearConstraint, milp  # slow to load, and seldom needed
    from scipy.sparse import coo_array

    e, n = len(spans.first), len(field.nodes)
    if not e:
        return np.zeros(0, np.intp), 0.0
    long = np.hypot(*np.diff(spans.points, axis=1).transpose(2, 0, 1)).sum(axis=1)
    price = np.where(spans.bulges == 0.0, LINE_PRICE, ARC_PRICE) * field.size
    gain = np.concatenate([long * worth_of(spans, field) - price, np.zeros(n)])
    one, other = _same_ink(spans, field)
    if len(one) > MOST_SHARED:
        return np.zeros(0, np.intp), 0.0
    own, c = np.arange(e), len(one)
    rows = np.concatenate([spans.first, spans.second, np.arange(n), n + np.arange(c), n + np.arange(c)])
    columns = np.concatenate([own, own, e + np.arange(n), one, other])
    values = np.concatenate([np.ones(2 * e), np.full(n, -2.0), np.ones(2 * c)])
    table = coo_array((values, (rows, columns)), shape=(n + c, e + n)).tocsc()
    # older versions of the solver take no longer numbers
    table.indices, table.indptr = table.indices.astype(np.int32), table.indptr.astype(np.int32)
    limits = LinearConstraint(table, np.append(np.zeros(n), np.full(c, -1.0)), np.append(np.zeros(n), np.ones(c)))
    found = milp(
        -gain, constraints=limits, integrality=np.ones(e + n), bounds=Bounds(0, 1), options={"node_limit": MOST_STEPS}
    )
    if found.x is None:
        return np.zeros(0, np.intp), 0.0
    return np.flatnonzero(found.x[:e] > 0.5), -float(found.fun)


def _same_ink(spans: Spans, field: Field) -> tuple[Ints, Ints]:
    """Pairs of spans of which one runs beside the other for the most part."""
    cells = cells_of(spans, field)
    near = np.stack([cv2.dilate(c, np.ones((3, 3), np.uint8)) for c in cells])
    flat = cells.reshape(len(cells), -1)
    beside = flat @ near.reshape(len(cells), -1).T / np.maximum(flat.sum(axis=1), 1.0)[:, None]
    one, other = np.nonzero(np.triu(np.maximum(beside, beside.T) > SHARED, 1))
    return one, other


def _outlined(ring: tuple[Ints, Floats], frame: Frame, field: Field) -> Outline:
    """A ring as an outline; a circle of arcs as a whole one."""
    at, bulges = ring
    made = Outline(frame, field.nodes[at], bulges, np.zeros(len(at), np.bool_))
    if made.curved.all():
        whole = rounded(made.line, frame)
        if whole.circle is not None:
            radii = np.hypot(*(frame.flat(made.line) - whole.circle.centre).T)
            if np.abs(radii - whole.circle.radius).max() * min(frame.ratio, 1.0) < field.reach:
                return whole
    bends = made.curved | np.roll(made.curved, 1)
    return Outline(frame, made.vertices, bulges, (made.turns < SMOOTH) & bends)


def _nested(rings: list[Outline]) -> tuple[Outline, ...]:
    """The largest ring and those inside it."""
    ordered = sorted(rings, key=lambda r: -cv2.contourArea(r.line.astype(np.float32)))
    if not ordered:
        return ()
    outer = ordered[0].line.astype(np.float32)

    def is_inside(ring: Outline) -> bool:
        return all(cv2.pointPolygonTest(outer, (float(x), float(y)), False) > 0 for x, y in ring.line[::8])

    return (ordered[0], *(r for r in ordered[1:] if is_inside(r)))
