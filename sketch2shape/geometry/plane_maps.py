"""The plane map from front to back face: the simplest kind that fits, and what it costs."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sketch2shape.geometry import homology
from sketch2shape.model import Bools, Floats


def _fits(src: Floats, dst: Floats) -> Iterator[tuple[Floats, float]]:
    """Ever richer plane maps from points to points, each with its rms misfit in pixels."""
    n = len(src)
    p, q = src.sum(axis=0) / n, dst.sum(axis=0) / n
    a, b = src - p, dst - q
    for s in (1.0, max(float(np.vdot(a, b) / (np.vdot(a, a) + 1e-12)), 1e-3))[: min(n, 2)]:
        x, y = q - s * p
        yield np.array([[s, 0.0, x], [0.0, s, y], [0.0, 0.0, 1.0]]), _rms(b - s * a)
    if n > 2:
        h = homology.homology(src, dst)
        yield h, _rms(homology.apply(h, src) - dst)


def map_fits(src: Floats, dst: Floats) -> Iterator[Floats]:
    """Ever richer plane maps from points to points."""
    return (h for h, _ in _fits(src, dst))


def _rms(off: Floats) -> float:
    """Of vectors (k, 2)."""
    return float(np.sqrt(np.vdot(off, off) / len(off)))


def plane_map(front: Floats, back: Floats, drawn: Bools, tolerance: float | None = None) -> Floats:
    """The simplest plane map (3, 3) that carries the drawn front vertices onto their back vertices.

    A richer kind of map must earn its place: it has to fit clearly better than the simpler one.
    """
    seen = drawn if np.count_nonzero(drawn) >= 2 else np.ones(len(front), bool)
    limit = 0.006 * _extent(front, back) + 1.0 if tolerance is None else tolerance
    best, least = np.eye(3), np.inf
    for fit, off in _fits(front[seen], back[seen]):
        # only the richest kind can send a vertex to infinity
        if off < least and (not fit[2, :2].any() or np.isfinite(homology.apply(fit, front)).all()):
            best, least = fit, off
            if off <= limit:
                break
    return best


def _extent(front: Floats, back: Floats) -> float:
    """Diagonal of the bounding box of both faces, pixels."""
    low, high = np.minimum(front.min(axis=0), back.min(axis=0)), np.maximum(front.max(axis=0), back.max(axis=0))
    return float(np.hypot(*(high - low)))
