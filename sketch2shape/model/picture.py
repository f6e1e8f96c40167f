"""What is seen: a decoded picture, and the ink found in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sketch2shape.model.arrays import Bools, Brief, Floats, Gray
from sketch2shape.model.vectors import VectorDrawing, VectorLine


@dataclass(frozen=True, eq=False, repr=False)
class Picture(Brief):
    """A decoded image, or a vector drawing with a view of it.

    pixels    : (h, w, 3) uint8 RGB, EXIF orientation applied, transparency composited
    source    : name for messages and reports
    full_size : (width, height) of the picture if the pixels are a reduced copy of it, else None
    drawing   : the lines themselves where they are known; the pixels then are for people to look at
    """

    pixels: NDArray[np.uint8]
    source: str = "<array>"
    full_size: tuple[int, int] | None = None
    drawing: VectorDrawing | None = None

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the picture, in whose pixels everything found in it is told."""
        return self.full_size or (int(self.pixels.shape[1]), int(self.pixels.shape[0]))

    @property
    def reduction(self) -> int:
        """Picture pixels along the side of each of `pixels`."""
        height, width = self.pixels.shape[:2]
        return round(max(self.size) / max(int(height), int(width)))


@dataclass(frozen=True, eq=False, repr=False)
class Ink(Brief):
    """What was drawn, at working size.

    mask      : (h, w) bool, True where there is ink
    strength  : (h, w) uint8, how dark the ink is against its surroundings, 255 where it is darkest
    pen_width : typical stroke width, working pixels
    scale     : working pixels per picture pixel (<= 1 for large pictures)
    page      : (3, 3) homography from picture pixels to the rectified page if a tilted page is seen whole, else None
    origin    : picture pixels of the point that the centre of a working pixel (-1/2, -1/2) would be
    lines     : the lines themselves, working pixels, where the drawing is known as vectors
    """

    mask: Bools
    strength: Gray
    pen_width: float
    scale: float = 1.0
    page: Floats | None = None
    origin: tuple[float, float] = (-0.5, -0.5)
    lines: tuple[VectorLine, ...] | None = None

    def to_picture(self, points: Floats) -> Floats:
        """Working pixels as picture pixels; the centre of a working pixel is the centre of those it stands for."""
        return np.asarray((points + 0.5) / self.scale + self.origin)

    def to_working(self, points: Floats) -> Floats:
        """Picture pixels as working pixels."""
        return np.asarray((points - self.origin) * self.scale - 0.5)
