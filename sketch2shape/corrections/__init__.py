"""What a person put right by hand: the corrections file, and how it is applied."""

from __future__ import annotations

from sketch2shape.corrections.corrections import (
    Corrections,
    corrected,
    corrections_from,
    lift_options,
    parse_corrections,
    points_from,
)
from sketch2shape.corrections.file import check_pictures, read_corrections

__all__ = [
    "Corrections",
    "check_pictures",
    "corrected",
    "corrections_from",
    "lift_options",
    "parse_corrections",
    "points_from",
    "read_corrections",
]
