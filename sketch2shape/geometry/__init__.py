"""Plane geometry that several stages share: lines, plane maps, homologies."""

from __future__ import annotations

from sketch2shape.geometry.lines import fit_lines, moments, project, thinned
from sketch2shape.geometry.plane_maps import map_cost, plane_map

__all__ = ["fit_lines", "map_cost", "moments", "plane_map", "project", "thinned"]
