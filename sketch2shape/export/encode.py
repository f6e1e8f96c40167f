"""The formats a result can be written in, and the one function that makes the bytes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import PurePath
from typing import Any

from sketch2shape.errors import NoObjectError, UsageError
from sketch2shape.export.plan_options import Angle, PaperName, PlanOptions
from sketch2shape.export.plans import encode_plan, plan_note
from sketch2shape.export.units import MILLIMETRES, in_millimetres
from sketch2shape.model import Answer, Solid
from sketch2shape.writing import formats

#: format -> what it is
FORMATS: dict[str, str] = {
    name: formats.FORMATS[name].what for name in formats.named("solid", "program", "plan", "drawing")
}

#: formats that hold the solid itself
MESH_FORMATS = formats.named("solid")

#: formats that are plans on paper
PLANS = formats.named("plan")

#: formats that have no word for the unit: programs take their numbers as millimetres
_UNITLESS = ("obj", "stl", "stl-ascii", "ply", "off", *formats.named("program"))

#: formats that need the objects in the picture besides the solids
_DRAWINGS = ("svg", "dxf")


def encode(
    result: Answer | Solid | Sequence[Solid],
    format: str,
    *,
    ngons: bool = False,
    tolerance: float | None = None,
    paper: PaperName = "a4",
    angle: Angle = "third",
) -> bytes:
    """The file's bytes for a result, a solid or several solids (one body each).

    format    : a key of `FORMATS`; the drawings "svg" and "dxf" need a whole result
    ngons     : in OBJ, write whole polygons as faces instead of triangles
    tolerance : in meshes, the largest distance of a facet from a curved side, in the solids' unit; None for one that
                looks smooth
    paper     : of plans, "a4" or "letter"
    angle     : of views, "third" or "first"

    Raises UsageError for an unknown format, paper or angle, NoObjectError if there is no solid.
    """
    if format not in FORMATS:
        raise UsageError(f"unknown format {format!r}", remedy=f"one of {', '.join(FORMATS)}")
    if format in _DRAWINGS:
        if not isinstance(result, Answer):
            raise UsageError(f"{format} shows the drawing and needs a whole result, not solids alone")
        return _drawing(result, format)
    solids = _solids_of(result)
    if format in PLANS:
        return encode_plan(solids, format, PlanOptions(paper, angle))
    if format in _UNITLESS:
        tolerance = tolerance and tolerance * MILLIMETRES[solids[0].unit]
        solids = tuple(in_millimetres(solids))
    if format == "obj":
        return _obj(solids, ngons, tolerance)
    return _EXACT[format](solids) if format in _EXACT else _MESHES[format](solids, tolerance)


def note_of(
    result: Answer | Solid | Sequence[Solid], format: str, *, paper: PaperName = "a4", angle: Angle = "third"
) -> str | None:
    """What `encode` has to assume, in words: a plan's size or scale, or a unit that a format has no word for.

    None if nothing. Raises as `encode`.
    """
    if format in _UNITLESS and _solids_of(result)[0].unit not in ("px", "mm"):
        return f"{format} has no word for the unit: its numbers are millimetres"
    return plan_note(_solids_of(result), format, PlanOptions(paper, angle)) if format in PLANS else None


def _solids_of(result: Answer | Solid | Sequence[Solid]) -> tuple[Solid, ...]:
    many = result.solids if isinstance(result, Answer) else result
    solids = (many,) if isinstance(many, Solid) else tuple(many)
    if not solids:
        raise NoObjectError("there is no object to write")
    return solids


def format_of(path: str | PurePath) -> str:
    """The format meant by a file name: "a.stl" is "stl", "a.face.dxf" is "face.dxf". Raises UsageError if none is."""
    name = formats.meant_by(PurePath(path).name)
    if name in FORMATS:
        return name
    endings = dict.fromkeys(end for known in FORMATS for end in formats.FORMATS[known].endings)
    last = PurePath(path).suffix.lower().lstrip(".")
    raise UsageError(f"no format has the extension {last!r}", remedy=f"one of {', '.join(endings)}")


def _drawing(result: Answer, format: str) -> bytes:
    from sketch2shape.export.drawing import drawing_dxf, drawing_svg

    if format == "dxf":
        return drawing_dxf(result.objects, result.solids).encode()
    return drawing_svg(result.objects, result.solids, result.picture.size).encode()


def _obj(solids: Sequence[Solid], ngons: bool, tolerance: float | None) -> bytes:
    from sketch2shape.export.obj import obj_text

    return obj_text(solids, ngons=ngons, tolerance=tolerance).encode()


def _through_trimesh(file_type: str) -> Callable[[Sequence[Solid], float | None], bytes]:
    """An encoder for a format that holds a single mesh."""

    def encoder(solids: Sequence[Solid], tolerance: float | None) -> bytes:
        from sketch2shape.export.mesh import to_trimesh

        data: Any = to_trimesh(solids, tolerance).export(file_type=file_type)
        return data.encode() if isinstance(data, str) else bytes(data)

    return encoder


def _stl_ascii(solids: Sequence[Solid], tolerance: float | None) -> bytes:
    """STL as text, all solids under one name: few programs read a second one."""
    from sketch2shape.export.mesh import to_trimesh

    mesh = to_trimesh(solids, tolerance)
    lines = ["solid sketch2shape"]
    for normal, corners in zip(mesh.face_normals.tolist(), mesh.triangles.tolist(), strict=True):
        rows = ["vertex {:.9g} {:.9g} {:.9g}".format(*corner) for corner in corners]
        head = "facet normal {:.9g} {:.9g} {:.9g}".format(*(n + 0.0 for n in normal))
        lines += [head, "outer loop", *rows, "endloop", "endfacet"]
    return ("\n".join([*lines, "endsolid sketch2shape"]) + "\n").encode()


def _glb(solids: Sequence[Solid], tolerance: float | None) -> bytes:
    """glTF with a named mesh for each solid, as it asks in metres and y upward; a pixel counts as a millimetre."""
    import numpy as np
    from trimesh import Scene

    from sketch2shape.export.mesh import to_trimesh

    turns = {"z": [[1, 0, 0], [0, 0, 1], [0, -1, 0]], "y": np.eye(3), "camera": np.diag([1, -1, -1])}
    scene: Any = Scene()
    for number, solid in enumerate(solids, 1):
        mesh: Any = to_trimesh(solid, tolerance)
        place = np.eye(4)
        place[:3, :3] = np.array(turns[solid.up], float) * (MILLIMETRES[solid.unit] / 1000.0)
        mesh.apply_transform(place)
        scene.add_geometry(mesh, geom_name=f"object_{number}", node_name=f"object_{number}")
    return bytes(scene.export(file_type="glb"))


def _threemf(solids: Sequence[Solid], tolerance: float | None) -> bytes:
    from sketch2shape.export.threemf import threemf_bytes

    return threemf_bytes(solids, tolerance)


def _step(solids: Sequence[Solid]) -> bytes:
    from sketch2shape.export.step import step_text

    return step_text(solids).encode()


def _scad(solids: Sequence[Solid]) -> bytes:
    from sketch2shape.export.scad import scad_text

    return scad_text(solids).encode()


def _build123d(solids: Sequence[Solid]) -> bytes:
    from sketch2shape.export.build123d import build123d_text

    return build123d_text(solids).encode()


def _cadquery(solids: Sequence[Solid]) -> bytes:
    from sketch2shape.export.cadquery import cadquery_text

    return cadquery_text(solids).encode()


def _face_svg(solids: Sequence[Solid]) -> bytes:
    from sketch2shape.export.drawing import face_svg

    return face_svg(solids).encode()


def _face_dxf(solids: Sequence[Solid]) -> bytes:
    from sketch2shape.export.drawing import face_dxf

    return face_dxf(solids).encode()


#: formats that hold triangles
_MESHES: dict[str, Callable[[Sequence[Solid], float | None], bytes]] = {
    "stl": _through_trimesh("stl"),
    "stl-ascii": _stl_ascii,
    "ply": _through_trimesh("ply"),
    "off": _through_trimesh("off"),
    "glb": _glb,
    "3mf": _threemf,
}

#: formats that hold curves as they are
_EXACT: dict[str, Callable[[Sequence[Solid]], bytes]] = {
    "step": _step,
    "scad": _scad,
    "build123d": _build123d,
    "cadquery": _cadquery,
    "face.svg": _face_svg,
    "face.dxf": _face_dxf,
}
