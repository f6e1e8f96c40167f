"""The best order from points alone: the most probable simple ring under a model of how faces look."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.connectors.angular import by_angle
from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.graham import convex_hull
from sketch2shape.connectors.orthogonal import candidate_pencils, pairings, solve
from sketch2shape.connectors.polygon import ON_LINE
from sketch2shape.connectors.ring_regularity import (
    CROSSING,
    EDGE_CUES,
    PAIR_CUES,
    Edges,
    edge_cues,
    edges_between,
    pair_cues,
)
from sketch2shape.connectors.ring_search import (
    EXHAUSTIVE,
    Energy,
    all_rings,
    canonical_rows,
    distinct,
    edge_index,
    improve,
    neighbours,
)
from sketch2shape.connectors.split_walk import split_walk
from sketch2shape.connectors.tour import improve as shorten
from sketch2shape.connectors.tour import insertion
from sketch2shape.connectors.weights import KINDS
from sketch2shape.connectors.whole_ring import RING_CUES, ring_cues
from sketch2shape.geometry import cross, distances
from sketch2shape.model import Bools, Floats, Ints

#: above so many points the candidates are compared as they are: the pairs of all edges would be too many
ALL_EDGES = 32
#: inverse distances of vanishing points that are tried, in sizes of the face
CONVERGE = (0.0, 0.07, -0.07, 0.15, -0.15, 0.24, -0.24)
#: rings of each kind that are looked at as a whole
SHORTLIST = 80
#: rings that are improved, for each kind
STARTS = 6
#: residuals that leave little doubt that a face is rectilinear, as parts of its size
STRAIGHT = (2e-4, 3e-3)
#: above so many points the tour is not shortened
SHORTENED = 80
#: an order whose energy is within this of the best is named as an alternative: it is at least half as probable
TIE = float(np.log(2.0))


def auto(points: Floats) -> Walk:
    """The most probable simple ring through all points.

    Strategy: candidates are the pairings of rectilinear faces in any parallel view, the short tour, the walks and the
    angular order. Each is improved under the energies of `regularity`, and so are the best of their neighbours. Up to
    eight points all rings are compared. Sureness is the probability of the answer among the rings looked at.
    """
    orders, energies = rank(points) if len(points) > ALL_EDGES else rank_improved(points, build(points))
    chance = np.exp(energies[0] - energies)
    rivals = np.flatnonzero(energies < energies[0] + TIE)[1:]
    said = ("two or more orders are about equally probable",) if len(rivals) else ()
    return Walk(
        orders[0],
        met=("every point is used",),
        violated=said,
        sureness=float(1.0 / chance.sum()),
        alternatives=tuple(orders[i] for i in rivals),
    )


@dataclass(frozen=True)
class Model:
    """What makes a ring through some points probable.

    edges    : all edges that rings may use
    at       : (n, n) index of the edge between two points
    kinds    : energy of edges and pairs of edges, for each kind of face
    parallel : (m, m) how parallel edges are, 0..1, by a narrow standard
    loosely  : (m, m) the same by a wide one
    """

    edges: Edges
    at: Ints
    kinds: tuple[Energy, ...]
    parallel: Floats
    loosely: Floats

    def of(self, orders: Ints) -> Floats:
        """(k,) energies of rings (k, n)."""
        whole = ring_cues(self.edges, self.parallel, self.loosely, self.at, orders)
        by_kind = [
            kind.of(orders) + whole @ np.array([weights[name] for name in RING_CUES])
            for kind, weights in zip(self.kinds, KINDS, strict=True)
        ]
        return mixed(np.array(by_kind))


def build(points: Floats) -> Model:
    """The model over all edges between the points."""
    return _model(points, *edge_index(len(points)))


def _model(points: Floats, ends: Ints, at: Ints) -> Model:
    edges = edges_between(points, ends)
    single, pairs = edge_cues(edges, convex_hull(points)), pair_cues(edges)
    crossed = np.where(crossings(edges), CROSSING, 0.0)
    found = []
    for weights in KINDS:
        edge = single @ np.array([weights[name] for name in EDGE_CUES])
        edge += weights["face"] / len(points) + weights["vertex"]  # the same for every ring: kinds against each other
        pair = crossed.copy()
        for name, cue in zip(PAIR_CUES, pairs, strict=True):
            pair += weights[name] * cue
        np.fill_diagonal(pair, 0.0)
        found.append(Energy(edge, pair, at))
    parallel, loosely = (pairs[PAIR_CUES.index(name)] for name in ("parallel", "parallel_loose"))
    np.fill_diagonal(parallel, 0.0)
    return Model(edges, at, tuple(found), parallel, loosely)


def mixed(energies: Floats) -> Floats:
    """(k,) energy of rings that may be of any kind, from their energies (kinds, k) as each kind."""
    least = energies.min(axis=0)
    return np.asarray(least - np.log(np.exp(least - energies).sum(axis=0)))


def crossings(edges: Edges) -> Bools:
    """(m, m) which pairs of edges meet other than in a common end.

    Everything follows from the side of each edge on which each point lies.
    """
    a, b = edges.points[edges.ends[:, 0]], edges.points[edges.ends[:, 1]]
    arms = edges.points[None] - a[:, None]
    side = cross((b - a)[:, None], arms)
    side[np.abs(side) < ON_LINE] = 0.0
    side = np.sign(side)
    reach = (arms * edges.vector[:, None]).sum(axis=2)
    on = (side == 0) & (reach > 0) & (reach < (edges.length**2)[:, None])
    np.put_along_axis(on, edges.ends, False, axis=1)
    np.put_along_axis(side, edges.ends, 0.0, axis=1)
    apart = side[:, edges.ends[:, 0]] * side[:, edges.ends[:, 1]] < 0
    touch = on[:, edges.ends[:, 0]] | on[:, edges.ends[:, 1]]
    return np.asarray((apart & apart.T) | touch | touch.T)


def rank(points: Floats) -> tuple[Ints, Floats]:
    """Candidates (k, n) and their energies, best first: for many points."""
    straight, evidence = straight_pairings(points)
    orders, _ = distinct(np.concatenate((straight, seeds(points))))
    energies = np.array([_ring_energy(points, order) for order in orders])
    return _ranked(orders, energies - evidence * _among(orders, straight))


def _ranked(orders: Ints, energies: Floats) -> tuple[Ints, Floats]:
    ranked = np.argsort(energies, kind="stable")
    return orders[ranked], energies[ranked]


def _among(orders: Ints, some: Ints) -> Bools:
    """Which rings (k, n), in canonical form, are among some others."""
    return np.asarray((orders[:, None] == canonical_rows(some)[None]).all(axis=2).any(axis=1))


def _ring_energy(points: Floats, order: Ints) -> float:
    """The energy of one ring, from its own edges only."""
    n = len(order)
    at = np.zeros((n, n), dtype=np.intp)
    at[order, np.roll(order, -1)] = at[np.roll(order, -1), order] = np.arange(n)
    ends = np.column_stack((order, np.roll(order, -1)))
    return float(_model(points, np.sort(ends, axis=1), at).of(order[None])[0])


def rank_improved(points: Floats, model: Model) -> tuple[Ints, Floats]:
    """Rings (k, n) and their energies, best first: out of all rings, or of improved candidates and those near them."""
    starts = seeds(points)
    if len(points) <= EXHAUSTIVE:
        every = all_rings(len(points))
        found = [every[np.argsort(kind.of(every), kind="stable")[:SHORTLIST]] for kind in model.kinds]
    else:
        found = [_improved(kind, starts) for kind in model.kinds]
    straight, evidence = straight_pairings(points)
    orders, _ = distinct(np.concatenate((straight, starts, *found)))
    return _ranked(orders, model.of(orders) - evidence * _among(orders, straight))


def _improved(kind: Energy, starts: Ints) -> Ints:
    """Rings that no exchange improves, and the best of those one exchange away from the best of them."""
    likely = np.argsort(kind.of(starts), kind="stable")[:STARTS]
    minima = improve(kind, starts[likely])
    near, above = neighbours(kind, minima[np.argmin(kind.of(minima))])
    return np.concatenate((minima, near[np.argsort(above, kind="stable")[:SHORTLIST]]))


def straight_pairings(points: Floats) -> tuple[Ints, float]:
    """Rings (k, n) that pair up along two directions almost without residual, and the log odds that says for them.

    By chance a vertex is on one of the lines with odds of about 20 tolerances; four vertices always fit, and half of
    the evidence is left to other faces whose regularity makes them fit.
    """
    nothing = np.empty((0, len(points)), dtype=np.intp)
    if len(points) % 2:
        return nothing, 0.0
    pencils = candidate_pencils(points, anchors=2)
    for tolerance in STRAIGHT:
        found = [order for _, order in solve(points, pairings(points, pencils, tolerance))]
        if found:
            return np.array(found), 0.5 * (len(points) - 4) * float(np.log(1.0 / (20.0 * tolerance)))
    return nothing, 0.0


def seeds(points: Floats) -> Ints:
    """Rings to start from, (k, n)."""
    gaps = distances(points)
    inserted = insertion(gaps, convex_hull(points))
    found = [by_angle(points, points.mean(axis=0)), inserted]
    if len(points) <= SHORTENED:
        found.append(shorten(gaps, inserted))
    found += [split_walk(points, axis=axis).order for axis in ("y", "x")]
    if len(points) % 2 == 0:
        for tolerance, converge in ((0.015, CONVERGE), (0.03, (0.0,))):
            pencils = candidate_pencils(points, converge)
            found += [order for _, order in solve(points, pairings(points, pencils, tolerance))[:6]]
    return distinct(np.array(found))[0]
