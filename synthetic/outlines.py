"""Outlines of lines and circular arcs in a face's own plane, and the named families of them that people design."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from shapely.geometry import Point, Polygon

from sketch2shape.model import Floats
from synthetic.profiles import profile, regular

QUARTER = float(np.tan(np.pi / 8))
"""Bulge of a quarter circle; of a half circle it is 1."""
CHORDS = 56
"""Chords that stand for a whole circle when the sight of it is worked out."""
TANGENT = 0.5
"""Largest turn, degrees, at which two edges join smoothly."""


@dataclass(frozen=True)
class Arc:
    """A part of a circle.

    centre : (2,)
    radius : > 0
    start  : angle of its first point, radians
    sweep  : angle to its last point, signed
    """

    centre: Floats
    radius: float
    start: float
    sweep: float

    def at(self, t: Floats) -> Floats:
        """(k, 2) points at parameters 0..1."""
        angle = self.start + self.sweep * t
        points: Floats = self.centre + self.radius * np.c_[np.cos(angle), np.sin(angle)]
        return points


@dataclass(frozen=True)
class Outline:
    """A closed ring of lines and arcs.

    points : (n, 2) vertices; none if the ring is one circle
    bulges : (n,) of the edge that starts at each vertex: tan of a quarter of the arc's angle, 0 = straight,
             positive = outwards where the ring has positive area
    circle : the whole ring, if it is one
    """

    points: Floats
    bulges: Floats
    circle: Arc | None = None

    def arcs(self) -> dict[int, Arc]:
        """The curved edges by the vertex they start at; a whole circle is edge -1."""
        if self.circle:
            return {-1: self.circle}
        after = np.roll(self.points, -1, 0)
        return {i: _arc(p, q, b) for i, (p, q, b) in enumerate(zip(self.points, after, self.bulges, strict=True)) if b}

    def smooth(self) -> list[bool]:
        """Whether the edges join smoothly at each vertex."""
        leaving, arriving, arcs = [], [], self.arcs()
        for i, p in enumerate(self.points):
            q = self.points[(i + 1) % len(self.points)]
            chord, turn = q - p, arcs[i].sweep / 2 if i in arcs else 0.0
            leaving.append(np.arctan2(chord[1], chord[0]) - turn)
            arriving.append(np.arctan2(chord[1], chord[0]) + turn)
        turns = np.degrees((np.array(leaving) - np.roll(arriving, 1) + np.pi) % (2 * np.pi) - np.pi) if leaving else []
        return [bool(abs(t) < TANGENT) for t in turns]

    def chords(self) -> tuple[Floats, list[int]]:
        """(k, 2) the ring as a polygon of short chords, and the vertex of each of its points (-1: inside an arc)."""
        if self.circle:
            t = np.arange(CHORDS) / CHORDS
            return self.circle.at(t), [-1] * CHORDS
        out, names, arcs = [], [], self.arcs()
        for i, p in enumerate(self.points):
            out.append(p[None])
            names.append(i)
            if i in arcs:
                k = max(int(np.ceil(CHORDS * abs(arcs[i].sweep) / (2 * np.pi))), 2)
                out.append(arcs[i].at(np.arange(1, k) / k))
                names += [-1] * (k - 1)
        return np.vstack(out), names

    def scaled(self, factor: float) -> Outline:
        """The outline `factor` times as large about the origin."""
        circle = self.circle
        if circle:
            circle = Arc(circle.centre * factor, circle.radius * factor, circle.start, circle.sweep)
        return Outline(self.points * factor, self.bulges, circle)

    def reversed(self) -> Outline:
        """The same ring the other way round."""
        circle = self.circle
        if circle:
            circle = Arc(circle.centre, circle.radius, circle.start, -circle.sweep)
        return Outline(self.points[::-1].copy(), -np.roll(self.bulges[::-1], -1), circle)


def _arc(p: Floats, q: Floats, bulge: float) -> Arc:
    sweep = 4 * float(np.arctan(bulge))
    chord = q - p
    left = np.array([-chord[1], chord[0]])
    centre = (p + q) / 2 + left / (2 * np.tan(sweep / 2))
    start = p - centre
    return Arc(centre, float(np.linalg.norm(start)), float(np.arctan2(start[1], start[0])), sweep)


def circle(centre: Floats, radius: float, turns: float = 1.0) -> Outline:
    """A whole circle; `turns` -1 for a hole."""
    return Outline(np.zeros((0, 2)), np.zeros(0), Arc(centre, radius, 0.0, 2 * np.pi * turns))


def _ring(points: list[tuple[float, float]], bulges: dict[int, float]) -> Outline:
    return Outline(np.array(points, float), np.array([bulges.get(i, 0.0) for i in range(len(points))]))


def _straight(name: str, rng: np.random.Generator) -> Outline:
    points = profile(name, rng)
    return Outline(points, np.zeros(len(points)))


def _slot(rng: np.random.Generator) -> Outline:
    w, h = 1.0, float(rng.uniform(0.3, 0.6))
    return _ring([(h / 2, 0), (w - h / 2, 0), (w - h / 2, h), (h / 2, h)], {1: 1.0, 3: 1.0})


def _rounded(rng: np.random.Generator) -> Outline:
    w, h = 1.0, float(rng.uniform(0.5, 1.0))
    r = float(rng.uniform(0.12, 0.4)) * h
    points = [(r, 0), (w - r, 0), (w, r), (w, h - r), (w - r, h), (r, h), (0, h - r), (0, r)]
    return _ring(points, {1: QUARTER, 3: QUARTER, 5: QUARTER, 7: QUARTER})


def _one_round(rng: np.random.Generator) -> Outline:
    w, h = 1.0, float(rng.uniform(0.6, 1.0))
    r = float(rng.uniform(0.25, 0.6)) * h
    return _ring([(0, 0), (w - r, 0), (w, r), (w, h), (0, h)], {1: QUARTER})


def _half(_rng: np.random.Generator) -> Outline:
    return _ring([(1, 0.5), (0, 0.5)], {1: 1.0})


def _quarter(_rng: np.random.Generator) -> Outline:
    return _ring([(0, 1), (0, 0), (1, 1)], {1: QUARTER})


def _sector(rng: np.random.Generator) -> Outline:
    angle = float(np.radians(rng.uniform(50, 160)))
    return _ring([(0, 0), (1, 0), (float(np.cos(angle)), float(np.sin(angle)))], {1: float(np.tan(angle / 4))})


def _segment(rng: np.random.Generator) -> Outline:
    return _ring([(1, 0), (0, 0)], {1: float(np.tan(np.radians(rng.uniform(110, 290)) / 4))})


def _round_end(rng: np.random.Generator) -> Outline:
    w, h = float(rng.uniform(0.5, 0.9)), float(rng.uniform(0.4, 0.7))
    return _ring([(0, 0), (w, 0), (w, h), (0, h)], {1: 1.0})


def _arch(rng: np.random.Generator) -> Outline:
    h, r = float(rng.uniform(0.55, 0.9)), float(rng.uniform(0.2, 0.32))
    top = {0: 1.0} if rng.random() < 0.35 else {}
    return _ring([(0, 0), (1, 0), (1, h), (0.5 + r, h), (0.5 - r, h), (0, h)], {3: -1.0} | top)


def _fillet(rng: np.random.Generator) -> Outline:
    t, r = float(rng.uniform(0.25, 0.4)), float(rng.uniform(0.12, 0.3))
    return _ring([(0, 0), (t, 0), (t, 1 - t - r), (t + r, 1 - t), (1, 1 - t), (1, 1), (0, 1)], {2: -QUARTER})


def _u_channel(rng: np.random.Generator) -> Outline:
    t, h = float(rng.uniform(0.15, 0.25)), float(rng.uniform(0.3, 0.6))
    points = [(0, 0), (t, 0), (t, h), (1 - t, h), (1 - t, 0), (1, 0), (1, h), (0, h)]
    return _ring(points, {2: -1.0, 6: 1.0})


ROUND: dict[str, Callable[[np.random.Generator], Outline]] = {
    "circle": lambda _rng: circle(np.zeros(2), 0.5),
    "slot": _slot,
    "rounded rectangle": _rounded,
    "rounded corner": _one_round,
    "half disc": _half,
    "quarter disc": _quarter,
    "sector": _sector,
    "segment": _segment,
    "round end": _round_end,
    "arch": _arch,
    "fillet": _fillet,
    "channel": _u_channel,
}


def outline(name: str, rng: np.random.Generator) -> Outline:
    """The family `name`, or a straight profile of that name: about the origin, size 1, positive area, any way up."""
    made = ROUND[name](rng) if name in ROUND else _straight(name, rng)
    if made.circle:
        return made
    if name in ROUND:
        spin = np.pi / 2 * int(rng.integers(4))
        matrix = np.array([[np.cos(spin), -np.sin(spin)], [np.sin(spin), np.cos(spin)]])
        made = Outline(made.points @ matrix.T, made.bulges)
    polygon, _ = made.chords()
    low, high = polygon.min(0), polygon.max(0)
    centred = Outline(made.points - (low + high) / 2, made.bulges).scaled(1 / float((high - low).max()))
    polygon, _ = centred.chords()
    area = polygon[:, 0] @ np.roll(polygon[:, 1], -1) - polygon[:, 1] @ np.roll(polygon[:, 0], -1)
    return centred.reversed() if area < 0 else centred


def round_holes(around: Outline, most: int, rng: np.random.Generator) -> list[Outline]:
    """Up to `most` circles inside an outline, clear of it and of each other; in a circle mostly one in its middle."""
    if around.circle and rng.random() < 0.8:
        return [circle(np.zeros(2), around.circle.radius * float(rng.uniform(0.35, 0.75)), -1)]
    room = Polygon(around.chords()[0])
    found: list[Outline] = []
    for _ in range(60):
        if len(found) == most:
            break
        radius = float(rng.uniform(0.07, 0.2))
        at = rng.uniform(-0.5, 0.5, 2)
        middle, clear = Point(*at), radius + 0.07
        # the middle alone tells of most, without the cost of a disc
        if room.contains(middle) and room.boundary.distance(middle) > 0.9 * clear:
            disc = middle.buffer(clear)
            if room.contains(disc):
                found.append(circle(at, radius, -1))
                room = room.difference(disc)
    return found


def pyramid_base(sides: int | None, rng: np.random.Generator) -> Outline:
    """A regular polygon of so many sides, or else of 3 to 12, mostly few, or a rectangle."""
    if not sides and rng.random() < 0.3:
        return _straight("box", rng)
    n = sides or int(rng.choice([3, 4, 5, 6, 8, 12], p=[0.2, 0.3, 0.15, 0.2, 0.1, 0.05]))
    return Outline(0.5 * regular(n, float(rng.uniform(0, 2 * np.pi))), np.zeros(n))


PLATES = ("circle", "box", "rounded rectangle", "hexagon", "L", "slot", "half disc", "octagon", "round end")
MIXED = tuple(name for name in ROUND if name != "circle")
