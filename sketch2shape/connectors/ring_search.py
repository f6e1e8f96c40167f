"""Rings of least energy, where the energy is a sum over edges and over pairs of edges.

Strategy: up to eight points every ring is looked at. Above that, several rings are improved side by side by the best
exchange of two edges (2-opt) or move of one to three points (or-opt). An exchange changes two or three edges only, so
its gain follows from the field r = W x of the ring: no ring is summed anew.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import permutations

import numpy as np

from sketch2shape.model import Bools, Floats, Ints

#: up to so many points all (n - 1)! / 2 rings are looked at
EXHAUSTIVE = 8
#: exchanges one ring may go through
ROUNDS = 60


@dataclass(frozen=True)
class Energy:
    """Energy of rings through n points.

    edge : (m,) energy of each of the m = n (n - 1) / 2 edges
    pair : (m, m) energy of each pair, symmetric, 0 on the diagonal
    at   : (n, n) index of the edge between two points
    """

    edge: Floats
    pair: Floats
    at: Ints

    def of(self, orders: Ints) -> Floats:
        """(k,) energies of rings (k, n)."""
        used = self.at[orders, np.roll(orders, -1, axis=1)]
        pairs = self.pair.take(used[:, :, None] * len(self.edge) + used[:, None, :]).sum(axis=(1, 2))
        return np.asarray(self.edge[used].sum(axis=1) + 0.5 * pairs)


def edge_index(n: int) -> tuple[Ints, Ints]:
    """(m, 2) ends of all edges between n points, and (n, n) the index of each (the diagonal is 0 and not used)."""
    ends = np.column_stack(np.triu_indices(n, 1))
    at = np.zeros((n, n), dtype=np.intp)
    at[ends[:, 0], ends[:, 1]] = at[ends[:, 1], ends[:, 0]] = np.arange(len(ends))
    return ends, at


@lru_cache(maxsize=8)
def all_rings(n: int) -> Ints:
    """((n - 1)! / 2, n) every ring through n points once."""
    rest = np.array(list(permutations(range(1, n))), dtype=np.intp).reshape(-1, n - 1)
    rest = rest[rest[:, 0] < rest[:, -1]]
    return np.column_stack((np.zeros(len(rest), dtype=np.intp), rest))


@dataclass(frozen=True)
class Moves:
    """Exchanges of k edges of a ring of n, by position.

    removed, added : (M, k, 2) positions of the ends of the edges that go and come
    order          : (M, n) positions in their new order
    """

    removed: Ints
    added: Ints
    order: Ints


@lru_cache(maxsize=32)
def reversals(n: int) -> Moves:
    """2-opt: every way to reverse a stretch."""
    i, j = np.triu_indices(n, 2)
    keep = ~((i == 0) & (j == n - 1))
    i, j = i[keep], j[keep]
    p = np.broadcast_to(np.arange(n), (len(i), n))
    inside = (p > i[:, None]) & (p <= j[:, None])
    order = np.where(inside, (i + 1 + j)[:, None] - p, p)
    k = (j + 1) % n
    removed = np.stack((np.stack((i, i + 1), 1), np.stack((j, k), 1)), 1)
    added = np.stack((np.stack((i, j), 1), np.stack((i + 1, k), 1)), 1)
    return Moves(removed, added, order)


@lru_cache(maxsize=32)
def relocations(n: int) -> Moves:
    """Or-opt: every way to move a stretch of one to three points, either way round, to another edge."""
    removed, added, orders = [], [], []
    for start in range(n):
        ring = [(start + p) % n for p in range(n)]
        for length in range(1, min(4, n - 2)):
            piece, rest = ring[:length], ring[length:]
            for gap in range(len(rest) - 1):
                u, v = rest[gap], rest[gap + 1]
                for part in (piece, piece[::-1]) if length > 1 else (piece,):
                    removed.append(((rest[-1], piece[0]), (piece[-1], rest[0]), (u, v)))
                    added.append(((rest[-1], rest[0]), (u, part[0]), (part[-1], v)))
                    orders.append(rest[: gap + 1] + part + rest[gap + 1 :])
    return Moves(np.array(removed, dtype=np.intp), np.array(added, dtype=np.intp), np.array(orders, dtype=np.intp))


def gains(energy: Energy, orders: Ints, moves: Moves) -> Floats:
    """(k, M) change of energy of each ring (k, n) by each move; negative is better."""
    used = energy.at[orders, np.roll(orders, -1, axis=1)]
    field = energy.edge + energy.pair[used].sum(axis=1)
    pair, m, rows = energy.pair.ravel(), len(energy.edge), np.arange(len(orders))[:, None] * len(energy.edge)
    out = _edges_at(energy.at, orders, moves.removed)
    new = _edges_at(energy.at, orders, moves.added)
    change = np.zeros(out[0].shape)
    for p in range(len(out)):
        change += field.take(new[p] + rows) - field.take(out[p] + rows)
        from_new, from_out = new[p] * m, out[p] * m
        for q in range(len(out)):
            change -= pair.take(from_new + out[q])
            if q > p:
                change += pair.take(from_new + new[q]) + pair.take(from_out + out[q])
    return change


def _edges_at(at: Ints, orders: Ints, positions: Ints) -> list[Ints]:
    """Indices of the edges between positions (M, k, 2) in each ring, one (rings, M) array for each of the k."""
    n = orders.shape[1]
    return [
        at.take(orders.take(positions[:, p, 0], axis=1) * n + orders.take(positions[:, p, 1], axis=1))
        for p in range(positions.shape[1])
    ]


def improve(energy: Energy, orders: Ints) -> Ints:
    """Improve rings (k, n), the best move first, until no move helps; equal rings are merged on the way."""
    n = orders.shape[1]
    active, done = orders, []
    for _ in range(ROUNDS):
        moved, following = _best_moves(energy, active, reversals(n))
        stuck = ~moved
        if stuck.any():  # the moves are many: tried only where no exchange of two edges helps
            moved[stuck], following[stuck] = _best_moves(energy, active[stuck], relocations(n))
        done.append(active[~moved])
        active, _ = distinct(following[moved])
        if len(active) == 0:
            break
    return distinct(np.concatenate([*done, active]))[0]


def _best_moves(energy: Energy, orders: Ints, moves: Moves) -> tuple[Bools, Ints]:
    """Which rings the best move lowers, and the rings after it."""
    change = gains(energy, orders, moves)
    at = change.argmin(axis=1)
    better = change[np.arange(len(orders)), at] < -1e-9
    return better, np.take_along_axis(orders, moves.order[at], axis=1)


def neighbours(energy: Energy, order: Ints) -> tuple[Ints, Floats]:
    """All rings one move from a ring, and how much their energies are above its own."""
    kinds = (reversals(len(order)), relocations(len(order)))
    rings = np.concatenate([order[moves.order] for moves in kinds])
    return rings, np.concatenate([gains(energy, order[None], moves)[0] for moves in kinds])


def distinct(orders: Ints) -> tuple[Ints, Ints]:
    """Each of the rings (k, n) once, in canonical form, and the rows they were first met in."""
    if len(orders) == 0:
        return orders, np.empty(0, dtype=np.intp)
    rows = canonical_rows(orders)
    _, first = np.unique(rows.astype(np.uint16).view(f"V{2 * rows.shape[1]}").ravel(), return_index=True)
    return rows[first], first


def canonical_rows(orders: Ints) -> Ints:
    """Each ring (k, n) started at 0 and run towards the smaller neighbour."""
    n = orders.shape[1]
    start = (orders == 0).argmax(axis=1)[:, None]
    forward = np.take_along_axis(orders, (start + np.arange(n)) % n, axis=1)
    backward = np.take_along_axis(orders, (start - np.arange(n)) % n, axis=1)
    return np.where((forward[:, 1] < forward[:, -1])[:, None], forward, backward)
