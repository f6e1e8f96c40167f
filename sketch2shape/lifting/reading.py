"""Reading a parallel drawing of a prism: is it oblique or axonometric, and at what slant is the face seen?

The slant (see `parallel`) is the one that makes the face regular and the view a usual one. The direction of d is only
known to within the drawing's noise, which matters where d is short and the face seen nearly from its edge: then the
slant is sought together with a small turn of d.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sketch2shape.lifting.regularity import Bearings, Candidates, Relations, bearings, between, log_odds, score
from sketch2shape.model import Bools, Floats

#: slants tried, radians: the face is never seen quite from the front nor quite from its edge
_SLANTS = np.deg2rad(np.linspace(6.0, 84.0, 105))
_STEP = float(_SLANTS[1] - _SLANTS[0])

#: a d known to within this angle, radians, is not turned at first, or not even when the pose is refined; else turns of
#: this many standard deviations are tried
_SURE, _QUITE_SURE = np.deg2rad(0.4), np.deg2rad(0.1)
_FEW_TURNS, _TURNS = np.linspace(-2.0, 2.0, 7), np.linspace(-2.0, 2.0, 13)
_NO_TURN = np.zeros(1)

#: receding edges of an oblique drawing are not drawn level or upright (within about this angle, radians), least of all
#: along the face's own edges, where they would hide the sides; the cost in log odds where they are
_STEEP, _STEEP_COST = np.deg2rad(2.0), 2.0

#: directions with less than this part of the longest one's length do not tell how a face is held
_LONG = 0.3

#: how likely a face in true shape has an edge drawn level, and the log odds against the page being held askew
_LEVEL, _ASKEW = 0.96, 1.0

#: angles at which receding edges of an oblique drawing, and the axes of an isometric one, rise, radians, and how likely
#: it is that one of them is used
_RECEDING, _OFTEN = (math.pi / 6, math.pi / 4, math.pi / 3), 0.5
_ISOMETRIC_AXES, _SOMETIMES = (math.pi / 6,), 0.3

#: the axes as an isometric view draws them, the upright one last, and how near d has to be to one, radians
_AXES, _ALONG = (-math.pi / 6, math.pi / 6, math.pi / 2), math.radians(1.0)

#: slant of an isometric view: all three axes equally foreshortened
ISOMETRIC = float(np.arccos(1.0 / np.sqrt(3.0)))

#: how likely an object in an orthographic view stands on none of its edges
_AFLOAT = 0.1

#: log odds of an oblique drawing before anything is seen: most hand-made drawings of prisms are
_OBLIQUE_PRIOR = 1.0


@dataclass(frozen=True)
class StretchedFace:
    """A drawn face ready to be stretched along d.

    relations    : what could be regular about the face as drawn
    along, across: (r,) components of the relations' vectors along and across d, pixels
    toward       : (2,) unit vector of d
    wobble       : standard deviation of the direction of d, radians
    noise        : standard deviation of a drawn vertex, pixels
    isometric    : how much the isometric view is believed for the axes' directions alone
    rests        : (k,) weight of each edge direction as one that the object stands on, sum 1; None if d is upright
    """

    relations: Relations
    along: Floats
    across: Floats
    toward: Floats
    wobble: float
    noise: float
    isometric: float = 0.0
    rests: Floats | None = None


@dataclass(frozen=True)
class Pose:
    """A guess at how the face is held: its slant, and by how much d was drawn astray, both radians."""

    slant: float
    turn: float

    def turned(self, d: Floats) -> Floats:
        """The connecting vector d without that error."""
        c, s = np.cos(self.turn), np.sin(self.turn)
        return np.array([c * d[0] - s * d[1], s * d[0] + c * d[1]])


@dataclass(frozen=True)
class ParallelReading:
    """The two ways to read a parallel drawing of a prism.

    pose        : the best one for an axonometric view
    axonometric : log odds of there being such a pose
    oblique     : log odds of the face being drawn in its true shape
    view        : what they were told from
    """

    pose: Pose
    axonometric: float
    oblique: float
    view: StretchedFace


@dataclass(frozen=True)
class _Trials:
    """Poses tried: every slant (g,) with every turn (h,), radians, the turn outermost; `sure` (h,) weighs the turns.

    Before all of them comes the face as drawn, neither stretched nor turned.
    """

    slants: Floats
    turns: Floats
    sure: Floats

    @cached_property
    def stretches(self) -> Floats:
        """(1 + h g, 1) stretch along d."""
        return np.concatenate([[1.0], *[1.0 / np.cos(self.slants)] * len(self.turns)])[:, None]

    @cached_property
    def swung(self) -> tuple[Floats, Floats]:
        """Cosine and sine of the turn of d, both (1 + h g, 1)."""
        swung = np.concatenate([[0.0], np.repeat(self.turns, len(self.slants))])[:, None]
        return np.cos(swung), np.sin(swung)


_STILL = _Trials(_SLANTS, _NO_TURN, np.ones(1))


def read_parallel(face: Floats, d: Floats, relations: Relations, noise: float) -> ParallelReading:
    """How likely the drawing is an axonometric view, at the best pose, and how likely an oblique one.

    face      : (m, 2) pixels, all rings
    d         : (2,) connecting vector, pixels
    relations : what could be regular about the face as drawn
    noise     : standard deviation of a drawn vertex, pixels
    """
    long = math.hypot(*d.tolist())
    t = d / long
    vectors = relations.rows @ face
    along, across = vectors @ t, vectors @ np.array([-t[1], t[0]])
    wobble = noise * math.sqrt(2.0 / len(face)) / long
    trials = _STILL if wobble <= _SURE else _trials(wobble, _SLANTS, _FEW_TURNS)
    found = _stretched(along, across, trials)
    turned = bearings(relations, found, noise)
    angle, spread = _as_drawn(t, turned, len(relations.edges))
    isometric = _isometric_odds(relations, angle, spread, d)
    rests = None
    if not _is_upright(t):
        rests = relations.lengths**2 * np.where(relations.edges > 1, 1.0, 0.4)
        rests *= np.where(_rests(vectors[: len(relations.edges)], face[: relations.outer]), 1.0, 0.25)
        rests /= rests.sum()
    view = StretchedFace(relations, along, across, t, wobble, noise, 0.6 if isometric > 1.0 else 0.0, rests)
    regular = score(relations, found, turned, noise)
    odds = regular[1:] + _pose_odds(view, trials, found, turned)
    oblique = float(regular[0]) + _OBLIQUE_PRIOR + _level_odds(relations, angle, spread)
    oblique += _usual_odds(view, _RECEDING, _OFTEN) - _steep_cost(view, turned.angle[0, : len(spread)], spread)
    isometric += _usual_odds(view, _ISOMETRIC_AXES, _SOMETIMES)
    turn, slant = divmod(int(odds.argmax()), len(_SLANTS))
    top = float(odds.max())
    chance = np.exp(odds - top).sum() / (len(_SLANTS) * trials.sure.sum())
    whole = top + math.log(chance) + isometric
    return ParallelReading(Pose(float(_SLANTS[slant]), float(trials.turns[turn])), whole, oblique, view)


def refined_pose(reading: ParallelReading) -> Pose:
    """The pose of a reading to a hundredth of a degree."""
    view, pose = reading.view, reading.pose
    near = np.clip(pose.slant + _STEP * np.linspace(-1.0, 1.0, 17), _SLANTS[0], _SLANTS[-1])
    trials = _trials(view.wobble, near, _TURNS if view.wobble > _QUITE_SURE else _NO_TURN)
    found = _stretched(view.along, view.across, trials)
    turned = bearings(view.relations, found, view.noise)
    odds = score(view.relations, found, turned, view.noise)[1:] + _pose_odds(view, trials, found, turned)
    odds = odds.reshape(len(trials.turns), len(near))
    turn, slant = divmod(int(odds.argmax()), len(near))
    return Pose(_peak(near, odds[turn], slant), _peak(trials.turns, odds[:, slant], turn))


def _peak(at: Floats, odds: Floats, best: int) -> float:
    """Where the parabola through the best of equally spaced values and its neighbours is highest."""
    if not 0 < best < len(at) - 1:
        return float(at[best])
    left, top, right = odds[best - 1 : best + 2]
    bend = float(left - 2.0 * top + right)
    return float(at[best] + (0.5 * (left - right) / bend * (at[best + 1] - at[best]) if bend < 0.0 else 0.0))


def _trials(wobble: float, slants: Floats, turns: Floats) -> _Trials:
    return _Trials(slants, wobble * turns, np.exp(-0.5 * turns**2))


def _stretched(along: Floats, across: Floats, trials: _Trials) -> Candidates:
    """The face in each pose, by the components of its relations' vectors along and across d as drawn."""
    stretches = trials.stretches
    if len(trials.turns) == 1:
        return Candidates(
            stretches * along, across[None].repeat(len(stretches), axis=0), stretches[:, 0], stretches[:, 0]
        )
    c, s = trials.swung
    return Candidates(stretches * (c * along + s * across), c * across - s * along, stretches[:, 0], stretches[:, 0])


def _pose_odds(view: StretchedFace, trials: _Trials, found: Candidates, turned: Bearings) -> Floats:
    """(h g,) log odds of the poses, whatever shape they give the face."""
    odds = _isotropy_odds(view.relations, found)[1:]
    odds = odds + np.add.outer(np.log(trials.sure), _slant_odds(view, trials.slants)).ravel()
    return odds if view.rests is None else odds + _gravity_odds(view, view.rests, trials, turned)[1:]


def _as_drawn(toward: Floats, turned: Bearings, k: int) -> tuple[Floats, Floats]:
    """(k,) directions of the edges as drawn, in the picture, and their standard deviations."""
    angle = turned.angle[0, :k] + math.atan2(toward[1], toward[0])
    return (angle + np.pi) % (2.0 * np.pi) - np.pi, turned.spread[0, :k]


def _slant_odds(view: StretchedFace, slants: Floats) -> Floats:
    """(g,) how usual a view at each slant is."""
    odds = _view_prior(slants, view.toward)
    if not view.isometric:
        return odds
    return odds + log_odds(slants - ISOMETRIC, np.full(len(slants), np.deg2rad(0.7)), view.isometric, np.pi / 2)


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
    own = math.atan2(d[1], d[0])
    off = np.full(len(angle), np.pi / 2)
    for axis in _AXES:
        if abs(math.sin(own - axis)) < math.sin(_ALONG):
            for other in _AXES[:2]:
                if other != axis:
                    off = np.minimum(off, between(angle, other))
    belief = np.where(relations.edges > 1, 0.4, 0.1)
    return float(log_odds(off, np.hypot(spread, np.deg2rad(0.5)), belief, np.pi / 2).max())


def _isotropy_odds(relations: Relations, found: Candidates) -> Floats:
    """Edges of a true face run in all directions alike: the density of the directions as drawn, each slant given.

    Foreshortening crowds them together, across d. (Witkin, "Recovering surface shape and orientation from texture",
    1981, reads slants from textures so.) A true angle turns area * (drawn / true length)^2 times as fast as the drawn.
    """
    k = len(relations.edges)
    square = np.maximum(found.x[:, :k] ** 2 + found.y[:, :k] ** 2, 1e-24)
    odds: Floats = np.log(found.area[:, None] * relations.drawn[:k] ** 2 / square).sum(axis=1)
    return odds


def _gravity_odds(view: StretchedFace, rests: Floats, trials: _Trials, turned: Bearings) -> Floats:
    """Paper is held upright: what is drawn vertical is vertical, and the base it stands on is at right angles to it."""
    k = len(rests)
    c, s = trials.swung
    rise, aside = c * view.toward[1] + s * view.toward[0], c * view.toward[0] - s * view.toward[1]
    turn = between(turned.angle[:, :k], np.arctan2(aside, rise * trials.stretches))
    width = np.sqrt(turned.spread[:, :k] ** 2 + np.deg2rad(1.0) ** 2)
    density = np.exp(-0.5 * ((turn - np.pi / 2) / width) ** 2) / (width * np.sqrt(2.0 * np.pi))
    odds: Floats = np.log(_AFLOAT + (1.0 - _AFLOAT) * np.pi * (density @ rests))
    return odds


def _rests(ways: Floats, outer: Floats) -> Bools:
    """(k,) could the object stand on an edge of these (k, 2) directions: is one of them at the bottom of the ring?"""
    down = np.where(ways[:, :1] > 0, 1.0, -1.0) * np.stack([-ways[:, 1], ways[:, 0]], axis=1)
    depth = outer @ down.T
    close = depth > depth.max(axis=0) - 0.02 * np.ptp(depth, axis=0)
    both = close & np.concatenate([close[-1:], close[:-1]])
    return np.asarray(both.any(axis=0))


def _steep_cost(view: StretchedFace, off: Floats, spread: Floats) -> float:
    """What it costs an oblique drawing that d hardly recedes; off: angle of each edge direction to d, radians."""
    level = float(np.arcsin(np.abs(view.toward).min()))
    steep = math.exp(-0.5 * max(level - _STEEP, 0.0) ** 2 / (math.radians(0.5) ** 2 + view.wobble**2))
    if steep <= 0.01:
        return 0.0
    # an edge drawn along d is hidden behind its own side
    near = np.sqrt((2.0 * spread) ** 2 + (2.0 * view.wobble) ** 2) + math.radians(1.5)
    hidden = bool((between(off, np.zeros(1)) < near).any())
    return _STEEP_COST * (1.0 + 3.0 * hidden) * steep


def _usual_odds(view: StretchedFace, usual: tuple[float, ...], belief: float) -> float:
    """Log odds that d rises at one of the usual angles, and not at any."""
    rise = math.atan2(abs(view.toward[1]), abs(view.toward[0]))
    off = min(abs(rise - angle) for angle in usual)
    spread = math.hypot(view.wobble, math.radians(0.5))
    density = math.exp(-0.5 * (off / spread) ** 2) / (spread * math.sqrt(2.0 * math.pi))
    return math.log(1.0 - belief + belief * 0.5 * math.pi / len(usual) * density)


def _level_odds(relations: Relations, angle: Floats, spread: Floats) -> float:
    """Faces in their true shape usually have edges drawn level, or nearly so on a page held askew."""
    off: Floats = between(angle, np.zeros(1))
    upright = bool((np.pi / 2 - off < 3.0 * spread + np.deg2rad(1.0)).any())
    off[relations.lengths < _LONG * relations.lengths.max()] = np.pi / 2
    belief = 0.6 if relations.rows.shape[1] == 3 and not upright else _LEVEL  # a triangle often stands on its tip
    exact = log_odds(off, np.hypot(spread, np.deg2rad(0.5)), belief, np.pi / 2)
    askew = log_odds(off, np.hypot(spread, np.deg2rad(4.0)), belief, np.pi / 2)
    return float(max(exact.max(), askew.max() - _ASKEW))
