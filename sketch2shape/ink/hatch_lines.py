"""Hatch lines: strokes that shade a face, told one by one where they are too far apart to close into an area.

A line of a hatching is straight, ends on other lines or nowhere, but at no corner, and has others like it at its side,
at even distances. Edges of the object that run along with them end at corners, so they stay.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.ink.lines import Lines, arcs_of, lines_of
from sketch2shape.ink.pen_width import rough_pen_width
from sketch2shape.ink.thinning import thinned_ink
from sketch2shape.model import Bools, Floats, Gray, Ints, as_gray

MOST = 400
"""More lines than this are the texture of a photo."""
MOST_ARCS = 5000
"""So are more pieces of lines between their meetings: drawings seen had 1436 at most, white noise has 47,000."""
FEWEST = 5
"""Lines of a hatching, at least ..."""
CLOSEST = 2.0
"""... their usual distance in pens, at least: closer ones are an area, see `without_hatching` ..."""
FARTHEST = 0.07
"""... their greatest distance as a share of the diagonal of the ink ..."""
WIDE = 1.5
"""... or so many times as far ..."""
SLENDER = 1.2
"""... and as a share of their length ..."""
LONGEST = 2.0
"""... the greatest length of one, in lengths of the longer one beside it: an edge may run on in a line ..."""
LEAST = 0.35
"""... their least length as a share of FARTHEST ..."""
EVEN = 2.0
"""... and the greatest ratio between two distances in a row."""
WIDELY_EVEN = 1.3
"""The same of those that are so far apart."""
MOST_EVEN = 0.7
"""Share of the lines that are so."""
MANY = 14
"""Lines side by side that end at no corner, from which on they need not be even: a bar with blunt bends has twelve."""
SWAY = 3.0
"""Greatest angle off the median of a hatching, in medians of what its lines are off ..."""
LEAST_SWAY = np.radians(3.0)
"""... but always this, radians."""
PARALLEL = np.radians(14.0)
"""Greatest angle between neighbours, radians: pencils sway."""
OVERLAP = 0.4
"""Least share of the shorter of two neighbours that lies beside the other."""
RIM, USUAL = 1.5, 0.9
"""Factor on the distance that nine in ten lines have at most, within which a line has another at its side ..."""
SHORTER = 0.7
"""... and its length over the other's from which on one that has none on its other side is an edge."""
SCANNED = 6
"""Every so manyeth row and column is looked at for even distances ..."""
SEEN = 4
"""... and so many of either must have them."""
PASSED = 4.5
"""A line that passes an end goes on for so many pens on both sides ..."""
INKED = 0.85
"""... with ink on at least this share of them."""
CORNER = 0.3
"""Ends of two lines that are this close, as a share of FARTHEST, are a corner with a gap."""


def without_hatch_lines(mask: Bools) -> Bools:
    """The ink without lines of hatchings; the same array where there are none.

    mask : (h, w) ink
    """
    ink = mask.view(np.uint8)
    x, y, w, h = cv2.boundingRect(ink)
    if not w:
        return mask
    part = ink[y : y + h, x : x + w]
    farthest = FARTHEST * float(np.hypot(w, h))
    if not any(_has_even_gaps(rows, WIDE * farthest) for rows in (part[::SCANNED], part[:, ::SCANNED].T)):
        return mask
    skeleton = thinned_ink(part).view(np.bool_)
    pen = rough_pen_width(part > 0)
    arcs, joints = arcs_of(skeleton, pen)
    if int(arcs.max()) > MOST_ARCS:
        return mask
    lines = lines_of(arcs, joints, pen)
    if not FEWEST <= len(lines.arcs) <= MOST:
        return mask
    hatching = _hatching(lines, part, pen, farthest)
    if not hatching.any():
        return mask
    gone = np.zeros(int(arcs.max()) + 1, np.bool_)
    gone[[arc for line in np.flatnonzero(hatching).tolist() for arc in lines.arcs[line]]] = True
    result = mask.copy()
    result[y : y + h, x : x + w] &= ~_ink_of(skeleton & gone[arcs], _kept(skeleton, arcs, joints, gone), pen)
    return result


def _kept(skeleton: Bools, arcs: Ints, joints: Ints, gone: Bools) -> Bools:
    """(h, w) the skeleton without the arcs that go, and without the stubs that these would leave at the others.

    gone : (n + 1,) whether each arc goes
    """
    goes = gone[arcs]
    touched = np.zeros(int(joints.max()) + 1, np.bool_)
    touched[_beside(skeleton & goes, joints)[2]] = True
    y, x, joint = (values.tolist() for values in _beside(skeleton & ~goes & (arcs > 0), joints))
    ends: dict[int, dict[int, list[tuple[int, int]]]] = {}
    for px, py, beside in zip(x, y, joint, strict=True):
        if touched[beside]:
            ends.setdefault(beside, {}).setdefault(int(arcs[py, px]), []).append((px, py))
    # a line that ends there may have reached its corner
    touched[[beside for beside, some in ends.items() if len(some) == 1]] = False
    kept = as_gray(skeleton & ~goes & ~touched[joints])
    for some in ends.values():
        tips = [np.mean(points, axis=0).round().astype(int).tolist() for points in some.values()]
        middle = np.mean(tips, axis=0).round().astype(int).tolist()
        for tip in tips if len(tips) > 1 else ():
            cv2.line(kept, tip, middle, 1)
    return kept > 0


def _beside(some: Bools, joints: Ints) -> tuple[Ints, Ints, Ints]:
    """Row and column of each pixel that lies within two pixels of a joint, and that joint; once for each joint."""
    near = cv2.dilate(as_gray(joints > 0), np.ones((5, 5), np.uint8)) > 0
    y, x = np.nonzero(some & near)
    padded = np.pad(joints, 2)
    around = np.sort(np.stack([padded[y + j, x + i] for j in range(5) for i in range(5)], axis=1), axis=1)
    pixel, place = np.nonzero(np.diff(around, axis=1, prepend=0))
    return y[pixel], x[pixel], around[pixel, place]


def _has_even_gaps(rows: Gray, farthest: float) -> bool:
    """Some rows meet several lines at even distances."""
    row, column = np.nonzero(rows[:, 1:] > rows[:, :-1])
    count = FEWEST - 1
    if len(row) <= SEEN * count:
        return False
    gap = np.diff(column)
    least, most = gap[: 1 - count].copy(), gap[: 1 - count].copy()
    for k in range(1, count):
        other = gap[k : len(gap) - count + 1 + k]
        least, most = np.minimum(least, other), np.maximum(most, other)
    even = (row[count:] == row[:-count]) & (most < EVEN * least) & (most < 1.1 * farthest)
    return len(np.unique(row[:-count][even])) >= SEEN


def _loose_ends(lines: Lines, some: Bools, ink: Gray, pen: float, farthest: float) -> Ints:
    """(n,) number of the ends of each line, 0 to 2, that are at no corner: in the open, or on a line that passes.

    some : (n,) the lines that are looked at; the others have 0
    """
    ends = lines.ends[some]
    out = np.stack([-lines.axis[some], lines.axis[some]], axis=1)
    passed = lines.on_line[some].copy()
    thick = as_gray(cv2.dilate(ink, np.ones((3, 3), np.uint8)))  # pencils sway
    reach = np.arange(1.0, PASSED * pen + 1.0, 2.0)[:, None, None, None]
    for ahead, degrees in itertools.product(np.linspace(0.0, 1.5, 4) * (pen + 2.0), range(30, 151, 8)):
        turn = np.radians(degrees)
        way = out @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        at = ends + ahead * out
        passed |= np.minimum(*(_inked(thick, at + side * reach * way).mean(axis=0) for side in (1, -1))) > INKED
    # where a gap parts two lines at a corner their ends are close
    gap = np.linalg.norm(ends[:, :, None, None] - lines.ends[None, None], axis=4)
    turned = np.abs(lines.axis[some] @ lines.axis.T) < np.cos(2.0 * PARALLEL)
    other = turned & (lines.length[None] > 0.5 * lines.length[some, None])
    corner = ((gap < CORNER * farthest) & other[:, None, :, None]).any(axis=(2, 3))
    result = np.zeros(len(some), np.intp)
    result[some] = (passed | (lines.free[some] & ~corner)).sum(axis=1)
    return result


def _inked(ink: Gray, points: Floats) -> Bools:
    """(...) whether there is ink at points (..., 2)."""
    h, w = ink.shape
    x, y = np.rint(points[..., 0]).astype(np.intp), np.rint(points[..., 1]).astype(np.intp)
    inside = (x >= 0) & (x < w) & (y >= 0) & (y < h)
    return np.asarray(inside & (ink[np.clip(y, 0, h - 1), np.clip(x, 0, w - 1)] > 0), np.bool_)


@dataclass(frozen=True)
class _Neighbours:
    """Which lines run beside each other.

    apart  : (n, n) distance between two, pixels
    across : (n, n) the same with the side on which the second one lies
    near   : (n, n) whether they could be neighbours in a hatching
    """

    apart: Floats
    across: Floats
    near: Bools

    def chains(self, some: Bools) -> Bools:
        """(n, n) whether one is the next one of the other, among some lines."""
        near = self.near & some & some[:, None]
        chain = near & _next_ones(self.across, near)
        return chain | chain.T


def _neighbours(lines: Lines, pen: float, farthest: float) -> _Neighbours:
    length, centre, axis = lines.length, lines.ends.mean(axis=1), lines.axis
    offset = centre[None] - centre[:, None]
    across = offset[..., 1] * axis[:, None, 0] - offset[..., 0] * axis[:, None, 1]
    along = np.abs(offset[..., 0] * axis[:, None, 0] + offset[..., 1] * axis[:, None, 1])
    shorter = np.minimum(length[:, None], length)
    beside = 0.5 * (length[:, None] + length) - along > OVERLAP * shorter
    parallel = np.abs(axis @ axis.T) > np.cos(PARALLEL)
    apart = np.minimum(np.abs(across), np.abs(across.T))
    near = parallel & beside & (apart > 1.2 * pen) & (apart < np.minimum(farthest, SLENDER * shorter))
    return _Neighbours(apart, across, near)


def _hatching(lines: Lines, ink: Gray, pen: float, farthest: float) -> Bools:
    """(n,) whether each line belongs to a hatching."""
    return _ruled(lines, ink, pen, farthest) | _ruled(lines, ink, pen, WIDE * farthest, wide=True)


def _ruled(lines: Lines, ink: Gray, pen: float, farthest: float, *, wide: bool = False) -> Bools:
    """(n,) whether each line belongs to a hatching of lines that are no farther apart than so many pixels.

    wide : whether they are nearly as far apart, and all at one distance: edges are at any
    """
    result = np.zeros(len(lines.arcs), np.bool_)
    beside = _neighbours(lines, pen, farthest)
    many = [group for group in _groups(beside.near) if len(group) >= FEWEST]
    if not many:
        return result
    some = np.zeros(len(result), np.bool_)
    some[[line for group in many for line in group]] = True
    some |= (np.abs(lines.axis @ lines.axis[some].T) > np.cos(PARALLEL)).any(axis=1)
    loose = _loose_ends(lines, some, ink, pen, farthest)
    length = lines.length
    linked = beside.chains((loose == 2) & (length > LEAST * farthest))
    longest = LONGEST * np.where(linked, length, 0.0).max(axis=1)
    for found in _groups(linked):
        group = [k for k in _alike(lines.axis, found) if length[k] < longest[k]]
        gaps = np.where(linked, beside.apart, np.inf)[np.ix_(group, group)].min(axis=1, initial=np.inf)
        known = gaps[np.isfinite(gaps)]
        if len(group) < FEWEST or not len(known):
            continue
        spacing = float(np.median(known))
        regular = _are_even(gaps, WIDELY_EVEN) if wide else len(group) >= MANY or _are_even(gaps, EVEN)
        if regular and spacing > (farthest / WIDE if wide else CLOSEST * pen):
            every = np.zeros_like(result)
            every[group] = True
            every |= _stragglers(lines, beside.near, loose, group, spacing)
            result |= every & ~_on_rim(beside, lines, RIM * float(np.quantile(known, USUAL)))
    return result


def _on_rim(beside: _Neighbours, lines: Lines, far: float) -> Bools:
    """(n,) lines without others on both sides, that are no shorter and touch something: a hatching ends at an edge.

    far : pixels beyond which a line has none
    """
    near = beside.near & (beside.apart < far)
    left, right = near & (beside.across < 0), near & (beside.across > 0)
    shorter = lines.length <= SHORTER * np.where(near, lines.length, 0.0).max(axis=1)
    return np.asarray(~(left.any(axis=1) & right.any(axis=1)) & ~shorter & ~lines.free.all(axis=1))


def _stragglers(lines: Lines, near: Bools, loose: Ints, group: list[int], spacing: float) -> Bools:
    """(n,) lines of a hatching that happen to end at a corner or reach into one, and bits of broken ones."""
    alike = np.zeros(len(loose), np.bool_)
    alike[_alike(lines.axis, list(range(len(loose))), group)] = True
    usual = float(np.median(lines.length[group]))
    close = near[group].any(axis=0)
    # an edge among them parts a hatching
    beyond = near[close].any(axis=0) & (loose == 2)
    result = alike & (close | beyond) & (loose >= 1) & (lines.length < LONGEST * usual)
    hull = cv2.convexHull(lines.ends[group].reshape(-1, 2).astype(np.float32))
    for k in np.flatnonzero(alike & ~result & (lines.length < usual)).tolist():
        depth = cv2.pointPolygonTest(hull, lines.ends[k].mean(axis=0).tolist(), True)
        result[k] = depth > (-1.5 * spacing if loose[k] == 2 else 0.0)
    return np.asarray(result, np.bool_)


def _next_ones(across: Floats, near: Bools) -> Bools:
    """(n, n) the nearest line on each side."""
    result = np.zeros_like(near)
    rows = np.arange(len(near))
    for side in (near & (across > 0), near & (across < 0)):
        closest = np.argmin(np.where(side, np.abs(across), np.inf), axis=1)
        result[rows, closest] |= side[rows, closest]
    return result


def _groups(linked: Bools) -> list[list[int]]:
    """Connected groups of lines."""
    left = set(range(len(linked)))
    groups = []
    while left:
        queue = [left.pop()]
        group = []
        while queue:
            k = queue.pop()
            group.append(k)
            reached = left.intersection(np.flatnonzero(linked[k]).tolist())
            left -= reached
            queue += reached
        groups.append(group)
    return groups


def _alike(axis: Floats, lines: list[int], like: list[int] | None = None) -> list[int]:
    """Those of some lines that have the direction of the group `like`, or of themselves, within what that sways."""
    doubled = 2.0 * np.arctan2(axis[:, 1], axis[:, 0])
    group = doubled[lines if like is None else like]
    middle = np.arctan2(np.median(np.sin(group)), np.median(np.cos(group)))
    off = np.abs(np.angle(np.exp(1j * (doubled - middle)))) / 2.0
    sway = max(LEAST_SWAY, SWAY * float(np.median(off[lines if like is None else like])))
    return [k for k in lines if off[k] < sway]


def _are_even(gaps: Floats, even: float) -> bool:
    """Most lines are as far from the next one as usual, to a factor."""
    middle = float(np.median(gaps))
    return bool(np.mean((gaps > middle / even) & (gaps < even * middle)) > MOST_EVEN)


def _ink_of(gone: Bools, kept: Bools, pen: float) -> Bools:
    """What is closer to the skeleton of lines that go than a pen, and not on what stays."""
    side = 2 * round(0.5 * pen + 2.0) + 1
    inner = 2 * round(0.5 * pen) + 1
    near = cv2.dilate(as_gray(gone), np.ones((side, side), np.uint8))
    stays = cv2.dilate(as_gray(kept), np.ones((inner, inner), np.uint8))
    return np.asarray((near > 0) & (stays == 0), np.bool_)
