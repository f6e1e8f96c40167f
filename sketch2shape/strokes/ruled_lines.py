"""Ruled lines: a vector drawing whose lines are straight, as segments between the corners where they end.

Such a drawing says where its corners are to a part of a pixel, so no tolerance need be guessed and no raster asked.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Brief, Floats, Ints, VectorLine

NEAR = 0.25
"""Working pixels from a line within which a point lies on it: files round to a hundredth, no hand is as steady."""
MEET = 0.5
"""Working pixels within which the ends of lines meet."""
STRAIGHT = 0.05
"""Working pixels that a line may bow and be straight."""
MOST = 160
"""Straight pieces beyond which a drawing is none that can be told at once."""


@dataclass(frozen=True, eq=False, repr=False)
class RuledLines(Brief):
    """Straight pieces of lines, and the segments that they make up.

    pieces  : (k, 2, 2) float, both ends of each straight piece as it was drawn, working pixels
    dashed  : (k,) bool, whether it is known to be dashed
    corners : (c, 2) float, where segments end
    on      : (c, s) bool, the segments on which each corner lies, whether at an end or between
    ends    : (s, 2) int, the corners at the ends of each segment: pieces on one line that touch are one
    """

    pieces: Floats
    dashed: Bools
    corners: Floats
    on: Bools
    ends: Ints

    @property
    def is_cut(self) -> Bools:
        """(c,) bool, corners where one segment ends upon others: it may run on behind something."""
        return np.asarray(self._degree == 1)

    @property
    def ways(self) -> Ints:
        """(c,) int, how many ways along segments lead from each corner."""
        return np.asarray(2 * self.on.sum(axis=1) - self._degree)

    @property
    def joined(self) -> Bools:
        """(c, c) bool, pairs of corners on one segment."""
        both = self.on.astype(np.float32)
        found = np.asarray(both @ both.T > 0)
        np.fill_diagonal(found, False)
        return found

    @property
    def _degree(self) -> Ints:
        """(c,) int, how many segments end at each corner."""
        return np.bincount(self.ends.ravel(), minlength=len(self.corners))


def ruled_lines(lines: Iterable[VectorLine]) -> RuledLines | None:
    """The lines of a drawing in working pixels; None if some are bent or end nowhere, or there are too many."""
    found = _pieces(lines)
    segments = None if found is None else _segments(found[0])
    meeting = None if segments is None else _corners(segments)
    if found is None or segments is None or meeting is None:
        return None
    pieces, dashed = found
    corners, ends = meeting
    on = _on(corners, segments)
    on[ends[:, 0], np.arange(len(ends))] = on[ends[:, 1], np.arange(len(ends))] = True
    whole = RuledLines(pieces, dashed, corners, on, ends)
    return whole if (whole.ways >= 2).all() else None


def _pieces(lines: Iterable[VectorLine]) -> tuple[Floats, Bools] | None:
    """Straight pieces and whether each is dashed; lines with corners are cut there."""
    ends: list[Floats] = []
    dashed: list[bool] = []
    for line in lines:
        if line.curved:
            return None
        points = _bends(line.points)
        ends += [points[k : k + 2] for k in range(len(points) - 1)]
        dashed += [line.dashed] * (len(points) - 1)
        if len(ends) > MOST:
            return None
    pieces = np.array(ends).reshape(-1, 2, 2)
    long = np.hypot(*(pieces[:, 1] - pieces[:, 0]).T) > MEET
    return (pieces[long], np.array(dashed)[long]) if long.any() else None


def _bends(points: Floats) -> Floats:
    """(n, 2) where a polyline begins, turns and ends."""
    if len(points) <= 2:
        return points
    bends = cv2.approxPolyDP(points.astype(np.float32)[:, None], STRAIGHT, False)[:, 0].astype(float)
    # OpenCV leaves out the end of a polyline that comes back to its start
    return bends if np.abs(bends[-1] - points[-1]).max() <= STRAIGHT else np.append(bends, points[-1:], axis=0)


def _segments(pieces: Floats) -> Floats | None:
    """(s, 2, 2) pieces of one line that touch or overlap as one; None where they are not quite on one line."""
    span = pieces[:, 1] - pieces[:, 0]
    length = np.hypot(span[:, 0], span[:, 1])
    order = np.argsort(-length, kind="stable")
    pieces, length = pieces[order], length[order]
    along, across = _seen_from(pieces, pieces.reshape(-1, 2))
    low, high = along.min(axis=2), along.max(axis=2)
    touch = (np.abs(across).max(axis=2) <= NEAR) & (low <= length[:, None] + MEET) & (high >= -MEET)
    first, later = np.nonzero(np.triu(touch, 1))
    if not len(first):
        return pieces
    owner = list(range(len(pieces)))
    for i, j in zip(first.tolist(), later.tolist(), strict=True):
        low_owner, high_owner = sorted((owner[i], owner[j]))
        owner = [low_owner if o == high_owner else o for o in owner]
    whole = []
    for own in sorted(set(owner)):  # the longest of each comes first
        mine = np.flatnonzero(np.array(owner) == own)
        points = pieces[mine].reshape(-1, 2)
        far = points[[int(along[own, mine].argmin()), int(along[own, mine].argmax())]]
        if np.abs(_seen_from(far[None], points)[1]).max() > NEAR:
            return None
        whole.append(far)
    return np.array(whole)


def _seen_from(segments: Floats, points: Floats) -> tuple[Floats, Floats]:
    """(s, k, 2) each: how far pairs of points (2k, 2) lie along and across each of the segments, pixels."""
    a, span = segments[:, 0], segments[:, 1] - segments[:, 0]
    unit = span / np.hypot(span[:, 0], span[:, 1])[:, None]
    to = points - a[:, None]
    along = to[..., 0] * unit[:, :1] + to[..., 1] * unit[:, 1:]
    across = cross(unit[:, None], to)
    return along.reshape(len(a), -1, 2), across.reshape(len(a), -1, 2)


def _corners(segments: Floats) -> tuple[Floats, Ints] | None:
    """(c, 2) the places where segments end, and (s, 2) which of them each has; None where that is not clear."""
    ends = segments.reshape(-1, 2)
    gap = ends[:, None] - ends
    same = gap[..., 0] ** 2 + gap[..., 1] ** 2 <= MEET**2
    first = same.argmax(axis=1)
    if (same[first] != same).any():
        return None
    _, label = np.unique(first, return_inverse=True)
    count = np.bincount(label)
    corners = np.stack([np.bincount(label, ends[:, k]) / count for k in (0, 1)], axis=1)
    return corners, label.reshape(-1, 2)


def _on(corners: Floats, segments: Floats) -> Bools:
    """(c, s) bool, the segments on which each corner lies."""
    span = segments[:, 1] - segments[:, 0]
    length = np.hypot(span[:, 0], span[:, 1])
    unit = span / length[:, None]
    to = corners[:, None] - segments[:, 0]
    along = to[..., 0] * unit[:, 0] + to[..., 1] * unit[:, 1]
    across = np.abs(cross(unit, to))
    return np.asarray((across <= MEET) & (along >= -MEET) & (along <= length + MEET))
