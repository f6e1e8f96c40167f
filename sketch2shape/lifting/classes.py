"""Sorting a face's edges into classes of parallel ones."""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.model import Floats, Ints

#: edges count as parallel within this many standard deviations of their directions, and within these bounds, radians
_SLACK = 3.0
_LEAST, _MOST = math.radians(1.0), math.radians(12.0)


def parallel_classes(vectors: Floats, lengths: Floats, noise: float) -> tuple[Ints, Floats]:
    """Class of each edge's direction and the sign that turns it along its class; long edges lead.

    vectors : (m, 2) edges in a shape in which parallels are parallel
    lengths : (m,) their lengths in the drawing, pixels
    noise   : standard deviation of a drawn vertex, pixels
    """
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
