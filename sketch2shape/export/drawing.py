"""The cleaned drawing as lines, and the true face laid flat, as SVG and DXF.

The drawing has its visible and hidden lines on two layers, in pixels of the picture. The true face is the front face
in its own plane, at full size: what one would cut or print to fold, mill or trace it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sketch2shape.export.mesh import settled
from sketch2shape.model import Solid, TwoFaceObject
from sketch2shape.sheets import dxf_file, dxf_pair
from sketch2shape.solids import DrawnLine, FlatRing, drawn_lines, front_outline

LAYERS = ("visible", "hidden")

#: gap between faces laid side by side, as a part of the widest
_GAP = 0.1

#: width of the line around a face laid flat, as a part of the face's longer side
_STROKE = 0.003

_SVG = '<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="{x:.9g} {y:.9g} {w:.9g} {h:.9g}">\n{body}\n</svg>\n'


def drawing_svg(objects: Sequence[TwoFaceObject], solids: Sequence[Solid], size: tuple[int, int]) -> str:
    """The cleaned drawing as SVG: for each object a group for each layer; size is the picture's, pixels."""
    bodies = []
    for number, (obj, solid) in enumerate(zip(objects, solids, strict=True), 1):
        lines = drawn_lines(obj, solid)
        layers = "\n".join(_svg_layer(lines, layer) for layer in LAYERS)
        bodies.append(f'<g id="object_{number}" fill="none" stroke="black" stroke-linecap="round">\n{layers}\n</g>')
    width, height = size
    head = f'width="{width}" height="{height}"'
    # the centre of the first pixel is (0, 0), its corner half a pixel before
    return _SVG.format(size=head, x=-0.5, y=-0.5, w=width, h=height, body="\n".join(bodies))


def drawing_dxf(objects: Sequence[TwoFaceObject], solids: Sequence[Solid]) -> str:
    """The cleaned drawing as DXF (release 12), layers VISIBLE and HIDDEN, y upward, one unit a pixel."""
    entities: list[str] = []
    for obj, solid in zip(objects, solids, strict=True):
        for line in drawn_lines(obj, solid):
            layer = "VISIBLE" if line.visible else "HIDDEN"
            entities += _dxf_line(line, layer)
    return dxf_file({"VISIBLE": "CONTINUOUS", "HIDDEN": "DASHED"}, entities, "px")


def face_svg(solids: Sequence[Solid]) -> str:
    """The true front faces side by side as SVG at full size, holes cut out; pixels become user units."""
    faces = _laid_out(solids)
    outer = [face[0].outline() for face in faces]
    high = max((float(np.ptp(ring[:, 1])) for ring in outer), default=1.0)
    wide = max((float(ring[:, 0].max()) for ring in outer), default=1.0)
    unit = solids[0].unit if solids else "px"
    stroke = _STROKE * max(wide, high)
    # the page is the view box, edge strokes included, at full size; SVG has no metres
    factor, written = (1000.0, "mm") if unit == "m" else (1.0, unit)
    page = [extent + 2 * stroke for extent in (wide, high)]
    size = 'width="{:.9g}{unit}" height="{:.9g}{unit}"'.format(*(factor * p for p in page), unit=written)
    paths = [
        f'<path id="face_{number}" fill="none" fill-rule="evenodd" stroke="black" stroke-width="{stroke:.4g}" '
        f'd="{_path(face)}"/>'
        for number, face in enumerate(faces, 1)
    ]
    return _SVG.format(size=size, x=-stroke, y=-stroke, w=page[0], h=page[1], body="\n".join(paths))


def face_dxf(solids: Sequence[Solid]) -> str:
    """The true front faces side by side as DXF, layers FACE and HOLES, y up, in the solids' unit.

    Rings are closed polylines, with bulges where they are arcs, or circles.
    """
    entities: list[str] = []
    for face in _laid_out(solids):
        for layer, ring in zip(["FACE"] + ["HOLES"] * (len(face) - 1), face, strict=True):
            entities += _dxf_ring(ring, layer)
    unit = solids[0].unit if solids else "px"
    return dxf_file({"FACE": "CONTINUOUS", "HOLES": "CONTINUOUS"}, entities, unit)


def _svg_layer(lines: list[DrawnLine], layer: str) -> str:
    """One layer's lines as a single path."""
    style = ' stroke-width="1.5"' if layer == "visible" else ' stroke-width="1" stroke-dasharray="5 4"'
    shown = [line for line in lines if line.visible == (layer == "visible")]
    path = " ".join("M" + "L".join(f"{x:.3f} {y:.3f}" for x, y in line.points) for line in shown)
    return f'<g class="{layer}"{style}><path d="{path}"/></g>'


def _dxf_line(line: DrawnLine, layer: str) -> list[str]:
    """A line, or a polyline along a curve."""
    if len(line.points) == 2:
        (x1, y1), (x2, y2) = line.points
        return ["0", "LINE", "8", layer, *dxf_pair(10, x1, -y1), *dxf_pair(11, x2, -y2)]
    rows = ["0", "POLYLINE", "8", layer, "66", "1", "70", "0", *dxf_pair(10, 0.0, 0.0), "30", "0.0"]
    for x, y in line.points:
        rows += ["0", "VERTEX", "8", layer, *dxf_pair(10, x, -y)]
    return [*rows, "0", "SEQEND", "8", layer]


def _dxf_ring(ring: FlatRing, layer: str) -> list[str]:
    """A ring as DXF, y up: arcs then turn the other way."""
    if ring.circle is not None:
        (x, y), radius = ring.circle
        return ["0", "CIRCLE", "8", layer, *dxf_pair(10, x, -y), "40", f"{radius:.6f}"]
    rows = ["0", "POLYLINE", "8", layer, "66", "1", "70", "1", *dxf_pair(10, 0.0, 0.0), "30", "0.0"]
    for (x, y), bulge in zip(ring.points, ring.bulges, strict=True):
        rows += ["0", "VERTEX", "8", layer, *dxf_pair(10, x, -y), *(["42", f"{-bulge:.9f}"] if bulge else [])]
    return [*rows, "0", "SEQEND", "8", layer]


def _laid_out(solids: Sequence[Solid]) -> list[list[FlatRing]]:
    """The rings of each front face in its own plane, from the left to the right, tops at 0."""
    faces: list[list[FlatRing]] = []
    flat = [front_outline(s) for s in solids]
    outlines = [face[0].outline() for face in flat]
    gap = _GAP * max((float(np.ptp(outline[:, 0])) for outline in outlines), default=0.0)
    left = 0.0
    for face, outline in zip(flat, outlines, strict=True):
        corner = outline.min(axis=0)
        shift = np.array([left, 0.0]) - corner
        moved = [ring.moved(shift) for ring in face]
        faces.append([replace(ring, points=settled(ring.points)) for ring in moved])
        left = float(settled(outline + shift)[:, 0].max()) + gap
    return faces


def _path(face: list[FlatRing]) -> str:
    return " ".join(_svg_ring(ring) for ring in face)


def _svg_ring(ring: FlatRing) -> str:
    """A ring as an SVG path; a circle as two halves, since an arc needs two ends."""
    if ring.circle is not None:
        (x, y), r = ring.circle
        half = f"A{r:.9g} {r:.9g} 0 0 1 "
        return f"M{x - r:.9g} {y:.9g}{half}{x + r:.9g} {y:.9g}{half}{x - r:.9g} {y:.9g}Z"
    steps = [f"M{ring.points[0, 0]:.9g} {ring.points[0, 1]:.9g}"]
    for start, bulge in enumerate(ring.bulges):
        after = (start + 1) % len(ring.points)
        x, y = ring.points[after]
        if bulge:
            r = ring.radius(start)
            steps.append(f"A{r:.9g} {r:.9g} 0 {int(abs(bulge) > 1.0)} {int(bulge > 0)} {x:.9g} {y:.9g}")
        elif after:
            steps.append(f"L{x:.9g} {y:.9g}")
    return "".join(steps) + "Z"
