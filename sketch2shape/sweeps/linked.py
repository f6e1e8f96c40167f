"""Linked: pieces of a line that a pencil's grain, dashes or crossing lines have parted, in order again.

Two pieces belong together where one goes on in the direction of the other behind a small gap (good continuation;
D. Lowe, "Perceptual Organization and Visual Recognition", 1985, section 3). Of several that could, the nearest does.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sketch2shape.model import Floats, Ints

GAP, GAP_PENS = 0.02, 3.0
"""Fraction of the drawing's size, and pens, of a gap at most."""
HEADING = 8
"""Points at the end of a piece that tell where it heads."""
LEAST_POINTS = 4
"""Points of a piece from which it has a direction."""
STRAIGHT_ON = 0.8
"""Cosine of the angle between the directions of both, and of a gap, at least."""
TOUCHING = 3.0
"""Pixels up to which a gap has no direction."""


def linked(paths: Sequence[NDArray[np.int32]], size: float, pen: float) -> list[Floats]:
    """Lines (k, 2) put together from two or more pieces (k, 2) each, pixels.

    size : of the drawing, pixels
    pen  : width, pixels
    """
    some = [p.astype(float) for p in paths if len(p) >= LEAST_POINTS]
    if len(some) < 2:
        return []
    mates = _mates(some, max(GAP * size, GAP_PENS * pen))
    chains, seen = list[Floats](), set[int]()
    # begun at the ends that no other piece follows; what then is left runs in a circle
    for end in [*np.flatnonzero(mates < 0).tolist(), *range(len(mates))]:
        order = _followed(end, mates, seen)
        if len(order) > 1:
            chains.append(np.concatenate([some[e // 2][:: 1 if e % 2 == 0 else -1] for e in order]))
    return chains


def _followed(end: int, mates: Ints, seen: set[int]) -> list[int]:
    """The ends at which the pieces of a line are entered, one after the other."""
    order: list[int] = []
    while end >= 0 and end // 2 not in seen:
        seen.add(end // 2)
        order.append(end)
        end = int(mates[end ^ 1])
    return order


def _mates(paths: list[Floats], gap: float) -> Ints:
    """(2n,) int, for the first and last end of each piece the end of the piece that goes on there, or -1."""
    at = np.concatenate([[p[0], p[-1]] for p in paths])
    near = np.concatenate([[p[min(HEADING, len(p) - 1)], p[max(-1 - HEADING, -len(p))]] for p in paths])
    out = at - near
    out /= np.hypot(*out.T)[:, None] + 1e-9
    between = at[None] - at[:, None]
    apart = np.hypot(between[..., 0], between[..., 1])
    way = between / (apart[..., None] + 1e-9)
    ahead = (way * out[:, None]).sum(axis=2)
    fits = (apart < gap) & (out @ out.T < -STRAIGHT_ON)
    fits &= (apart < TOUCHING) | ((ahead > STRAIGHT_ON) & (ahead.T > STRAIGHT_ON))
    own = np.arange(len(at)) // 2
    fits &= own[:, None] != own
    mates = np.full(len(at), -1)
    first, second = np.nonzero(np.triu(fits))
    for k in np.argsort(apart[first, second], kind="stable"):
        i, j = first[k], second[k]
        if mates[i] < 0 and mates[j] < 0:
            mates[i], mates[j] = j, i
    return mates
