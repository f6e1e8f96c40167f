"""The curves that edges lie on: straight lines and circles in space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from sketch2shape.model.arrays import Brief, Floats


@dataclass(frozen=True)
class Line:
    """The straight curve; an edge's two vertices say where it runs."""


@dataclass(frozen=True, eq=False, repr=False)
class Circle(Brief):
    """A circle; an edge on it runs from its start to its end, or all round, turning about the normal (right-hand rule).

    center : (3,) float, in the solid's unit
    normal : (3,) float of unit length, across its plane
    radius : in the solid's unit
    """

    center: Floats
    normal: Floats
    radius: float

    def scaled(self, factor: float) -> Circle:
        """The same circle in a smaller unit of length, `factor` of which make the present one."""
        return Circle(self.center * factor, self.normal, self.radius * factor)


Curve: TypeAlias = Line | Circle


@dataclass(frozen=True, eq=False)
class Arc:
    """A piece of a circle, or all of it, with the frame its angles are measured in.

    circle : what it is a piece of
    first  : (3,) unit vector from the centre to where it begins
    sweep  : angle it turns through about the circle's normal, radians, up to 2 pi
    """

    circle: Circle
    first: Floats
    sweep: float

    def at(self, t: Floats) -> Floats:
        """(k, 3) points at parts (k,) of the arc, 0..1, evenly by angle."""
        angle = self.sweep * np.asarray(t, float)[:, None]
        second = np.cross(self.circle.normal, self.first)
        points: Floats = self.circle.center + self.circle.radius * (np.cos(angle) * self.first + np.sin(angle) * second)
        return points

    def farthest(self, direction: Floats) -> Floats:
        """(k, 3) the points, at most two, where the arc reaches farthest along a direction and against it."""
        second = np.cross(self.circle.normal, self.first)
        across, up = float(direction @ self.first), float(direction @ second)
        if np.hypot(across, up) < 1e-12 * float(np.linalg.norm(direction)):
            return np.zeros((0, 3))
        angles = (np.arctan2(up, across) + np.array([0.0, np.pi])) % (2 * np.pi)
        return self.at(angles[angles <= self.sweep] / self.sweep)

    @property
    def segment(self) -> Floats:
        """(3,) area between the arc and its chord, along the normal that it turns about."""
        area: Floats = 0.5 * self.circle.radius**2 * (self.sweep - np.sin(self.sweep)) * self.circle.normal
        return area


def arc_between(circle: Circle, start: Floats | None, end: Floats | None) -> Arc:
    """The arc of a circle from one point (3,) on it to another; None, None for all of it.

    Where all of it begins depends on its normal alone, so that circles one behind the other begin alike.
    """
    if start is None or end is None:
        side = np.eye(3)[int(np.abs(circle.normal).round(6).argmin())]
        first = side - (side @ circle.normal) * circle.normal
        return Arc(circle, first / np.linalg.norm(first), 2 * np.pi)
    first = start - circle.center
    first = first - (first @ circle.normal) * circle.normal
    first = first / (np.linalg.norm(first) or 1.0)
    last = end - circle.center
    turn = float(np.arctan2(last @ np.cross(circle.normal, first), last @ first)) % (2 * np.pi)
    return Arc(circle, first, turn)
