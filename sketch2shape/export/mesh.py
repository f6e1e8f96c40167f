"""From solids to triangle meshes with exactly the solids' vertices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from sketch2shape.export.triangulate import signed_area, triangulate
from sketch2shape.model import Floats, Ints, Solid

if TYPE_CHECKING:
    from trimesh import Trimesh


def mesh_faces(solid: Solid) -> Ints:
    """(k, 3) triangles of a closed surface over `solid.vertices`, normals outward.

    Both caps have the same triangles, so a prism's mesh is as regular as the prism; a side face is two triangles.
    """
    front, _, *sides = [solid.rings(face) for face in solid.faces]
    half = sum(solid.ring_sizes)
    start = np.cumsum([0, *solid.ring_sizes])
    flat = cap_plane(solid)
    cap = triangulate(flat, list(solid.ring_sizes))
    if list(front[0]) != list(range(start[1])):
        cap = cap[:, ::-1]
    quads = np.array([ring for (ring,) in sides], np.intp)
    return np.concatenate([cap, cap[:, ::-1] + half, quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def cap_plane(solid: Solid) -> Floats:
    """(m, 2) the front face in its own plane: x along the object's width, y along its height, in `solid.unit`.

    Without own axes, or if those do not span the face, the plane is fitted.
    """
    cap = solid.vertices[: sum(solid.ring_sizes)]
    outer = cap[: solid.ring_sizes[0]]
    axes = np.eye(3) if solid.axes is None else solid.axes
    flat: Floats = (cap - outer.mean(axis=0)) @ axes[:2].T
    spread = np.linalg.norm(np.ptp(outer, axis=0))
    off_plane = np.linalg.norm((outer - outer.mean(axis=0)) @ axes[2])
    if off_plane > 1e-6 * spread or abs(signed_area(flat[: len(outer)])) < 1e-12 * spread**2:
        right, down, _ = np.linalg.svd(outer - outer.mean(axis=0))[2]
        flat = (cap - outer.mean(axis=0)) @ np.c_[right, down]
    return flat


def to_trimesh(solids: Solid | Sequence[Solid]) -> Trimesh:
    """One mesh with a body for each solid, vertices in the solids' order, none merged or dropped.

    Metadata: `unit` (of the first solid).
    """
    import trimesh

    bodies = [solids] if isinstance(solids, Solid) else list(solids)
    starts = np.cumsum([0, *(len(s.vertices) for s in bodies)])
    vertices = np.concatenate([s.vertices for s in bodies]) if bodies else np.zeros((0, 3))
    faces = [mesh_faces(s) + start for s, start in zip(bodies, starts, strict=False)]
    triangles = np.concatenate(faces) if faces else np.zeros((0, 3), np.intp)
    unit = bodies[0].unit if bodies else "px"
    return trimesh.Trimesh(vertices=vertices, faces=triangles, process=False, metadata={"unit": unit})
