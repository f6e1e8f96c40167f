"""Plane geometry that several stages share: points, lines, rings, plane maps, homologies."""

from __future__ import annotations

from sketch2shape.geometry.lines import fit_lines, moments, project, thinned
from sketch2shape.geometry.plane import (
    are_simple,
    cross,
    distances,
    inside,
    line_crossings,
    segment_distance,
    segments_meet,
    signed_area,
    size_of,
)
from sketch2shape.geometry.plane_maps import map_fits, plane_map

__all__ = [
    "are_simple",
    "cross",
    "distances",
    "fit_lines",
    "inside",
    "line_crossings",
    "map_fits",
    "moments",
    "plane_map",
    "project",
    "segment_distance",
    "segments_meet",
    "signed_area",
    "size_of",
    "thinned",
]
