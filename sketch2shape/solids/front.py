"""The front face of a solid, laid flat."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats, Solid
from sketch2shape.solids.triangles import in_order

#: right, up and away where a solid does not tell, as a viewer has them
_CAMERA = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])

#: a face lies level if the upright makes an angle of less than this sine with its normal
_LEVEL = 0.1


def front_rings(solid: Solid) -> list[Floats]:
    """The rings (n, 2) of the front face in its own plane, the outer one first, in `solid.unit`.

    It is seen from before, or from outside the solid where it is turned to the side or lies level: y runs down it, or
    toward the viewer on a level face, and x to the right then.
    Each ring starts at its vertex of the lowest number and runs to the lower of its neighbours.
    """
    rings = [solid.vertices[list(in_order(ring))] for ring in solid.rings(solid.faces[0])]
    outer = rings[0]
    middle = outer.mean(axis=0)
    _, high, away = _CAMERA if solid.axes is None else solid.axes
    inward = -solid.faces[0].surface.normal
    if not inward.any():  # a face without area
        inward = away
    if inward @ away < -_LEVEL:  # the far side of a mirrored reading
        inward = -inward
    down = max((v - (v @ inward) * inward for v in (-high, -away)), key=lambda v: float(np.linalg.norm(v) > _LEVEL))
    down = down / (np.linalg.norm(down) or 1.0)
    plane = np.array([np.cross(down, inward), down])
    return [(ring - middle) @ plane.T for ring in rings]
