"""Exact verification: whether ruled lines that are known are those of a hypothesis, each line and every edge.

Lines of a file either lie on the edges or do not, so nothing is weighed. What is hidden is told as everywhere else
(`visibility`); where an edge dives behind a contour, a line may end a little earlier or later.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sketch2shape.evidence.overlaps import ONE_WAY
from sketch2shape.evidence.score import Evidence, drawn_vertices, grown
from sketch2shape.evidence.visibility import SAMPLES, hidden_depth
from sketch2shape.evidence.witness import directions, doubled
from sketch2shape.geometry import cross
from sketch2shape.hypotheses import Rings, Stack, stack, which_plausible
from sketch2shape.model import Bools, Floats, Ints, Lines
from sketch2shape.strokes import MEET

SURELY = 3.0
"""Working pixels behind the outline of the front face from which on a point is surely hidden."""
DIVES = 6.0
"""Working pixels before an edge is hidden in which it need not be drawn: two of the raster in which that is told."""
SLIPS = 10
"""Samples of an edge that is partly hidden which may be told wrongly: along contours that it nears at a small angle."""
SHORTEST = 2.0
"""Working pixels of the shortest edge that is told apart from none."""
SPATIAL = 3
"""Directions that the edges of an object have at least; with two it is a flat figure."""
LAID = 0.05
"""Part of what is seen of edges that may lie along other edges and say nothing against an answer."""


class _Laid(NamedTuple):
    """Pieces of lines that lie on edges: pairs of them.

    edge, piece : (k,) int, numbers of both
    first, last : (k,) int, the edge's samples along which the piece lies, from one to the other
    off         : (k, 2) float, pixels by which its ends miss the edge's line
    is_whole    : (k,) bool, whether it lies on that edge with all its length
    """

    edge: Ints
    piece: Ints
    first: Ints
    last: Ints
    off: Floats
    is_whole: Bools


def exactly_drawn(rings: Rings, pieces: Floats, dashed: Bools) -> tuple[Evidence, float] | None:
    """The evidence for a hypothesis that the lines show exactly, and their rms distance from it; else None.

    pieces : (k, 2, 2) float, ends of straight lines, working pixels
    dashed : (k,) bool, whether each is dashed
    """
    one = stack([rings])
    if not which_plausible(one, SHORTEST).all():
        return None
    v, edges = one.vertices[0], one.frame.edges
    a, span = v[edges[:, 0]], v[edges[:, 1]] - v[edges[:, 0]]
    length = np.hypot(span[:, 0], span[:, 1])
    laid = _laid(a, span / length[:, None], length, pieces)
    if len(np.unique(laid.piece[laid.is_whole])) < len(pieces):
        return None
    depth = hidden_depth(one, SURELY)[0]
    lines = _style(laid, dashed, depth == 2, ~grown(depth[None] >= 1, length[None], DIVES)[0])
    if lines is None or directions(span, length, SPATIAL) < SPATIAL:
        return None
    if _is_laid(a, span, length) and doubled(a, span, length, (depth == 0).mean(axis=1), SHORTEST) > LAID:
        return None
    drawn = np.ones(len(v) // 2, np.bool_) if lines != "removed" else _drawn(laid, depth, one)
    noise = float(np.sqrt((laid.off[laid.is_whole] ** 2).mean()))
    return Evidence(1.0, 1.0, 1.0, 1.0, lines, drawn), noise


def _is_laid(a: Floats, span: Floats, length: Floats) -> bool:
    """Whether some edge may run along another: a line of its direction that comes as close beside it."""
    unit = span / length[:, None]
    sine = np.abs(cross(unit[:, None], unit))
    to = a - a[:, None]
    start = cross(unit[:, None], to)
    end = start + cross(unit[:, None], span[None])
    near = (np.minimum(np.abs(start), np.abs(end)) <= SHORTEST) | (start * end < 0)
    along = (to * unit[:, None]).sum(axis=2)
    far = along + (span[None] * unit[:, None]).sum(axis=2)
    overlap = np.minimum(np.maximum(along, far), length[:, None]) - np.maximum(np.minimum(along, far), 0.0)
    np.fill_diagonal(near, False)
    return bool((near & (sine < ONE_WAY) & (overlap > 0)).any())


def _laid(a: Floats, unit: Floats, length: Floats, pieces: Floats) -> _Laid:
    """Which pieces lie on which edges, that begin at a and have these directions and lengths, in pixels."""
    to = pieces[None] - a[:, None, None]
    along = to[..., 0] * unit[:, None, None, 0] + to[..., 1] * unit[:, None, None, 1]
    across = cross(unit[:, None, None], to)
    low, high = along.min(axis=2), along.max(axis=2)
    from_, till = np.maximum(low, 0.0), np.minimum(high, length[:, None])
    edge, piece = np.nonzero((np.abs(across).max(axis=2) <= MEET) & (till - from_ > MEET))
    scale = SAMPLES / length[edge]
    first = np.ceil((from_[edge, piece] - MEET) * scale - 0.5).astype(np.intp)
    last = np.floor((till[edge, piece] + MEET) * scale - 0.5).astype(np.intp)
    whole = (till - from_ >= high - low - 2 * MEET)[edge, piece]
    first, last = np.maximum(first, 0), np.minimum(last, SAMPLES - 1)
    return _Laid(edge, piece, first, last, across[edge, piece], whole)


def _style(laid: _Laid, dashed: Bools, hidden: Bools, visible: Bools) -> Lines | None:
    """How hidden edges are drawn, if all lines lie where they should, and every edge is drawn that should be.

    hidden, visible : (e, SAMPLES) bool, samples that surely are
    """
    dashes = dashed[laid.piece]
    solid = _covered(laid, ~dashes, len(hidden))
    if not dashed.any() and solid.all():
        return "wire"
    bare = (visible & ~solid).sum(axis=1)
    is_drawn = ((bare == 0) | (bare <= SLIPS) & ~visible.all(axis=1)).all()
    if not is_drawn:
        return None
    right = _passed(laid, hidden) == 0
    if dashed.any():
        shown = _passed(laid, visible)
        right = np.where(dashes, (shown <= SLIPS) & (shown <= laid.last - laid.first), right)
        is_drawn = (solid | _covered(laid, dashes, len(hidden))).all()
    is_told = is_drawn and len(np.unique(laid.piece[laid.is_whole & right])) == len(dashed)
    return ("dashed" if dashed.any() else "removed") if is_told else None


def _covered(laid: _Laid, some: Bools, count: int) -> Bools:
    """(count, SAMPLES) bool, samples of the edges along which some of the pieces lie."""
    steps = np.zeros((count, SAMPLES + 1), np.intp)
    good = some & (laid.first <= laid.last)
    np.add.at(steps, (laid.edge[good], laid.first[good]), 1)
    np.add.at(steps, (laid.edge[good], laid.last[good] + 1), -1)
    return np.asarray(steps.cumsum(axis=1)[:, :-1] > 0)


def _passed(laid: _Laid, marked: Bools) -> Ints:
    """(k,) int, how many of the marked samples each piece passes on its edge."""
    sums = np.zeros((len(marked), SAMPLES + 1), np.intp)
    np.cumsum(marked, axis=1, out=sums[:, 1:])
    last = np.maximum(laid.last + 1, laid.first)
    return np.asarray(sums[laid.edge, last] - sums[laid.edge, np.minimum(laid.first, SAMPLES)])


def _drawn(laid: _Laid, depth: Ints, one: Stack) -> Bools:
    """(m,) bool, back vertices at which lines of two edges end."""
    lit = _covered(laid, np.ones(len(laid.edge), np.bool_), len(depth)) & (depth < 2)
    return np.asarray(drawn_vertices(lit[None], one.frame)[0])
