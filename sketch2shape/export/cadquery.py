"""A program for CadQuery that makes the solid: the outline and its holes as wires, extruded or lofted."""

from __future__ import annotations

from collections.abc import Sequence

from sketch2shape.export.parameters import Design, Path
from sketch2shape.export.program_text import bracketed, wrapped
from sketch2shape.export.python_program import direction, program
from sketch2shape.model import Solid


def cadquery_text(solids: Sequence[Solid]) -> str:
    """The program."""
    return program(solids, _CadQuery())


class _CadQuery:
    """Wires that make solids; `part` is a workplane that holds them."""

    library = "CadQuery"

    def imports(self, body: Sequence[str]) -> list[str]:
        used = [name for name in ("loft", "vertex") if any(f"{name}(" in line for line in body)]
        return ["import cadquery as cq", *([f"from cadquery.func import {', '.join(used)}"] if used else [])]

    def outline(self, name: str, path: Path) -> list[str]:
        if path.circle is not None:
            (x, y), diameter = path.circle
            return [f"{name} = cq.Wire.makeCircle({diameter} / 2, cq.Vector({x}, {y}, 0), cq.Vector(0, 0, 1))"]
        points = [f"({x}, {y})" for x, y in path.points]
        if path.is_straight:
            return wrapped(f"{name} = cq.Workplane().polyline([", points, "]).close().val()")
        lines = [f"{name} = (", f"    cq.Workplane().moveTo{points[0]}"]
        for point, arc in zip([*points[1:], points[0]], path.arcs, strict=True):
            lines.append(f"    .lineTo{point}" if arc is None else f"    .sagittaArc({point}, {arc.rise})")
        return [*lines, "    .close().val()", ")"]

    def plane(self, name: str, design: Design) -> str:
        x_axis, normal = direction(design.axes[0]), direction(design.axes[2])
        return f"{name} = cq.Plane(origin=({', '.join(design.origin)}), xDir={x_axis}, normal={normal})"

    def extruded(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        outer, *holes = outlines
        solid = f"cq.Solid.extrudeLinear({outer}, [{', '.join(holes)}], cq.Vector(0, 0, {design.length}))"
        return [f"solid{ending} = {solid}", _placed(f"solid{ending}", ending)]

    def lofted(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        x, y = (f"(1 - {design.scale}) * {bracketed(text)}" for text in design.foot)
        lines = [f"far{ending} = cq.Location(({x}, {y}, {design.length}))"]
        for number, name in enumerate(outlines):
            end = f"{name}.scale({design.scale}).moved(far{ending})"
            lines.append(f"solid{ending} {'-=' if number else '='} loft({name}, {end}, cap=True, ruled=True)")
        return [*lines, _placed(f"solid{ending}", ending)]

    def pointed(self, design: Design, outlines: Sequence[str], ending: str) -> list[str]:
        apex = f"vertex({', '.join((*design.foot, design.length))})"
        return [f"solid{ending} = loft({outlines[0]}, {apex}, cap=True)", _placed(f"solid{ending}", ending)]

    def face_maker(self, name: str) -> list[str]:
        return [
            f"def {name}(loops):",
            "    outer, *holes = [cq.Wire.makePolygon(loop, close=True) for loop in loops]",
            "    return cq.Face.makeFromWires(outer, holes)",
        ]

    def closed(self, ending: str, plane: str | None) -> str:
        solid = f"cq.Solid.makeSolid(cq.Shell.makeShell([face{ending}(loops) for loops in faces{ending}]))"
        return _placed(solid, ending) if plane else f"part{ending} = cq.Workplane({solid})"

    def compound(self, parts: Sequence[str]) -> str:
        return f"cq.Workplane(cq.Compound.makeCompound([{', '.join(f'{part}.val()' for part in parts)}]))"

    def saved(self) -> str:
        return 'part.export("part.step")'


def _placed(solid: str, ending: str) -> str:
    return f"part{ending} = cq.Workplane({solid}.moved(cq.Location(plane{ending})))"
