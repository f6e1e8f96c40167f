"""Where a curved surface turns away from the viewer: its outline, which depends on the view, and its smooth joints."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from sketch2shape.model import Boundary, Cone, Cylinder, Face, Floats, Ints, Plane
from sketch2shape.solids.tessellation import Tessellation

#: faces that meet in an edge at a smaller angle than this, degrees, are one smooth surface there: drawings have no line
_SMOOTH = 5.0


def smooth_edges(boundary: Boundary) -> frozenset[int]:
    """Numbers of the edges at which two faces meet smoothly, as a line and an arc do that are tangent."""
    if not boundary.is_round:
        return frozenset()
    beside: dict[int, list[Face]] = {}
    for face in boundary.faces:
        for loop in face.loops:
            for number, _ in loop:
                beside.setdefault(number, []).append(face)
    found: set[int] = set()
    for number, faces in beside.items():
        edge = boundary.edges[number]
        if edge.start is None or edge.end is None or len(faces) != 2 or boundary.arc(edge) is not None:
            continue
        middle = 0.5 * (boundary.vertices[edge.start] + boundary.vertices[edge.end])
        first, second = (_normal(face, middle) for face in faces)
        if float(first @ second) > math.cos(math.radians(_SMOOTH)):
            found.add(number)
    return frozenset(found)


def _normal(face: Face, point: Floats) -> Floats:
    """(3,) unit normal of a face at a point of it, out of the solid."""
    match face.surface:
        case Plane(_, normal):
            return normal
        case Cylinder(circle, convex):
            radial = point - circle.center
            radial = radial - (radial @ circle.normal) * circle.normal
            return _unit(radial if convex else -radial)
        case Cone(apex, circle, convex):
            line = point - apex
            rim = apex + line * float((circle.center - apex) @ circle.normal) / float(line @ circle.normal)
            radial = rim - circle.center
            normal = np.cross(line, np.cross(circle.normal, radial))
            return _unit(normal if (normal @ radial > 0) == convex else -normal)


def _unit(vector: Floats) -> Floats:
    return np.asarray(vector / (np.linalg.norm(vector) or 1.0))


def contour_candidates(form: Tessellation, smooth: frozenset[int]) -> Ints:
    """(c, 4) edges within smooth surfaces: their two vertices, and the rows of `form.triangles` on either side.

    Such an edge is a part of the outline in a view in which one of the triangles faces the viewer and the other not.
    """
    if not form.boundary.is_round:
        return np.zeros((0, 4), np.intp)
    sides: dict[tuple[int, int], list[int]] = {}
    row = 0
    for face, facets, triangles in zip(form.boundary.faces, form.faces, form.face_triangles, strict=True):
        each = len(triangles) // max(len(facets), 1)
        flat = isinstance(face.surface, Plane)
        for number, facet in enumerate(facets.tolist()):
            for k, a in enumerate(facet):
                b = facet[(k + 1) % len(facet)]
                # whichever of a facet's triangles: they lie in one plane
                if not flat or (a < len(form.boundary.vertices) and b < len(form.boundary.vertices)):
                    sides.setdefault((min(a, b), max(a, b)), []).append(row + each * number)
        row += len(triangles)
    kept = {tuple(sorted(form.paths[e].tolist())) for e in smooth}
    rims = {(min(a, b), max(a, b)) for path in form.paths for a, b in pairwise(path.tolist())} - kept
    found = [(*edge, *pair) for edge, pair in sides.items() if len(pair) == 2 and edge not in rims]
    curved = _curved_rows(form)
    found = [c for c in found if curved[c[2]] or curved[c[3]]]
    return np.array(found, np.intp).reshape(-1, 4)


def _curved_rows(form: Tessellation) -> list[bool]:
    return [
        not isinstance(face.surface, Plane)
        for face, triangles in zip(form.boundary.faces, form.face_triangles, strict=True)
        for _ in range(len(triangles))
    ]
