"""Outlines: rings of straight edges and arcs, as they are seen.

All circles in the faces of an object are seen as ellipses of one shape. In the frame that draws the picture out along
the short axis of these they are circles again, and an arc is told by its bulge there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import cv2
import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Floats, Ints

STEPS = 24
"""Points that stand for an edge."""
ROUND_STEPS = 96
"""Points that stand for a whole ellipse."""
STRAIGHT = 1e-4
"""Bulge up to which an edge is straight."""


class Frame(NamedTuple):
    """The frame in which the circles of a face are circles.

    along : (2,) float of unit length, the direction in which they are seen shortened
    ratio : short over long axis of their ellipses
    """

    along: Floats
    ratio: float

    def flat(self, points: Floats) -> Floats:
        """Points (..., 2) of the picture in this frame."""
        return np.stack([points @ self.along / self.ratio, points @ self._across], axis=-1)

    def seen(self, points: Floats) -> Floats:
        """Points (..., 2) of this frame in the picture."""
        return np.asarray(points[..., :1] * self.ratio * self.along + points[..., 1:] * self._across)

    @property
    def _across(self) -> Floats:
        return np.array([-self.along[1], self.along[0]])


class Circle(NamedTuple):
    """A circle in a frame: centre (2,) and radius."""

    centre: Floats
    radius: float


@dataclass(frozen=True, eq=False)
class Outline:
    """A ring of straight edges and arcs in the picture.

    frame    : of its circles
    vertices : (n, 2) float, pixels; none for a whole ellipse
    bulges   : (n,) float, of the edge from each vertex to the next: tan of a quarter of the arc's angle in the frame,
               0 where it is straight
    smooth   : (n,) bool, vertices at which it runs on without a corner
    circle   : in the frame, where it is a whole ellipse
    """

    frame: Frame
    vertices: Floats
    bulges: Floats
    smooth: Bools
    circle: Circle | None = None

    @cached_property
    def line(self) -> Floats:
        """(k, 2) float, pixels, points along it, the first not repeated; `STEPS` an edge."""
        if self.circle is not None:
            angle = np.linspace(0, 2 * np.pi, ROUND_STEPS, endpoint=False)
            rim = np.stack([np.cos(angle), np.sin(angle)], axis=1)
            return self.frame.seen(self.circle.centre + self.circle.radius * rim)
        flat = self.frame.flat(self.vertices)
        return self.frame.seen(arcs_between(flat, np.roll(flat, -1, axis=0), self.bulges).reshape(-1, 2))

    @property
    def knots(self) -> Ints:
        """(n,) int, where among the points of the line its vertices lie."""
        return np.arange(len(self.vertices)) * STEPS

    @property
    def curved(self) -> Bools:
        """(n,) bool, whether each edge is an arc; (1,) for a whole ellipse."""
        return np.ones(1, np.bool_) if self.circle is not None else np.abs(self.bulges) > STRAIGHT

    @property
    def middle(self) -> Floats:
        """(2,) float, pixels, the centre of the ellipse or of its vertices."""
        if self.circle is not None:
            return self.frame.seen(self.circle.centre)
        return np.asarray(self.vertices.mean(axis=0))

    @cached_property
    def turns(self) -> Floats:
        """(n,) by how much it turns at each vertex, radians."""
        line, k, knots = self.line, len(self.line), self.knots
        before, after = line[knots] - line[(knots - 1) % k], line[(knots + 1) % k] - line[knots]
        return np.asarray(np.abs(np.arctan2(cross(before, after), (before * after).sum(axis=1))))

    @property
    def edges(self) -> Ints:
        """(k,) int, the edge that each point of the line begins or lies on."""
        return np.zeros(len(self.line), np.intp) if self.circle is not None else np.arange(len(self.line)) // STEPS

    @property
    def numbers(self) -> int:
        """How many numbers tell it, the shape of all circles seen told once: two a vertex, one an arc.

        Where it runs on smoothly, the arc beside follows: a rounded corner takes three numbers in all.
        """
        if self.circle is not None:
            return 3
        return 2 * len(self.vertices) + int(self.curved.sum()) - int(self.smooth.sum())

    def ellipses(self) -> Iterator[tuple[int, tuple[Floats, tuple[float, float], float]]]:
        """Each arc's edge, and its ellipse as seen: centre, half axes, the longer first, angle of that in degrees."""
        if self.circle is not None:
            yield 0, self._ellipse(self.circle)
            return
        flat = self.frame.flat(self.vertices)
        for i in np.flatnonzero(self.curved).tolist():
            a, b, bulge = flat[i], flat[(i + 1) % len(flat)], float(self.bulges[i])
            normal = 0.5 * np.array([a[1] - b[1], b[0] - a[0]])
            centre = 0.5 * (a + b) + normal * ((bulge * bulge - 1) / (2 * bulge))
            yield i, self._ellipse(Circle(centre, float(np.hypot(*(a - centre)))))

    def _ellipse(self, circle: Circle) -> tuple[Floats, tuple[float, float], float]:
        along = float(np.degrees(np.arctan2(self.frame.along[1], self.frame.along[0])))
        short, long = circle.radius * self.frame.ratio, circle.radius
        centre = self.frame.seen(circle.centre)
        if short > long:
            return centre, (short, long), along % 180.0
        return centre, (long, short), (along + 90.0) % 180.0

    def within(self, frame: Frame) -> Outline:
        """The same in another frame; a circle keeps its middle in the picture and its radius across."""
        circle = self.circle
        if circle is not None:
            circle = Circle(frame.flat(self.middle), circle.radius)
        return replace(self, frame=frame, circle=circle)

    def moved(self, centre: Floats, scale: float) -> Outline:
        """The same scaled about a point of the picture."""
        vertices = centre + scale * (self.vertices - centre)
        circle = self.circle
        if circle is not None:
            at = self.frame.flat(centre)
            circle = Circle(at + scale * (circle.centre - at), scale * circle.radius)
        return Outline(self.frame, vertices, self.bulges, self.smooth, circle)

    def carried(self, by: Callable[[Floats], Floats]) -> Outline:
        """The same with all points moved each by its own way (k, 2): in perspective too an ellipse becomes one."""
        if self.circle is not None:
            return ellipse_through(self.line + by(self.line))
        vertices, n = self.vertices + by(self.vertices), len(self.vertices)
        bulges = self.bulges.copy()
        curved = np.flatnonzero(self.curved)
        tops = self.line[curved * STEPS + STEPS // 2]
        a, b, top = (self.frame.flat(p) for p in (vertices[curved], vertices[(curved + 1) % n], tops + by(tops)))
        bulges[curved] = np.sign(bulges[curved]) * _bulges_over(a, b, top)
        return replace(self, vertices=vertices, bulges=bulges)

    def shifted(self, by: Floats) -> Outline:
        """The same moved in the picture."""
        circle = self.circle
        if circle is not None:
            circle = Circle(circle.centre + self.frame.flat(by), circle.radius)
        return Outline(self.frame, self.vertices + by, self.bulges, self.smooth, circle)


def in_one_frame(rings: Sequence[Outline]) -> tuple[Outline, ...]:
    """Rings of one face with all their circles in the frame of the longest curved one: they are seen alike."""
    curved = [ring for ring in rings if ring.curved.any()]
    if not curved:
        return tuple(rings)
    frame = max(curved, key=lambda ring: float(np.hypot(*np.ptp(ring.line, axis=0)))).frame
    return tuple(ring.within(frame) for ring in rings)


def ellipse_through(points: Floats) -> Outline:
    """The whole ellipse that points (k, 2), pixels, lie on (A. Fitzgibbon and others, TPAMI 1999)."""
    (x, y), (a, b), angle = cv2.fitEllipseDirect(points.astype(np.float32))
    turned = np.radians(angle + (0.0 if a < b else 90.0))
    frame = Frame(np.array([np.cos(turned), np.sin(turned)]), min(a, b) / max(a, b))
    none = np.zeros(0)
    circle = Circle(frame.flat(np.array([x, y])), 0.5 * max(a, b))
    return Outline(frame, np.zeros((0, 2)), none, none.astype(np.bool_), circle)


def _bulges_over(a: Floats, b: Floats, top: Floats) -> Floats:
    """(n,) sizes of the bulges of arcs from a to b through a point near their middle, (n, 2) each.

    An angle at the rim is half of that at the centre.
    """
    u, v = a - top, b - top
    inner = np.abs(np.arctan2(cross(u, v), (u * v).sum(axis=1)))
    return np.asarray(np.tan(0.5 * (np.pi - inner)))


def polygon(vertices: Floats) -> Outline:
    """A ring of straight edges."""
    n = len(vertices)
    return Outline(Frame(np.array([1.0, 0.0]), 1.0), vertices, np.zeros(n), np.zeros(n, np.bool_))


def arcs_between(a: Floats, b: Floats, bulges: Floats, steps: int = STEPS) -> Floats:
    """(n, steps, 2) points of arcs from a to b, (n, 2) each, the last point left out."""
    t = np.arange(steps) / steps
    straight = a[:, None] + t[:, None] * (b - a)[:, None]
    curved = np.abs(bulges) > STRAIGHT
    if not curved.any():
        return straight
    p, chord, bulge = a[curved], (b - a)[curved], bulges[curved]
    normal = 0.5 * np.stack([-chord[:, 1], chord[:, 0]], axis=1)
    middle, turn = p + 0.5 * chord, 2 * np.arctan(np.abs(bulge))
    centre = middle + normal * ((bulge * bulge - 1) / (2 * bulge))[:, None]
    radius = (1 + bulge * bulge) / (2 * np.abs(bulge))
    angle = turn[:, None] * (2 * t - 1)
    up = (np.sign(bulge) * radius)[:, None] * np.cos(angle)
    on = radius[:, None] * np.sin(angle)
    straight[curved] = centre[:, None] + up[..., None] * normal[:, None] + on[..., None] * 0.5 * chord[:, None]
    return straight
