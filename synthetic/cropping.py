"""A picture whose border cuts off a corner or an edge of the object, where the rest still tells it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sketch2shape.model import Floats
from synthetic.scenes import Scene

Window = tuple[int, int, int, int]
"""Left, top, right, bottom of what is kept, pixels."""

DEEPEST = 0.12
"""Part of the object's extent that the border cuts off at most."""


def window(scene: Scene, points: Floats, lines: str, size: tuple[int, int], rng: np.random.Generator) -> Window:
    """A window on a sheet of `size` (w, h) that leaves one or two vertices out; the whole sheet if none can be."""
    choices = []
    for axis in (0, 1):
        for sign in (-1, 1):
            along = np.sort(sign * points[:, axis])[::-1]
            for outside, (out, kept) in enumerate(pairwise(along[:4]), 1):
                if out - kept > 4 and outside <= 2 and _can_be_told(scene, sign * points[:, axis] >= out, lines):
                    least = max(out - min(out - kept, DEEPEST * float(np.ptp(points[:, axis]))) * 0.9, kept + 2)
                    choices.append((axis, sign, float(rng.uniform(least, max(out - 1, least)))))
    w, h = size
    if not choices:
        return 0, 0, w, h
    axis, sign, at = choices[int(rng.integers(len(choices)))]
    border = round(sign * at)
    window = [0, 0, w, h]
    window[axis + (2 if sign > 0 else 0)] = int(np.clip(border, 1, size[axis] - 1))
    return window[0], window[1], window[2], window[3]


def _can_be_told(scene: Scene, outside: np.ndarray[tuple[int, ...], np.dtype[np.bool_]], lines: str) -> bool:
    """Whether the vertices outside belong to one face and their partners in the other are drawn inside."""
    half = scene.half
    front, back = outside[:half], outside[half:]
    if front.any() and back.any():
        return False
    if lines == "wire":
        return True
    drawn = np.zeros(2 * half, bool)
    for a, b, seen in scene.edges:
        for t0, t1 in seen:
            drawn[a] |= t0 < 1e-6
            drawn[b] |= t1 > 1 - 1e-6
    partners = np.r_[back, front]
    return lines == "dashed" or bool(drawn[partners].all())
