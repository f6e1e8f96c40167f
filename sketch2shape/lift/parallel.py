"""Prisms in parallel drawings: oblique, where the face has its true shape, and axonometric, where it is foreshortened.

In an orthographic view of a right prism the connecting vector d is the image of the face's normal. With t along d and n
across it, the true face is the drawn one stretched by 1 / cos(slant) along t, its depth |d| / sin(slant): one unknown.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sketch2shape.lift.regularity import Relations, bearings, between, find_relations, log_odds, score
from sketch2shape.model import Floats

#: slants tried, radians: the face is never seen quite from the front nor quite from its edge
_SLANTS = np.deg2rad(np.linspace(6.0, 84.0, 235))

#: the slant of an isometric view: all three axes equally foreshortened
ISOMETRIC = float(np.arccos(1.0 / np.sqrt(3.0)))


@dataclass(frozen=True)
class ParallelReading:
    """One way to read a parallel drawing of a prism.

    family   : "oblique" or "axonometric"
    slant    : angle between the face's normal and the line of sight, radians; 0 in an oblique drawing
    odds     : log odds of this reading
    evidence : numbers for the report
    """

    family: str
    slant: float
    odds: float
    evidence: dict[str, Any] = field(default_factory=dict)


def axonometric_maps(slants: Floats, d: Floats) -> Floats:
    """(g, 2, 2) maps from the drawn face to the true one, in the picture's own directions: stretched along d."""
    t = d / np.hypot(*d)
    along = np.outer(t, t)
    return np.eye(2) + (1.0 / np.cos(slants) - 1.0)[:, None, None] * along


def read_axonometric(face: Floats, sizes: list[int], d: Floats, noise: float) -> ParallelReading:
    """The best slant for a face drawn in an orthographic view, with the odds of there being one.

    face  : (m, 2) pixels, all rings
    sizes : vertices of each ring
    d     : (2,) connecting vector, pixels
    noise : standard deviation of a drawn vertex, pixels
    """
    relations = find_relations(face, sizes, face, noise)
    odds = _axonometric_odds(_SLANTS, relations, face, d, noise)
    best = float(_SLANTS[odds.argmax()])
    step = float(_SLANTS[1] - _SLANTS[0])
    for _ in range(2):
        near = np.clip(best + step * np.linspace(-1.0, 1.0, 17), _SLANTS[0], _SLANTS[-1])
        best = float(near[_axonometric_odds(near, relations, face, d, noise).argmax()])
        step /= 8.0
    top = float(odds.max())
    whole = top + float(np.log(np.exp(odds - top).mean()))
    return ParallelReading("axonometric", best, whole, {"slant_deg": round(float(np.rad2deg(best)), 2)})


def read_oblique(face: Floats, sizes: list[int], noise: float) -> ParallelReading:
    """The odds that the face is drawn in its true shape; arguments as in `read_axonometric`."""
    relations = find_relations(face, sizes, face, noise)
    odds = float(score(relations, face[None], np.eye(2)[None], noise)[0])
    odds += _level_odds(relations, face, noise)
    return ParallelReading("oblique", 0.0, odds)


def _axonometric_odds(slants: Floats, relations: Relations, face: Floats, d: Floats, noise: float) -> Floats:
    maps = axonometric_maps(slants, d)
    shapes = np.einsum("mi,gij->gmj", face, maps)
    odds = score(relations, shapes, maps, noise) + _slant_prior(slants)
    return odds + _gravity_odds(relations, shapes, maps, d, noise) + _isometric_odds(slants, d)


def _slant_prior(slants: Floats) -> Floats:
    """Objects are shown from where their faces can be seen: rarely head-on, rarely edge-on."""
    prior: Floats = -0.5 * ((np.rad2deg(slants) - 48.0) / 18.0) ** 2
    return prior


def _isometric_odds(slants: Floats, d: Floats) -> Floats:
    """An axis drawn at 30 degrees, or upright, suggests the isometric view."""
    rise = np.rad2deg(np.arctan2(abs(d[1]), abs(d[0])))
    belief = 0.35 if abs(rise - 30.0) < 1.0 or rise > 89.0 else 0.02
    return log_odds(slants - ISOMETRIC, np.full(len(slants), np.deg2rad(0.5)), belief, np.pi / 2)


def _gravity_odds(relations: Relations, shapes: Floats, maps: Floats, d: Floats, noise: float) -> Floats:
    """Paper is held upright: what is drawn vertical is vertical, and the base it stands on is at right angles to it.

    Says nothing if d itself is vertical. Includes a mild prior on the height from which things are seen.
    """
    upright = abs(d[0]) / np.hypot(*d)
    if upright < 0.1:
        return np.zeros(len(shapes))
    plumb = maps[:, 1]
    angle, spread = bearings(relations, shapes, maps, noise)
    turn = between(angle, np.arctan2(plumb[:, 1], plumb[:, 0])[:, None])
    width = np.hypot(spread, np.deg2rad(1.0))
    density = np.exp(-0.5 * ((turn - np.pi / 2) / width) ** 2) / (width * np.sqrt(2.0 * np.pi))
    weight = relations.lengths**2 * (relations.edges > 1) + 0.3 * relations.lengths**2
    chance = 1.0 + density @ (weight / weight.sum()) * np.pi
    elevation = np.rad2deg(np.arccos(np.clip(1.0 / np.linalg.norm(plumb, axis=1), 0.0, 1.0)))
    odds: Floats = np.log(chance) - 0.5 * ((elevation - 33.0) / 14.0) ** 2
    return odds


def _level_odds(relations: Relations, face: Floats, noise: float) -> float:
    """Faces in their true shape usually have edges drawn level."""
    angle, spread = bearings(relations, face[None], np.eye(2)[None], noise)
    off = between(angle[0], np.zeros(1))
    odds = log_odds(off, np.hypot(spread[0], np.deg2rad(0.5)), 0.6, np.pi / 2)
    return float(odds.max())
