"""From solids to triangle meshes with exactly the solids' vertices."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from sketch2shape.model import Floats, Solid
from sketch2shape.solids import triangulated

if TYPE_CHECKING:
    from trimesh import Trimesh


_GRAIN = 1e-10
"""Coordinates are written in steps of about this part of the solid's extent: what is left of rounding errors is 0."""


def settled(points: Floats) -> Floats:
    """The points on a decimal grid far finer than they are known, so that 1.1e-13 is 0 and equal coordinates are equal.

    The step is a power of ten: numbers such as 40 and 12.5 stay what they are.
    """
    extent = float(np.abs(points).max(initial=0.0))
    if not extent > 0.0:
        return points
    decimals = -int(np.floor(np.log10(extent * _GRAIN)))
    rounded: Floats = np.round(points, decimals) + 0.0  # no -0
    return rounded


def to_trimesh(solids: Solid | Sequence[Solid]) -> Trimesh:
    """One mesh with a body for each solid, vertices in the solids' order, none merged or dropped.

    Metadata: `unit` (of the first solid).
    """
    import trimesh

    bodies = [solids] if isinstance(solids, Solid) else list(solids)
    starts = np.cumsum([0, *(len(s.vertices) for s in bodies)])
    vertices = np.concatenate([settled(s.vertices) for s in bodies]) if bodies else np.zeros((0, 3))
    faces = [triangulated(s) + start for s, start in zip(bodies, starts, strict=False)]
    triangles = np.concatenate(faces) if faces else np.zeros((0, 3), np.intp)
    unit = bodies[0].unit if bodies else "px"
    return trimesh.Trimesh(vertices=vertices, faces=triangles, process=False, metadata={"unit": unit})
