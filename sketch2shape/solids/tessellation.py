"""A solid's surface as flat triangles: exact where it is flat, within a chord tolerance where it is curved.

The solid's own vertices come first, in their order; the points added on arcs lie on the true circles. Faces that meet
in an arc share its points, so the surface stays closed. A straight solid has no more points than its vertices.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from sketch2shape.model import Boundary, DirectedEdge, Face, Floats, Ints, Line, Loop, Plane, Ring
from sketch2shape.solids.triangles import flat_triangles

#: largest distance of a chord from its arc, as a part of the solid's diagonal, where none is asked for: about a
#: hundred chords for a cylinder, whose facets no screen shows
FINE = 2e-4

#: chords of a whole circle: at least enough to pass for round, at most what keeps files small; a multiple of 4, so that
#: a circle reaches as far as its chords do
_LEAST, _MOST, _QUARTERS = 16, 1024, 4


@dataclass(frozen=True)
class Tessellation:
    """A solid's surface in facets.

    boundary : what it is of
    vertices : (v, 3) float, the solid's own first
    paths    : for each edge the vertices along it, from its start to its end; round a whole circle, the first twice
    faces    : for each face its facets: triangles (t, 3), or the strip of quadrilaterals (t, 4) of a curved side;
               outward by the right-hand rule
    """

    boundary: Boundary
    vertices: Floats
    paths: tuple[Ints, ...]
    faces: tuple[Ints, ...]

    @cached_property
    def face_triangles(self) -> tuple[Ints, ...]:
        """(t, 3) triangles of each face, outward."""
        return tuple(halved(facets) for facets in self.faces)

    @property
    def triangles(self) -> Ints:
        """(t, 3) triangles of a closed surface, outward, one face after the other."""
        return np.concatenate(self.face_triangles)

    def ring(self, loop: Loop) -> Ring:
        """The vertices along a loop, those on arcs too."""
        return _ring(self.paths, loop)


def tessellated(boundary: Boundary, tolerance: float | None = None) -> Tessellation:
    """The surface of a solid in facets.

    tolerance : largest distance of a facet from the true surface, in the solid's unit; None for one that looks smooth
    """
    vertices, paths = _sampled(boundary, tolerance)
    faces = tuple(_facets(boundary, face, vertices, paths) for face in boundary.faces)
    return Tessellation(boundary, vertices, paths, faces)


def halved(facets: Ints) -> Ints:
    """(t, 3) triangles of facets: themselves, or quadrilaterals cut in two."""
    if facets.shape[1] == 3:
        return facets
    return np.asarray(facets[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3))


def _sampled(boundary: Boundary, tolerance: float | None) -> tuple[Floats, tuple[Ints, ...]]:
    """All vertices, and those along each edge."""
    if not boundary.is_round:
        return boundary.vertices, tuple(np.array(ends) for ends in boundary.edge_ends)
    chords = _chords(boundary, tolerance)
    points, count = [boundary.vertices], len(boundary.vertices)
    paths: list[Ints] = []
    for number, edge in enumerate(boundary.edges):
        arc = boundary.arc(edge)
        whole = edge.start is None or edge.end is None
        if arc is not None:
            n = chords[number]
            points.append(arc.at(np.arange(0 if whole else 1, n) / n))
        inner = np.arange(count, count if arc is None else count + len(points[-1]))
        count += len(inner)
        walk = (*inner, *inner[:1]) if whole else (edge.start, *inner, edge.end)
        paths.append(np.array(walk, np.intp))
    return np.concatenate(points), tuple(paths)


def _chords(boundary: Boundary, tolerance: float | None) -> dict[int, int]:
    """How many chords stand for each curved edge; as many for both rims of a curved side, by the larger one."""
    size = float(np.linalg.norm(np.ptp(boundary.extremes(np.eye(3)), axis=0)))
    tolerance = FINE * size if tolerance is None else tolerance
    chords: dict[int, int] = {}
    for face in boundary.faces:
        if isinstance(face.surface, Plane):
            continue
        rims = [number for number, _ in _rims(boundary, face)]
        arcs = [arc for arc, _ in boundary.arcs(face)]
        radius = max(arc.circle.radius for arc in arcs)
        n = max(round_chords(radius, arc.sweep, tolerance) for arc in arcs)
        chords.update(dict.fromkeys(rims, n))
    return chords


def round_chords(radius: float, sweep: float, tolerance: float) -> int:
    """How many chords of an arc stay within a tolerance of it."""
    step = 2.0 * math.acos(max(1.0 - tolerance / radius, 0.0)) if radius > 0 else math.pi
    whole = min(max(math.ceil(2.0 * math.pi / max(step, 1e-6)), _LEAST), _MOST)
    whole += -whole % _QUARTERS
    return max(math.ceil(whole * sweep / (2.0 * math.pi) - 1e-9), 2)


def _rims(boundary: Boundary, face: Face) -> list[DirectedEdge]:
    """The curved edges of a face as its loops walk them."""
    return [step for loop in face.loops for step in loop if not isinstance(boundary.edges[step.edge].curve, Line)]


def _ring(paths: tuple[Ints, ...], loop: Loop) -> Ring:
    return tuple(int(i) for e, forward in loop for i in (paths[e][:-1] if forward else paths[e][:0:-1]))


def _facets(boundary: Boundary, face: Face, vertices: Floats, paths: tuple[Ints, ...]) -> Ints:
    match face.surface:
        case Plane(_, normal):
            return flat_triangles(vertices, [_ring(paths, loop) for loop in face.loops], normal)
    (edge, forward), *others = _rims(boundary, face)
    near = paths[edge] if forward else paths[edge][::-1]
    if not others:
        apex = np.full(len(near) - 1, len(boundary.vertices) - 1, np.intp)
        return np.stack([near[:-1], near[1:], apex], axis=1)
    far = paths[others[0].edge] if forward else paths[others[0].edge][::-1]
    return np.array([[a, b, d, c] for (a, b), (c, d) in zip(pairwise(near), pairwise(far), strict=True)], np.intp)
