"""A solid before it is measured: its true face, where that lies, and how far it reaches."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np

from sketch2shape.model import Floats, Ints


@dataclass(frozen=True)
class Shape:
    """A prism, or a frustum, with parallel faces.

    family    : how it was projected
    flat      : (m, 2) true face in its own plane, all rings, about as large as drawn, pixels
    pose      : (3, 3) rows: the plane's two axes and its normal, away from the viewer, in the viewer's axes
    origin    : (3,) where the plane's (0, 0) lies
    depth     : distance between the faces along the normal, negative if f2 is the nearer one
    taper     : size of the back face over that of the front face; the axis goes through the mean of the outer vertices
    camera    : (3, 4) from `vertices` to homogeneous pixels of the drawing
    map       : (2, 2) the linear part of drawing -> flat, row vectors
    sizes     : vertices of each ring
    free      : was the depth a mere default?
    noise     : standard deviation of a vertex of the face, pixels of the drawing
    evidence  : numbers for the report
    warnings  : what had to be assumed
    order     : (2m,) number of each vertex in the object, None if they are in its order (see `box`)
    """

    family: Literal["oblique", "axonometric", "perspective"]
    flat: Floats
    pose: Floats
    origin: Floats
    depth: float
    camera: Floats
    map: Floats
    sizes: list[int]
    taper: float = 1.0
    free: bool = False
    noise: float = 0.0
    evidence: dict[str, Any] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    order: Ints | None = None

    @cached_property
    def to_drawing(self) -> Floats:
        """(2, 2) the linear part of flat -> drawing, row vectors."""
        (a, b), (c, d) = self.map.tolist()
        inverse: Floats = np.array([[d, -b], [-c, a]]) / (a * d - b * c)
        return inverse

    @property
    def vertices(self) -> Floats:
        """(2m, 3) in the object's order: front face, then back face."""
        middle = self.flat[: self.sizes[0]].mean(axis=0)
        back = middle + self.taper * (self.flat - middle)
        plane, normal = self.pose[:2], self.pose[2]
        own = np.concatenate([self.flat @ plane, back @ plane + self.depth * normal]) + self.origin
        if self.order is None:
            return own
        vertices = np.empty_like(own)
        vertices[self.order] = own
        return vertices
