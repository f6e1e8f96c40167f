"""A program for build123d that makes the solid: the outline as a face, its holes taken out, extruded or lofted."""

from __future__ import annotations

import re
from collections.abc import Sequence

from sketch2shape.export.parameters import Design, Path
from sketch2shape.export.program_text import bracketed, wrapped
from sketch2shape.export.python_program import direction, program
from sketch2shape.model import Solid

#: what a program may use of the library
_USED = (
    "CenterArc", "Compound", "Face", "Line", "Plane", "Polyline", "Pos", "SagittaArc", "Shell", "Solid", "Vertex",
    "Wire", "extrude", "loft", "make_face", "scale",
)  # fmt: skip


def build123d_text(solids: Sequence[Solid]) -> str:
    """The program."""
    return program(solids, _Build123d())


class _Build123d:
    """Algebra mode: shapes are values, planes place them."""

    library = "build123d"

    def imports(self, body: Sequence[str]) -> list[str]:
        text = "\n".join(body)
        used = [name for name in _USED if re.search(rf"\b{name}\b", text)]
        line = f"from build123d import {', '.join([*used, 'export_step'])}"
        return [line] if len(line) <= 100 else wrapped("from build123d import (", [*used, "export_step"], ")")

    def outline(self, name: str, path: Path) -> list[str]:
        if path.circle is not None:
            (x, y), diameter = path.circle
            # as a closed arc: a Circle that is moved would be scaled about its own centre
            return [f"{name} = make_face(CenterArc(({x}, {y}), {diameter} / 2, 0, 360))"]
        points = [f"({x}, {y})" for x, y in path.points]
        if path.is_straight:
            return wrapped(f"{name} = make_face(Polyline([", points, "], close=True))")
        lines = [f"{name} = make_face(["]
        for k, (point, arc) in enumerate(zip(points, path.arcs, strict=True)):
            ends = f"{point}, {points[(k + 1) % len(points)]}"
            lines.append(f"    Line({ends})," if arc is None else f"    SagittaArc({ends}, {arc.rise}),")
        return [*lines, "])"]

    def plane(self, name: str, design: Design) -> str:
        x_dir, z_dir = direction(design.axes[0]), direction(design.axes[2])
        return f"{name} = Plane(origin=({', '.join(design.origin)}), x_dir={x_dir}, z_dir={z_dir})"

    def extruded(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        face = outlines[0] if len(outlines) == 1 else f"({' - '.join(outlines)})"
        return [f"part{ending} = extrude(plane{ending} * {face}, {design.length})"]

    def lofted(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        x, y = (f"(1 - {design.scale}) * {bracketed(text)}" for text in design.foot)
        lines = [f"far{ending} = Pos({x}, {y}, {design.length})"]
        for number, name in enumerate(outlines):
            loft = f"loft([{name}, far{ending} * scale({name}, {design.scale})], ruled=True)"
            lines.append(f"solid{ending} {'-=' if number else '='} {loft}")
        return [*lines, f"part{ending} = plane{ending} * solid{ending}"]

    def pointed(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        apex = f"Vertex({', '.join((*design.foot, design.length))})"
        return [f"part{ending} = plane{ending} * loft([{outlines[0]}, {apex}])"]

    def face_maker(self, name: str) -> list[str]:
        return [
            f"def {name}(loops):",
            "    outer, *holes = [Wire.make_polygon(loop, close=True) for loop in loops]",
            "    return Face(outer, holes)",
        ]

    def closed(self, ending: str, plane: str | None) -> str:
        placed = f"{plane} * " if plane else ""
        return f"part{ending} = {placed}Solid(Shell([face{ending}(loops) for loops in faces{ending}]))"

    def compound(self, parts: Sequence[str]) -> str:
        return f"Compound([{', '.join(parts)}])"

    def saved(self) -> str:
        return 'export_step(part, "part.step")'
