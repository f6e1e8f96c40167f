"""What speaks for and against an oblique drawing: level edges of the face, and how its receding edges run."""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.lifting.regularity import Relations, between, log_odds
from sketch2shape.model import Floats

#: receding edges of an oblique drawing are not drawn level or upright (within about this angle, radians), least of all
#: along the face's own edges, where they would hide the sides; the cost in log odds where they are
_STEEP, _STEEP_COST = np.deg2rad(2.0), 2.0

#: directions with less than this part of the longest one's length do not tell how a face is held
_LONG = 0.3

#: how likely a face in true shape has an edge drawn level, and if its edges have two directions only; and the log odds
#: against the page being held askew
_LEVEL, _LEVEL_CROSSED, _ASKEW = 0.97, 0.996, 1.0

#: what is drawn within so many standard deviations of the plumb, and this angle more, radians, is plumb
_SPREADS, _PLUMB = 3.0, math.radians(1.0)

#: angles at which receding edges of an oblique drawing rise, radians, and how likely it is that each of them is used
_RECEDING = {math.pi / 6: 0.12, math.pi / 4: 0.28, math.pi / 3: 0.1}


def steep_cost(toward: Floats, wobble: float, off: Floats, spread: Floats) -> float:
    """What it costs an oblique drawing that d hardly recedes.

    toward, wobble : (2,) unit vector of d, and the standard deviation of its direction, radians
    off, spread    : (k,) angle of each edge direction to d, and its standard deviation, radians
    """
    level = float(np.arcsin(np.abs(toward).min()))
    steep = math.exp(-0.5 * max(level - _STEEP, 0.0) ** 2 / (math.radians(0.5) ** 2 + wobble**2))
    if steep <= 0.01:
        return 0.0
    # an edge drawn along d is hidden behind its own side
    near = np.sqrt((2.0 * spread) ** 2 + (2.0 * wobble) ** 2) + math.radians(1.5)
    hidden = bool((between(off, np.zeros(1)) < near).any())
    return _STEEP_COST * (1.0 + 3.0 * hidden) * steep


def usual_odds(toward: Floats, wobble: float) -> float:
    """Log odds that d rises at one of the angles at which edges of an oblique drawing recede, and not at any."""
    rise = math.atan2(abs(toward[1]), abs(toward[0]))
    spread = math.hypot(wobble, math.radians(0.5))
    odds = 1.0 - sum(_RECEDING.values())
    for angle, belief in _RECEDING.items():
        density = math.exp(-0.5 * ((rise - angle) / spread) ** 2) / (spread * math.sqrt(2.0 * math.pi))
        odds += belief * 0.5 * math.pi * density
    return math.log(odds)


def level_odds(relations: Relations, angle: Floats, spread: Floats, toward: Floats, wobble: float) -> float:
    """Faces in their true shape usually have edges drawn level, or nearly so on a page held askew.

    Where anything is drawn plumb, the page is not. The arguments are those of `steep_cost`, but for `angle` of each
    edge direction in the picture.
    """
    if not len(angle):
        return 0.0
    off: Floats = between(angle, np.zeros(1))
    upright = bool((np.pi / 2 - off < _SPREADS * spread + _PLUMB).any())
    off[relations.lengths < _LONG * relations.lengths.max()] = np.pi / 2
    belief = _LEVEL_CROSSED if len(relations.edges) == 2 else _LEVEL
    if relations.rows.shape[1] == 3 and not upright:
        belief = 0.6  # a triangle often stands on its tip
    exact = log_odds(off, np.hypot(spread, np.deg2rad(0.5)), belief, np.pi / 2)
    if upright or abs(toward[0]) < math.sin(_SPREADS * wobble + _PLUMB):
        return float(exact.max())
    askew = log_odds(off, np.hypot(spread, np.deg2rad(4.0)), belief, np.pi / 2)
    return float(max(exact.max(), askew.max() - _ASKEW))
