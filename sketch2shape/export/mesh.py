"""From solids to triangle meshes with exactly the solids' vertices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from sketch2shape.model import Solid
from sketch2shape.solids import triangulated

if TYPE_CHECKING:
    from trimesh import Trimesh


def to_trimesh(solids: Solid | Sequence[Solid]) -> Trimesh:
    """One mesh with a body for each solid, vertices in the solids' order, none merged or dropped.

    Metadata: `unit` (of the first solid).
    """
    import trimesh

    bodies = [solids] if isinstance(solids, Solid) else list(solids)
    starts = np.cumsum([0, *(len(s.vertices) for s in bodies)])
    vertices = np.concatenate([s.vertices for s in bodies]) if bodies else np.zeros((0, 3))
    faces = [triangulated(s) + start for s, start in zip(bodies, starts, strict=False)]
    triangles = np.concatenate(faces) if faces else np.zeros((0, 3), np.intp)
    unit = bodies[0].unit if bodies else "px"
    return trimesh.Trimesh(vertices=vertices, faces=triangles, process=False, metadata={"unit": unit})
