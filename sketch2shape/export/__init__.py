"""Writing solids down: meshes, CAD and drawing formats, all as bytes; nothing here touches the disk."""

from __future__ import annotations

from sketch2shape.export.encode import FORMATS, MESH_FORMATS, PLANS, encode, format_of, note_of
from sketch2shape.export.mesh import to_trimesh
from sketch2shape.export.plan_options import Angle, PaperName

__all__ = ["FORMATS", "MESH_FORMATS", "PLANS", "Angle", "PaperName", "encode", "format_of", "note_of", "to_trimesh"]
