"""Hatch lines: strokes that shade a face, told one by one where they are too far apart to close into an area.

A line of a hatching is straight, ends on other lines or nowhere, but at no corner, and has others like it at its side,
at even distances. Edges of the object that run along with them end at corners, so they stay.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import cv2
import numpy as np
from skimage.morphology import skeletonize

from sketch2shape.ink.pen_width import rough_pen_width
from sketch2shape.model import Bools, Floats, Gray, Ints, as_gray

FEWEST = 5
"""Lines of a hatching, at least ..."""
CLOSEST = 3.5
"""... their usual distance in pens, at least: closer ones are an area, see `without_hatching` ..."""
FARTHEST = 0.08
"""... their greatest distance as a share of the diagonal of the ink ..."""
SLENDER = 1.2
"""... and as a share of their length ..."""
LONGEST = 2.0
"""... the greatest length of one, in lengths of the longer one beside it: an edge may run on in a line ..."""
LEAST = 0.3
"""... their least length as a share of FARTHEST ..."""
EVEN = 2.0
"""... and the greatest ratio between two distances in a row."""
MOST_EVEN = 0.7
"""Share of the lines that are so."""
SWAY = 3.0
"""Greatest angle off the median of a hatching, in medians of what its lines are off ..."""
LEAST_SWAY = np.radians(3.0)
"""... but always this, radians."""
PARALLEL = np.radians(14.0)
"""Greatest angle between neighbours, radians: pencils sway."""
STRAIGHT = 0.06
"""Greatest deviation of a line from its axis (r.m.s.) as a share of its length."""
THROUGH = np.radians(20.0)
"""Greatest bend of a line that goes on beyond a crossing, radians."""
SHORTEST = 3.0
"""Least length of a line in pens."""
OVERLAP = 0.4
"""Least share of the shorter of two neighbours that lies beside the other."""
SCANNED = 3
"""Every so manyeth row and column is looked at for even distances ..."""
SEEN = 6
"""... and so many of either must have them."""
PASSED = 5.0
"""A line that passes an end goes on for so many pens on both sides ..."""
LEAST_PASSED = 10.0
"""... and at least so many pixels."""
INKED = 0.85
"""... with ink on at least this share of them."""
CORNER = 0.25
"""Ends of two lines that are this close, as a share of FARTHEST, are a corner with a gap."""
TIP = 8
"""Length of the end of a line that tells its direction, pixels."""


@dataclass(frozen=True)
class _Lines:
    """Straight lines, each of one or more arcs of the skeleton.

    arcs : n lists of arcs
    ends : (n, 2, 2) x, y of both ends
    free : (n, 2) whether nothing touches them there
    on_line : (n, 2) whether they end there on another that goes on
    """

    arcs: list[list[int]]
    ends: Floats
    free: Bools
    on_line: Bools

    @property
    def length(self) -> Floats:
        return np.asarray(np.linalg.norm(self.ends[:, 1] - self.ends[:, 0], axis=1), np.float64)


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
    if not (_has_even_gaps(part, farthest) or _has_even_gaps(np.ascontiguousarray(part.T), farthest)):
        return mask
    skeleton = np.asarray(skeletonize(part > 0), np.bool_)
    pen = rough_pen_width(part > 0)
    arcs, joints = _arcs_of(skeleton, pen)
    lines = _lines_of(arcs, joints, pen)
    loose = _loose_ends(lines, part, pen, farthest)
    hatching = _hatching(lines, loose, pen, farthest)
    if not hatching.any():
        return mask
    gone = np.zeros(int(arcs.max()) + 1, np.bool_)
    gone[[arc for line in np.flatnonzero(hatching).tolist() for arc in lines.arcs[line]]] = True
    result = mask.copy()
    result[y : y + h, x : x + w] &= ~_ink_of(gone[arcs], skeleton & ~gone[arcs], pen)
    return result


def _has_even_gaps(ink: Gray, farthest: float) -> bool:
    """Some rows meet several lines at even distances."""
    rows = ink[::SCANNED]
    row, column = np.nonzero((rows[:, 1:] > rows[:, :-1]))
    count = FEWEST - 1
    if len(row) <= count:
        return False
    gaps = np.lib.stride_tricks.sliding_window_view(np.diff(column), count)
    within = row[count:] == row[:-count]
    least, most = gaps.min(axis=1), gaps.max(axis=1)
    return len(np.unique(row[:-count][within & (most < EVEN * least) & (most < 2.0 * farthest)])) >= SEEN


def _arcs_of(skeleton: Bools, pen: float) -> tuple[Ints, Ints]:
    """Numbers of the arcs between joints and of the joints themselves, (h, w) each, 0 elsewhere."""
    thin = skeleton.view(np.uint8)
    around = cv2.filter2D(thin, cv2.CV_8U, np.ones((3, 3), np.uint8), borderType=cv2.BORDER_CONSTANT)
    side = 2 * round(0.5 * pen) + 3
    joint = cv2.dilate(as_gray(skeleton & (around > 3)), np.ones((side, side), np.uint8))
    arcs = cv2.connectedComponents(as_gray(skeleton & (joint == 0)), connectivity=8)[1]
    return arcs, cv2.connectedComponents(joint, connectivity=8)[1]


@dataclass(frozen=True)
class _Arc:
    """Ends (2, 2) x, y of an arc; unit directions (2, 2) out of it there; joints (2,), 0 for none; and deviation."""

    ends: Floats
    out: Floats
    joints: tuple[int, int]
    bend: float


def _arc(points: Floats, joints: Ints) -> _Arc:
    centre = points.mean(axis=0)
    axis = np.linalg.svd(points - centre, full_matrices=False)[2][0] if len(points) > 1 else np.array([1.0, 0.0])
    along = (points - centre) @ axis
    ends = points[[int(np.argmin(along)), int(np.argmax(along))]]
    out, met = [], []
    for end in ends:
        near = points[np.abs(points - end).max(axis=1) <= TIP]
        away = end - near.mean(axis=0)
        out.append(away / max(float(np.hypot(*away)), 1e-9))
        x, y = end.astype(int)
        met.append(int(joints[max(0, y - 2) : y + 3, max(0, x - 2) : x + 3].max()))
    across = (points - centre) @ np.array([-axis[1], axis[0]])
    return _Arc(ends, np.array(out), (met[0], met[1]), float(np.sqrt(np.mean(across**2))))


def _lines_of(arcs: Ints, joints: Ints, pen: float) -> _Lines:
    """Arcs that go on straight beyond a joint, put together; what is not straight is left out."""
    ys, xs = np.nonzero(arcs)
    order = np.argsort(arcs[ys, xs], kind="stable")
    points = np.stack([xs, ys], axis=1)[order].astype(np.float64)
    bounds = np.flatnonzero(np.diff(arcs[ys, xs][order])) + 1
    every = [_arc(own, joints) for own in np.split(points, bounds)] if len(points) else []
    at: dict[int, list[tuple[int, int]]] = {}
    for k, arc in enumerate(every):
        for side in (0, 1):
            if arc.joints[side]:
                at.setdefault(arc.joints[side], []).append((k, side))
    pairs = [pair for ends in at.values() for pair in _pairs(every, ends)]
    partner = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
    passed = {every[k].joints[side] for (k, side), _ in pairs}
    straight: list[tuple[list[int], Floats, list[list[bool]]]] = []
    for chain in _chains(len(every), partner):
        tips = (chain[0], (chain[-1][0], 1 - chain[-1][1]))
        ends = np.array([every[k].ends[side] for k, side in tips])
        members = [k for k, _ in chain]
        if _is_straight([every[k] for k in members], ends, pen):
            met = [every[k].joints[side] for k, side in tips]
            flags = [[joint == 0 for joint in met], [joint in passed for joint in met]]
            straight.append(([k + 1 for k in members], ends, flags))
    return _Lines(
        [members for members, _, _ in straight],
        np.array([ends for _, ends, _ in straight]).reshape(-1, 2, 2),
        *np.array([flags for _, _, flags in straight], np.bool_).reshape(-1, 2, 2).swapaxes(0, 1),
    )


def _pairs(arcs: list[_Arc], ends: list[tuple[int, int]]) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Pairs of ends at a joint, the straightest first, of which each goes on in the other."""
    found = []
    for a, b in itertools.combinations(ends, 2):
        turn = float(np.arccos(np.clip(-(arcs[a[0]].out[a[1]] @ arcs[b[0]].out[b[1]]), -1.0, 1.0)))
        if turn < THROUGH and a[0] != b[0]:
            found.append((turn, a, b))
    pairs, taken = [], set()
    for _, a, b in sorted(found):
        if a not in taken and b not in taken:
            pairs.append((a, b))
            taken |= {a, b}
    return pairs


def _loose_ends(lines: _Lines, ink: Gray, pen: float, farthest: float) -> Ints:
    """(n,) number of the ends of each line, 0 to 2, that are at no corner: in the open, or on a line that passes."""
    if not lines.arcs:
        return np.zeros(0, np.intp)
    axis = (lines.ends[:, 1] - lines.ends[:, 0]) / lines.length[:, None]
    out = np.stack([-axis, axis], axis=1)
    passed = lines.on_line.copy()
    thick = as_gray(cv2.dilate(ink, np.ones((3, 3), np.uint8)))  # pencils sway
    reach = np.arange(1.0, max(LEAST_PASSED, PASSED * pen) + 1.0)[:, None, None, None]
    for ahead, degrees in itertools.product(np.linspace(0.0, 1.5, 5) * (pen + 2.0), range(30, 151, 6)):
        turn = np.radians(degrees)
        way = out @ np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        at = lines.ends + ahead * out
        passed |= np.minimum(*(_inked(thick, at + side * reach * way).mean(axis=0) for side in (1, -1))) > INKED
    # where a gap parts two lines at a corner their ends are close
    gap = np.linalg.norm(lines.ends[:, :, None, None] - lines.ends[None, None], axis=4)
    turned = np.abs(axis @ axis.T) < np.cos(2.0 * PARALLEL)
    other = turned & (lines.length[None] > 0.5 * lines.length[:, None])
    corner = ((gap < CORNER * farthest) & other[:, None, :, None]).any(axis=(2, 3))
    return np.asarray((passed | (lines.free & ~corner)).sum(axis=1), np.intp)


def _inked(ink: Gray, points: Floats) -> Bools:
    """(...) whether there is ink at points (..., 2)."""
    h, w = ink.shape
    x, y = np.rint(points[..., 0]).astype(np.intp), np.rint(points[..., 1]).astype(np.intp)
    inside = (x >= 0) & (x < w) & (y >= 0) & (y < h)
    return np.asarray(inside & (ink[np.clip(y, 0, h - 1), np.clip(x, 0, w - 1)] > 0), np.bool_)


def _chains(count: int, partner: dict[tuple[int, int], tuple[int, int]]) -> list[list[tuple[int, int]]]:
    """Arcs in the order in which they go on in each other, each with the side at which it is entered; no closed ones."""
    seen: set[int] = set()
    chains = []
    for start in itertools.product(range(count), (0, 1)):
        if start[0] in seen or start in partner:
            continue
        chain, entered = [], start
        while entered[0] not in seen:
            seen.add(entered[0])
            chain.append(entered)
            leaving = (entered[0], 1 - entered[1])
            if leaving not in partner:
                break
            entered = partner[leaving]
        chains.append(chain)
    return chains


def _is_straight(arcs: list[_Arc], ends: Floats, pen: float) -> bool:
    along = ends[1] - ends[0]
    length = float(np.hypot(*along))
    if length < SHORTEST * pen:
        return False
    limit = STRAIGHT * length + 0.3 * pen
    inner = np.concatenate([arc.ends for arc in arcs]) - ends[0]
    off = np.abs(inner @ np.array([-along[1], along[0]])) / length
    return float(off.max()) < 2.0 * limit and max(arc.bend for arc in arcs) < limit


def _hatching(lines: _Lines, loose: Ints, pen: float, farthest: float) -> Bools:
    """(n,) whether each line belongs to a hatching."""
    count = len(lines.arcs)
    result = np.zeros(count, np.bool_)
    if count < FEWEST:
        return result
    length, centre = lines.length, lines.ends.mean(axis=1)
    axis = (lines.ends[:, 1] - lines.ends[:, 0]) / length[:, None]
    offset = centre[None] - centre[:, None]
    across = offset[..., 1] * axis[:, None, 0] - offset[..., 0] * axis[:, None, 1]
    along = np.abs(offset[..., 0] * axis[:, None, 0] + offset[..., 1] * axis[:, None, 1])
    shorter = np.minimum(length[:, None], length)
    beside = 0.5 * (length[:, None] + length) - along > OVERLAP * shorter
    parallel = np.abs(axis @ axis.T) > np.cos(PARALLEL)
    apart = np.minimum(np.abs(across), np.abs(across.T))
    near = parallel & beside & (apart > 1.2 * pen) & (apart < np.minimum(farthest, SLENDER * shorter))
    both = (loose == 2) & (length > LEAST * farthest)
    chain = near & both & both[:, None] & _next_ones(across, near & both & both[:, None])
    linked = chain | chain.T
    longest = LONGEST * np.where(linked, length, 0.0).max(axis=1)
    for found in _groups(linked):
        group = [k for k in _alike(axis, found) if length[k] < longest[k]]
        if len(group) < FEWEST:
            continue
        gaps = np.where(linked, apart, np.inf)[np.ix_(group, group)].min(axis=1)
        if not _are_even(gaps) or np.median(gaps) < CLOSEST * pen:
            continue
        result[group] = True
        usual = float(np.median(length[group]))
        alike = np.zeros(count, np.bool_)
        alike[_alike(axis, list(range(count)), group)] = True
        result |= alike & (near[group].any(axis=0)) & (loose >= 1) & (length < LONGEST * usual)  # those that happen to end at a corner
        hull = cv2.convexHull(lines.ends[group].reshape(-1, 2).astype(np.float32))
        for k in np.flatnonzero(~result & (length < usual) & alike).tolist():
            result[k] = cv2.pointPolygonTest(hull, centre[k].tolist(), False) > 0  # bits of broken lines
    return result


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


def _are_even(gaps: Floats) -> bool:
    """Most lines are as far from the next one as usual."""
    middle = float(np.median(gaps))
    return bool(np.mean((gaps > middle / EVEN) & (gaps < EVEN * middle)) > MOST_EVEN)


def _ink_of(gone: Bools, kept: Bools, pen: float) -> Bools:
    """What is closer to the skeleton of lines that go than a pen, and not on what stays."""
    side = 2 * round(0.5 * pen + 2.0) + 1
    inner = 2 * round(0.5 * pen) + 1
    near = cv2.dilate(as_gray(gone), np.ones((side, side), np.uint8))
    stays = cv2.dilate(as_gray(kept), np.ones((inner, inner), np.uint8))
    return (near > 0) & (stays == 0)
