"""Lines: the straight strokes of a drawing, by its skeleton, before anything is known of the object.

The skeleton falls into arcs between joints; arcs that go on straight beyond a joint are one line.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import cv2
import numpy as np

from sketch2shape.model import Bools, Floats, Ints, as_gray

STRAIGHT = 0.06
"""Greatest deviation of a line from its axis (r.m.s.) as a share of its length: pencils sway."""
THROUGH = np.radians(20.0)
"""Greatest bend of a line that goes on beyond a crossing, radians."""
SHORTEST = 3.0
"""Least length of a line in pens."""
TIP = 8
"""Length of the end of an arc that tells its direction, pixels."""


@dataclass(frozen=True)
class Lines:
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
    def axis(self) -> Floats:
        """(n, 2) unit vector along each."""
        return np.asarray((self.ends[:, 1] - self.ends[:, 0]) / self.length[:, None], np.float64)

    @property
    def length(self) -> Floats:
        """(n,) pixels."""
        return np.asarray(np.linalg.norm(self.ends[:, 1] - self.ends[:, 0], axis=1), np.float64)


def arcs_of(skeleton: Bools, pen: float) -> tuple[Ints, Ints]:
    """Numbers of the arcs between joints and of the joints themselves, (h, w) each, 0 elsewhere."""
    thin = skeleton.view(np.uint8)
    around = cv2.filter2D(thin, cv2.CV_8U, np.ones((3, 3), np.uint8), borderType=cv2.BORDER_CONSTANT)
    side = 2 * round(0.5 * pen) + 3
    joint = cv2.dilate(as_gray(skeleton & (around > 3)), np.ones((side, side), np.uint8))
    planes = (as_gray(skeleton & (joint == 0)), as_gray(joint))
    arcs, joints = (np.asarray(cv2.connectedComponents(plane, connectivity=8)[1], np.intp) for plane in planes)
    return arcs, joints


@dataclass(frozen=True)
class _Arcs:
    """All arcs of a skeleton.

    ends   : (n, 2, 2) x, y of both ends of each
    out    : (n, 2, 2) unit directions out of it there
    joints : (n, 2) int, the joints there, 0 for none
    bend   : (n,) deviation from its axis, r.m.s., pixels
    """

    ends: Floats
    out: Floats
    joints: Ints
    bend: Floats


def _measured(arcs: Ints, joints: Ints) -> _Arcs:
    """The arcs of a map, all at once: a page of text has thousands.

    arcs   : (h, w) int, numbers of the arcs, 1 to n, 0 elsewhere
    joints : (h, w) int, those of the joints
    """
    ys, xs = np.nonzero(arcs)
    order = np.argsort(arcs[ys, xs], kind="stable")
    points = np.stack([xs, ys], axis=1)[order].astype(np.float64)
    own = arcs[ys, xs][order] - 1
    count = int(own[-1]) + 1 if len(own) else 0
    size = np.asarray(np.bincount(own, minlength=count), np.float64)

    def mean(values: Floats, of: Floats) -> Floats:
        """(n, 2) mean of values (k, 2), of so many each."""
        return np.stack([np.bincount(own, v, count) for v in values.T], axis=1) / of[:, None]

    off = points - mean(points, size)[own]
    square, mixed = mean(off * off, size), mean(off * off[:, ::-1], size)[:, 0]
    angle = 0.5 * np.arctan2(2.0 * mixed, square[:, 0] - square[:, 1])
    axis = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = (off * axis[own]).sum(axis=1)
    across = off[:, 1] * axis[own, 0] - off[:, 0] * axis[own, 1]
    # the points of each arc in the order of how far along it they lie: the first and the last are its ends
    sorted_along = np.lexsort((along, own))
    last = np.cumsum(size).astype(np.intp)
    tips = np.stack([sorted_along[last - size.astype(np.intp)], sorted_along[last - 1]], axis=1)
    ends, out = points[tips], np.zeros((count, 2, 2))
    for side in (0, 1):
        near = (np.abs(points - ends[own, side]).max(axis=1) <= TIP).astype(np.float64)
        away = ends[:, side] - mean(points * near[:, None], np.asarray(np.bincount(own, near, count)))
        out[:, side] = away / np.maximum(np.hypot(away[:, 0], away[:, 1]), 1e-9)[:, None]
    beside = cv2.dilate(joints.astype(np.float32), np.ones((5, 5), np.uint8))
    x, y = ends.astype(np.intp).transpose(2, 0, 1)
    return _Arcs(ends, out, beside[y, x].astype(np.intp), np.sqrt(np.bincount(own, across * across, count) / size))


def lines_of(arcs: Ints, joints: Ints, pen: float) -> Lines:
    """Arcs that go on straight beyond a joint, put together; what is not straight is left out."""
    every = _measured(arcs, joints)
    beside = every.joints.tolist()
    at: dict[int, list[tuple[int, int]]] = {}
    for k, both in enumerate(beside):
        for side, joint in enumerate(both):
            if joint:
                at.setdefault(joint, []).append((k, side))
    pairs = [pair for ends in at.values() if len(ends) > 1 for pair in _pairs(every, ends)]
    partner = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
    passed = {beside[k][side] for (k, side), _ in pairs}
    straight: list[tuple[list[int], Floats, list[list[bool]]]] = []
    for chain in _chains(len(beside), partner):
        tips = (chain[0], (chain[-1][0], 1 - chain[-1][1]))
        ends = np.array([every.ends[k, side] for k, side in tips])
        members = [k for k, _ in chain]
        if _is_straight(every, members, ends, pen):
            met = [beside[k][side] for k, side in tips]
            flags = [[joint == 0 for joint in met], [joint in passed for joint in met]]
            straight.append(([k + 1 for k in members], ends, flags))
    return Lines(
        [members for members, _, _ in straight],
        np.array([ends for _, ends, _ in straight]).reshape(-1, 2, 2),
        *np.array([flags for _, _, flags in straight], np.bool_).reshape(-1, 2, 2).swapaxes(0, 1),
    )


def _pairs(arcs: _Arcs, ends: list[tuple[int, int]]) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Pairs of ends at a joint, the straightest first, of which each goes on in the other."""
    out = np.array([arcs.out[k, side] for k, side in ends])
    turn = np.arccos(np.clip(-(out @ out.T), -1.0, 1.0))
    first, second = np.nonzero(np.triu(turn < THROUGH, 1))
    found = sorted((float(turn[a, b]), ends[a], ends[b]) for a, b in zip(first, second, strict=True))
    pairs, taken = [], set()
    for _, a, b in found:
        if a[0] != b[0] and a not in taken and b not in taken:
            pairs.append((a, b))
            taken |= {a, b}
    return pairs


def _chains(count: int, partner: dict[tuple[int, int], tuple[int, int]]) -> list[list[tuple[int, int]]]:
    """Arcs in the order in which they go on in each other, with the side where each is entered; no closed ones."""
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


def _is_straight(arcs: _Arcs, members: list[int], ends: Floats, pen: float) -> bool:
    """Whether some arcs that go on in each other are one line between these ends."""
    (x0, y0), (x1, y1) = ends.tolist()
    length = float(np.hypot(x1 - x0, y1 - y0))
    if length < SHORTEST * pen:
        return False
    limit = STRAIGHT * length + 0.3 * pen
    if float(arcs.bend[members].max()) >= limit:
        return False
    inner = arcs.ends[members].reshape(-1, 2) - ends[0]
    off = np.abs(inner @ np.array([y0 - y1, x1 - x0])) / length
    return float(off.max()) < 2.0 * limit
