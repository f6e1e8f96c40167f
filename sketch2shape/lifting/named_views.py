"""The axonometric views that drawing rules name: isometric, and the dimetric one of ISO 5456-3.

Their axes have fixed directions and foreshortenings, so a drawing whose edges run along them was made with them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sketch2shape.lifting.regularity import between
from sketch2shape.model import Floats

Name = Literal["isometric", "dimetric"]

#: how far off a hand or a pixel draws an axis, radians, besides the drawing's own noise
SLOPPY = math.radians(0.4)

#: how likely an edge of a face drawn in such a view runs along an axis
_ALONG = 0.97

#: part of the oblique drawings whose edges run along all three isometric axes that were not meant so
_TRIAD = 0.95

#: how likely no edge runs along one of the two axes
_ONE_AXIS = 0.005

#: a chance less than this is none
_NEVER = 1e-9

#: slants of a face across an axis: all alike in an isometric view; in the dimetric one, across its half axis or another
ISOMETRIC = math.acos(1.0 / math.sqrt(3.0))
_HALF, _FULL = math.asin(math.sqrt(2.0) / 3.0), math.asin(math.sqrt(8.0) / 3.0)

#: the slants of `SLANTED`
SLANTS: Floats = np.array([ISOMETRIC, _HALF, _FULL])

#: directions of the dimetric axes against the level, radians: a full and the half one
_FLAT, _STEEP = math.radians(7.181), math.radians(41.410)


@dataclass(frozen=True)
class NamedView:
    """A pair of faces as such a view shows it.

    name   : of the view
    slant  : index into `SLANTS`
    normal : direction of the connecting edges, radians, y down
    axes   : directions of the other two axes
    belief : how likely it is among all axonometric views
    """

    name: Name
    slant: int
    normal: float
    axes: tuple[float, float]
    belief: float


def _views() -> tuple[NamedView, ...]:
    up, iso = 0.5 * math.pi, math.pi / 6.0
    found = [
        NamedView("isometric", 0, normal, axes, 0.2)
        for normal, axes in ((iso, (-iso, up)), (-iso, (iso, up)), (up, (iso, -iso)))
    ]
    for side in (1.0, -1.0):
        flat, steep = -side * _FLAT, side * _STEEP
        found += [
            NamedView("dimetric", 1, steep, (flat, up), 0.03),
            NamedView("dimetric", 2, flat, (steep, up), 0.015),
            NamedView("dimetric", 2, up, (flat, steep), 0.015),
        ]
    return tuple(found)


VIEWS = _views()

#: log of how likely an axonometric view is none of these
FREE = math.log(1.0 - sum(view.belief for view in VIEWS))


def off_axis(view: NamedView, toward: float) -> float:
    """The turn that takes a connecting vector drawn in this direction onto the view's axis, radians."""
    return (view.normal - toward + 0.5 * math.pi) % math.pi - 0.5 * math.pi


def view_odds(view: NamedView, toward: float, wobble: float, angle: Floats, spread: Floats, weight: Floats) -> float:
    """Log odds that the connecting edges and the face's edges follow a view's axes, and not any directions.

    toward, wobble : direction of the connecting edges and its standard deviation, radians
    angle, spread  : (k,) the same of the face's edges
    weight         : (k,) how much each of them counts, sum 1
    """
    width = math.hypot(wobble, SLOPPY)
    normal = math.pi * math.exp(-0.5 * (off_axis(view, toward) / width) ** 2) / (width * math.sqrt(2.0 * math.pi))
    if normal < 1e-4:
        return -math.inf
    near, wide = _near(view, angle, spread)
    along = float((near @ (weight / wide)).sum()) / math.sqrt(2.0 * math.pi)
    odds = math.log(view.belief * normal) + math.log(1.0 - _ALONG + _ALONG * 0.5 * math.pi * along)
    return odds + math.log(_ONE_AXIS + (_ALONG - _ONE_AXIS) * float(near.max(axis=1).prod()))


def triad_odds(toward: float, wobble: float, angle: Floats, spread: Floats) -> float:
    """Log odds of an oblique drawing whose edges run along all three isometric axes: they do so by chance alone.

    As in `view_odds`.
    """
    width = math.hypot(wobble, SLOPPY)
    most = 0.0
    for view in VIEWS:
        chance = math.exp(-0.5 * (off_axis(view, toward) / width) ** 2) if view.name == "isometric" else 0.0
        if chance > _NEVER:
            most = max(most, chance * float(_near(view, angle, spread)[0].max(axis=1).prod()))
    return math.log(1.0 - _TRIAD * most)


def _near(view: NamedView, angle: Floats, spread: Floats) -> tuple[Floats, Floats]:
    """(2, k) how near each edge runs to each axis, 1 if along it, and (k,) how sure its direction is, radians."""
    wide = np.sqrt(spread**2 + SLOPPY**2)
    return np.array([np.exp(-0.5 * (between(angle, axis) / wide) ** 2) for axis in view.axes]), wide
