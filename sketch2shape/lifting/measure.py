"""The sizes and the unit a user asks for."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketch2shape.lifting.options import LiftOptions
from sketch2shape.model import Floats

#: sizes given that differ more than this from the drawing are worth a word
_DIFFERENT = 0.02

_NAMES = ("width", "height", "depth")

#: how the warning of a size that the drawing leaves free begins
_LEFT_FREE = "the drawing leaves the {} free"


def measured(own: Floats, free: int | None, options: LiftOptions, axis: int | None = None) -> tuple[Floats, list[str]]:
    """(3,) factors for width, height and depth that give the sizes asked for, and what is to be said about them.

    own  : (3,) width, height and depth as read, pixels
    free : which of them the drawing leaves free, if one
    axis : of a round solid the one along its axis: the two others keep their proportion, so that circles stay circles

    One size sets the scale. A free one is taken as given beside another, or in pixels; of sizes that contradict the
    drawing each one wins, and a warning says by how much the proportions changed.
    """
    own = np.maximum(own, 1e-12)
    if options.fit is not None:
        scale = options.largest() / float(own.max())
        return np.full(3, scale), _assumed(own * scale, free, options)
    sizes = options.sizes()
    given = [k for k, size in enumerate(sizes) if size is not None]
    factors = np.array([1.0 if size is None else size / own[k] for k, size in enumerate(sizes)])
    fixed = [k for k in given if k != free]
    if not given:
        warnings = (
            [] if options.solid_unit == "px" else [f"no size was given: one pixel is taken as one {options.solid_unit}"]
        )
        return factors, warnings + _assumed(own, free, options)
    leading = fixed[0] if fixed else None
    scale = factors[leading] if leading is not None else (factors[given[0]] if options.solid_unit != "px" else 1.0)
    factors = np.where(np.isin(np.arange(3), given), factors, scale)
    told = [] if axis is None else _kept_round(factors, given, axis)
    warnings = told + _contradictions(factors, fixed)
    return factors, warnings if free in given else warnings + _assumed(own * factors, free, options)


def _kept_round(factors: Floats, given: Sequence[int], axis: int) -> list[str]:
    """Make the two factors across the axis of a round solid one: the first that is given; what is to be said of it."""
    across = [k for k in range(3) if k != axis]
    leading = next((k for k in across if k in given), across[0])
    other = across[1 - across.index(leading)]
    lost = float(factors[other] / factors[leading]) - 1.0
    factors[other] = factors[leading]
    if other not in given or abs(lost) <= _DIFFERENT:
        return []
    return [f"circles stay circles: the {_NAMES[other]} follows from the {_NAMES[leading]}"]


def _contradictions(factors: Floats, fixed: Sequence[int]) -> list[str]:
    """What sizes that do not fit the drawing together changed."""
    first = fixed[0] if fixed else 0
    changed = [(k, float(factors[k] / factors[first]) - 1.0) for k in fixed[1:]]
    return [
        f"{_NAMES[first]} and {_NAMES[k]} do not fit the drawing together: {_NAMES[k]} was changed by {part:+.0%}"
        for k, part in changed
        if abs(part) > _DIFFERENT
    ]


def _assumed(sizes: Floats, free: int | None, options: LiftOptions) -> list[str]:
    if free is None:
        return []
    return [f"{_LEFT_FREE.format(_NAMES[free])}: {sizes[free]:.4g} {options.solid_unit} is assumed"]


def free_size(warnings: Sequence[str]) -> str | None:
    """The size, "width", "height" or "depth", that a solid with these warnings has by assumption only."""
    said = (name for name in _NAMES for w in warnings if w.startswith(_LEFT_FREE.format(name)))
    return next(said, None)
