"""Prisms in parallel drawings: oblique, where the face has its true shape, and axonometric, where it is foreshortened.

In an orthographic view of a right prism the connecting vector d is the image of the face's normal. With t along d and n
across it, the true face is the drawn one stretched by 1 / cos(slant) along t, its depth |d| / sin(slant): one unknown.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.lift.face import edge_vectors
from sketch2shape.lift.regularity import Bearings, Candidates, Relations, bearings, between, log_odds, score
from sketch2shape.lift.shape import Shape
from sketch2shape.model import Bools, Floats

#: slants tried, radians: the face is never seen quite from the front nor quite from its edge
_SLANTS = np.deg2rad(np.linspace(6.0, 84.0, 157))
_STEP = float(_SLANTS[1] - _SLANTS[0])

#: how far each slant stretches the face along d, the face drawn in its true shape first
_STRETCHES = np.concatenate([[1.0], 1.0 / np.cos(_SLANTS)])

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
class StretchedFace:
    """A drawn face ready to be stretched along d.

    relations    : what could be regular about the face as drawn
    along, across: (r,) components of the relations' vectors along and across d, pixels
    toward       : (2,) unit vector of d
    noise        : standard deviation of a drawn vertex, pixels
    isometric    : how much the isometric view is believed for the axes' directions alone
    rests        : (k,) weight of each edge direction as one that the object stands on, sum 1; None if d is upright
    """

    relations: Relations
    along: Floats
    across: Floats
    toward: Floats
    noise: float
    isometric: float = 0.0
    rests: Floats | None = None


@dataclass(frozen=True)
class ParallelReading:
    """The two ways to read a parallel drawing of a prism.

    slant       : best angle between the face's normal and the line of sight in an axonometric view, radians
    axonometric : log odds of there being such an angle
    oblique     : log odds of the face being drawn in its true shape
    view        : what they were told from
    """

    slant: float
    axonometric: float
    oblique: float
    view: StretchedFace


def axonometric_maps(slants: Floats, d: Floats) -> Floats:
    """(g, 2, 2) maps from the drawn face to the true one, in the picture's own directions: stretched along d."""
    t = d / np.hypot(*d)
    along = np.outer(t, t)
    return np.eye(2) + (1.0 / np.cos(slants) - 1.0)[:, None, None] * along


def read_parallel(face: Floats, d: Floats, relations: Relations, noise: float) -> ParallelReading:
    """How likely the drawing is an axonometric view, at the best slant, and how likely an oblique one.

    face      : (m, 2) pixels, all rings
    d         : (2,) connecting vector, pixels
    relations : what could be regular about the face as drawn
    noise     : standard deviation of a drawn vertex, pixels
    """
    view, isometric = _viewed(face, d, relations, noise)
    scores, turned = _scores(view, _STRETCHES)
    oblique = float(scores[0]) + _OBLIQUE_PRIOR + _oblique_odds(view, Bearings(turned.angle[:1], turned.spread[:1]))
    odds = scores[1:] + _slant_odds(view, _SLANTS, Bearings(turned.angle[1:], turned.spread[1:]))
    best = int(odds.argmax())
    top = float(odds[best])
    whole = top + float(np.log(np.exp(odds - top).mean())) + isometric
    return ParallelReading(float(_SLANTS[best]), whole, oblique, view)


def refined_slant(reading: ParallelReading) -> float:
    """The slant of a reading to a hundredth of a degree."""
    view = reading.view
    near = np.clip(reading.slant + _STEP * np.linspace(-1.0, 1.0, 33), _SLANTS[0], _SLANTS[-1])
    scores, turned = _scores(view, 1.0 / np.cos(near))
    odds = scores + _slant_odds(view, near, turned)
    best = int(odds.argmax())
    if not 0 < best < len(near) - 1:
        return float(near[best])
    left, top, right = odds[best - 1 : best + 2]
    bend = left - 2.0 * top + right
    return float(near[best] + (0.5 * (left - right) / bend * (near[best + 1] - near[best]) if bend < 0.0 else 0.0))


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


def _viewed(face: Floats, d: Floats, relations: Relations, noise: float) -> tuple[StretchedFace, float]:
    """The face ready for stretching, and the log odds of its axes being those of an isometric view."""
    t = d / np.hypot(*d)
    vectors = relations.rows @ face
    along, across = vectors @ t, vectors @ np.array([-t[1], t[0]])
    view = StretchedFace(relations, along, across, t, noise)
    drawn = Candidates(along[None], across[None], np.ones(1), np.ones(1))
    angle, spread = _as_drawn(view, bearings(relations, drawn, noise))
    isometric = _isometric_odds(relations, angle, spread, d)
    rests = None
    if not _is_upright(t):
        rests = relations.lengths**2 * np.where(relations.edges > 1, 1.0, 0.4)
        rests *= np.where(_rests(vectors[: len(relations.edges)], face[: relations.outer]), 1.0, 0.25)
        rests /= rests.sum()
    return replace(view, isometric=0.6 if isometric > 1.0 else 0.0, rests=rests), isometric


def _scores(view: StretchedFace, stretches: Floats) -> tuple[Floats, Bearings]:
    """(g,) regularity of the face stretched so, and its bearings measured from d."""
    x = stretches[:, None] * view.along
    found = Candidates(x, np.broadcast_to(view.across, x.shape), stretches, stretches)
    turned = bearings(view.relations, found, view.noise)
    return score(view.relations, found, turned, view.noise), turned


def _as_drawn(view: StretchedFace, turned: Bearings) -> tuple[Floats, Floats]:
    """(k,) directions of the edges as drawn, in the picture, and their standard deviations; `turned` is unstretched."""
    k = len(view.relations.edges)
    angle = turned.angle[0, :k] + np.arctan2(view.toward[1], view.toward[0])
    return (angle + np.pi) % (2.0 * np.pi) - np.pi, turned.spread[0, :k]


def _slant_odds(view: StretchedFace, slants: Floats, turned: Bearings) -> Floats:
    """(g,) what else than regularity speaks for each slant: the usual views, and gravity."""
    odds = _view_prior(slants, view.toward)
    if view.isometric:
        odds = odds + log_odds(slants - ISOMETRIC, np.full(len(slants), np.deg2rad(0.7)), view.isometric, np.pi / 2)
    return odds if view.rests is None else odds + _gravity_odds(view, slants, view.rests, turned)


def _view_prior(slants: Floats, toward: Floats) -> Floats:
    """Log density of a slant against a uniform one.

    Objects are shown from where their faces can be seen, rarely head-on, rarely edge-on; and, if d is not upright, from
    somewhat above or below: the vertical is not much foreshortened.
    """
    raw = _view_density(_SLANTS, toward)
    return (raw if slants is _SLANTS else _view_density(slants, toward)) - float(np.log(np.exp(raw).mean()))


def _view_density(slants: Floats, toward: Floats) -> Floats:
    prior: Floats = -0.5 * ((np.rad2deg(slants) - 48.0) / 20.0) ** 2
    if _is_upright(toward):
        return prior
    plumb = np.sqrt((toward[1] / np.cos(slants)) ** 2 + toward[0] ** 2)
    elevation = np.rad2deg(np.arccos(np.minimum(1.0 / plumb, 1.0)))
    prior -= 0.5 * ((elevation - 33.0) / 14.0) ** 2
    return prior


def _is_upright(toward: Floats) -> bool:
    """Is the connecting vector, of length one, drawn vertical?"""
    return bool(abs(toward[0]) < 0.1)


def _isometric_odds(relations: Relations, angle: Floats, spread: Floats, d: Floats) -> float:
    """Axes drawn at 30 degrees to both sides of the level, or one upright and one at 30 degrees: an isometric view."""
    own = np.arctan2(d[1], d[0])
    off = np.full(len(angle), np.pi / 2)
    for axis in np.deg2rad([-30.0, 30.0, 90.0]):
        if between(own, axis) < np.deg2rad(1.0):
            for other in np.deg2rad([-30.0, 30.0]):
                if other != axis:
                    off = np.minimum(off, between(angle, other))
    belief = np.where(relations.edges > 1, 0.4, 0.1)
    return float(log_odds(off, np.hypot(spread, np.deg2rad(0.5)), belief, np.pi / 2).max())


def _gravity_odds(view: StretchedFace, slants: Floats, rests: Floats, turned: Bearings) -> Floats:
    """Paper is held upright: what is drawn vertical is vertical, and the base it stands on is at right angles to it."""
    k = len(rests)
    plumb = np.arctan2(view.toward[0], view.toward[1] / np.cos(slants))
    turn = between(turned.angle[:, :k], plumb[:, None])
    width = np.hypot(turned.spread[:, :k], np.deg2rad(1.0))
    density = np.exp(-0.5 * ((turn - np.pi / 2) / width) ** 2) / (width * np.sqrt(2.0 * np.pi))
    odds: Floats = np.log(0.2 + (0.8 * np.pi) * (density @ rests))
    return odds


def _rests(ways: Floats, outer: Floats) -> Bools:
    """(k,) could the object stand on an edge of these (k, 2) directions: is one of them at the bottom of the ring?"""
    down = np.where(ways[:, :1] > 0, 1.0, -1.0) * np.stack([-ways[:, 1], ways[:, 0]], axis=1)
    depth = outer @ down.T
    close = depth > depth.max(axis=0) - 0.02 * np.ptp(depth, axis=0)
    rests: Bools = (close & np.roll(close, 1, axis=0)).any(axis=0)
    return rests


def _oblique_odds(view: StretchedFace, turned: Bearings) -> float:
    """What else than regularity speaks for an oblique drawing: level edges, and a d that recedes."""
    angle, spread = _as_drawn(view, turned)
    odds = _level_odds(view.relations, angle, spread)
    if np.abs(view.toward).min() < _STEEP:
        # an edge drawn along d is hidden behind its own side
        along = between(turned.angle[0, : len(spread)], np.zeros(1)) < 2.0 * spread + np.deg2rad(1.5)
        odds -= _STEEP_COST * (1.0 + 3.0 * bool(along.any()))
    return odds


def _level_odds(relations: Relations, angle: Floats, spread: Floats) -> float:
    """Faces in their true shape usually have edges drawn level, or nearly so on a page held askew."""
    off: Floats = between(angle, np.zeros(1))
    upright = bool((np.pi / 2 - off < 3.0 * spread + np.deg2rad(1.0)).any())
    off[relations.lengths < _LONG * relations.lengths.max()] = np.pi / 2
    belief = 0.6 if relations.rows.shape[1] == 3 and not upright else 0.88  # a triangle often stands on its tip
    exact = log_odds(off, np.hypot(spread, np.deg2rad(0.5)), belief, np.pi / 2)
    askew = log_odds(off, np.hypot(spread, np.deg2rad(4.0)), belief, np.pi / 2)
    return float(max(exact.max(), askew.max() - 0.7))
