"""What follows from a solid's boundary alone: its surface as triangles, its hidden lines, its true face."""

from __future__ import annotations

from sketch2shape.solids.front import front_rings
from sketch2shape.solids.hidden import Run, edge_runs
from sketch2shape.solids.triangles import face_triangles, triangulated

__all__ = ["Run", "edge_runs", "face_triangles", "front_rings", "triangulated"]
