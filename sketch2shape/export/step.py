"""STEP for CAD: an exact boundary representation with plane faces, as ISO 10303-21 text, schema AP214.

Each solid is one manifold solid: its faces are whole polygons with their holes, not triangles, so a CAD system can
measure, fillet and extrude them. Lengths are written in millimetres.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketch2shape.export.units import MILLIMETRES
from sketch2shape.model import Floats, Solid

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
    points = solid.vertices * MILLIMETRES[solid.unit]
    vertices = [w.add(f"VERTEX_POINT('',{w.point(p)})") for p in points]
    curves: dict[tuple[int, int], str] = {}
    for a, b in solid.edges.tolist():
        way = points[b] - points[a]
        vector = w.add(f"VECTOR('',{w.direction(way)},1.)")
        line = w.add(f"LINE('',{w.point(points[a])},{vector})")
        curves[a, b] = w.add(f"EDGE_CURVE('',{vertices[a]},{vertices[b]},{line},.T.)")
    faces = [_face(w, points, rings, curves) for rings in solid.faces]
    shell = w.add(f"CLOSED_SHELL('',({','.join(faces)}))")
    return w.add(f"MANIFOLD_SOLID_BREP('object {number}',{shell})")


def _face(w: _Writer, points: Floats, rings: tuple[tuple[int, ...], ...], curves: dict[tuple[int, int], str]) -> str:
    """A plane face with its outer bound and its holes, normal outward."""
    bounds: list[str] = []
    for ring in rings:
        oriented = []
        for a, b in zip(ring, (*ring[1:], ring[0]), strict=True):
            forward = (a, b) in curves
            curve = curves[(a, b) if forward else (b, a)]
            oriented.append(w.add(f"ORIENTED_EDGE('',*,*,{curve},.{'T' if forward else 'F'}.)"))
        loop = w.add(f"EDGE_LOOP('',({','.join(oriented)}))")
        kind = "FACE_BOUND" if bounds else "FACE_OUTER_BOUND"
        bounds.append(w.add(f"{kind}('',{loop},.T.)"))
    outer = points[list(rings[0])]
    p = outer - outer[0]
    normal = np.cross(p, np.roll(p, -1, axis=0)).sum(axis=0)
    plane = w.add(f"PLANE('',{w.placement(outer[0], normal, outer[1] - outer[0])})")
    return w.add(f"ADVANCED_FACE('',({','.join(bounds)}),{plane},.T.)")


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
