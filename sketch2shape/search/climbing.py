"""Climbing: from the cheapest hypotheses to cheaper ones around them, each step judged by the energy.

The sources follow ink, so where ink misleads them they end beside the truth: two corners of a chamfer taken for one, a
vertex caught by another line, a bend of the hand taken for one, two that lie close taken for each other. A step changes
one vertex (`neighbours`) or exchanges two, moves the likeliest few to the ink and keeps the cheapest (steepest ascent;
S. Russell, P. Norvig, "Artificial Intelligence", section on local search).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from sketch2shape.evidence import Evidence, View, judge_stack, most_possible
from sketch2shape.fit import FLAT, turns
from sketch2shape.hypotheses import Rings, Stack, split, stack, which_plausible
from sketch2shape.model import Bools, Floats
from sketch2shape.search.attempts import Looks
from sketch2shape.search.found import TIE, Found, hand_of, is_same, priced, total
from sketch2shape.search.neighbours import GAIN, MOST_CLIMBED, VERTEX, neighbours
from sketch2shape.search.refining import HOPELESS, compared_with, refined
from sketch2shape.search.tolerances import Traced

PRICED = 3
"""Hypotheses of a step that are priced, of each kind: those drawn best."""
CORNERED = 4
"""Rounds whose corners a vertex may move to."""
CLOSE, CLOSE_PENS = 2.0, 0.75
"""Pixels, or pens if that is more, within which two corners are one."""
EXCHANGED = 0.1
"""Part of the drawing's size within which two vertices may have been taken for each other."""
MOST_VERTICES = 24
"""Vertices of a face from which no search climbs."""
WOBBLES = 5.0
"""Standard deviations of the hand that an added edge is long at least: a shorter one is a wobble."""
FOLDED = 1.0
"""Pixels from the edge before it within which an edge that turns back lies on it."""


@dataclass(frozen=True, eq=False)
class _Ground:
    """What a climb goes over.

    view    : the drawing
    traced  : its strokes
    corners : (k, 2) float, pixels: where vertices may be; none if they may only be exchanged or left out
    hand    : noise of the hand, pixels
    steady  : whether lines are straight
    """

    view: View
    traced: Traced
    corners: Floats
    hand: float
    steady: bool


def climb(found: list[Found], looks: Looks, view: View, starts: int, *, closely: bool = False) -> list[Found]:
    """What lies above the cheapest few of the hypotheses found, of each climb all steps.

    looks   : at the drawing; their corners are where a vertex may move to
    view    : what hypotheses are held against
    starts  : how many of those found are started from
    closely : vertices may only be exchanged or left out
    """
    if not found:
        return []
    first = looks.rounds[0] if looks.rounds else looks.close
    corners = np.zeros((0, 2)) if closely else _corners(looks, view)
    steady = bool(looks.rounds) and first.is_steady
    ground = _Ground(view, first.traced, corners, hand_of(found), steady)
    return [step for top in _different(found)[:starts] for step in _climbed(top, ground)]


def _different(found: list[Found]) -> list[Found]:
    """The hypotheses, of those that are the same object the cheapest, the cheapest first."""
    tops: list[Found] = []
    for other in sorted(priced(found), key=total):
        if not any(is_same(other, top) for top in tops):
            tops.append(other)
    return tops


def _corners(looks: Looks, view: View) -> Floats:
    """(k, 2) float, pixels: where the rounds have corners, strokes end, or dashes meet."""
    rounds = looks.rounds or [looks.close]
    traced = rounds[0].traced
    every = [look.graph.points for look in rounds[:CORNERED]]
    points = np.concatenate([*every, traced.strokes.ends.reshape(-1, 2), traced.dash_ends])
    near = max(CLOSE, CLOSE_PENS * view.pen)
    kept = np.zeros((0, 2))
    for point in points:
        if not len(kept) or np.hypot(*(kept - point).T).min() > near:
            kept = np.vstack([kept, point])
    return kept


def _climbed(top: Found, ground: _Ground) -> Iterator[Found]:
    """Step after step upwards; faces with holes stay as they are."""
    if len(top.rings.sizes) > 1 or top.rings.sizes[0] > MOST_VERTICES:
        return
    for _ in range(MOST_CLIMBED):
        better = _step(top, ground)
        if better is None:
            return
        yield better
        top = better


def _step(top: Found, ground: _Ground) -> Found | None:
    """The cheapest neighbour that is clearly cheaper."""
    every = (_on_ink(top, rings, judged, ground) for rings, judged in _likely(top, ground))
    cheaper = [other for other in every if total(other) < total(top) - _least_gain(top, other)]
    return min(cheaper, key=total, default=None)


def _least_gain(top: Found, other: Found) -> float:
    """Nats that it has to save: one more vertex in one of a hundred places saves some by chance."""
    is_more = sum(other.rings.sizes) > sum(top.rings.sizes)
    return top.energy.vertex if is_more and top.energy is not None else TIE


def _on_ink(top: Found, rings: Rings, evidence: Evidence, ground: _Ground) -> Found:
    """The neighbour moved to the ink and priced; one whose edges fold back has no price.

    The hand stays as it was: it does not grow steadier as hypotheses explain more.
    """
    other = compared_with(refined(ground.traced, rings, evidence, top.sheet), ground.view)
    if other.compared is None or _fold_back(other.rings.vertices[None])[0]:
        return other
    return replace(other, energy=other.compared.energy(ground.hand), noise=max(other.noise, ground.hand))


def _likely(top: Found, ground: _Ground) -> Iterator[tuple[Rings, Evidence]]:
    """Of each kind of neighbours the one that is drawn best and, of the few drawn best, the cheapest."""
    kinds = _left_out(top.rings)
    if len(ground.corners):
        kinds = neighbours(top.rings, top.evidence, ground.corners, top.sheet)
    for moves in chain(_exchanged(top.rings, EXCHANGED * ground.view.size), kinds):
        some = moves.some(np.flatnonzero(_is_possible(moves, top, ground)))
        least = top.evidence.score - HOPELESS
        if len(some):
            some = some.some(np.flatnonzero(most_possible(some, top.sheet) > least))
        if not len(some):
            continue
        judged = judge_stack(some, top.sheet)
        hopeful = [k for k in range(len(judged)) if judged[k].score > least]
        order = sorted(hopeful, key=lambda k: -judged[k].score)[:PRICED]
        if not order:
            continue
        # where lines are not straight a vertex for each wobble saves ink: it has to be seen in the score too
        if _adds(moves, top) and not ground.steady and judged[order[0]].score < top.evidence.score + VERTEX + GAIN:
            continue
        costs = [_cost(split(some.vertices[k], some.sizes), judged[k], top, ground) for k in order]
        for k in dict.fromkeys((order[0], order[int(np.argmin(costs))])):
            yield split(some.vertices[k], some.sizes), judged[k]


def _cost(rings: Rings, evidence: Evidence, top: Found, ground: _Ground) -> float:
    """Nats, where it is: it has not been moved to the ink."""
    compared = compared_with(replace(top, rings=rings, evidence=evidence), ground.view).compared
    return np.inf if compared is None else compared.energy(ground.hand).total


def _is_possible(moves: Stack, top: Found, ground: _Ground) -> Bools:
    """(b,) bool: faces of an object, whose added edges no wobble makes."""
    wobble = top.energy.noise if _adds(moves, top) and top.energy is not None else 0.0
    least = max(ground.view.pen, WOBBLES * wobble)
    return np.asarray(which_plausible(moves, least) & ~_fold_back(moves.vertices))


def _adds(moves: Stack, top: Found) -> bool:
    return sum(moves.sizes) > sum(top.rings.sizes)


def _fold_back(vertices: Floats) -> Bools:
    """(b,) bool: an edge of a face runs back along the one before it; vertices (b, 2n, 2) of faces without holes."""
    faces = vertices.reshape(len(vertices), 2, -1, 2)
    edges = np.roll(faces, -1, axis=2) - faces
    ahead = np.roll(edges, -1, axis=2)
    longer = np.sqrt(np.maximum((edges**2).sum(axis=3), (ahead**2).sum(axis=3)))
    off = np.abs(edges[..., 0] * ahead[..., 1] - edges[..., 1] * ahead[..., 0])
    return np.asarray((((edges * ahead).sum(axis=3) < 0) & (off < FOLDED * longer)).any(axis=(1, 2)))


def _exchanged(rings: Rings, far: float) -> Iterator[Stack]:
    """Hypotheses with two vertices exchanged that lie close to each other."""
    v = rings.vertices
    i, j = np.triu_indices(len(v), 1)
    near = np.hypot(*(v[i] - v[j]).T) < far
    i, j = i[near], j[near]
    if len(i):
        many, k = np.repeat(v[None], len(i), 0), np.arange(len(i))
        many[k, i], many[k, j] = v[j], v[i]
        yield Stack(many, rings.sizes)


def _left_out(rings: Rings) -> Iterator[Stack]:
    """Hypotheses of faces without holes with one flat vertex less: it may be a bend of the hand."""
    front, back = rings.front[0], rings.back[0]
    flat = np.flatnonzero(np.maximum(turns(front), turns(back)) < FLAT)
    if len(front) > 3 and len(flat):
        yield stack([Rings((np.delete(front, i, 0),), (np.delete(back, i, 0),)) for i in flat])
