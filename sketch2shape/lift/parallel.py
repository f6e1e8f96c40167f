"""Prisms in parallel drawings: oblique, where the face has its true shape, and axonometric, where it is foreshortened.

In an orthographic view of a right prism the connecting vector d is the image of the face's normal. With t along d and n
across it, the true face is the drawn one stretched by 1 / cos(slant) along t, its depth |d| / sin(slant): one unknown.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.lift.face import edge_vectors
from sketch2shape.lift.regularity import Relations, bearings, between, log_odds, score
from sketch2shape.lift.shape import Shape
from sketch2shape.model import Bools, Floats

#: slants tried, radians: the face is never seen quite from the front nor quite from its edge
_SLANTS = np.deg2rad(np.linspace(6.0, 84.0, 157))

#: drawn over true length of the receding edges of a cabinet drawing, the commonest oblique one
CABINET = 0.5

#: the same of a cavalier drawing
CAVALIER = 1.0

# : receding edges of an oblique drawing are not drawn level or upright (sine of the slack), least of all along the
# face's : own edges, where they would hide the sides; the cost in log odds where they are
_STEEP, _STEEP_COST = 0.035, 1.5

#: directions with less than this part of the longest one's length do not tell how a face is held
_LONG = 0.3

#: slant of an isometric view: all three axes equally foreshortened
ISOMETRIC = float(np.arccos(1.0 / np.sqrt(3.0)))

#: log odds of an oblique drawing before anything is seen: most hand-made drawings of prisms are
_OBLIQUE_PRIOR = 0.8


@dataclass(frozen=True)
class ParallelReading:
    """One way to read a parallel drawing of a prism.

    slant : angle between the face's normal and the line of sight, radians; 0 in an oblique drawing
    odds  : log odds of this reading
    """

    slant: float
    odds: float


def axonometric_maps(slants: Floats, d: Floats) -> Floats:
    """(g, 2, 2) maps from the drawn face to the true one, in the picture's own directions: stretched along d."""
    t = d / np.hypot(*d)
    along = np.outer(t, t)
    return np.eye(2) + (1.0 / np.cos(slants) - 1.0)[:, None, None] * along


def read_axonometric(face: Floats, d: Floats, relations: Relations, noise: float) -> ParallelReading:
    """The best slant for a face drawn in an orthographic view, with the odds of there being one.

    face      : (m, 2) pixels, all rings
    d         : (2,) connecting vector, pixels
    relations : what could be regular about the face as drawn
    noise     : standard deviation of a drawn vertex, pixels
    """
    isometric = _isometric_odds(relations, face, d, noise)
    belief = 0.6 if isometric > 1.0 else 0.0
    odds = _axonometric_odds(_SLANTS, relations, face, d, noise, belief)
    best = float(_SLANTS[odds.argmax()])
    step = float(_SLANTS[1] - _SLANTS[0])
    for _ in range(2):
        near = np.clip(best + step * np.linspace(-1.0, 1.0, 17), _SLANTS[0], _SLANTS[-1])
        best = float(near[_axonometric_odds(near, relations, face, d, noise, belief).argmax()])
        step /= 8.0
    top = float(odds.max())
    whole = top + float(np.log(np.exp(odds - top).mean())) + isometric
    return ParallelReading(best, whole)


def read_oblique(face: Floats, d: Floats, relations: Relations, noise: float) -> ParallelReading:
    """The odds that the face is drawn in its true shape; arguments as in `read_axonometric`."""
    odds = float(score(relations, face[None], np.eye(2)[None], noise)[0])
    odds += _level_odds(relations, face, noise) + _OBLIQUE_PRIOR
    if min(abs(d)) < _STEEP * np.hypot(*d):
        odds -= _STEEP_COST * (1.0 + 3.0 * _along_edges(relations, face, d, noise))
    return ParallelReading(0.0, odds)


def axonometric_shape(face: Floats, sizes: list[int], d: Floats, slant: float) -> Shape:
    """The right prism drawn so in an orthographic view; arguments as in `read_axonometric`, slant in radians."""
    length = float(np.hypot(*d))
    t = d / length
    n = np.array([-t[1], t[0]])
    along = np.array([*(t * np.cos(slant)), -np.sin(slant)])
    across = np.array([*n, 0.0])
    pose = np.array([t[0] * along + n[0] * across, t[1] * along + n[1] * across, [*(t * np.sin(slant)), np.cos(slant)]])
    stretch = axonometric_maps(np.array([slant]), d)[0]
    middle = face[: sizes[0]].mean(axis=0)
    flat = (face - middle) @ stretch
    evidence = {"slant_deg": round(float(np.rad2deg(slant)), 2), "foreshortening": round(float(np.cos(slant)), 4)}
    depth = length / float(np.sin(slant))
    return Shape("axonometric", flat, pose, np.array([*middle, 0.0]), depth, stretch, sizes, evidence=evidence)


def oblique_shape(face: Floats, sizes: list[int], d: Floats, ratio: float | None, noise: float) -> Shape:
    """The face as drawn, with the depth that the ratio of drawn to true receding lengths gives.

    ratio : None for `CABINET`, or 1 (cavalier) if the receding edges are drawn just as long as some edge of the face
    noise : standard deviation of a drawn vertex, pixels
    """
    length = float(np.hypot(*d))
    used = ratio or _likely_ratio(face, sizes, length, noise)
    evidence = {
        "depth_ratio": used,
        "receding_deg": round(float(np.rad2deg(np.arctan2(-d[1], d[0]))), 2),
    }
    depth = length / used
    return Shape(
        "oblique", face, np.eye(3), np.zeros(3), depth, np.eye(2), sizes, free=ratio is None, evidence=evidence
    )


def _likely_ratio(face: Floats, sizes: list[int], length: float, noise: float) -> float:
    edges = np.hypot(*edge_vectors(face, sizes).T)
    off_full, off_half = (float(np.abs(edges - times * length).min()) for times in (1.0, 2.0))
    return CAVALIER if off_full < 2.0 * noise and off_half > 2.0 * noise else CABINET


def _axonometric_odds(
    slants: Floats, relations: Relations, face: Floats, d: Floats, noise: float, isometric: float
) -> Floats:
    """Log odds of each slant; `isometric` is how much the isometric view is believed for the axes' directions alone."""
    maps = axonometric_maps(slants, d)
    shapes = np.einsum("mi,gij->gmj", face, maps)
    odds = score(relations, shapes, maps, noise) + _view_prior(slants, d)
    odds = odds + log_odds(slants - ISOMETRIC, np.full(len(slants), np.deg2rad(0.7)), isometric, np.pi / 2)
    return odds + _gravity_odds(relations, shapes, maps, face[: relations.outer], d, noise)


def _view_prior(slants: Floats, d: Floats) -> Floats:
    """Log density of a slant against a uniform one.

    Objects are shown from where their faces can be seen, rarely head-on, rarely edge-on; and, if d is not upright, from
    somewhat above or below: the vertical is not much foreshortened.
    """

    def raw(angles: Floats) -> Floats:
        prior: Floats = -0.5 * ((np.rad2deg(angles) - 48.0) / 20.0) ** 2
        if not _is_upright(d):
            plumb = axonometric_maps(angles, d)[:, 1]
            elevation = np.rad2deg(np.arccos(np.clip(1.0 / np.linalg.norm(plumb, axis=1), 0.0, 1.0)))
            prior = prior - 0.5 * ((elevation - 33.0) / 14.0) ** 2
        return prior

    return raw(slants) - float(np.log(np.exp(raw(_SLANTS)).mean()))


def _is_upright(d: Floats) -> bool:
    """Is the connecting vector drawn vertical?"""
    return bool(abs(d[0]) < 0.1 * np.hypot(*d))


def _isometric_odds(relations: Relations, face: Floats, d: Floats, noise: float) -> float:
    """Axes drawn at 30 degrees to both sides of the level, or one upright and one at 30 degrees: an isometric view."""
    angle, spread = bearings(relations, face[None], np.eye(2)[None], noise)
    own = np.arctan2(d[1], d[0])
    off = np.full(angle.shape[1], np.pi / 2)
    for axis in np.deg2rad([-30.0, 30.0, 90.0]):
        if between(own, axis) < np.deg2rad(1.0):
            for other in np.deg2rad([-30.0, 30.0]):
                if other != axis:
                    off = np.minimum(off, between(angle[0], other))
    belief = np.where(relations.edges > 1, 0.4, 0.1)
    return float(log_odds(off, np.hypot(spread[0], np.deg2rad(0.5)), belief, np.pi / 2).max())


def _gravity_odds(relations: Relations, shapes: Floats, maps: Floats, outer: Floats, d: Floats, noise: float) -> Floats:
    """Paper is held upright: what is drawn vertical is vertical, and the base it stands on is at right angles to it.

    Says nothing if d itself is vertical.
    """
    if _is_upright(d):
        return np.zeros(len(shapes))
    plumb = maps[:, 1]
    angle, spread = bearings(relations, shapes, maps, noise)
    turn = between(angle, np.arctan2(plumb[:, 1], plumb[:, 0])[:, None])
    width = np.hypot(spread, np.deg2rad(1.0))
    density = np.exp(-0.5 * ((turn - np.pi / 2) / width) ** 2) / (width * np.sqrt(2.0 * np.pi))
    weight = relations.lengths**2 * np.where(relations.edges > 1, 1.0, 0.4)
    weight *= np.where(_rests(relations, outer), 1.0, 0.25)
    chance = 0.2 + 0.8 * density @ (weight / weight.sum()) * np.pi
    odds: Floats = np.log(chance)
    return odds


def _rests(relations: Relations, outer: Floats) -> Bools:
    """(k,) could the object stand on an edge of this direction: is one of them at the bottom of the outer ring?"""
    n = len(outer)
    along = relations.directions[:, :n] @ outer
    rests = np.zeros(len(along), bool)
    for k, (x, y) in enumerate(along):
        across = np.array([-y, x]) if x > 0 else np.array([y, -x])
        depth = outer @ across
        close = depth > depth.max() - 0.02 * np.ptp(depth)
        rests[k] = bool((close & np.roll(close, 1)).any())
    return rests


def _along_edges(relations: Relations, face: Floats, d: Floats, noise: float) -> bool:
    """Is d drawn parallel to an edge of the face?"""
    angle, spread = bearings(relations, face[None], np.eye(2)[None], noise)
    off = between(angle[0], np.arctan2(d[1:], d[:1]))
    return bool((off < 2.0 * spread[0] + np.deg2rad(1.5)).any())


def _level_odds(relations: Relations, face: Floats, noise: float) -> float:
    """Faces in their true shape usually have edges drawn level, or nearly so on a page held askew."""
    angle, spread = bearings(relations, face[None], np.eye(2)[None], noise)
    off: Floats = between(angle[0], np.zeros(1))
    upright = bool((np.pi / 2 - off < 3.0 * spread[0] + np.deg2rad(1.0)).any())
    off[relations.lengths < _LONG * relations.lengths.max()] = np.pi / 2
    belief = 0.6 if len(face) == 3 and not upright else 0.88  # a triangle often stands on its tip
    exact = log_odds(off, np.hypot(spread[0], np.deg2rad(0.5)), belief, np.pi / 2)
    askew = log_odds(off, np.hypot(spread[0], np.deg2rad(4.0)), belief, np.pi / 2)
    return float(max(exact.max(), askew.max() - 0.7))
