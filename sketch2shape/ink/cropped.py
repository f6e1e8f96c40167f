"""Drawings cut off by the border of the picture: an edge that lay along it is lost, its ends run into the border."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.model import Bools, Floats, Ink

LEAST_CUT = 0.08
"""Distance between the places where ink runs into one side of the picture, as a part of the ink's extent, at least."""

MOST_CUTS = 8
"""Places where ink runs into one side of the picture, beyond which it is a texture, a table or a page of text."""


def cut_off(ink: Ink) -> Floats | None:
    """(2, 2) float, pixels: least and greatest x and y of the picture, where its sides cut ink off.

    Infinite on sides that ink does not run into in two places; None if no side cuts anything.
    """
    if ink.page is not None or ink.lines is not None or not ink.mask.any():
        return None
    pen = max(1, round(ink.pen_width))
    (h, w), mask = ink.mask.shape, ink.mask
    top, bottom, left, right = (_cuts(side, pen) is not None for side in (mask, mask[::-1], mask.T, mask.T[::-1]))
    if not (top or bottom or left or right):
        return None
    least = (0.0 if left else -np.inf, 0.0 if top else -np.inf)
    return np.array([least, (w - 1.0 if right else np.inf, h - 1.0 if bottom else np.inf)])


def closed_at_border(ink: Ink) -> Ink | None:
    """The ink with lines along those sides of the picture that it runs into in two places; None if there are none.

    The picture is as wide and high as the ink's mask; a page that is seen whole has nothing cut off.
    """
    if ink.page is not None or ink.lines is not None or not ink.mask.any():
        return None
    pen = max(1, round(ink.pen_width))
    mask = ink.mask.copy()
    is_closed = [_close(side, pen) for side in (mask, mask[::-1], mask.T, mask.T[::-1])]
    return replace(ink, mask=mask) if any(is_closed) else None


def _close(mask: Bools, pen: int) -> bool:
    """Draw a line along the first rows of a mask between the outermost places where ink runs into them."""
    cuts = _cuts(mask, pen)
    if cuts is not None:
        mask[:pen, cuts[0] : cuts[1] + 1] = True
    return cuts is not None


def _cuts(mask: Bools, pen: int) -> tuple[int, int] | None:
    """The outermost places where ink runs into the first rows of a mask; None if they do not cut a drawing off."""
    touching = np.flatnonzero(mask[: max(1, pen // 2)].any(axis=0))
    inked = np.flatnonzero(mask.any(axis=0))
    runs = np.count_nonzero(np.diff(touching) > 1) + 1
    if not len(touching) or runs > MOST_CUTS or touching[-1] - touching[0] < max(LEAST_CUT * np.ptp(inked), 3 * pen):
        return None
    return int(touching[0]), int(touching[-1])
