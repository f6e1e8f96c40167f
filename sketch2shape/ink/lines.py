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


def lines_of(arcs: Ints, joints: Ints, pen: float) -> Lines:
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
    return Lines(
        [members for members, _, _ in straight],
        np.array([ends for _, ends, _ in straight]).reshape(-1, 2, 2),
        *np.array([flags for _, _, flags in straight], np.bool_).reshape(-1, 2, 2).swapaxes(0, 1),
    )


def _pairs(arcs: list[_Arc], ends: list[tuple[int, int]]) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Pairs of ends at a joint, the straightest first, of which each goes on in the other."""
    out = np.array([arcs[k].out[side] for k, side in ends])
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


def _is_straight(arcs: list[_Arc], ends: Floats, pen: float) -> bool:
    along = ends[1] - ends[0]
    length = float(np.hypot(*along))
    if length < SHORTEST * pen:
        return False
    limit = STRAIGHT * length + 0.3 * pen
    inner = np.concatenate([arc.ends for arc in arcs]) - ends[0]
    off = np.abs(inner @ np.array([-along[1], along[0]])) / length
    return float(off.max()) < 2.0 * limit and max(arc.bend for arc in arcs) < limit
