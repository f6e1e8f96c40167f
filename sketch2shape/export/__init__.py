"""Writing solids down: meshes, CAD and drawing formats, all as bytes; nothing here touches the disk."""

from __future__ import annotations

from sketch2shape.export.encode import FORMATS, MESH_FORMATS, encode, format_of
from sketch2shape.export.mesh import to_trimesh

__all__ = ["FORMATS", "MESH_FORMATS", "encode", "format_of", "to_trimesh"]
