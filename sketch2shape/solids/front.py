"""The front face of a solid, laid flat."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Floats, Loop, Plane, Solid

#: right, up and away where a solid does not tell, as a viewer has them
_CAMERA = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])

#: a face lies level if the upright makes an angle of less than this sine with its normal
_LEVEL = 0.1

#: chords of a whole circle where an outline stands in for it
_CHORDS = 96


@dataclass(frozen=True, eq=False)
class FlatArc:
    """A circular arc in a plane.

    center : (2,)
    radius : of its circle
    begin  : angle at which it begins, radians from the first axis to the second
    sweep  : angle it turns through, negative from the second axis to the first
    """

    center: Floats
    radius: float
    begin: float
    sweep: float

    def at(self, t: Floats) -> Floats:
        """(k, 2) points at parts (k,) of it, 0..1."""
        angle = self.begin + self.sweep * np.asarray(t, float)
        return np.asarray(self.center + self.radius * np.c_[np.cos(angle), np.sin(angle)])

    def farthest(self) -> Floats:
        """(k, 2) its points that reach farthest along one of the axes."""
        t = np.asarray((np.pi / 2 * np.arange(-4, 9) - self.begin) / self.sweep, np.float64)
        return self.at(t[(t >= 0.0) & (t <= 1.0)])


@dataclass(frozen=True)
class FlatRing:
    """A ring of lines and circular arcs in a plane.

    points : (n, 2) its vertices
    bulges : (n,) of the edge that starts at each vertex: tan of a quarter of the angle it turns through, from the first
             axis to the second; 0 = straight
    circle : centre (2,) and radius, where the ring is a whole circle: then it has no vertices
    """

    points: Floats
    bulges: Floats
    circle: tuple[Floats, float] | None = None

    def moved(self, by: Floats) -> FlatRing:
        """The ring shifted by a vector (2,)."""
        circle = None if self.circle is None else (self.circle[0] + by, self.circle[1])
        return FlatRing(self.points + by, self.bulges, circle)

    def radius(self, start: int) -> float:
        """Of the arc that begins at a vertex."""
        return self.arc(start).radius

    def arc(self, start: int) -> FlatArc:
        """The arc that begins at a vertex."""
        p, q = self.points[start], self.points[(start + 1) % len(self.points)]
        half, chord = 2.0 * float(np.arctan(self.bulges[start])), q - p
        center = 0.5 * (p + q) + np.array([-chord[1], chord[0]]) / (2.0 * np.tan(half))
        x, y = p - center
        return FlatArc(center, float(np.hypot(x, y)), float(np.arctan2(y, x)), 2.0 * half)

    def outline(self) -> Floats:
        """(k, 2) the ring as points, arcs by short chords."""
        if self.circle is not None:
            turn = np.arange(_CHORDS) * (2.0 * np.pi / _CHORDS)
            return np.asarray(self.circle[0] + self.circle[1] * np.c_[np.cos(turn), np.sin(turn)])
        pieces: list[Floats] = []
        for start, bulge in enumerate(self.bulges.tolist()):
            pieces.append(self.points[start][None])
            if bulge:
                arc = self.arc(start)
                n = max(int(np.ceil(_CHORDS * abs(arc.sweep) / (2.0 * np.pi))), 2)
                pieces.append(arc.at(np.arange(1, n) / n))
        return np.concatenate(pieces)


def front_outline(solid: Solid) -> list[FlatRing]:
    """The rings of the front face in its own plane, the outer one first, in `solid.unit`.

    It is seen from before, or from outside the solid where it is turned to the side or lies level: y runs down it, or
    toward the viewer on a level face, and x to the right then.
    Each ring starts at its vertex of the lowest number and runs to the lower of its neighbours.
    """
    face = solid.faces[0]
    _, high, away = _CAMERA if solid.axes is None else solid.axes
    inward = -face.surface.normal if isinstance(face.surface, Plane) else away
    if not inward.any():  # a face without area
        inward = away
    if inward @ away < -_LEVEL:  # the far side of a mirrored reading
        inward = -inward
    down = max((v - (v @ inward) * inward for v in (-high, -away)), key=lambda v: float(np.linalg.norm(v) > _LEVEL))
    down = down / (np.linalg.norm(down) or 1.0)
    plane = np.array([np.cross(down, inward), down])
    rings = [laid_ring(solid, loop, plane) for loop in face.loops]
    outer = rings[0]
    middle = outer.points.mean(axis=0) if outer.circle is None else outer.circle[0]
    return [ring.moved(-middle) for ring in rings]


def laid_ring(solid: Solid, loop: Loop, plane: Floats) -> FlatRing:
    """A loop as a ring in the plane with these two unit axes, rows (2, 3)."""
    edges = [(solid.edges[number], forward) for number, forward in loop]
    first = edges[0][0]
    whole = solid.boundary.arc(first)
    if whole is not None and (first.start is None or first.end is None):
        return FlatRing(np.zeros((0, 2)), np.zeros(0), (plane @ whole.circle.center, whole.circle.radius))
    starts: list[int] = []
    bulges: list[float] = []
    for edge, forward in edges:
        arc = solid.boundary.arc(edge)
        begin = edge.start if forward else edge.end
        starts.append(-1 if begin is None else begin)
        turn = 0.0
        if arc is not None:
            turn = float(np.sign(arc.circle.normal @ np.cross(plane[0], plane[1]))) * (1.0 if forward else -1.0)
        bulges.append(0.0 if arc is None else turn * float(np.tan(arc.sweep / 4.0)))
    at = starts.index(min(starts))
    starts, bulges = starts[at:] + starts[:at], bulges[at:] + bulges[:at]
    if starts[-1] < starts[1] or (len(starts) == 2 and abs(bulges[1]) > abs(bulges[0])):
        starts, bulges = starts[:1] + starts[:0:-1], [-b for b in bulges[::-1]]
    return FlatRing(solid.vertices[starts] @ plane.T, np.array(bulges))
