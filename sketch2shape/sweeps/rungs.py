"""Rungs: the lines between the faces of a wireframe, which tell the way to the back face and where edges meet.

In a parallel wireframe all ink that does not run along the way to the back face lies on ink again when it is moved by
it, or against it. This picks the way among the differences of any two places where lines meet.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Bools, Floats
from sketch2shape.strokes import Skeleton

LEAST_REACH, REACH, OWN_PENS = 2.0, 0.006, 0.5
"""Pixels, fraction of the drawing's size, and pens, within which a place is on ink."""
ONE_JOINT, ONE_PENS = 4.0, 1.2
"""Pixels, and pens, within which places where lines meet are one."""
MOST_JOINTS = 160
"""Places where lines meet in a drawing that is looked at: there are some 140 where eight round holes cross."""
PROBES = 40
"""Points of a straight line between two joints that are looked up."""
INKED = 0.95
"""Part of a line that must lie on ink for it to be drawn."""
LEAST_RUNG, LEAST_RUNG_PENS = 0.015, 3.0
"""Least length of a rung over the drawing's size, and in pens: all ink lies near itself."""
LOOKED_AT = 600
"""Points of ink that choose among shifts."""
ALONG = 5.0
"""Pixels to either side, along a shift, at which there is ink where a line runs along it."""
AGAIN = 0.82
"""Part of the ink across a shift that lies on ink again if it leads to the back face: .95 to 1 of wireframes without
foreign strokes, .8 at most of nearly all other shifts that were seen."""
MOST_SHIFTS = 2
"""Shifts that are followed up."""
NEAREST, LATERAL = 0.12, 2.0
"""How far along a rung, over its length or in reaches, the place where its lines meet may lie off its end: they draw
each other aside where they are nearly parallel."""


def reach_of(skeleton: Skeleton, size: float) -> float:
    """Pixels within which a place is on ink."""
    return max(LEAST_REACH, REACH * size, OWN_PENS * skeleton.pen_width)


def joints(skeleton: Skeleton) -> Floats:
    """(k, 2) pixels, where lines meet or end; of a texture only the first, a few more than are looked at."""
    near = max(ONE_JOINT, ONE_PENS * skeleton.pen_width)
    middle, ends = np.zeros((MOST_JOINTS + 1, 2)), np.zeros(MOST_JOINTS + 1)
    found = 0
    for end in (np.asarray(p[k], float) for p in skeleton.paths for k in (0, -1)):
        own = np.flatnonzero(np.hypot(*(middle[:found] - end).T) < near)
        k = int(own[0]) if len(own) else found
        if k > MOST_JOINTS:
            break
        found = max(found, k + 1)
        ends[k] += 1
        middle[k] += (end - middle[k]) / ends[k]
    return middle[:found]


def wire_shifts(skeleton: Skeleton, at: Floats, others: Floats, size: float) -> list[Floats]:
    """Shifts (2,) by which nearly all ink across them lies on ink again, the best first.

    at     : (k, 2) joints, whose differences are asked
    others : (s, 2) shifts that are asked besides: where rungs touch arcs they seem shorter than they are
    size   : of the drawing, pixels
    """
    if not 4 <= len(at) <= MOST_JOINTS:
        return []
    reach = reach_of(skeleton, size)
    p = skeleton.points[:: max(1, len(skeleton.points) // LOOKED_AT)]
    some = [*others, *_drawn_differences(skeleton, at, size, reach)]
    told = [(_again(skeleton, p, d, reach), d) for d in some]
    good = sorted((t for t in told if t[0] >= AGAIN), key=lambda t: -t[0])
    found: list[Floats] = []
    for _, d in good:
        if all(np.hypot(*(d - e)) > 3 * reach for e in found):
            found.append(_refined(skeleton, d))
        if len(found) == MOST_SHIFTS:
            break
    return found


def _drawn_differences(skeleton: Skeleton, at: Floats, size: float, reach: float) -> Floats:
    """(k, 2) differences of joints with ink between them, distinct ones, downwards."""
    i, j = np.triu_indices(len(at), 1)
    gap = at[j] - at[i]
    far = np.hypot(*gap.T) > max(LEAST_RUNG_PENS * skeleton.pen_width, LEAST_RUNG * size)
    i, gap = i[far], gap[far]
    part = np.linspace(0, 1, PROBES)
    off = looked_up(skeleton.distance, at[i][:, None] + part[:, None] * gap[:, None])
    gap = gap[np.count_nonzero(off <= reach, axis=1) >= INKED * PROBES]
    gap = np.where((gap[:, 1] < 0)[:, None], -gap, gap)
    _, first = np.unique(np.rint(gap / reach).astype(np.intp), axis=0, return_index=True)
    return np.asarray(gap[np.sort(first)])


def _again(skeleton: Skeleton, p: Floats, shift: Floats, reach: float) -> float:
    """Part of the ink across a shift that lies on ink when it is moved by it or against it."""
    u = shift / np.hypot(*shift)

    def on(at: Floats, within: float) -> Bools:
        return looked_up(skeleton.distance, at) <= within

    across = p[~(on(p + ALONG * u, 1.0) & on(p - ALONG * u, 1.0))]
    if len(across) < PROBES:
        return 0.0
    return float((on(across + shift, reach) | on(across - shift, reach)).mean())


def _refined(skeleton: Skeleton, shift: Floats) -> Floats:
    """A shift moved by up to three pixels to where the most ink lies on ink."""
    p = skeleton.points[:: max(1, len(skeleton.points) // LOOKED_AT)]
    for step in (1.0, 0.5):
        steps = np.arange(-2, 3) * step
        some = shift + np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 1, 2)
        near = np.exp(-0.5 * looked_up(skeleton.distance, p + some) ** 2).sum(axis=1)
        shift = some[int(near.argmax()), 0]
    return np.asarray(shift)


def rung_ends(skeleton: Skeleton, at: Floats, shift: Floats, size: float) -> Floats:
    """(n, 2) front ends of lines along a shift: joints with ink all the way to where they are moved.

    at : (k, 2) joints
    """
    reach, long = reach_of(skeleton, size), float(np.hypot(*shift))
    u = shift / long
    part = np.linspace(0.04, 0.96, max(12, int(long / 4)))
    paired: list[Floats] = []
    lone: list[Floats] = []
    for way, back in ((shift, 0.0), (-shift, 1.0)):
        off = looked_up(skeleton.distance, at[:, None] + part[:, None] * way)
        for start in at[(off <= reach).mean(axis=1) >= INKED]:
            miss = at - (start + way)
            along, across = np.abs(miss @ u), np.abs(miss @ np.array([-u[1], u[0]]))
            near = (across < reach) & (along < max(LATERAL * reach, NEAREST * long))
            front = start - back * shift
            if near.any():
                other = at[np.where(near, along + across, np.inf).argmin()] - (1.0 - back) * shift
                paired.append(0.5 * (front + other))
            else:
                lone.append(front)
    kept: list[Floats] = []
    for place in (*paired, *lone):
        if all(np.hypot(*(place - k)) > 1.5 * reach for k in kept):
            kept.append(place)
    return np.array(kept).reshape(-1, 2)


def off_both(skeleton: Skeleton, shift: Floats) -> NDArray[np.float32]:
    """(h, w) pixels to ink of each place or, if that is farther, of the same place on the back face."""
    h, w = skeleton.distance.shape
    moved = np.array([[1, 0, -shift[0]], [0, 1, -shift[1]]], np.float32)
    own = np.ascontiguousarray(skeleton.distance, np.float32)
    back = cv2.warpAffine(own, moved, (w, h), borderMode=cv2.BORDER_CONSTANT, borderValue=(1e3,))
    return np.asarray(np.maximum(own, back), np.float32)


def looked_up(field: NDArray[np.float32], points: Floats) -> Floats:
    """(...) values of a map (h, w) at points (..., 2); outside it those of its border, where there is no ink."""
    h, w = field.shape
    at = (points + 0.5).astype(np.int32)
    return np.asarray(field.take(np.clip(at[..., 1], 0, h - 1) * w + np.clip(at[..., 0], 0, w - 1)))
