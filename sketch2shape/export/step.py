"""STEP for CAD: an exact boundary representation with plane faces, as ISO 10303-21 text, schema AP214.

Each solid is one manifold solid: its faces are whole polygons with their holes, not triangles, so a CAD system can
measure, fillet and extrude them. Lengths are written in millimetres.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketch2shape.export.units import MILLIMETRES
from sketch2shape.model import Boundary, Curve, Face, Floats, Line, Plane, Solid, Surface

_HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('sketch2shape'),'2;1');
FILE_NAME('sketch2shape','1970-01-01T00:00:00',(''),(''),'sketch2shape','sketch2shape','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
"""


class _Writer:
    """Numbers the entities of the data section as they are written."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, entity: str) -> str:
        """Write an entity and return the reference to it."""
        self.lines.append(f"#{len(self.lines) + 1}={entity};")
        return f"#{len(self.lines)}"

    def point(self, p: Floats) -> str:
        return self.add(f"CARTESIAN_POINT('',({_numbers(p)}))")

    def direction(self, v: Floats) -> str:
        return self.add(f"DIRECTION('',({_numbers(v / np.linalg.norm(v))}))")

    def placement(self, origin: Floats, axis: Floats, side: Floats) -> str:
        parts = (self.point(origin), self.direction(axis), self.direction(side))
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(parts)})")


def step_text(solids: Sequence[Solid]) -> str:
    """A STEP file with one manifold solid for each solid."""
    w = _Writer()
    context = _context(w)
    frame = w.placement(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]))
    bodies = [_body(w, number, solid) for number, solid in enumerate(solids, 1)]
    shape = w.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({','.join([frame, *bodies])}),{context})")
    _product(w, shape)
    return _HEADER + "\n".join(w.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"


def _numbers(values: Floats) -> str:
    """STEP reals: always with a decimal point."""
    texts = [f"{float(v) + 0.0:.12g}" for v in values]
    return ",".join(_real(t) for t in texts)


def _real(text: str) -> str:
    mantissa, mark, exponent = text.partition("e")
    mantissa = mantissa if "." in mantissa else mantissa + "."
    return mantissa + (f"E{int(exponent)}" if mark else "")


def _body(w: _Writer, number: int, solid: Solid) -> str:
    """One solid: points, straight edges, plane faces, a closed shell."""
    shape = solid.boundary.scaled(MILLIMETRES[solid.unit])
    points = shape.vertices
    vertices = [w.add(f"VERTEX_POINT('',{w.point(p)})") for p in points]
    edges = []
    for edge in shape.edges:
        curve = _curve(w, points[edge.start], points[edge.end], edge.curve)
        edges.append(w.add(f"EDGE_CURVE('',{vertices[edge.start]},{vertices[edge.end]},{curve},.T.)"))
    faces = [_face(w, shape, face, edges) for face in shape.faces]
    shell = w.add(f"CLOSED_SHELL('',({','.join(faces)}))")
    return w.add(f"MANIFOLD_SOLID_BREP('object {number}',{shell})")


def _curve(w: _Writer, start: Floats, end: Floats, curve: Curve) -> str:
    """The curve that an edge between two points lies on."""
    match curve:
        case Line():
            vector = w.add(f"VECTOR('',{w.direction(end - start)},1.)")
            return w.add(f"LINE('',{w.point(start)},{vector})")


def _surface(w: _Writer, surface: Surface, side: Floats) -> str:
    """The surface that a face lies on; side is a direction in it."""
    match surface:
        case Plane(origin, normal):
            return w.add(f"PLANE('',{w.placement(origin, normal, side)})")


def _face(w: _Writer, shape: Boundary, face: Face, edges: list[str]) -> str:
    """A face with its outer bound and its holes, normal outward."""
    bounds: list[str] = []
    for ring in face.loops:
        oriented = [w.add(f"ORIENTED_EDGE('',*,*,{edges[e]},.{'T' if forward else 'F'}.)") for e, forward in ring]
        loop = w.add(f"EDGE_LOOP('',({','.join(oriented)}))")
        kind = "FACE_BOUND" if bounds else "FACE_OUTER_BOUND"
        bounds.append(w.add(f"{kind}('',{loop},.T.)"))
    first, second, *_ = shape.rings(face)[0]
    surface = _surface(w, face.surface, shape.vertices[second] - shape.vertices[first])
    return w.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},.T.)")


def _context(w: _Writer) -> str:
    """Units: millimetre, radian, steradian; points closer than a millionth of a millimetre are one."""
    length = w.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    angle = w.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    solid_angle = w.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    exact = w.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),{length},'distance_accuracy_value','')")
    return w.add(
        f"(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({exact}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))REPRESENTATION_CONTEXT('',''))"
    )


def _product(w: _Writer, shape: str) -> None:
    """The product a STEP file must be about."""
    application = w.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    w.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    mechanical = w.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    product = w.add(f"PRODUCT('sketch2shape','sketch2shape','',({mechanical}))")
    formation = w.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    design = w.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    definition = w.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
    whole = w.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    w.add(f"SHAPE_DEFINITION_REPRESENTATION({whole},{shape})")
    w.add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
