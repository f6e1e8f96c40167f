"""The best order from points alone: the most probable simple ring under a model of how faces look."""

from __future__ import annotations

import numpy as np

from sketch2shape.connect.angular import by_angle
from sketch2shape.connect.connection import Walk
from sketch2shape.connect.geometry import distances, ring_edges_of, segments_meet
from sketch2shape.connect.graham import convex_hull
from sketch2shape.connect.orthogonal import candidate_directions, pairings, solve
from sketch2shape.connect.regularity import CROSSING, EDGE_CUES, PAIR_CUES, Edges, edge_cues, edges_between, pair_cues
from sketch2shape.connect.search import EXHAUSTIVE, Energy, all_rings, canonical_rows, edge_index, improve, neighbours
from sketch2shape.connect.split_walk import split_walk
from sketch2shape.connect.tour import improve as shorten
from sketch2shape.connect.tour import insertion
from sketch2shape.connect.weights import EDGE_WEIGHTS, PAIR_WEIGHTS
from sketch2shape.model import Bools, Floats, Ints

#: above so many points the candidates are compared as they are: the pairs of all edges would be too many
ALL_EDGES = 32
#: above so many points the tour is not shortened
SHORTENED = 80
#: an order whose energy is within this of the best is named as an alternative: it is at least half as probable
TIE = float(np.log(2.0))


def auto(points: Floats) -> Walk:
    """The most probable simple ring through all points.

    Strategy: candidates are the pairings of rectilinear faces in any parallel view, the short tour, the walks and the
    angular order. Each is improved under the energy of `regularity`, and so are the best of their neighbours. Up to
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


def build(points: Floats) -> Energy:
    """The energy of all edges between the points."""
    ends, at = edge_index(len(points))
    return _energy(points, ends, at)


def _energy(points: Floats, ends: Ints, at: Ints) -> Energy:
    edges = edges_between(points, ends)
    edge = edge_cues(edges, convex_hull(points)) @ np.array([EDGE_WEIGHTS[name] for name in EDGE_CUES])
    pair = np.tensordot(np.array([PAIR_WEIGHTS[name] for name in PAIR_CUES]), pair_cues(edges), axes=1)
    return Energy(edge, pair + CROSSING * crossings(edges), at)


def crossings(edges: Edges) -> Bools:
    """(m, m) which pairs of edges meet other than in a common end, or leave it in the same direction."""
    a, b = edges.points[edges.ends[:, 0]], edges.points[edges.ends[:, 1]]
    meet = segments_meet(a[:, None], b[:, None], a[None], b[None], slack=1e-9)
    first, second = edges.ends[:, 0], edges.ends[:, 1]
    meet &= ~(
        (first[:, None] == first)
        | (second[:, None] == second)
        | (first[:, None] == second)
        | (second[:, None] == first)
    )
    return meet


def rank(points: Floats) -> tuple[Ints, Floats]:
    """Candidates (k, n) and their energies, best first: for many points."""
    orders = seeds(points)
    energies = np.array([_ring_energy(points, order) for order in orders])
    ranked = np.argsort(energies, kind="stable")
    return orders[ranked], energies[ranked]


def _ring_energy(points: Floats, order: Ints) -> float:
    """The energy of one ring, from its own edges only."""
    n = len(order)
    at = np.zeros((n, n), dtype=np.intp)
    at[order, np.roll(order, -1)] = at[np.roll(order, -1), order] = np.arange(n)
    return float(_energy(points, np.sort(ring_edges_of(order), axis=1), at).of(order[None])[0])


def rank_improved(points: Floats, model: Energy) -> tuple[Ints, Floats]:
    """Rings (k, n) and their energies, best first: all rings, or improved candidates and those near the best."""
    n = len(points)
    if n <= EXHAUSTIVE:
        orders = all_rings(n)
    else:
        minima = improve(model, seeds(points))
        best = minima[np.argmin(model.of(minima))]
        orders = np.unique(np.concatenate((minima, canonical_rows(neighbours(best)))), axis=0)
    energies = model.of(orders)
    ranked = np.argsort(energies, kind="stable")
    return orders[ranked], energies[ranked]


def seeds(points: Floats) -> Ints:
    """Rings to start from, (k, n)."""
    gaps = distances(points)
    inserted = insertion(gaps, convex_hull(points))
    found = [by_angle(points, points.mean(axis=0)), inserted]
    if len(points) <= SHORTENED:
        found.append(shorten(gaps, inserted))
    found += [split_walk(points, axis=axis).order for axis in ("y", "x")]
    if len(points) % 2 == 0:
        directions = candidate_directions(points)
        for tolerance in (0.01, 0.03):
            found += [order for _, order in solve(points, pairings(points, directions, tolerance))[:6]]
    return np.unique(canonical_rows(np.array(found)), axis=0)
