"""What was found in a picture, in a line of words."""

from __future__ import annotations

from typing import NamedTuple

from sketch2shape.model import Answer, Solid
from sketch2shape.solids import shape_name

#: objects of a sheet that are described one by one
_MOST = 4


class Measures(NamedTuple):
    """How large a solid is: lengths in `unit`, the surface in its square, the volume in its cube."""

    width: float
    height: float
    depth: float
    surface: float
    volume: float
    unit: str


def measures_of(answer: Answer) -> tuple[Measures, ...]:
    """The measures of each solid, to six digits."""
    found = []
    for solid in answer.solids:
        width, height, depth = (float(f"{size:.6g}") for size in solid.dimensions)
        surface, volume = float(f"{solid.area:.6g}"), float(f"{solid.volume:.6g}")
        found.append(Measures(width, height, depth, surface, volume, solid.unit))
    return tuple(found)


def least_confidence(answer: Answer) -> float:
    """Confidence of the object that is least sure."""
    return min(answer.confidences)


def describe(answer: Answer) -> str:
    """What the objects are, how large, how sure, and what had to be assumed.

    As in "box, 40 x 40 x 51 mm, confidence 0.99; the drawing leaves the depth free: 51 mm is assumed".
    """
    solids = answer.solids[:_MOST]
    words = [f"{shape_name(solid)}, {size_of(solid)}" for solid in solids]
    if len(answer.solids) > _MOST:
        words.append(f"{len(answer.solids) - _MOST} more")
    count = f"{len(answer.solids)} objects: " if len(answer.solids) > 1 else ""
    assumed = list(dict.fromkeys(warning for solid in answer.solids for warning in solid.warnings))
    return "; ".join([f"{count}{', '.join(words)}, confidence {least_confidence(answer):.2f}", *assumed])


def size_of(solid: Solid) -> str:
    """As in "40 x 40 x 51.5 mm": width, height and depth along the object's own axes."""
    return " x ".join(f"{extent:.4g}" for extent in solid.dimensions) + f" {solid.unit}"
