"""From solids to triangle meshes: the solids' own vertices, then the points added on arcs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from sketch2shape.model import Floats, Solid
from sketch2shape.solids import tessellated

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


def to_trimesh(solids: Solid | Sequence[Solid], tolerance: float | None = None) -> Trimesh:
    """One mesh with a body for each solid, its own vertices first and in order, none merged or dropped.

    tolerance : largest distance of a facet from a curved side, in the solids' unit; None for one that looks smooth

    Metadata: `unit` (of the first solid).
    """
    import trimesh

    bodies = [solids] if isinstance(solids, Solid) else list(solids)
    forms = [tessellated(s.boundary, tolerance) for s in bodies]
    starts = np.cumsum([0, *(len(form.vertices) for form in forms)])
    vertices = np.concatenate([settled(form.vertices) for form in forms]) if forms else np.zeros((0, 3))
    faces = [form.triangles + start for form, start in zip(forms, starts, strict=False)]
    triangles = np.concatenate(faces) if faces else np.zeros((0, 3), np.intp)
    unit = bodies[0].unit if bodies else "px"
    return trimesh.Trimesh(vertices=vertices, faces=triangles, process=False, metadata={"unit": unit})
