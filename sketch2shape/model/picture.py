"""What is seen: a decoded picture, and the ink found in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sketch2shape.model.arrays import Bools, Brief, Floats, Gray


@dataclass(frozen=True, eq=False, repr=False)
class Picture(Brief):
    """A decoded image.

    pixels    : (h, w, 3) uint8 RGB, EXIF orientation applied, transparency composited
    source    : name for messages and reports
    full_size : (width, height) of the picture if the pixels are a reduced copy of it, else None
    """

    pixels: NDArray[np.uint8]
    source: str = "<array>"
    full_size: tuple[int, int] | None = None

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
    """

    mask: Bools
    strength: Gray
    pen_width: float
    scale: float = 1.0
    page: Floats | None = None


def to_picture(points: Floats, scale: float) -> Floats:
    """Working pixels as picture pixels; the centre of a working pixel is the centre of those it stands for."""
    return (points + 0.5) / scale - 0.5


def to_working(points: Floats, scale: float) -> Floats:
    """Picture pixels as working pixels."""
    return (points + 0.5) * scale - 0.5
