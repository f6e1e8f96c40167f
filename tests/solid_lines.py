"""The lines of small drawings, for the tests of vector drawings."""

import numpy as np
from sketches import hidden_edges

from sketch2shape.model import VectorLine
from sketch2shape.model.drawing import ring_edges


def prism_lines(f1, f2, lines="wire"):
    """A line for each edge that is drawn; a convex f1 unless all edges are drawn alike."""
    vertices = np.concatenate([f1, f2])
    edges = list(zip(ring_edges([len(f1)]), hidden_edges(f1, f2), strict=True))
    return [
        VectorLine(vertices[[i, j]], dashed=bool(hidden and lines == "dashed"))
        for (i, j), hidden in edges
        if not (hidden and lines == "removed")
    ]


def prism_strokes(f1, f2, lines="wire"):
    """The same as arrays."""
    return [line.points for line in prism_lines(f1, f2, lines)]
