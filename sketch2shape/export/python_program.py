"""Python programs that make the solid: what those for build123d and CadQuery have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from sketch2shape.export.parameters import Design, Path, Rounding, design_of, parameter_lines, plain_number
from sketch2shape.export.program_text import about, wrapped
from sketch2shape.model import Plane, Solid
from sketch2shape.solids import extrusion_of, tessellated


class Dialect(Protocol):
    """How a library is spoken to."""

    library: str
    """its name, as pip knows it"""

    def imports(self, body: Sequence[str]) -> list[str]:
        """The lines that import what the program uses."""

    def outline(self, name: str, path: Path) -> list[str]:
        """An outline."""

    def plane(self, name: str, design: Design) -> str:
        """The plane of the near end."""

    def extruded(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        """`part` of outlines, the outer one first, then the holes, and the `plane`."""

    def lofted(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        """The same of a tapered solid with curved sides."""

    def pointed(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        """`part` of the only outline, the `plane`, and the point over the foot."""

    def face_maker(self, name: str) -> list[str]:
        """A function that makes a flat face of its loops of points, the outer one first."""

    def closed(self, ending: str, plane: str | None) -> str:
        """`part` of the `faces` around it, drawn on a plane if one is named."""

    def compound(self, parts: Sequence[str]) -> str:
        """Several solids as one."""

    def saved(self) -> str:
        """The statement that writes a STEP file."""


def program(solids: Sequence[Solid], dialect: Dialect) -> str:
    """The program; `part` is the solid, or a compound of several, whose dimensions' names end in their number."""
    body: list[str] = []
    for number, solid in enumerate(solids, 1):
        body += [*_part(solid, f"_{number}" if len(solids) > 1 else "", dialect), ""]
    if len(solids) > 1:
        body += [f"part = {dialect.compound([f'part_{k}' for k in range(1, len(solids) + 1)])}", ""]
    first, *more = about(solids)
    head = [f'"""{first}', "", *more, f"Needs {dialect.library}: pip install {dialect.library.lower()}", '"""', ""]
    last = ['if __name__ == "__main__":', f"    {dialect.saved()}"]
    return "\n".join([*head, *dialect.imports(body), "", *body, *last]) + "\n"


def _part(solid: Solid, ending: str, dialect: Dialect) -> list[str]:
    extrusion = extrusion_of(solid)
    if extrusion is None:
        return _polyhedron(solid, ending, dialect)
    design = design_of(extrusion, ending)
    names = [f"outline{ending}", *(f"hole{ending}_{k}" for k in range(1, len(design.outlines)))]
    lines = [*parameter_lines(design.parameters, "#", lambda p: f"{p.name} = {p.value}"), ""]
    plane = dialect.plane(f"plane{ending}", design)
    if design.scale not in ("0", "1") and design.is_straight:
        return [*lines, *_tapered(design, names, ending, dialect), plane, dialect.closed(ending, f"plane{ending}")]
    for name, path in zip(names, design.outlines, strict=True):
        lines += dialect.outline(name, path)
    made = {"1": dialect.extruded, "0": dialect.pointed}.get(design.scale, dialect.lofted)
    return [*lines, plane, *made(design, names, ending)]


def _tapered(design: Design, names: Sequence[str], ending: str, dialect: Dialect) -> list[str]:
    """The loops of each face of a tapered solid: flat faces, where lofting would give free-form ones."""
    lines = []
    for name, path in zip(names, design.outlines, strict=True):
        lines += wrapped(f"{name} = [", (f"({x}, {y})" for x, y in path.points), "]")
    foot, near, far, faces = (name + ending for name in ("foot", "near", "far", "faces"))
    return [
        *lines,
        f"{foot} = ({design.foot[0]}, {design.foot[1]})  # the point that the taper leads to, seen along the axis",
        "",
        "",
        f"def end{ending}(points, part, level):",
        f"    x0, y0 = {foot}",
        "    return [(x0 + part * (x - x0), y0 + part * (y - y0), level) for x, y in points]",
        "",
        "",
        *dialect.face_maker(f"face{ending}"),
        "",
        "",
        f"{near} = [end{ending}(points, 1, 0) for points in [{', '.join(names)}]]",
        f"{far} = [end{ending}(points, {design.scale}, {design.length}) for points in [{', '.join(names)}]]",
        f"{faces} = [[loop[::-1] for loop in {near}], {far}]",
        f"for a, b in zip({near}, {far}):",
        f"    {faces} += [[[a[i - 1], a[i], b[i], b[i - 1]]] for i in range(len(a))]",
    ]


def _polyhedron(solid: Solid, ending: str, dialect: Dialect) -> list[str]:
    """All vertices and faces of a solid that is no extrusion; curved ones in facets."""
    surface = tessellated(solid.boundary)
    number = Rounding(float(np.abs(surface.vertices).max()))
    points = (f"({', '.join(map(number, vertex))})" for vertex in surface.vertices.tolist())
    faces: list[str] = []
    for face, facets in zip(solid.faces, surface.faces, strict=True):
        flat = isinstance(face.surface, Plane)
        loops = [[[*surface.ring(loop)] for loop in face.loops]] if flat else [[facet] for facet in facets.tolist()]
        faces += map(str, loops)
    return [
        *wrapped(f"points{ending} = [", points, "]"),
        *wrapped(f"faces{ending} = [", faces, "]"),
        "",
        "",
        *dialect.face_maker(f"face{ending}"),
        "",
        "",
        f"faces{ending} = [[[points{ending}[i] for i in loop] for loop in loops] for loops in faces{ending}]",
        dialect.closed(ending, None),
    ]


def direction(row: Sequence[float]) -> str:
    """A unit vector as a tuple."""
    return f"({', '.join(plain_number(value, 9) for value in row)})"
