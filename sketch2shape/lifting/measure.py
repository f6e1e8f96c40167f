"""The sizes and the unit a user asks for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.lifting.frame import own_axes
from sketch2shape.lifting.options import LiftOptions
from sketch2shape.lifting.shape import Shape

#: sizes given that differ more than this from the drawing are worth a word
_DIFFERENT = 0.02


def measured(shape: Shape, options: LiftOptions) -> Shape:
    """The shape in the unit asked for, with the sizes asked for.

    Width, else height, else depth sets the scale. A depth given besides another size, or in pixels, sets the depth
    alone: exact where the drawing leaves it free, against the drawing otherwise, which a warning then says.
    """
    width, height, depth = options.sizes()
    unit, warnings = options.solid_unit, list(shape.warnings)
    own_width, own_height = (1.0, 1.0) if width is None and height is None else _extents(shape)
    sized: float | None = None
    if width is not None:
        sized = width / own_width
    elif height is not None:
        sized = height / own_height
    elif depth is not None and unit != "px":
        sized = depth / abs(shape.depth)
    if sized is None:
        sized = 1.0
        if unit != "px":
            warnings.append(f"no size was given: one pixel is taken as one {unit}")
    elif width is not None and height is not None and abs(height / sized / own_height - 1.0) > _DIFFERENT:
        warnings.append(f"width and height do not fit the drawing together: height is {sized * own_height:.4g} {unit}")
    if depth is not None:
        stretch = depth / (sized * abs(shape.depth))
        if not shape.free and abs(stretch - 1.0) > _DIFFERENT:
            warnings.append(f"the drawing's own depth is {sized * abs(shape.depth):.4g} {unit}")
        shape = replace(shape, depth=shape.depth * stretch)
    elif shape.free:
        warnings.append(f"the drawing leaves the depth free: {sized * abs(shape.depth):.4g} {unit} is assumed")
    return replace(
        shape, flat=shape.flat * sized, origin=shape.origin * sized, depth=shape.depth * sized, warnings=tuple(warnings)
    )


def _extents(shape: Shape) -> tuple[float, float]:
    """Width and height of the whole object along its own axes."""
    vertices = shape.vertices
    axes = own_axes(vertices[: len(shape.flat)], shape.pose[2] * np.sign(shape.depth or 1.0), shape.sizes)
    width, height = (float(e) for e in np.ptp(vertices @ axes[:2].T, axis=0))
    return max(width, 1e-12), max(height, 1e-12)
