"""The kinds of files that are written: one table for the command, its help, the service, the page and the documents.

It lies here, below all else, so that `--help` can read it without loading what does the work. What makes the bytes
stands in `export/encode.py` and `pipeline/products.py`; tests see to it that every kind has its maker.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal, TypeAlias

    Group: TypeAlias = Literal["solid", "program", "plan", "drawing", "report", "picture"]
    """What a file holds: the solid itself, a program that makes it, a plan of it on paper, the drawing or the true face
    as lines, the report, a picture of the result."""


class Format:
    """A kind of file.

    what    : what it is, in words
    group   : what it holds
    media   : its media type
    endings : of file names that mean it, without the first dot; the one that is written comes first
    """

    __slots__ = ("endings", "group", "media", "what")

    def __init__(self, what: str, group: Group, media: str, endings: tuple[str, ...]) -> None:
        """Of these four."""
        self.what, self.group, self.media, self.endings = what, group, media, endings


_SVG, _DXF, _PDF, _PNG = "image/svg+xml", "image/vnd.dxf", "application/pdf", "image/png"
_PYTHON = "text/x-python"

#: name of the format -> the kind of file; of kinds with the same ending the first is meant by it
FORMATS: dict[str, Format] = {
    "obj": Format("Wavefront OBJ", "solid", "model/obj", ("obj",)),
    "stl": Format("binary STL", "solid", "model/stl", ("stl",)),
    "stl-ascii": Format("STL as text", "solid", "model/stl", ("stl",)),
    "ply": Format("binary PLY", "solid", "application/octet-stream", ("ply",)),
    "glb": Format("binary glTF", "solid", "model/gltf-binary", ("glb",)),
    "3mf": Format("3MF for 3-D printing, with its unit", "solid", "model/3mf", ("3mf",)),
    "off": Format("OFF as text", "solid", "text/plain", ("off",)),
    "step": Format("STEP AP214 with planes, cylinders and cones, for CAD", "solid", "model/step", ("step", "stp")),
    "scad": Format("OpenSCAD program with named dimensions", "program", "application/x-openscad", ("scad",)),
    "build123d": Format("Python program for build123d with named dimensions", "program", _PYTHON, ("py",)),
    "cadquery": Format("Python program for CadQuery with named dimensions", "program", _PYTHON, ("py",)),
    "net.svg": Format("the paper net, cut and fold lines on layers", "plan", _SVG, ("net.svg",)),
    "net.pdf": Format("the paper net, to print", "plan", _PDF, ("net.pdf",)),
    "views.svg": Format("front, top and side view with dimensions", "plan", _SVG, ("views.svg",)),
    "views.pdf": Format("front, top and side view with dimensions, to print", "plan", _PDF, ("views.pdf",)),
    "views.dxf": Format("front, top and side view with dimensions, at full size", "plan", _DXF, ("views.dxf",)),
    "worksheet.pdf": Format("drawing, dimensions and questions, then the answers", "plan", _PDF, ("worksheet.pdf",)),
    "svg": Format("the cleaned drawing, visible and hidden lines in groups", "drawing", _SVG, ("svg",)),
    "dxf": Format("the cleaned drawing, visible and hidden lines on layers", "drawing", _DXF, ("dxf",)),
    "face.svg": Format("the true front face laid flat", "drawing", _SVG, ("face.svg",)),
    "face.dxf": Format("the true front face laid flat", "drawing", _DXF, ("face.dxf",)),
    "json": Format("the report", "report", "application/json", ("json",)),
    "overlay": Format("PNG of the object drawn over the drawing", "picture", _PNG, ("overlay.png",)),
    "stages": Format("PNG that shows each stage", "picture", _PNG, ("stages.png",)),
    "preview": Format("PNG of the shaded solid", "picture", _PNG, ("preview.png",)),
    "html": Format("page with the turning solid, needs no network", "picture", "text/html; charset=utf-8", ("html",)),
}


def named(*groups: Group) -> tuple[str, ...]:
    """The names of the formats of these groups, in the order of the table."""
    return tuple(name for name, format in FORMATS.items() if format.group in groups)


def ending(name: str) -> str:
    """What the names of its files end with: ".obj", ".face.svg"."""
    return "." + FORMATS[name].endings[0]


def meant_by(file: str) -> str | None:
    """The format that a file name means by its ending, the longest that is known: "a.face.svg" is "face.svg"."""
    lower = file.lower()
    known = [
        (len(end), name) for name, format in FORMATS.items() for end in format.endings if lower.endswith("." + end)
    ]
    return max(known, key=lambda found: found[0])[1] if known else None
