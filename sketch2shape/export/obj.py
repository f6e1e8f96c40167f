"""Wavefront OBJ text, with triangles or with whole n-gon faces."""

from __future__ import annotations

from collections.abc import Sequence

from sketch2shape.export.mesh import settled
from sketch2shape.model import Plane, Solid
from sketch2shape.solids import Tessellation, tessellated


def obj_text(solids: Sequence[Solid], *, ngons: bool = False, tolerance: float | None = None) -> str:
    """An OBJ file with one `o` group for each solid.

    ngons     : write each flat face as one polygon where it has no hole (OBJ has no word for holes: such caps stay
                triangles), and a curved side in strips of quadrilaterals
    tolerance : largest distance of a facet from a curved side, in the solids' unit; None for one that looks smooth
    """
    lines = ["# sketch2shape"]
    if solids:
        lines.append(f"# unit: {solids[0].unit}")
    start = 1
    for number, solid in enumerate(solids, 1):
        lines.append(f"o object_{number}")
        form = tessellated(solid.boundary, tolerance)
        lines += [f"v {x:.10g} {y:.10g} {z:.10g}" for x, y, z in settled(form.vertices).tolist()]
        lines += ["f " + " ".join(str(i + start) for i in face) for face in _polygons(form, ngons)]
        start += len(form.vertices)
    return "\n".join(lines) + "\n"


def _polygons(form: Tessellation, ngons: bool) -> list[list[int]]:
    """Vertex indices of each face to write."""
    if not ngons:
        return [triangle for triangles in form.face_triangles for triangle in triangles.tolist()]
    polygons: list[list[int]] = []
    for face, facets in zip(form.boundary.faces, form.faces, strict=True):
        whole = isinstance(face.surface, Plane) and len(face.loops) == 1
        polygons += [list(form.ring(face.loops[0]))] if whole else facets.tolist()
    return polygons
