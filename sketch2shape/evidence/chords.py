"""Chords: foreign lines from vertex to vertex of an answer that no one draws into an object, but into a flat figure.

A diagonal of a face, a height or a section runs within the object, and turns at a vertex. Where a line goes on straight
from an edge to another vertex, the edge was a part of a longer line; one that runs outside the silhouette says that the
outline is another.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import cv2
import numpy as np

from sketch2shape.evidence.overlaps import HALF, ONE_WAY, PLACES
from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Floats, Gray, Ints, as_gray

INKED = 0.8
"""Fraction of a chord from which on it is a line that someone drew."""
SHORTEST = 0.1
"""Length of a chord, as a fraction of the drawing's size, below which it tells nothing."""

Faces = Sequence[Floats]
"""Outlines, (m, 2) float each."""


def chords(foreign: Floats, v: Floats, edges: Ints, faces: Callable[[], Faces], reach: float, size: float) -> float:
    """Length of such foreign lines, as a fraction of the drawing's size.

    foreign : (k, 2) float, pixels of ink that the answer leaves unexplained
    v       : (n, 2) float, vertices of the answer, pixels
    edges   : (e, 2) int, between vertices
    faces   : gives the outlines, pixels, that together cover the answer
    reach   : pixels from a line within which ink is its own
    """
    if not len(foreign):
        return 0.0
    one, other = _pairs(v, edges, SHORTEST * size)
    if not len(one):
        return 0.0
    on = v[one, None] + PLACES * (v[other] - v[one])[:, None]
    corner, extent = np.floor(v.min(axis=0)) - 1.0, np.ceil(np.ptp(v, axis=0)).astype(int) + 3
    drawn = _covered(on - corner, _inked(foreign - corner, extent, reach)) > INKED
    one, other, on = one[drawn], other[drawn], on[drawn]
    if not len(one):
        return 0.0
    strange = _goes_on(v, edges, one, other, reach) | _goes_on(v, edges, other, one, reach)
    strange |= _covered(on - corner, _silhouette(faces(), corner, extent)) < HALF
    return float(np.hypot(*(v[other] - v[one])[strange].T).sum()) / size


def faces_of(front: Floats, back: Floats) -> Faces:
    """Both faces of an answer, (m, 2) pixels each, and the sides between them, (4, 2) each."""
    sides = np.stack([front, np.roll(front, -1, axis=0), np.roll(back, -1, axis=0), back], axis=1)
    return [front, back, *sides]


def _pairs(v: Floats, edges: Ints, shortest: float) -> tuple[Ints, Ints]:
    """Pairs of vertices without an edge between them that are no nearer to each other than this."""
    apart = np.hypot(*(v[:, None] - v).transpose(2, 0, 1)) >= shortest
    apart[edges[:, 0], edges[:, 1]] = apart[edges[:, 1], edges[:, 0]] = False
    one, other = np.nonzero(np.triu(apart))
    return one, other


def _inked(foreign: Floats, extent: Ints, reach: float) -> Gray:
    """Where foreign ink is near."""
    mask = np.zeros((extent[1], extent[0]), np.uint8)
    x, y = np.rint(foreign).astype(np.intp).T
    inside = (x >= 0) & (y >= 0) & (x < extent[0]) & (y < extent[1])
    mask[y[inside], x[inside]] = 1
    wide = 2 * int(np.ceil(reach)) + 1
    return as_gray(cv2.dilate(mask, cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (wide, wide))))


def _silhouette(faces: Faces, corner: Floats, extent: Ints) -> Gray:
    mask = np.zeros((extent[1], extent[0]), np.uint8)
    for face in faces:
        cv2.fillPoly(mask, [np.rint(face - corner).astype(np.int32)], 1)
    return as_gray(cv2.dilate(mask, np.ones((3, 3), np.uint8)))


def _covered(on: Floats, mask: Gray) -> Floats:
    """(c,) of the places (c, n, 2) on each chord the fraction that a mask covers."""
    x, y = np.rint(on).astype(np.intp).transpose(2, 0, 1)
    return np.asarray(mask[y, x].mean(axis=1))


def _goes_on(v: Floats, edges: Ints, one: Ints, other: Ints, reach: float) -> Bools:
    """(c,) whether each chord goes on straight from an edge that ends at its first vertex."""
    both = np.concatenate([edges, edges[:, ::-1]])
    way, chord = v[both[:, 1]] - v[both[:, 0]], v[other] - v[one]
    aside = np.abs(cross(chord[:, None], way)) / (np.hypot(*chord.T)[:, None] + 1e-9)
    on = (aside < np.minimum(ONE_WAY * np.hypot(*way.T), reach)) & (chord @ way.T > 0.0)
    return np.asarray((on & (both[:, 1] == one[:, None])).any(axis=1))
