"""Reading a parallel drawing of a prism: oblique, in a named axonometric view or in any, and how the face is held.

The slant (see `parallel`) is the one that makes the face regular and the view a usual one. The direction of d is only
known to within the drawing's noise, which matters where d is short and the face seen nearly from its edge: then the
slant is sought together with a small turn of d.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from sketch2shape.lifting.depth_cue import depth_odds
from sketch2shape.lifting.evenness import Base, base_of, with_regular_base
from sketch2shape.lifting.named_views import FREE, SLANTS, SLOPPY, VIEWS, NamedView, off_axis, triad_odds, view_odds
from sketch2shape.lifting.oblique_cues import level_odds, steep_cost, usual_odds
from sketch2shape.lifting.poses import Pose, Trials
from sketch2shape.lifting.regularity import (
    Bearings,
    Candidates,
    Relations,
    bearings,
    between,
    score,
)
from sketch2shape.lifting.roundness import Arcs, arcs_of, roundness_odds
from sketch2shape.lifting.usual_views import (
    SEEN_SLANTS,
    STANDING,
    is_upright,
    plumb_density,
    plumb_turn,
    rests_on,
    standing_odds,
    usual_view,
    view_prior,
)
from sketch2shape.model import Bools, Floats

#: slants tried, radians
_SLANTS = SEEN_SLANTS
_STEP = float(_SLANTS[1] - _SLANTS[0])

#: a d known to within this angle, radians, is not turned at first, or not even when the pose is refined; else turns of
#: this many standard deviations are tried
_SURE, _QUITE_SURE = np.deg2rad(0.4), np.deg2rad(0.1)
_FEW_TURNS, _TURNS = np.linspace(-2.0, 2.0, 7), np.linspace(-2.0, 2.0, 13)
_NO_TURN = np.zeros(1)

#: poses whose proportions differ by less than this (of the logarithm) are one solid to a person
_SAME = 0.12

#: solids that the poses of one face give at most, and the least part of the likelihood that makes one
_SOLIDS, _RARE = 3, 0.03

#: a slant that is known no better than this standard deviation, radians, is taken as the mean of those that it may be
_VAGUE = 1.2 * _STEP

#: ... unless that mean itself is less likely than this part of the likeliest: it lies between two peaks then
_ONE_PEAK = 0.5

#: what is drawn within this many standard deviations of an axis of a named view is taken to run along it
_NEAR_AXIS = 3.0

#: how likely an object in an orthographic view stands on none of its edges
_AFLOAT = 0.1

#: log odds of an oblique drawing against any axonometric one before anything is seen
_OBLIQUE_PRIOR = -0.5


@dataclass(frozen=True)
class StretchedFace:
    """A drawn face ready to be stretched along d.

    relations    : what could be regular about the face as drawn
    along, across: (r,) components of the relations' vectors along and across d, pixels
    toward       : (2,) unit vector of d
    wobble       : standard deviation of the direction of d, radians
    noise        : standard deviation of a vertex of the face, pixels
    rests        : (k,) weight of each edge direction as one that the object stands on, sum 1
    arcs         : its arcs, if it has some
    base         : its one ring, if it is the base of a pyramid
    """

    relations: Relations
    along: Floats
    across: Floats
    toward: Floats
    wobble: float
    noise: float
    rests: Floats
    arcs: Arcs | None = None
    base: Base | None = None


@dataclass(frozen=True)
class ParallelReading:
    """One way to read a parallel drawing of a prism.

    name : "oblique", "isometric", "dimetric", or "axonometric" for any other such view
    odds : log odds of it
    pose : how the face is held; None if it faces the viewer
    held : how much of its likelihood is in poses with the proportions of this one
    view : what it was told from
    """

    name: Literal["oblique", "axonometric", "isometric", "dimetric"]
    odds: float
    pose: Pose | None
    held: float
    view: StretchedFace


#: a named view that the drawing may be, log odds of its directions, and the pose with d on the view's axis
_Named = tuple[NamedView, float, Pose]

_STILL = Trials(_SLANTS, _NO_TURN, np.ones(1))
_FLAT = Trials(np.zeros(0), _NO_TURN, np.ones(1))


def _alike() -> Bools:
    """(g, g) slants that give about the same proportions."""
    stretch, deep = np.log(np.cos(_SLANTS)), np.log(np.sin(_SLANTS))
    return (np.abs(np.subtract.outer(stretch, stretch)) < _SAME) & (np.abs(np.subtract.outer(deep, deep)) < _SAME)


_ALIKE = _alike()


def read_parallel(
    face: Floats,
    d: Floats,
    relations: Relations,
    noise: float,
    wobble: float,
    *,
    aslant: bool = True,
    arcs: Sequence[Floats] = (),
    pyramid: bool = False,
) -> list[ParallelReading]:
    """The ways to read the drawing with their log odds: oblique and axonometric, and each named view that it may be.

    face      : (m, 2) pixels, all rings
    d         : (2,) connecting vector, pixels
    relations : what could be regular about the face as drawn
    noise     : standard deviation of a vertex of the face, pixels
    wobble    : standard deviation of the direction of d, radians
    aslant    : may the face be foreshortened?
    arcs      : (k, 2) points along each arc of the face, pixels
    pyramid   : is the face the base of a pyramid, its vertices all there is to it?
    """
    long = math.hypot(*d.tolist())
    t = d / long
    vectors = relations.rows @ face
    k = len(relations.edges)
    angle = np.arctan2(vectors[:k, 1], vectors[:k, 0])
    spread = noise * relations.weight[:k] / np.maximum(relations.drawn[:k], 1e-12)
    rests = relations.lengths**2 * np.where(relations.edges > 1, 1.0, 0.4)
    rests *= np.where(rests_on(vectors[:k], face[: relations.outer]), 1.0, 0.25)
    rests /= rests.sum() if k else 1.0
    view = StretchedFace(relations, vectors @ t, vectors @ np.array([-t[1], t[0]]), t, wobble, noise, rests)
    view = replace(
        view,
        arcs=arcs_of(arcs, t, noise) if arcs else None,
        base=base_of(face, t, noise) if pyramid else None,
    )
    named = _named(view, angle, spread) if aslant else []
    trials = (_STILL if wobble <= _SURE else _trials(wobble, _SLANTS, _FEW_TURNS, t)) if aslant else _FLAT
    trials = replace(trials, named=tuple(pose for _, _, pose in named)) if named else trials
    found = _stretched(view.along, view.across, trials)
    turned = bearings(relations, found, noise)
    turned = _on_axes(view, turned, named) if named else turned
    regular = _regularity(view, trials, found, turned)
    oblique = float(regular[0]) + _OBLIQUE_PRIOR + level_odds(relations, angle, spread, t, wobble)
    oblique += triad_odds(math.atan2(t[1], t[0]), wobble, angle, spread) if k else 0.0
    oblique += usual_odds(t, wobble) - steep_cost(t, wobble, turned.angle[0, :k], spread)
    readings = [ParallelReading("oblique", oblique, None, 1.0, view)]
    if not aslant:
        return readings
    head = trials.head
    if not pyramid:  # the height of one has nothing to do with its sides
        regular = regular + depth_odds(relations, found, trials.every_slant, long, (noise, wobble))
    even = regular[1:head] + _isotropy_odds(relations, found)[1:head]
    for (known, odds, pose), more in zip(named, even.tolist(), strict=True):
        readings.append(ParallelReading(known.name, odds + more, pose, 1.0, view))
    return readings + _free(view, trials, regular[head:] + _pose_odds(view, trials, found, turned))


def _on_axes(view: StretchedFace, turned: Bearings, named: list[_Named]) -> Bearings:
    """The bearings with what was drawn near an axis of a named view, in the trial of that view, right along it.

    How far off it was drawn counts in `view_odds`, so the right angles of the axes must not count it once more.
    """
    relations, angle = view.relations, turned.angle.copy()
    toward = math.atan2(view.toward[1], view.toward[0])
    wide = np.hypot(view.noise * relations.weight / np.maximum(relations.drawn[: len(relations.weight)], 1e-12), SLOPPY)
    drawn = (angle[0] + toward + np.pi) % (2.0 * np.pi) - np.pi
    for row, (view_named, _, pose) in enumerate(named, 1):
        for axis in view_named.axes:
            aside = axis - toward - pose.turn
            true = math.atan2(math.sin(aside), math.cos(aside) / math.cos(pose.slant))
            angle[row, between(drawn, axis) < _NEAR_AXIS * wide] = true
    return replace(turned, angle=angle)


def _named(view: StretchedFace, angle: Floats, spread: Floats) -> list[_Named]:
    """The named views that the drawing may be, the log odds of its directions, and the pose with d on the view's axis.

    angle, spread : (k,) directions of the edges as drawn and their standard deviations, radians
    """
    if not len(angle):
        return []
    weight = view.relations.lengths**2 / (view.relations.lengths**2).sum()
    toward = math.atan2(view.toward[1], view.toward[0])
    found: list[_Named] = []
    for named in VIEWS:
        odds = view_odds(named, toward, view.wobble, angle, spread, weight)
        if odds > -math.inf:
            turn = min(max(off_axis(named, toward), -2.0 * view.wobble), 2.0 * view.wobble)
            found.append((named, odds, Pose(float(SLANTS[named.slant]), turn)))
    return found


def _free(view: StretchedFace, trials: Trials, odds: Floats) -> list[ParallelReading]:
    """Any axonometric view: the solids, a few at most, that the poses with these log odds give."""
    top = float(odds.max())
    chance = np.exp(odds - top).reshape(-1, len(_SLANTS))
    sums = chance.sum(axis=0)
    whole = float(sums.sum())
    found: list[tuple[float, Pose]] = []
    for _ in range(_SOLIDS):
        near = _ALIKE @ sums
        middle = int(near.argmax())
        if near[middle] < _RARE * whole:
            break
        window = np.flatnonzero(_ALIKE[middle])
        found.append((float(near[middle]), _likeliest(chance[:, window], _SLANTS[window], trials.turns)))
        sums = np.where(_ALIKE[middle], 0.0, sums)
        chance = np.where(_ALIKE[middle], 0.0, chance)
    told = sum(part for part, _ in found)
    # what is left over is shared out, and known to be something else
    base = top + math.log(whole / told / (len(_SLANTS) * trials.spread)) + FREE
    return [ParallelReading("axonometric", base + math.log(part), pose, told / whole, view) for part, pose in found]


def _likeliest(chance: Floats, slants: Floats, turns: Floats) -> Pose:
    """The pose of a solid: the likeliest where there is a sharp peak or two, else the mean, off by less on average.

    chance : (h, g) of each turn (h,) with each slant (g,), radians
    """
    part = chance.sum(axis=0) / chance.sum()
    mean = float(part @ slants)
    middle = float(part[int(np.abs(slants - mean).argmin())])
    if math.sqrt(float(part @ (slants - mean) ** 2)) > _VAGUE and middle > _ONE_PEAK * float(part.max()):
        return Pose(mean, float(chance.sum(axis=1) @ turns / chance.sum()), vague=True)
    turn, slant = divmod(int(chance.argmax()), len(slants))
    return Pose(float(slants[slant]), float(turns[turn]))


def refined_pose(view: StretchedFace, pose: Pose) -> Pose:
    """The pose of an axonometric reading to a hundredth of a degree, unless it is vague."""
    if pose.vague:
        return pose
    near = np.clip(pose.slant + _STEP * np.linspace(-1.0, 1.0, 17), _SLANTS[0], _SLANTS[-1])
    trials = _trials(view.wobble, near, _TURNS if view.wobble > _QUITE_SURE else _NO_TURN, view.toward)
    found = _stretched(view.along, view.across, trials)
    turned = bearings(view.relations, found, view.noise)
    regular = _regularity(view, trials, found, turned)
    odds = regular[trials.head :] + _pose_odds(view, trials, found, turned)
    odds = odds.reshape(len(trials.turns), len(near))
    turn, slant = divmod(int(odds.argmax()), len(near))
    return Pose(_peak(near, odds[turn], slant), _peak(trials.turns, odds[:, slant], turn))


def _peak(at: Floats, odds: Floats, best: int) -> float:
    """Where the parabola through the best of some values and its neighbours, if equally far, is highest."""
    if not 0 < best < len(at) - 1 or abs(at[best + 1] - 2.0 * at[best] + at[best - 1]) > 1e-9:
        return float(at[best])
    left, top, right = odds[best - 1 : best + 2]
    bend = float(left - 2.0 * top + right)
    return float(at[best] + (0.5 * (left - right) / bend * (at[best + 1] - at[best]) if bend < 0.0 else 0.0))


def _regularity(view: StretchedFace, trials: Trials, found: Candidates, turned: Bearings) -> Floats:
    """(4 + h g,) log odds of how regular the face is in each pose: its edges, its arcs, itself as a base."""
    odds = score(view.relations, found, turned, view.noise)
    if view.base is not None:
        odds = with_regular_base(odds, view.base, trials.stretches, trials.swung)
    if view.arcs is not None:
        odds = odds + roundness_odds(view.arcs, trials.stretches, trials.swung)
    return odds


def _trials(wobble: float, slants: Floats, turns: Floats, toward: Floats) -> Trials:
    """Trials with these turns, in wobbles; if d may be plumb, with the one that makes it so, as likely as that is."""
    sure = np.exp(-0.5 * turns**2)
    spread = float(sure.sum())
    plumb = plumb_turn(toward)
    if len(turns) == 1 or not is_upright(toward) or abs(plumb) > 2.0 * wobble:
        return Trials(slants, wobble * turns, sure, spread)
    standing = spread * STANDING / (1.0 - STANDING) * math.pi * plumb_density(plumb, wobble)
    return Trials(slants, np.append(wobble * turns, plumb), np.append(sure, standing), spread, has_plumb=True)


def _stretched(along: Floats, across: Floats, trials: Trials) -> Candidates:
    """The face in each pose, by the components of its relations' vectors along and across d as drawn."""
    stretches, steps = trials.stretches, trials.steps
    if len(trials.turns) == 1 and not trials.named:
        whole = across[None].repeat(len(stretches), axis=0)
        return Candidates(stretches * along, whole, stretches[:, 0], stretches[:, 0], steps)
    c, s = trials.swung
    x, y = stretches * (c * along + s * across), c * across - s * along
    return Candidates(x, y, stretches[:, 0], stretches[:, 0], steps)


def _pose_odds(view: StretchedFace, trials: Trials, found: Candidates, turned: Bearings) -> Floats:
    """(h g,) log odds of the poses, whatever shape they give the face."""
    odds = _isotropy_odds(view.relations, found)[trials.head :]
    usual = view_prior(trials.slants, view.toward) - usual_view(view.toward)
    odds = odds + np.add.outer(np.log(trials.sure), usual).ravel()
    if is_upright(view.toward):
        return odds + (math.log(1.0 - STANDING) if trials.has_plumb else standing_odds(view.toward, view.wobble))
    upright: Floats = odds + _gravity_odds(view, trials, turned)[trials.head :]
    return upright


def _isotropy_odds(relations: Relations, found: Candidates) -> Floats:
    """Edges of a true face run in all directions alike: the density of the directions as drawn, each slant given.

    Foreshortening crowds them together, across d. (Witkin, "Recovering surface shape and orientation from texture",
    1981, reads slants from textures so.) A true angle turns area * (drawn / true length)^2 times as fast as the drawn.
    """
    k = len(relations.edges)
    square = np.maximum(found.x[:, :k] ** 2 + found.y[:, :k] ** 2, 1e-24)
    odds: Floats = np.log(found.area[:, None] * relations.drawn[:k] ** 2 / square).sum(axis=1)
    return odds


def _gravity_odds(view: StretchedFace, trials: Trials, turned: Bearings) -> Floats:
    """Paper is held upright: what is drawn vertical is vertical, and the base it stands on is at right angles to it."""
    k = len(view.rests)
    if k == 0:
        return np.zeros(len(trials.stretches))
    c, s = trials.swung
    rise, aside = c * view.toward[1] + s * view.toward[0], c * view.toward[0] - s * view.toward[1]
    turn = between(turned.angle[:, :k], np.arctan2(aside, rise * trials.stretches))
    width = np.sqrt(turned.spread[:, :k] ** 2 + np.deg2rad(1.0) ** 2)
    density = np.exp(-0.5 * ((turn - np.pi / 2) / width) ** 2) / (width * np.sqrt(2.0 * np.pi))
    odds: Floats = np.log(_AFLOAT + (1.0 - _AFLOAT) * np.pi * (density @ view.rests))
    return odds
