"""Sweeps: two-face objects whose rings hold arcs, or whose back face is a point, as a drawing shows them.

The front face is an outline of lines and arcs; the back face is the same moved, or drawn together towards a centre, to
a point at last. Where a sweep hides its own lines follows from rays: a point of the side at a part r of its way to the
back is hidden if the way up to there runs through the inside of the front face (the slices of the object that lie
nearer are the front face moved along that way).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.sweeps.insides import Inside
from sketch2shape.sweeps.outlines import Frame, Outline, in_one_frame

REGULAR = 6
"""Numbers that tell a regular polygon seen askew."""
NEAREST = -0.9
"""Part that a point comes nearer to its image, over the rest of the way, at least: none comes from behind the eye."""
RAY = 48
"""Places at which a ray is looked at."""
FARTHEST = 8.0
"""How far a ray away from the centre is followed, distances to the centre."""


@dataclass(frozen=True, eq=False)
class Way:
    """How the front face becomes the back face.

    shift  : (2,) float, pixels, where all points move alike
    centre : (2,) float, pixels, towards which they are drawn together, or None
    scale  : of the back face over the front; 0 for a point
    slope  : (2,) float, part per pixel by which the way grows over the face, as in perspective; None in parallel views
             and where the picture is parallel to the face
    origin : (2,) float, pixels, where shift and scale are as they say

    In perspective it is a plane homology: a point goes towards the centre, or along the shift, by a ratio that is
    linear in its place (R. Hartley and A. Zisserman, "Multiple View Geometry", 2003, appendix 7.2).
    """

    shift: Floats
    centre: Floats | None = None
    scale: float = 1.0
    slope: Floats | None = None
    origin: Floats | None = None

    def of(self, points: Floats) -> Floats:
        """(k, 2) float, pixels, from each point to its image on the back face."""
        if self.slope is None or self.origin is None:
            if self.centre is not None:
                return (1.0 - self.scale) * (self.centre - points)
            return np.broadcast_to(self.shift, points.shape)
        grown = (1.0 + (points - self.origin) @ self.slope)[..., None]
        if self.centre is None:
            return np.asarray(grown * self.shift)
        nearer = np.maximum(grown * (1.0 - self.scale) / self.scale, NEAREST)
        return np.asarray(nearer / (1.0 + nearer) * (self.centre - points))

    def moved(self, by: Floats) -> Way:
        """The same elsewhere in the picture."""
        centre, origin = (None if at is None else at + by for at in (self.centre, self.origin))
        return replace(self, centre=centre, origin=origin)

    def back(self) -> Way:
        """From the back face to the front, for ways without a centre."""
        slope = None if self.slope is None else self.slope / (1.0 + float(self.slope @ self.shift))
        return replace(self.moved(self.shift), shift=-self.shift, slope=slope)

    @property
    def is_pointed(self) -> bool:
        """Whether the back face is a point."""
        return self.centre is not None and self.scale == 0.0

    @property
    def numbers(self) -> int:
        """How many numbers tell it."""
        told = 3 if self.centre is not None and not self.is_pointed else 2
        return told if self.slope is None else told + 2


@dataclass(frozen=True, eq=False)
class Sweep:
    """A two-face object with arcs or a point.

    rings : of the front face, the outer one first
    way   : to the back face
    is_near : whether the front face is the nearer one; a cone seen from above stands with its base behind
    regular : nats for the number of sides of a base that is taken for a regular polygon, since only some of its
              vertices are seen; None for others
    tangents : whether lines are drawn where an arc runs on smoothly, as wireframes of CAD programs show them
    """

    rings: tuple[Outline, ...]
    way: Way
    is_near: bool = True
    regular: float | None = None
    tangents: bool = False

    @property
    def frame(self) -> Frame:
        """In which its circles are circles."""
        return self.rings[0].frame

    @property
    def has_arcs(self) -> bool:
        """Whether some edge is curved."""
        return any(ring.curved.any() for ring in self.rings)

    @property
    def shape_numbers(self) -> int:
        """How many numbers tell its front face, the shape of its circles told once."""
        return REGULAR if self.regular is not None else sum(ring.numbers for ring in self.rings) + self.has_arcs

    @property
    def edges(self) -> Floats:
        """(k, 2, 2) float, pixels: the ends of the edges of the front face and of those to the back face."""
        rings = [ring.vertices for ring in self.rings]
        start, end = np.concatenate(rings), np.concatenate([np.roll(v, -1, axis=0) for v in rings])
        ends = np.stack([np.concatenate([start, start]), np.concatenate([end, start + self.way.of(start)])], axis=1)
        return np.asarray(ends)

    def shifted(self, by: Floats) -> Sweep:
        """The same moved in the picture."""
        return replace(self, rings=tuple(ring.shifted(by) for ring in self.rings), way=self.way.moved(by))

    def reversed(self) -> Sweep:
        """The same with the two faces exchanged. Only for ways without a centre."""
        return replace(self, rings=in_one_frame([self.image(ring) for ring in self.rings]), way=self.way.back())

    def image(self, ring: Outline) -> Outline:
        """One of its rings on the back face, which is no point."""
        way = self.way
        if way.slope is not None:
            return ring.carried(way.of)
        return ring.shifted(way.shift) if way.centre is None else ring.moved(way.centre, way.scale)


@dataclass(frozen=True, eq=False)
class Redrawn:
    """The lines of a sweep, sampled.

    points : (k, 2) float, pixels
    along  : (k, 2) float of unit length, the direction of the line there
    length : (k,) float, pixels that each point stands for
    edge   : (k,) int, the edge or silhouette that each belongs to
    depth  : (k,) int, 0 seen, 1 on the border of sight, 2 hidden
    silhouettes : (s, 2, 2) float, pixels
    """

    points: Floats
    along: Floats
    length: Floats
    edge: Ints
    depth: Ints
    silhouettes: Floats


def seen_vertices(sweep: Sweep, margin: float) -> Bools:
    """(m,) bool, which vertices of the back face, rings in turn, are not hidden by the front."""
    v = np.concatenate([ring.vertices for ring in sweep.rings])
    entry = _entries(sweep, v, sweep.way.of(v), margin)
    return _depth(sweep, entry, np.ones(len(v))) < 2


def redraw(sweep: Sweep, spacing: float, margin: float) -> Redrawn:
    """The lines of a sweep, and what of them it hides itself.

    spacing : pixels between the samples of straight sides
    margin  : pixels within which a line may lie on the border of sight
    """
    line = np.concatenate([ring.line for ring in sweep.rings])
    to = sweep.way.of(line)
    entry = _entries(sweep, line, to, margin)
    starts = np.cumsum([0, *(len(ring.line) for ring in sweep.rings)])
    sharp = np.concatenate(
        [r.knots[~r.smooth | sweep.tangents] + s for r, s in zip(sweep.rings, starts[:-1], strict=True)]
    )
    silhouettes = np.concatenate(
        [turning_points(r, to[s:e]) + s for r, s, e in zip(sweep.rings, starts[:-1], starts[1:], strict=True)]
    )
    pieces = [_rim(sweep, entry, 0.0)]
    if not sweep.way.is_pointed:
        pieces.append(_rim(sweep, entry, 1.0))
    pieces += [_side(sweep, line[i], to[i], entry[:, i], spacing) for i in sharp.tolist()]
    pieces += [_doubtful(_side(sweep, line[i], to[i], entry[:, i], spacing)) for i in silhouettes.tolist()]
    names = np.cumsum([0, *(int(p[3].max()) + 1 for p in pieces[:-1])])
    edge = np.concatenate([p[3] + n for p, n in zip(pieces, names, strict=True)])
    points, along, length = (np.concatenate([p[k] for p in pieces]) for k in range(3))
    depth = np.concatenate([p[4] for p in pieces])
    outlines = np.stack([line[silhouettes], line[silhouettes] + to[silhouettes]], axis=1)
    return Redrawn(points, along, length, edge, depth, outlines)


_Piece = tuple[Floats, Floats, Floats, Ints, Ints]
"""Points, directions, lengths, edges and depths of some lines."""


def _rim(sweep: Sweep, entry: Floats, r: float) -> _Piece:
    """The rings at a part r of the way to the back."""
    parts, name = [], 0
    for ring in sweep.rings:
        at = ring.line + r * sweep.way.of(ring.line)
        step = np.roll(at, -1, axis=0) - at
        long = np.hypot(step[:, 0], step[:, 1]) + 1e-9
        parts.append((at + 0.5 * step, step / long[:, None], long, ring.edges + name))
        name += len(ring.curved)
    points, along, length, edge = (np.concatenate(p) for p in zip(*parts, strict=True))
    return points, along, length, edge, _depth(sweep, entry, np.full(len(points), r))


def _side(sweep: Sweep, start: Floats, to: Floats, entry: Floats, spacing: float) -> _Piece:
    """The straight line from a point of the front to its image."""
    long = float(np.hypot(*to)) + 1e-9
    n = max(int(long / spacing), 2)
    r = (np.arange(n) + 0.5) / n
    depth = _depth(sweep, np.repeat(entry[:, None], n, axis=1), r)
    return start + r[:, None] * to, np.tile(to / long, (n, 1)), np.full(n, long / n), np.zeros(n, np.intp), depth


def _doubtful(piece: _Piece) -> _Piece:
    """A silhouette: where some of it is hidden, none is sure to be seen, since its ray leaves the ring so slowly."""
    points, along, length, edge, depth = piece
    return points, along, length, edge, np.maximum(depth, 1) if (depth == 2).any() else depth


def turning_points(ring: Outline, to: Floats) -> Ints:
    """Where the line of a ring turns from one side of its way to the other without a corner: silhouettes start there.

    to : (k, 2) float, pixels, from each point of the line to its image
    """
    span = np.roll(ring.line, -1, axis=0) - np.roll(ring.line, 1, axis=0)
    side = cross(span, to)
    turns = np.flatnonzero((side > 0) != (np.roll(side, 1) > 0))
    edge, n = ring.edges, len(ring.line)
    bends = ring.curved[edge] | ring.curved[edge[np.arange(n) - 1]]
    for k in ring.knots[~ring.smooth]:
        bends[(k + np.arange(-1, 2)) % n] = False
    return turns[bends[turns]]


def _entries(sweep: Sweep, line: Floats, to: Floats, margin: float) -> Floats:
    """(2, k) where the ray of each point comes inside the front face: surely, and perhaps.

    For a near front the ray runs towards the back and the entry is a part of the way; for a far one it runs away from
    the centre and the entry is the distance to the centre over that of the point.
    """
    if sweep.is_near:
        t = (np.arange(RAY) + 1.0) / RAY
        ray, place = line[:, None] + t[:, None] * to[:, None], t
    else:
        centre = np.zeros(2) if sweep.way.centre is None else sweep.way.centre
        place = 1.0 + (FARTHEST - 1.0) * ((np.arange(RAY) + 1.0) / RAY) ** 2
        ray = centre + place[:, None] * (line - centre)[:, None]
    within = Inside.of([ring.line for ring in sweep.rings]).at(ray)
    return np.stack([_first(within > margin, place), _first(within > 1.0, place)])


def _first(inside: Bools, place: Floats) -> Floats:
    return np.where(inside.any(axis=1), place[inside.argmax(axis=1)], np.inf)


def _depth(sweep: Sweep, entry: Floats, r: Floats) -> Ints:
    """0 seen, 1 perhaps, 2 hidden: points at parts r of the way, with the entries (2, k) of their rays."""
    if sweep.is_near:
        surely, perhaps = entry <= r
    else:
        k = sweep.way.scale
        surely, perhaps = (1.0 - r * (1.0 - k)) >= k * entry if k > 0 else np.isfinite(entry)
    return np.where(surely, 2, np.where(perhaps, 1, 0))
