"""Corners: the points where strokes end, meet or turn.

A vertex of the object is where stroke ENDS meet, at the least-squares intersection of their lines; an X, where two
strokes run straight on, is a crossing and no vertex; a T is one end on another stroke's interior.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.strokes import Strokes


@dataclass(frozen=True)
class Corners:
    """Corners, the surest first.

    points : (k, 2) float, pixels
    degree : (k,) int, how many stroke ends meet there
    on     : (k,) bool, whether it also lies on the interior of another stroke (T)
    strokes: (m, 2) int, the corner at each end of each stroke
    """

    points: Floats
    degree: Ints
    on: Bools
    strokes: Ints


def join_ends(strokes: Strokes, pen: float) -> Corners:
    """Corners where the ends of strokes meet.

    pen : pen width, pixels
    """
    ends = strokes.ends.reshape(-1, 2)
    if not len(ends):
        none = np.zeros(0, np.intp)
        return Corners(np.zeros((0, 2)), none, np.zeros(0, bool), np.zeros((0, 2), np.intp))
    span = strokes.ends[:, 1] - strokes.ends[:, 0]
    lengths = np.linalg.norm(span, axis=1) + 1e-9
    direction = np.repeat(span / lengths[:, None], 2, axis=0)
    cluster = _cluster(ends, direction, np.repeat(lengths, 2), strokes.tolerance, pen)
    names, label = np.unique(cluster, return_inverse=True)
    points = np.array([_meeting_point(ends[label == c], direction[label == c]) for c in range(len(names))])
    degree = np.bincount(label, minlength=len(names))
    on = _on_interior(points, strokes, strokes.tolerance + pen)
    return Corners(points, degree.astype(np.intp), on, label.reshape(-1, 2).astype(np.intp))


def crossings(strokes: Strokes, reach: float, least: int = 3) -> Floats:
    """Points where at least `least` strokes run across each other, (k, 2) float, pixels.

    Where two cross there is usually no vertex; where three do, vertices coincide (the isometric cube's centre).
    """
    a, span = strokes.ends[:, 0], strokes.ends[:, 1] - strokes.ends[:, 0]
    i, j = np.triu_indices(len(a), 1)
    det = span[i, 0] * span[j, 1] - span[i, 1] * span[j, 0]
    length = strokes.lengths
    slanted = np.abs(det) > 0.1 * length[i] * length[j]
    i, j, det = i[slanted], j[slanted], det[slanted]
    w = a[j] - a[i]
    s = (w[:, 0] * span[j, 1] - w[:, 1] * span[j, 0]) / det
    t = (w[:, 0] * span[i, 1] - w[:, 1] * span[i, 0]) / det
    inner_s, inner_t = np.minimum(s, 1 - s) * length[i], np.minimum(t, 1 - t) * length[j]
    ok = (inner_s > 2 * reach) & (inner_t > 2 * reach)
    points = a[i[ok]] + s[ok, None] * span[i[ok]]
    kept: list[Floats] = []
    for point in points:
        if kept and np.linalg.norm(np.array(kept) - point, axis=1).min() < 2 * reach:
            continue
        q = point - a
        along = (q * span).sum(axis=1) / (length + 1e-9)
        across = np.abs(q[:, 0] * span[:, 1] - q[:, 1] * span[:, 0]) / (length + 1e-9)
        if ((across <= reach) & (along > 2 * reach) & (along < length - 2 * reach)).sum() >= least:
            kept.append(point)
    return np.array(kept).reshape(-1, 2)


def _meeting_point(ends: Floats, direction: Floats) -> Floats:
    """Least-squares intersection of the lines through the ends, held to the ends where they are nearly parallel."""
    k = len(ends)
    x, y = -direction[:, 1], direction[:, 0]
    c = x * ends[:, 0] + y * ends[:, 1]
    xx, yy, xy, xc, yc = float(x @ x), float(y @ y), float(x @ y), float(x @ c), float(y @ c)
    if xx * yy - xy * xy <= 0.02 * k * k / 4:
        # a pull towards the ends tames parallel lines
        weight = 0.02
        px, py = ends.sum(axis=0).tolist()
        xx, yy, xc, yc = xx + weight * k, yy + weight * k, xc + weight * px, yc + weight * py
    det = xx * yy - xy * xy
    return np.array([(yy * xc - xy * yc) / det, (xx * yc - xy * xc) / det])


def _cluster(ends: Floats, direction: Floats, lengths: Floats, tolerance: float, pen: float) -> Ints:
    """Label of the corner each end belongs to: the closest ends join first, as long as their lines still meet there."""
    gap = np.linalg.norm(ends[:, None] - ends[None], axis=2)
    sine = np.abs(direction[:, None, 0] * direction[None, :, 1] - direction[:, None, 1] * direction[None, :, 0])
    base = 4 + 1.2 * pen + 2 * tolerance
    reach = base + 0.7 * pen / np.maximum(sine, 0.1)
    reach = np.minimum(reach, 0.5 * np.minimum(lengths[:, None], lengths[None]) + base)
    other = np.arange(len(ends)) // 2
    i, j = np.nonzero(np.triu((gap <= reach) & (other[:, None] != other[None]), 1))
    order = np.argsort(gap[i, j], kind="stable")
    label = list(range(len(ends)))
    members = {k: [k] for k in label}
    for p, q, far in zip(i[order].tolist(), j[order].tolist(), reach[i, j][order].tolist(), strict=True):
        a, b = label[p], label[q]
        if a == b:
            continue
        both = members[a] + members[b]
        if len({k // 2 for k in both}) == len(both) and _meet(ends[both], direction[both], far, base):
            for k in members.pop(b):
                label[k] = a
            members[a] = both
    return np.array(label)


def _meet(ends: Floats, direction: Floats, reach: float, slack: float) -> bool:
    """Whether these strokes meet in one point near all their ends."""
    point = _meeting_point(ends, direction)
    offset = point - ends
    off_line = np.abs(offset[:, 0] * direction[:, 1] - offset[:, 1] * direction[:, 0])
    return bool(off_line.max() <= 0.5 * slack and np.linalg.norm(offset, axis=1).max() <= reach)


def _on_interior(points: Floats, strokes: Strokes, reach: float) -> Bools:
    """Whether each corner lies on the interior of a stroke."""
    a, span = strokes.ends[:, 0], strokes.ends[:, 1] - strokes.ends[:, 0]
    length = np.linalg.norm(span, axis=1) + 1e-9
    u = span / length[:, None]
    q = points[:, None] - a[None]
    along = (q * u).sum(axis=2)
    across = np.abs(q[..., 0] * u[:, 1] - q[..., 1] * u[:, 0])
    inside = (along > 2.5 * reach) & (along < length - 2.5 * reach) & (across <= reach)
    return np.asarray(inside.any(axis=1))
