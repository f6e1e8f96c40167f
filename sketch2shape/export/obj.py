"""Wavefront OBJ text, with triangles or with whole n-gon faces."""

from __future__ import annotations

from collections.abc import Sequence

from sketch2shape.export.mesh import settled
from sketch2shape.model import Solid
from sketch2shape.solids import face_triangles


def obj_text(solids: Sequence[Solid], *, ngons: bool = False) -> str:
    """An OBJ file with one `o` group for each solid.

    ngons : write each face as one polygon where it has no hole (OBJ has no word for holes: such caps stay triangles)
    """
    lines = ["# sketch2shape"]
    if solids:
        lines.append(f"# unit: {solids[0].unit}")
    start = 1
    for number, solid in enumerate(solids, 1):
        lines.append(f"o object_{number}")
        lines += [f"v {x:.10g} {y:.10g} {z:.10g}" for x, y, z in settled(solid.vertices).tolist()]
        lines += ["f " + " ".join(str(i + start) for i in face) for face in _polygons(solid, ngons)]
        start += len(solid.vertices)
    return "\n".join(lines) + "\n"


def _polygons(solid: Solid, ngons: bool) -> list[list[int]]:
    """Vertex indices of each face to write."""
    polygons: list[list[int]] = []
    for face, triangles in zip(solid.faces, face_triangles(solid.boundary), strict=True):
        rings = solid.rings(face)
        polygons += [list(rings[0])] if ngons and len(rings) == 1 else triangles.tolist()
    return polygons
