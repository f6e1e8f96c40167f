"""The shortest tour: the travelling salesman's ring through all points.

Shortest rings never cross themselves (crossed edges can be exchanged for shorter ones: G. A. Croes, Oper. Res. 6,
1958).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.connection import Walk
from sketch2shape.connectors.graham import convex_hull
from sketch2shape.geometry import distances
from sketch2shape.model import Floats, Ints


def tour(points: Floats) -> Walk:
    """Insert points into the convex hull where the detour is least, then improve by 2-opt and or-opt. O(n^2) a round.

    A local minimum: for the few vertices of a face it is nearly always the shortest tour.
    """
    gaps = distances(points)
    return Walk(improve(gaps, insertion(gaps, convex_hull(points))), met=("every point is used",))


def insertion(gaps: Floats, hull: Ints) -> Ints:
    """(n,) order: from the hull, the point with the least detour is inserted first."""
    order = hull.tolist()
    rest = sorted(set(range(len(gaps))) - set(order))
    while rest:
        a = np.array(order)
        b = np.roll(a, -1)
        detour = gaps[a][:, rest] + gaps[b][:, rest] - gaps[a, b][:, None]
        at, which = np.unravel_index(int(np.argmin(detour)), detour.shape)
        order.insert(int(at) + 1, rest.pop(int(which)))
    return np.array(order, dtype=np.intp)


def improve(gaps: Floats, order: Ints) -> Ints:
    """2-opt and or-opt, the best exchange first, until neither shortens the ring."""
    tolerance = 1e-12 * float(gaps.max()) * len(order)
    while True:
        gain, shorter = _best_reversal(gaps, order)
        if gain <= tolerance:
            gain, shorter = _best_move(gaps, order)
        if gain <= tolerance:
            return order
        order = shorter


def _best_reversal(gaps: Floats, order: Ints) -> tuple[float, Ints]:
    """2-opt: reverse the stretch whose two ends gain most."""
    a, b = order, np.roll(order, -1)
    kept = gaps[a, b]
    gain = kept[:, None] + kept[None, :] - gaps[a][:, a] - gaps[b][:, b]
    np.fill_diagonal(gain, 0.0)
    i, j = sorted(int(v) for v in np.unravel_index(int(np.argmax(gain)), gain.shape))
    return float(gain[i, j]), np.concatenate((order[: i + 1], order[i + 1 : j + 1][::-1], order[j + 1 :]))


def _best_move(gaps: Floats, order: Ints) -> tuple[float, Ints]:
    """Or-opt: move a stretch of one to three points to the edge where it gains most."""
    best, answer = 0.0, order
    n = len(order)
    for length in range(1, min(4, n - 2)):
        for shift in range(n):
            ring = np.roll(order, -shift)
            piece, rest = ring[:length], ring[length:]
            removed = gaps[rest[-1], piece[0]] + gaps[piece[-1], rest[0]] - gaps[rest[-1], rest[0]]
            a, b = rest[:-1], rest[1:]
            for part in (piece, piece[::-1]):
                gain = removed - (gaps[a, part[0]] + gaps[part[-1], b] - gaps[a, b])
                at = int(np.argmax(gain))
                if gain[at] > best:
                    best = float(gain[at])
                    answer = np.concatenate((rest[: at + 1], part, rest[at + 1 :]))
    return best, answer
