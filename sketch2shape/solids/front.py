"""The front face of a solid, laid flat."""

from __future__ import annotations

import numpy as np

from sketch2shape.geometry import signed_area
from sketch2shape.model import Floats, Solid
from sketch2shape.solids.triangles import in_order

#: a face farther than this part of its extent from the plane of the solid's own axes does not lie in it
_OFF_PLANE = 1e-6
#: a face of less area than this part of its extent squared is seen from its edge
_EDGE_ON = 1e-12


def front_rings(solid: Solid) -> list[Floats]:
    """The rings (n, 2) of the front face in its own plane, the outer one first, in `solid.unit`.

    x runs along the object's width, y along its height. Without own axes, or if those do not span the face, the plane
    is fitted. Each ring starts at its vertex of the lowest number and runs to the lower of its neighbours.
    """
    rings = [solid.vertices[list(in_order(ring))] for ring in solid.rings(solid.faces[0])]
    outer = rings[0]
    middle = outer.mean(axis=0)
    axes = np.eye(3) if solid.axes is None else solid.axes
    spread = np.linalg.norm(np.ptp(outer, axis=0))
    plane = axes[:2]
    off_plane = np.linalg.norm((outer - middle) @ axes[2]) > _OFF_PLANE * spread
    if off_plane or abs(signed_area((outer - middle) @ plane.T)) < _EDGE_ON * spread**2:
        plane = np.linalg.svd(outer - middle)[2][:2]
    return [(ring - middle) @ plane.T for ring in rings]
