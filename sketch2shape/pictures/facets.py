"""A solid's surface as triangles and drawn edges in one index space, for the pictures and the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Floats, Ints, Solid


@dataclass(frozen=True)
class Surface:
    """What a renderer needs of one or several solids.

    vertices  : (v, 3) float, right-handed, x right, y down, z away from the viewer
    triangles : (t, 3) indices, outward by the right-hand rule
    edges     : (e, 2) indices of the edges to draw
    """

    vertices: Floats
    triangles: Ints
    edges: Ints


def surface(solids: Sequence[Solid]) -> Surface:
    """The surfaces of the solids, side by side, turned so that the first one faces the viewer squarely."""
    from sketch2shape.export.mesh import mesh_faces

    if not solids:
        none = np.zeros((0, 3), np.intp)
        return Surface(np.zeros((0, 3)), none, none[:, :2])
    starts = np.cumsum([0] + [len(s.vertices) for s in solids[:-1]])
    return Surface(
        np.concatenate([s.vertices for s in solids]) @ _own_axes(solids[0]).T,
        np.concatenate([mesh_faces(s) + k for s, k in zip(solids, starts, strict=True)]),
        np.concatenate([s.edges + k for s, k in zip(solids, starts, strict=True)]),
    )


def _own_axes(solid: Solid) -> Floats:
    """(3, 3) rotation from the solid's coordinates to its width, height and depth."""
    if solid.axes is None:
        return np.eye(3)
    mirrored = np.linalg.det(solid.axes) < 0
    return np.asarray(solid.axes * [[1.0], [1.0], [-1.0 if mirrored else 1.0]])
