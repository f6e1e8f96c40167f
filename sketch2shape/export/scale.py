"""The scale at which a solid is drawn on paper: true or a usual ratio if its real size is known, else what fits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sketch2shape.export.units import MILLIMETRES

#: mantissas of usual reductions and enlargements (ISO 5455)
_USUAL = (1, 2, 5)

#: each guess at what fits is so much smaller than the one before
_SMALLER = 0.93


@dataclass(frozen=True)
class Scale:
    """A scale.

    factor : millimetres on paper for a unit of the solid
    told   : in words, for the sheet
    note   : what had to be assumed or reduced, for the result; None if nothing
    """

    factor: float
    told: str
    note: str | None


def reductions(unit: str) -> Iterator[Scale]:
    """True scale, then 1:2, 1:5, 1:10 and so on."""
    for text, ratio in _ratios(1, 12):
        note = None if ratio == 1.0 else f"drawn at scale {text} to fit the paper"
        yield Scale(MILLIMETRES[unit] * ratio, f"scale {text}", note)


def usual_scales(unit: str) -> Iterator[Scale]:
    """Usual enlargements and reductions of a solid with a real size, the largest first."""
    for text, ratio in _ratios(-6, 12):
        yield Scale(MILLIMETRES[unit] * ratio, f"scale {text}", None)


def fitting_scales(factor: float) -> Iterator[Scale]:
    """Ever smaller scales for a solid in pixels, from a factor that is too large or just fits, millimetres a pixel."""
    for _ in range(48):
        rounded = float(f"{factor:.2g}")
        told = f"no real size is known: 100 px of the drawing are {100 * rounded:.4g} mm here"
        yield Scale(rounded, told, f"{told} (--width 40mm gives one)")
        factor *= _SMALLER


def _ratios(first: int, last: int) -> Iterator[tuple[str, float]]:
    """Usual ratios as text and number: number `first` of 1:1, 1:2, 1:5, 1:10, ...; 0 and below enlarge, as 2:1."""
    for k in range(first, last + 1):
        step = abs(k - 1)
        n = _USUAL[step % 3] * 10 ** (step // 3)
        yield (f"1:{n}", 1.0 / n) if k >= 1 else (f"{n}:1", float(n))
