"""Which vertex belongs to which face: two copies of one point set, moved or scaled about a vanishing point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.geometry import cross, size_of
from sketch2shape.model import Floats, Ints

#: a point within this part of the size from where its partner should be matches
TOLERANCE = 0.03
#: smallest and largest scale of the second face against the first, and how far from 1 a scale must be to be one
SCALES = (0.2, 5.0)
SAME_SCALE = 0.01


@dataclass(frozen=True)
class Placement:
    """The second face as a copy of the first.

    first, second : (n,) indices of corresponding points
    scale, shift  : second = scale * first + shift
    misfit        : rms distance from that, units of the points
    """

    first: Ints
    second: Ints
    scale: float
    shift: Floats
    misfit: float

    @classmethod
    def fitted(cls, points: Floats, first: Ints, second: Ints, *, moved_only: bool = False) -> Placement:
        """Least-squares scale and shift of a correspondence; the scale is 1 for `moved_only`."""
        a, b = points[first], points[second]
        centre_a, centre_b = a.mean(axis=0), b.mean(axis=0)
        u, v = a - centre_a, b - centre_b
        scale = 1.0 if moved_only else float((u * v).sum() / (u * u).sum())
        if scale <= 0:
            scale = 1.0
        off = v - scale * u
        return cls(first, second, scale, centre_b - scale * centre_a, float(np.sqrt((off * off).sum(axis=1).mean())))


def match(f1: Floats, f2: Floats) -> Placement:
    """Correspondence of two faces (n, 2) given apart: least squared distances, mean and size taken out. O(n^3)."""
    from scipy.optimize import linear_sum_assignment

    def normal(points: Floats) -> Floats:
        centred = points - points.mean(axis=0)
        return np.asarray(centred / np.sqrt((centred * centred).sum(axis=1).mean()))

    gap = normal(f1)[:, None] - normal(f2)[None]
    rows, columns = linear_sum_assignment((gap * gap).sum(axis=2))
    n = len(f1)
    return Placement.fitted(np.concatenate((f1, f2)), rows.astype(np.intp), columns.astype(np.intp) + n)


def placements(points: Floats, tolerance: float = TOLERANCE) -> list[Placement]:
    """Every way to split 2n points into a face and its copy, by translation, else by a scaling.

    Strategy: the leftmost point has a partner; each other point is tried, which fixes the translation. Walking along
    it, the first free point must be in the first face and its partner must be where it belongs. For a scaling the
    partner of the rightmost point is tried as well. O(n) and O(n^2) trials of O(n^2).
    """
    limit = tolerance * size_of(points)
    start = int(np.lexsort((points[:, 1], points[:, 0]))[0])
    moved = [_pair_up(points, 1.0, points[q] - points[start], limit) for q in range(len(points)) if q != start]
    found = _distinct(points, [pairs for pairs in moved if pairs is not None], moved_only=True)
    if found:
        return found
    scaled = [_pair_up(points, scale, shift, limit) for scale, shift in _scalings(points, start, limit)]
    return _distinct(points, [pairs for pairs in scaled if pairs is not None], moved_only=False)


def _distinct(points: Floats, found: list[Ints], *, moved_only: bool) -> list[Placement]:
    """One placement for each way to pair the points, best fit first."""
    unique = {frozenset(frozenset(pair) for pair in pairs.tolist()): pairs for pairs in found}
    fitted = [Placement.fitted(points, p[:, 0], p[:, 1], moved_only=moved_only) for p in unique.values()]
    return sorted(fitted, key=lambda placement: placement.misfit)


def _pair_up(points: Floats, scale: float, shift: Floats, limit: float) -> Ints | None:
    """(n, 2) pairs, or None if some point has no partner.

    The first free point along the motion cannot be the image of another, so it is in the first face.
    """
    if scale == 1.0:
        reach = points @ shift
    else:
        centre = shift / (1.0 - scale)
        reach = np.hypot(*(points - centre).T) * (1.0 if scale > 1 else -1.0)
    gap = np.linalg.norm((scale * points + shift)[:, None] - points[None], axis=2)
    np.fill_diagonal(gap, np.inf)
    pairs, used = [], np.zeros(len(points), dtype=bool)
    for i in np.argsort(reach, kind="stable").tolist():
        if used[i]:
            continue
        j = int(gap[i].argmin())
        if gap[i, j] > limit:
            return None
        pairs.append((i, j))
        used[[i, j]] = True
        gap[:, [i, j]] = np.inf
    return np.array(pairs, dtype=np.intp)


def _scalings(points: Floats, start: int, limit: float) -> list[tuple[float, Floats]]:
    """(scale, shift) hypotheses from partners of the leftmost and of the rightmost point."""
    end = int(np.lexsort((points[:, 1], points[:, 0]))[-1])
    indices = np.arange(len(points))
    q, r = (grid.ravel() for grid in np.meshgrid(indices, indices, indexing="ij"))
    free = (q != start) & (r != end) & (q != r) & ~((q == end) & (r == start))
    q, r = q[free], r[free]
    hypotheses = []
    # the rightmost point is in the leftmost's face, and r is its image, or it is itself the image of r
    for from_end, to_end in ((np.full_like(r, end), r), (r, np.full_like(r, end))):
        before, after = points[from_end] - points[start], points[to_end] - points[q]
        length = np.hypot(before[:, 0], before[:, 1])
        known = length > 0
        along = (before * after).sum(axis=1)[known] / length[known]
        off = np.abs(cross(before[known], after[known])) / length[known]
        scale = along / length[known]
        good = (off < 2 * limit) & (scale > SCALES[0]) & (scale < SCALES[1]) & (np.abs(scale - 1) > SAME_SCALE)
        for s, k in zip(scale[good].tolist(), q[known][good].tolist(), strict=True):
            hypotheses.append((s, points[k] - s * points[start]))
    return hypotheses
