"""The formats a result can be written in, and the one function that makes the bytes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from sketch2shape.errors import UsageError
from sketch2shape.model import Solid

if TYPE_CHECKING:
    from sketch2shape.result import Result

Encoder = Callable[[Sequence[Solid]], bytes]


def encode(result: Result | Solid | Sequence[Solid], format: str, *, ngons: bool = False) -> bytes:
    """The file's bytes for a result, a solid or several solids (one body each).

    format : a key of `FORMATS`, see there
    ngons  : in OBJ, write whole polygons as faces instead of triangles

    Raises UsageError for an unknown format.
    """
    from sketch2shape.result import Result

    many = result.solids if isinstance(result, Result) else result
    solids = (many,) if isinstance(many, Solid) else tuple(many)
    if format not in FORMATS:
        raise UsageError(f"unknown format {format!r}", remedy=f"one of {', '.join(FORMATS)}")
    if format == "obj":
        return _obj(solids, ngons=ngons)
    return _ENCODERS[format](solids)


def format_of(path: str | PurePath) -> str:
    """The format meant by a file name's extension. Raises UsageError if there is none."""
    suffix = PurePath(path).suffix.lower().lstrip(".")
    if suffix not in _SUFFIXES:
        raise UsageError(f"no format has the extension {suffix!r}", remedy=f"one of {', '.join(_SUFFIXES)}")
    return _SUFFIXES[suffix]


def _obj(solids: Sequence[Solid], *, ngons: bool = False) -> bytes:
    from sketch2shape.export.obj import obj_text

    return obj_text(solids, ngons=ngons).encode()


def _through_trimesh(file_type: str, **options: Any) -> Encoder:
    """An encoder for a format that holds a single mesh."""

    def encoder(solids: Sequence[Solid]) -> bytes:
        from sketch2shape.export.mesh import to_trimesh

        data = to_trimesh(solids).export(file_type=file_type, **options)
        return data.encode() if isinstance(data, str) else bytes(data)

    return encoder


def _scene(solids: Sequence[Solid]) -> Any:
    """A trimesh scene with a named geometry for each solid."""
    import trimesh

    from sketch2shape.export.mesh import to_trimesh

    scene = trimesh.Scene()
    for number, solid in enumerate(solids, 1):
        scene.add_geometry(to_trimesh(solid), geom_name=f"object_{number}", node_name=f"object_{number}")
    scene.units = solids[0].unit if solids else "px"
    return scene


def _glb(solids: Sequence[Solid]) -> bytes:
    return bytes(_scene(solids).export(file_type="glb"))


_ENCODERS: dict[str, Encoder] = {
    "obj": _obj,
    "stl": _through_trimesh("stl"),
    "stl-ascii": _through_trimesh("stl_ascii"),
    "ply": _through_trimesh("ply"),
    "off": _through_trimesh("off"),
    "glb": _glb,
}

#: format -> what it is
FORMATS: dict[str, str] = {
    "obj": "Wavefront OBJ",
    "stl": "binary STL",
    "stl-ascii": "STL as text",
    "ply": "binary PLY",
    "glb": "binary glTF",
    "off": "OFF as text",
}

_SUFFIXES = {"obj": "obj", "stl": "stl", "ply": "ply", "glb": "glb", "off": "off"}
