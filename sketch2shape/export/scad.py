"""A program for OpenSCAD that makes the solid: named dimensions, the outline, its holes cut out, one extrusion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketch2shape.export.parameters import Design, Path, Place, Rounding, design_of, parameter_lines, plain_number
from sketch2shape.export.program_text import about, minus, wrapped
from sketch2shape.model import Floats, Plane, Solid
from sketch2shape.solids import extrusion_of, tessellated

#: chords of a whole circle
_CHORDS = 180

_ARC = """// points between the ends of an arc
function arc(center, radius, begin, end) = let (n = ceil($fn * abs(end - begin) / 360))
  [for (i = [1 : n - 1]) center + radius * [cos(begin + (end - begin) * i / n), sin(begin + (end - begin) * i / n)]];
"""


def scad_text(solids: Sequence[Solid]) -> str:
    """The program; names of several solids' dimensions end in their number."""
    lines = [f"// {line}" for line in about(solids)]
    body: list[str] = []
    for number, solid in enumerate(solids, 1):
        ending = f"_{number}" if len(solids) > 1 else ""
        extrusion = extrusion_of(solid)
        body.append("")
        body += _polyhedron(solid) if extrusion is None else _extruded(design_of(extrusion, ending), ending)
    arcs = any("arc(" in line for line in body)
    if arcs or any("circle(" in line or "cylinder(" in line for line in body):
        lines += ["", f"$fn = {_CHORDS};  // chords of a circle"]
    lines += ["", *_ARC.splitlines()] if arcs else []
    return "\n".join([*lines, *body]) + "\n"


def _extruded(design: Design, ending: str) -> list[str]:
    """Dimensions, the outline, and the solid."""
    lines = [*parameter_lines(design.parameters, "//", lambda p: f"{p.name} = {p.value};"), ""]
    whole = design.outlines[0].circle
    if whole is not None and len(design.outlines) == 1 and design.foot == whole[0]:
        steps = [*_placed(design, design.foot_origin), _cylinder(design, whole[1])]
    else:
        lines += [*_outline(design, ending), ""]
        steps = _swept(design, ending)
    return [*lines, *("  " * k + step for k, step in enumerate(steps))]


def _outline(design: Design, ending: str) -> list[str]:
    """The module of the outline, its holes cut out."""
    outer, *holes = design.outlines
    if not holes:
        return [f"module outline{ending}() {{", *_polygon(outer, 2), "}"]
    cut = [line for hole in holes for line in _polygon(hole, 4)]
    return [f"module outline{ending}() {{", "  difference() {", *_polygon(outer, 4), *cut, "  }", "}"]


def _swept(design: Design, ending: str) -> list[str]:
    """The outline drawn out, each step to be indented under the one before."""
    if design.scale == "1":
        drawn = [f"linear_extrude(height = {design.length})"]
        return [*_placed(design, design.origin), *drawn, f"outline{ending}();"]
    return [
        *_placed(design, design.foot_origin),
        f"linear_extrude(height = {design.length}, scale = {design.scale})",
        f"translate([{minus(design.foot[0])}, {minus(design.foot[1])}])",
        f"outline{ending}();",
    ]


def _cylinder(design: Design, diameter: str) -> str:
    """A cylinder, a cone or a truncated cone."""
    if design.scale == "1":
        return f"cylinder(h = {design.length}, d = {diameter});"
    far = "0" if design.scale == "0" else f"{design.scale} * {diameter}"
    return f"cylinder(h = {design.length}, d1 = {diameter}, d2 = {far});"


def _placed(design: Design, place: Place) -> list[str]:
    """What moves and turns the solid to where it stands."""
    steps = [f"translate([{', '.join(place)}])"] if any(text != "0" for text in place) else []
    angles = [plain_number(angle, 6) for angle in turns(design.axes)]
    return [*steps, f"rotate([{', '.join(angles)}])"] if any(text != "0" for text in angles) else steps


def _polygon(path: Path, indent: int) -> list[str]:
    if path.circle is not None:
        (x, y), diameter = path.circle
        moved = f"translate([{x}, {y}]) "
        return [f"{' ' * indent}{moved}circle(d = {diameter});"]
    points = [f"[{x}, {y}]" for x, y in path.points]
    if path.is_straight:
        return wrapped("polygon([", points, "]);", indent=indent, step=2)
    pieces: list[str] = []
    straight: list[str] = []
    for point, arc in zip(points, path.arcs, strict=True):
        straight.append(point)
        if arc is not None:
            pieces.append(f"[{', '.join(straight)}]")
            pieces.append(f"arc([{', '.join(arc.center)}], {arc.radius}, {arc.begin}, {arc.end})")
            straight = []
    pieces += [f"[{', '.join(straight)}]"] if straight else []
    left = " " * (indent + 2)
    return [
        " " * indent + "polygon(concat(",
        *(f"{left}{piece}," for piece in pieces[:-1]),
        f"{left}{pieces[-1]}",
        " " * indent + "));",
    ]


def turns(axes: Floats) -> tuple[float, float, float]:
    """Angles about x, then y, then z, degrees, that turn x, y, z into the axes (3, 3), rows."""
    m = axes.T
    about_y = float(np.arcsin(np.clip(-m[2, 0], -1.0, 1.0)))
    if abs(m[2, 0]) > 1.0 - 1e-9:  # looking along y, turns about x and z are one
        about_x, about_z = float(np.arctan2(-m[1, 2], m[1, 1])), 0.0
    else:
        about_x, about_z = float(np.arctan2(m[2, 1], m[2, 2])), float(np.arctan2(m[1, 0], m[0, 0]))
    x, y, z = np.degrees([about_x, about_y, about_z]).tolist()
    return x, y, z


def _polyhedron(solid: Solid) -> list[str]:
    """All vertices and faces of a solid that is no extrusion: faces with holes in triangles, curved ones in facets."""
    surface = tessellated(solid.boundary)
    number = Rounding(float(np.abs(surface.vertices).max()))
    points = (f"[{', '.join(map(number, vertex))}]" for vertex in surface.vertices.tolist())
    faces: list[list[int]] = []
    for face, facets in zip(solid.faces, surface.faces, strict=True):
        whole = len(face.loops) == 1 and isinstance(face.surface, Plane)
        # OpenSCAD wants faces clockwise as seen from outside
        faces += [list(surface.ring(face.loops[0]))[::-1]] if whole else facets[:, ::-1].tolist()
    lines = ["polyhedron(", *wrapped("points = [", points, "],", indent=2, step=2)]
    return [*lines, *wrapped("faces = [", map(str, faces), "]", indent=2, step=2), ");"]
