"""Making exact what a drawing with arcs makes nearly so: smooth joints, right angles, half turns, common centres.

Each relation that nearly holds becomes an equation. The face is the one that obeys them all and moves least in the
drawing (Gauss and Newton's steps in the null space of the linearised equations). If a point would have to move further
than the drawing's noise, or the equations contradict each other, fewer kinds of them are asked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from sketch2shape.lifting.profile import Edge, Profile, neighbours, profile_of
from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats

#: a point may move this many standard deviations of the drawing's noise, and a relation may be off by as many
_REACH = _NEAR = 3.5

#: least standard deviation of a point, pixels: what fitting an ellipse to ink leaves
_LEAST = 0.5

#: the most that angles may be off to be taken as meant, radians: smooth joints, directions of edges, turns of arcs
_SMOOTH, _STRAIGHT, _TURNED = math.radians(14.0), math.radians(6.0), math.radians(9.0)

#: the most that two radii, or two centres, may differ to be taken as one, part of the radius
_ALIKE = 0.08

#: steps taken at most, the step in pixels after which no other is, the part of the face's size by which equations may
#: be missed in the end, and singular values over the largest that count as none
_STEPS, _SETTLED, _EXACT, _SINGULAR = 12, 1e-5, 1e-7, 1e-7

#: unknowns of a face at most: of more the arcs are fitted one by one, and nothing is made exact but they
_MOST = 80

Equation = Callable[[Floats], float]
"""How far a relation is from holding, about in units of the face."""

Named = tuple[str, list[Equation]]
"""A set of equations and its name."""


def exact_arcs(shape: Shape, *, regular: bool) -> Shape:
    """The shape with true arcs; regular: with smooth joints and simple angles made exact, where the drawing allows."""
    if shape.bent is None:
        return shape
    profile = profile_of(shape, shape.bent)
    free = profile.start()
    many = len(free) > _MOST
    if not many:
        free = _solved(profile, free, [])
    if many or not regular:
        return profile.shape(free, shape)
    noise = max(shape.noise, _LEAST)
    allowed = _REACH * noise + float(np.abs(profile.moved(free)).max())
    level = bool(np.array_equal(shape.pose, np.eye(3)))
    ways, x = _first_that_holds(profile, free, _Relations(profile, free, noise, level).ways(), allowed)
    later = [(f"{ways[0]}, {name}", [*ways[1], *e]) for name, e in _Relations(profile, x, noise, level).sizes()]
    (told, kept), x = _first_that_holds(profile, free, [*later, ways], allowed)
    shape = profile.shape(x, shape)
    moved = float(np.hypot(*profile.moved(x).reshape(-1, 2).T).max())
    told_of = {"beautified": {"by": told, "moved_px": round(moved, 3)}} if kept else {}
    return replace(shape, evidence={**shape.evidence, **told_of})


def _first_that_holds(profile: Profile, free: Floats, sets: list[Named], allowed: float) -> tuple[Named, Floats]:
    """The first set of equations that the face can obey, and its unknowns then; no equations if there is none."""
    for name, equations in sets:
        x = _solved(profile, free, equations)
        if _holds(profile, free, x, equations, allowed):
            return (name, equations), x
    return ("nothing", []), free


def _holds(profile: Profile, free: Floats, x: Floats, equations: list[Equation], allowed: float) -> bool:
    """Do the unknowns obey the equations, with no point moved further than allowed and no edge turned about?"""
    missed = max((abs(e(x)) for e in equations), default=0.0)
    moved = float(np.hypot(*profile.moved(x).reshape(-1, 2).T).max())
    size = float(np.ptp(profile.points, axis=0).max())
    return missed <= _EXACT * size and moved <= allowed and _sound(profile, free, x)


def _sound(profile: Profile, before: Floats, after: Floats) -> bool:
    """Has no edge turned about or shrunk to little, and no arc turned inside out?"""
    for edge in profile.edges:
        old, new = (profile.vertices(x)[edge.last] - profile.vertices(x)[edge.first] for x in (before, after))
        if float(old @ new) < 0.5 * float(old @ old):
            return False
    turns = profile.turns(after)
    same = np.sign(turns) == np.sign(profile.turns(before))
    return bool(same.all() and (np.abs(turns) < 2.0 * math.pi).all() and (profile.circles(after)[:, 2] > 0).all())


def _solved(profile: Profile, start: Floats, equations: list[Equation]) -> Floats:
    """The unknowns that obey the equations and are nearest to the drawing."""
    scale = np.ones(len(start))
    first = 2 * profile.bent.vertices
    # a turn in pixels along its arc, about
    scale[first : first + len(profile.open)] = 1.0 / max(float(np.ptp(profile.points, axis=0).max()), 1e-9)
    x = start
    for _ in range(_STEPS):
        off, slope = _linear(profile.moved, x, scale)
        step = np.zeros(len(x))
        space = np.eye(len(x))
        if equations:
            missed, across = _linear(lambda y: np.array([e(y) for e in equations]), x, scale)
            u, s, vt = np.linalg.svd(across, full_matrices=True)
            rank = int((s > _SINGULAR * s[0]).sum())
            step = -vt[:rank].T @ ((u[:, :rank].T @ missed) / s[:rank])
            space = vt[rank:].T
        if space.size:
            rest = np.linalg.lstsq(slope @ space, -(off + slope @ step), rcond=1e-9)[0]
            step = step + space @ rest
        x = x + scale * step
        if float(np.abs(step).max()) < _SETTLED:
            break
    return x


def _linear(function: Callable[[Floats], Floats], x: Floats, scale: Floats) -> tuple[Floats, Floats]:
    """A function's values at x and its derivatives by x / scale, by central differences."""
    columns = []
    for k, size in enumerate(scale):
        step = np.zeros(len(x))
        step[k] = 1e-4 * size
        columns.append((function(x + step) - function(x - step)) / 2e-4)
    return function(x), np.stack(columns, axis=1)


@dataclass(frozen=True)
class _Round:
    """An arc (the edge) or a whole circle (its number, without an edge)."""

    profile: Profile
    edge: Edge | None
    number: int

    def center(self, x: Floats) -> Floats:
        """(2,) of unknowns x."""
        return self.profile.circles(x)[self.number, :2] if self.edge is None else self.profile.center(x, self.edge)

    def radius(self, x: Floats) -> float:
        """Of unknowns x."""
        if self.edge is None:
            return float(self.profile.circles(x)[self.number, 2])
        return self.profile.radius(x, self.edge)


@dataclass(frozen=True)
class _Relations:
    """Finds what nearly holds in a face.

    profile : the face
    x       : its unknowns, nearest to the drawing
    noise   : standard deviation of a point, pixels of the drawing
    level   : does the face look as it is, so that edges drawn level are level?
    """

    profile: Profile
    x: Floats
    noise: float
    level: bool

    @cached_property
    def size(self) -> float:
        """Of the face, in its unit."""
        return float(np.ptp(self.profile.points, axis=0).max())

    @property
    def spread(self) -> float:
        """Standard deviation of a point of the true face where it is most stretched."""
        return self.noise / max(float(np.linalg.svd(self.profile.to_drawing, compute_uv=False)[-1]), 1e-9)

    def ways(self) -> list[Named]:
        """Equations of how edges run, by name: sets to try, the most exact first."""
        joints, ways, turns = self._smooth(), self._directions(), self._turns()
        return [
            ("joints, directions and turns", [*joints, *ways, *turns]),
            ("joints and directions", [*joints, *ways]),
            ("joints", joints),
            ("directions and turns", [*ways, *turns]),
        ]

    def sizes(self) -> list[Named]:
        """Equations of how large and where arcs are, as told once the ways hold."""
        centers, radii = self._centers(), self._radii()
        return [
            ("centres and radii", [*centers, *radii]),
            ("centres", centers),
            ("radii", radii),
        ]

    def _chord(self, edge: Edge) -> float:
        v = self.profile.vertices(self.x)
        return float(np.hypot(*(v[edge.last] - v[edge.first])))

    def _slack(self, edge: Edge, most: float) -> float:
        """How far the direction of an edge may be off, radians: an arc's at its end is four times as vague."""
        times = 1.0 if edge.arc is None else 4.0
        vague = times * math.sqrt(2.0) * self.spread / max(self._chord(edge), 1e-9)
        return min(_NEAR * vague + math.radians(1.0), most)

    def _smooth(self) -> list[Equation]:
        """Lines and arcs, or two arcs, that join without a corner."""
        found: list[Equation] = []
        for before, after in neighbours(self.profile.rings):
            if before.arc is None and after.arc is None:
                continue
            slack = max(self._slack(before, _SMOOTH), self._slack(after, _SMOOTH))
            equation = self._joint(before, after)
            if abs(equation(self.x)) <= slack * self.size:
                found.append(equation)
        return found

    def _joint(self, before: Edge, after: Edge) -> Equation:
        def turned(x: Floats) -> float:
            gap = self.profile.heading(x, after, at_end=False) - self.profile.heading(x, before, at_end=True)
            return self.size * _wrapped(gap, 2.0 * math.pi)

        return turned

    def _directions(self) -> list[Equation]:
        """Straight edges at right angles, or at 45 degrees, to the longest one."""
        straight = [edge for edge in self.profile.edges if edge.arc is None]
        if not straight:
            return []
        angle = {edge: self.profile.heading(self.x, edge, at_end=False) for edge in straight}
        main = max(straight, key=self._chord)
        right = 0.5 * math.pi
        off = {edge: _wrapped(angle[edge] - angle[main], right) for edge in straight}
        square = [edge for edge in straight if abs(off[edge]) <= self._slack(edge, _STRAIGHT)]
        weight = np.array([self._chord(edge) ** 2 for edge in square])
        lean = angle[main] + float(weight @ [off[edge] for edge in square]) / float(weight.sum())
        if self.level and abs(_wrapped(lean, right)) <= self._slack(main, math.radians(2.0)):
            lean -= _wrapped(lean, right)
        found: list[Equation] = []
        for edge in straight:
            step = right if edge in square else 0.5 * right
            gap = _wrapped(angle[edge] - lean, step)
            if abs(gap) <= self._slack(edge, _STRAIGHT):
                found.append(self._pointing(edge, angle[edge] - gap))
        return found

    def _pointing(self, edge: Edge, angle: float) -> Equation:
        return lambda x: self.size * _wrapped(self.profile.heading(x, edge, at_end=False) - angle, 2.0 * math.pi)

    def _turns(self) -> list[Equation]:
        """Arcs of a quarter, a half or three quarters of a turn."""
        found: list[Equation] = []
        for edge in self.profile.edges:
            if edge.arc is None:
                continue
            turn = float(self.profile.turns(self.x)[edge.arc])
            meant = 0.5 * math.pi * round(turn / (0.5 * math.pi))
            if meant and abs(turn - meant) <= self._slack(edge, _TURNED):
                found.append(self._turning(edge.arc, meant))
        return found

    def _turning(self, arc: int, angle: float) -> Equation:
        return lambda x: self.size * (float(self.profile.turns(x)[arc]) - angle)

    def _rounds(self) -> list[_Round]:
        """Each arc and circle."""
        edges = [edge for edge in self.profile.edges if edge.arc is not None]
        return [_Round(self.profile, edge, 0) for edge in edges] + [
            _Round(self.profile, None, k) for k in range(len(self.profile.whole))
        ]

    def _centers(self) -> list[Equation]:
        """Arcs and circles about one point: each other's centre, a corner, or the middle of four corners."""
        found: list[Equation] = []
        rounds = self._rounds()
        for k, own in enumerate(rounds):
            slack = min(_NEAR * 2.0 * self.spread, _ALIKE * own.radius(self.x) + self.spread)
            for point in (*(other.center for other in rounds[:k]), *self._points()):
                if float(np.hypot(*(own.center(self.x) - point(self.x)))) <= slack:
                    found += [_same(own.center, point, axis) for axis in (0, 1)]
                    break
        return found

    def _points(self) -> list[Callable[[Floats], Floats]]:
        """Points that a circle may be meant to be about, as functions of the unknowns."""
        p = self.profile
        corners = [_corner(p, slice(k, k + 1)) for k in range(p.bent.vertices)]
        if p.sizes[0] == 4 and not any(edge.arc is not None for edge in p.rings[0]):
            corners.append(_corner(p, slice(0, 4)))
        return corners

    def _radii(self) -> list[Equation]:
        """Arcs and circles of one size."""
        found: list[Equation] = []
        rounds = sorted((own.radius for own in self._rounds()), key=lambda radius: radius(self.x))
        for small, large in pairwise(rounds):
            gap = large(self.x) - small(self.x)
            if gap <= min(_NEAR * 2.0 * self.spread, _ALIKE * large(self.x)):
                found.append(_equal(small, large))
        return found


def _corner(profile: Profile, rows: slice) -> Callable[[Floats], Floats]:
    """The middle of some vertices."""
    return lambda x: np.asarray(profile.vertices(x)[rows].mean(axis=0))


def _same(center: Callable[[Floats], Floats], point: Callable[[Floats], Floats], axis: int) -> Equation:
    return lambda x: float(center(x)[axis] - point(x)[axis])


def _equal(one: Callable[[Floats], float], other: Callable[[Floats], float]) -> Equation:
    return lambda x: other(x) - one(x)


def _wrapped(angle: float, period: float) -> float:
    """The angle less the nearest multiple of a period."""
    return angle - period * round(angle / period)
