"""Which strokes of a drawing its best answer leaves out: what to look at where the answer is not trusted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketch2shape.model import Floats, Ink, TwoFaceObject
from sketch2shape.strokes import trace_strokes

_PLACES = 12
"""Places along a stroke that are looked at."""
_REACH = 0.02
"""How far from the object's edges a stroke may lie and be explained, as a fraction of the drawing's diagonal."""
_SHORT = 0.04
"""Strokes shorter than this fraction of the drawing's diagonal are no edges."""


def unexplained_strokes(ink: Ink, objects: Sequence[TwoFaceObject]) -> Floats:
    """(k, 2, 2) float, picture pixels: strokes that lie, for the most part, on no edge of any object, longest first."""
    ends = trace_strokes(ink).ends
    if not len(ends):
        return np.zeros((0, 2, 2))
    diagonal = float(np.linalg.norm(np.ptp(ends.reshape(-1, 2), axis=0)))
    ends = ends[np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) >= _SHORT * diagonal]
    part = (np.arange(_PLACES) + 0.5) / _PLACES
    places = ends[:, :1] + part[:, None] * (ends[:, 1:] - ends[:, :1])
    away = _distance(places.reshape(-1, 2), objects).reshape(-1, _PLACES)
    off = away > max(_REACH * diagonal, 2.0 * ink.pen_width / ink.scale)
    return np.asarray(ends[off.mean(axis=1) > 0.5])


def _distance(points: Floats, objects: Sequence[TwoFaceObject]) -> Floats:
    """(n,) from each point to the next edge of any object, pixels."""
    nearest = np.full(len(points), np.inf)
    for obj in objects:
        a, b = _lines(obj).swapaxes(0, 1)
        if not len(a):
            continue
        along = b - a
        t = ((points[:, None] - a) * along).sum(axis=2) / np.maximum((along**2).sum(axis=1), 1e-12)
        foot = a + np.clip(t, 0.0, 1.0)[..., None] * along
        nearest = np.minimum(nearest, np.linalg.norm(points[:, None] - foot, axis=2).min(axis=1))
    return nearest


def _lines(obj: TwoFaceObject) -> Floats:
    """(k, 2, 2) its edges, silhouettes and chords of its arcs, pixels."""
    arcs = [np.stack([p[:-1], p[1:]], axis=1) for p in (arc.path for arc in obj.arcs)]
    return np.concatenate([obj.vertices[obj.edges], obj.silhouettes, *arcs])
