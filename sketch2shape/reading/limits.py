"""How much one input may cost."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sketch2shape.errors import LimitError, UsageError
from sketch2shape.model import checked_number

#: Pillow refuses more by itself (twice its warning level), so that a higher limit could not be kept.
_MOST_PIXELS = 178_956_970


@dataclass(frozen=True)
class Limits:
    """What a picture may hold at most; anything larger is refused from its header, before it is decoded.

    max_pixels : width x height; the default admits the 50-megapixel photos of telephones
    max_side   : longest side, pixels; the warps of OpenCV address pixels with 16-bit numbers
    max_bytes  : size of the file
    """

    max_pixels: int = 64_000_000
    max_side: int = 32_767
    max_bytes: int = 256 * 2**20

    def __post_init__(self) -> None:
        """Refuse limits that cannot be kept."""
        for name in ("max_pixels", "max_side", "max_bytes"):
            checked_number(name, getattr(self, name), -math.inf)
        if not 0 < self.max_pixels <= _MOST_PIXELS:
            raise UsageError(f"a limit of {self.max_pixels} pixels", remedy=f"1 to {_MOST_PIXELS} pixels")
        if self.max_side < 1 or self.max_bytes < 1:
            raise UsageError("limits must be positive", remedy="leave them at their defaults")

    def check_size(self, width: int, height: int) -> None:
        """Raise LimitError if a picture of this size is too large."""
        if width * height > self.max_pixels:
            megapixels = width * height / 1e6
            raise LimitError(
                f"{width} x {height} is {megapixels:.0f} megapixels, the limit is {self.max_pixels / 1e6:g}",
                remedy="a smaller picture, or --max-pixels",
            )
        if max(width, height) > self.max_side:
            raise LimitError(f"{width} x {height} has a side over {self.max_side} pixels", remedy="a smaller picture")

    def check_bytes(self, size: int) -> None:
        """Raise LimitError if a file of this size is too large."""
        if size > self.max_bytes:
            raise LimitError(
                f"the file is larger than {self.max_bytes / 2**20:g} MB", remedy="a smaller file, or --max-bytes"
            )
