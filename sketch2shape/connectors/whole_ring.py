"""Cues of a ring that no pair of its edges can tell: seen only when the whole ring is there."""

from __future__ import annotations

import numpy as np

from sketch2shape.connectors.graham import convex_hull
from sketch2shape.connectors.polygon import ON_LINE
from sketch2shape.connectors.ring_regularity import Edges
from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Floats, Ints

RING_CUES = (
    "star",
    "kernel",
    "area",
    "reflex",
    "directions",
    "excess",
    "alternate",
    "worst",
    "strict",
    "strict_worst",
)
#: points a side of the grid on which the kernel (from where all of the ring is seen) is measured
GRID = 14


def ring_cues(edges: Edges, parallel: Floats, loosely: Floats, at: Ints, orders: Ints) -> Floats:
    """(k, 10) the RING_CUES of rings (k, n).

    Whether the ring is star-shaped from somewhere, and the part of its area it is star-shaped from; its area as a part
    of the hull's; the part of its corners that are reflex; the number of different edge directions for each edge; log
    of its length against the shortest of these rings; how far every other edge is parallel, as in a rectilinear face,
    on the whole and at the worst, by the wide standard and by the narrow one.

    parallel, loosely : (m, m) how parallel edges are, 0..1, by a narrow and by a wide standard
    at       : (n, n) index of the edge between two points
    """
    following = np.roll(orders, -1, axis=1)
    used = at[orders, following]
    ring = edges.points[orders]
    steps = edges.points[following] - ring
    area = 0.5 * cross(ring, edges.points[following]).sum(axis=1)
    places, cell = _grid(edges.points)
    seen = _seen_from(edges, used, np.where(orders < following, 1.0, -1.0) * np.sign(area)[:, None], places)
    kernel = seen.sum(axis=1) * cell
    turns = cross(steps, np.roll(steps, -1, axis=1)) * np.sign(area)[:, None]
    alike = parallel.take(used[:, :, None] * len(parallel) + used[:, None, :])
    hull = edges.points[convex_hull(edges.points)]
    hull_area = 0.5 * cross(hull, np.roll(hull, -1, axis=0)).sum()
    length = edges.length[used].sum(axis=1)
    return np.column_stack((
        kernel > 0,
        np.minimum(kernel / np.maximum(np.abs(area), 1e-9), 1.0),
        np.abs(area) / hull_area,
        (turns < 0).mean(axis=1),
        (1.0 / (1.0 + alike.sum(axis=2))).mean(axis=1),
        np.log(length / length.min()),
        *_alternate(loosely, used),
        *_alternate(parallel, used),
    ))  # fmt: skip


def _seen_from(edges: Edges, used: Ints, sign: Floats, places: Floats) -> Bools:
    """(k, p) whether all of each ring is seen from each place; sign (k, n) turns edges to have the inside leftwards."""
    start = edges.points[edges.ends[:, 0]]
    side = cross(edges.vector[:, None], places[None] - start[:, None])
    sides = np.stack((side < -ON_LINE, side > ON_LINE))
    return np.asarray(sides[(sign > 0).astype(np.intp), used].all(axis=1))


def _grid(points: Floats) -> tuple[Floats, float]:
    """Places all over the box of the points, and the area each stands for."""
    low, span = points.min(axis=0), np.ptp(points, axis=0)
    steps = (np.arange(GRID) + 0.5) / GRID
    unit = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    return low + unit * span, float(span[0] * span[1] / GRID**2)


def _alternate(loosely: Floats, used: Ints) -> tuple[Floats, Floats]:
    """How parallel the edges at even distance along each ring are: mean (to the fourth power) and least."""
    n = used.shape[1]
    if n % 2:
        return np.zeros(len(used)), np.zeros(len(used))
    i, j = np.triu_indices(n, 2)
    i, j = i[(j - i) % 2 == 0], j[(j - i) % 2 == 0]
    alike = loosely.take(used[:, i] * len(loosely) + used[:, j])
    return alike.mean(axis=1) ** 4, alike.min(axis=1)
