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
FARTHEST = 0.08
"""... their greatest distance as a share of the diagonal of the ink ..."""
SLENDER = 0.9
"""... and as a share of their length ..."""
EVEN = 2.0
"""... and the greatest ratio between two distances in a row."""
PARALLEL = np.radians(14.0)
"""Greatest angle between neighbours, radians: pencils sway."""
STRAIGHT = 0.06
"""Greatest deviation of a line from its axis (r.m.s.) as a share of its length."""
THROUGH = np.radians(32.0)
"""Greatest bend of a line that goes on beyond a crossing, radians."""
SHORTEST = 3.0
"""Least length of a line in pens."""
OVERLAP = 0.4
"""Least share of the shorter of two neighbours that lies beside the other."""
SCANNED = 3
"""Every so manyeth row and column is looked at for even distances ..."""
SEEN = 6
"""... and so many of either must have them."""
TIP = 8
"""Length of the end of a line that tells its direction, pixels."""


@dataclass(frozen=True)
class _Lines:
    """Straight lines, each of one or more arcs of the skeleton.

    arcs    : n lists of arcs
    ends    : (n, 2, 2) x, y of both ends
    loose   : (n,) number of ends, 0 to 2, that are at no corner
    """

    arcs: list[list[int]]
    ends: Floats
    loose: Ints

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
    hatching = _hatching(lines, pen, farthest)
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
    going_on = {joint: _pairs(every, ends) for joint, ends in at.items()}
    partner = {a: b for pairs in going_on.values() for pair in pairs for a, b in (pair, pair[::-1])}
    wide = _wide_joints(joints, pen)

    def is_loose(end: tuple[int, int]) -> bool:
        joint = every[end[0]].joints[end[1]]
        return joint == 0 or joint in wide or any(end not in pair for pair in going_on[joint])

    chains = _chains(len(every), partner)
    straight: list[tuple[list[int], Floats, int]] = []
    for chain in chains:
        first, last = chain[0], (chain[-1][0], 1 - chain[-1][1])
        ends = np.array([every[first[0]].ends[first[1]], every[last[0]].ends[last[1]]])
        members = [k for k, _ in chain]
        if _is_straight([every[k] for k in members], ends, pen):
            straight.append(([k + 1 for k in members], ends, int(is_loose(first)) + int(is_loose(last))))
    return _Lines(
        [members for members, _, _ in straight],
        np.array([ends for _, ends, _ in straight]).reshape(-1, 2, 2),
        np.array([loose for _, _, loose in straight], np.intp),
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


def _wide_joints(joints: Ints, pen: float) -> set[int]:
    """Joints in which several lines end side by side on another."""
    _, _, stats, _ = cv2.connectedComponentsWithStats(as_gray(joints > 0), connectivity=8)
    extent = np.hypot(stats[1:, cv2.CC_STAT_WIDTH], stats[1:, cv2.CC_STAT_HEIGHT])
    return set((np.flatnonzero(extent > 4.0 * (pen + 3.0)) + 1).tolist())


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


def _hatching(lines: _Lines, pen: float, farthest: float) -> Bools:
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
    both = lines.loose == 2
    chain = near & both & both[:, None] & _next_ones(across, near & both & both[:, None])
    for group in _groups(chain | chain.T):
        if len(group) >= FEWEST and _is_even(across, apart, group):
            result[group] = True
            # a line of it that happens to end at a corner
            result |= (near[group].sum(axis=0) >= 1) & (lines.loose >= 1)
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


def _is_even(across: Floats, apart: Floats, group: list[int]) -> bool:
    """Most distances between neighbours are like their median."""
    position = across[group[0]][group]
    gaps = np.diff(np.sort(position))
    gaps = gaps[gaps > 0.25 * np.median(gaps)]
    middle = float(np.median(gaps))
    return bool(np.mean((gaps > middle / EVEN) & (gaps < EVEN * middle)) > 0.7)


def _ink_of(gone: Bools, kept: Bools, pen: float) -> Bools:
    """What is closer to the skeleton of lines that go than a pen, and not on what stays."""
    side = 2 * round(0.5 * pen + 2.0) + 1
    inner = 2 * round(0.5 * pen) + 1
    near = cv2.dilate(as_gray(gone), np.ones((side, side), np.uint8))
    stays = cv2.dilate(as_gray(kept), np.ones((inner, inner), np.uint8))
    return (near > 0) & (stays == 0)
