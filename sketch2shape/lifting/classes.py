"""Sorting a face's edges into classes of parallel ones."""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.model import Floats, Ints

#: edges count as parallel within this many standard deviations of their directions, and within these bounds, radians
_SLACK = 6.0
_LEAST, _MOST = math.radians(1.0), math.radians(12.0)

#: edges of a ring that runs in two directions by turns: their least number, the least sine between the two, and the
#: mean square of how far edges miss them, over the noise's variance
_CROSSED, _APART, _BENT = 6, 0.3, 4.0


def parallel_classes(vectors: Floats, lengths: Floats, noise: float) -> tuple[Ints, Floats]:
    """Class of each edge's direction and the sign that turns it along its class; long edges lead.

    vectors : (m, 2) edges in a shape in which parallels are parallel
    lengths : (m,) their lengths in the drawing, pixels
    noise   : standard deviation of a vertex, pixels
    """
    crossed = _crossed(vectors, lengths, noise)
    if crossed is not None:
        return crossed
    label, sign = np.zeros(len(vectors), np.intp), np.ones(len(vectors))
    ways, longs = vectors.tolist(), lengths.tolist()
    sums: list[list[float]] = []
    for e in np.argsort(-lengths, kind="stable").tolist():
        x, y = ways[e]
        best, turn = -1, min(max(_SLACK * noise / max(longs[e], 1e-9), _LEAST), _MOST)
        for k, (u, v) in enumerate(sums):
            off = abs(math.atan2(u * y - v * x, abs(u * x + v * y)))
            if off < turn:
                best, turn = k, off
        if best < 0:
            best = len(sums)
            sums.append([0.0, 0.0])
        way = sums[best]
        along = -1.0 if way[0] * x + way[1] * y < 0.0 else 1.0
        way[0] += along * x
        way[1] += along * y
        label[e], sign[e] = best, along
    return label, sign


def _crossed(vectors: Floats, lengths: Floats, noise: float) -> tuple[Ints, Floats] | None:
    """The classes of a ring whose edges run in two directions by turns, as those of letters and stairs do."""
    m = len(vectors)
    if m < _CROSSED or m % 2:
        return None
    label = np.arange(m) % 2
    x, y = vectors.T
    lean = np.array([np.arctan2(2.0 * (x * y)[k::2].sum(), (x * x - y * y)[k::2].sum()) for k in (0, 1)]) / 2.0
    if abs(math.sin(lean[1] - lean[0])) < _APART:
        return None
    c, s = np.cos(lean)[label], np.sin(lean)[label]
    along = c * x + s * y
    off = np.arctan2(np.abs(c * y - s * x), np.abs(along)) * lengths
    allowed = 2.0 * (noise**2 + (_LEAST * lengths) ** 2 / 8.0)
    if (off**2 / allowed).mean() > _BENT:
        return None
    return label.astype(np.intp), np.where(along < 0.0, -1.0, 1.0)
