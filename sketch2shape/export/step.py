"""STEP for CAD: an exact boundary representation, as ISO 10303-21 text, schema AP214.

Each solid is one manifold solid: its faces are whole, with their holes, on planes, cylinders and cones, not triangles,
so a CAD system can measure, fillet and extrude them. Lengths are written in millimetres.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sketch2shape.export.units import MILLIMETRES
from sketch2shape.model import Arc, Boundary, Circle, Cone, Cylinder, DirectedEdge, Face, Floats, Plane, Solid

#: an apex that stands off the axis by less than this part of the radius makes a right cone
_RIGHT = 1e-7

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

    def line(self, start: Floats, end: Floats) -> str:
        vector = self.add(f"VECTOR('',{self.direction(end - start)},1.)")
        return self.add(f"LINE('',{self.point(start)},{vector})")

    def circle(self, arc: Arc) -> str:
        place = self.placement(arc.circle.center, arc.circle.normal, arc.first)
        return self.add(f"CIRCLE('',{place},{_numbers(np.array([arc.circle.radius]))})")


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
    """One solid: points, edges, faces, a closed shell."""
    shape = _Shape(w, solid.boundary.scaled(MILLIMETRES[solid.unit]))
    faces = [_face(w, shape, face) for face in shape.boundary.faces]
    shell = w.add(f"CLOSED_SHELL('',({','.join(faces)}))")
    return w.add(f"MANIFOLD_SOLID_BREP('object {number}',{shell})")


class _Shape:
    """A boundary whose points and edges are written.

    boundary : it, in millimetres
    vertices : references to its vertices
    edges    : references to its edges
    begins   : reference to the point where each whole circle begins, by its edge, and the point itself
    """

    def __init__(self, w: _Writer, boundary: Boundary) -> None:
        self.boundary = boundary
        points = boundary.vertices
        self.vertices = [w.add(f"VERTEX_POINT('',{w.point(p)})") for p in points]
        self.begins: dict[int, tuple[str, Floats]] = {}
        self.edges: list[str] = []
        for number, edge in enumerate(boundary.edges):
            arc = boundary.arc(edge)
            if edge.start is not None and edge.end is not None:
                curve = w.circle(arc) if arc else w.line(points[edge.start], points[edge.end])
                ends = self.vertices[edge.start], self.vertices[edge.end]
            elif arc:
                curve, at = w.circle(arc), arc.at(np.zeros(1))[0]
                begin = w.add(f"VERTEX_POINT('',{w.point(at)})")
                self.begins[number] = begin, at
                ends = begin, begin
            self.edges.append(w.add(f"EDGE_CURVE('',{ends[0]},{ends[1]},{curve},.T.)"))


def _face(w: _Writer, shape: _Shape, face: Face) -> str:
    """A face with its outer bound and its holes, normal outward."""
    whole = [loop[0] for loop in face.loops if shape.boundary.edges[loop[0].edge].start is None]
    if whole and not isinstance(face.surface, Plane):
        bounds = [_seamed(w, shape, whole)]
    else:
        bounds = []
        for ring in face.loops:
            loop = _loop(w, [f"{shape.edges[e]},.{'T' if forward else 'F'}." for e, forward in ring])
            bounds.append(w.add(f"{'FACE_BOUND' if bounds else 'FACE_OUTER_BOUND'}('',{loop},.T.)"))
    surface, sense = _surface(w, shape.boundary, face)
    return w.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},.{'T' if sense else 'F'}.)")


def _loop(w: _Writer, steps: list[str]) -> str:
    oriented = [w.add(f"ORIENTED_EDGE('',*,*,{step})") for step in steps]
    return w.add(f"EDGE_LOOP('',({','.join(oriented)}))")


def _seamed(w: _Writer, shape: _Shape, rims: list[DirectedEdge]) -> str:
    """The bound of a side that goes all round, cut open along a seam, which is walked once each way."""
    (first, forward), *others = rims
    begin, start = shape.begins[first]
    if others:
        end, stop = shape.begins[others[0].edge]
    else:
        end, stop = shape.vertices[-1], shape.boundary.vertices[-1]
    seam = w.add(f"EDGE_CURVE('',{begin},{end},{w.line(start, stop)},.T.)")
    far = [f"{shape.edges[e]},.{'T' if ahead else 'F'}." for e, ahead in others]
    steps = [f"{shape.edges[first]},.{'T' if forward else 'F'}.", f"{seam},.T.", *far, f"{seam},.F."]
    return w.add(f"FACE_OUTER_BOUND('',{_loop(w, steps)},.T.)")


def _surface(w: _Writer, boundary: Boundary, face: Face) -> tuple[str, bool]:
    """The surface that a face lies on, and whether its own normal points out of the solid."""
    match face.surface:
        case Plane(origin, normal):
            return w.add(f"PLANE('',{w.placement(origin, normal, _side(boundary, face))})"), True
        case Cylinder(circle, convex):
            side = next(boundary.arcs(face))[0].first
            place = w.placement(circle.center, circle.normal, side)
            return w.add(f"CYLINDRICAL_SURFACE('',{place},{_numbers(np.array([circle.radius]))})"), convex
        case Cone(apex, circle, convex):
            return _cone(w, boundary, face, apex, circle, convex)


def _side(boundary: Boundary, face: Face) -> Floats:
    """A direction in a flat face: that of the first step around it."""
    number, forward = face.loops[0][0]
    edge = boundary.edges[number]
    arc = boundary.arc(edge)
    if edge.start is None or edge.end is None:
        return np.zeros(3) if arc is None else arc.first
    step: Floats = boundary.vertices[edge.end] - boundary.vertices[edge.start]
    return step if forward else -step


def _cone(w: _Writer, boundary: Boundary, face: Face, apex: Floats, circle: Circle, convex: bool) -> tuple[str, bool]:
    """A right cone by its name; a slanting one, as the rounded corner of a tapered block, as a rational surface."""
    axis = circle.center - apex
    height = abs(float(axis @ circle.normal))
    first = next(boundary.arcs(face))[0].first
    if float(np.linalg.norm(axis - (axis @ circle.normal) * circle.normal)) <= _RIGHT * circle.radius:
        outward = circle.normal if axis @ circle.normal > 0 else -circle.normal
        numbers = _numbers(np.array([circle.radius, np.arctan2(circle.radius, height)]))
        return w.add(f"CONICAL_SURFACE('',{w.placement(circle.center, outward, first)},{numbers})"), convex
    rims = [arc for arc, _ in boundary.arcs(face)]
    return _ruled(w, rims[0], rims[1] if len(rims) > 1 else apex, convex)


def _ruled(w: _Writer, rim: Arc, far: Arc | Floats, convex: bool) -> tuple[str, bool]:
    """The lines that join an arc with a like one, or with a point, as a rational B-spline surface: an exact one."""
    near, weights = _control_points(rim)
    beyond = _control_points(far)[0] if isinstance(far, Arc) else np.tile(far, (len(near), 1))
    rows = [f"({w.point(p)},{w.point(q)})" for p, q in zip(near, beyond, strict=True)]
    pieces = len(near) // 2
    knots = _numbers(np.arange(pieces + 1) / pieces)
    counts = ",".join(["3", *["2"] * (pieces - 1), "3"])
    weighed = ",".join(f"({_numbers(np.array([a, a]))})" for a in weights)
    surface = w.add(
        f"(BOUNDED_SURFACE()B_SPLINE_SURFACE(2,1,({','.join(rows)}),.UNSPECIFIED.,.F.,.F.,.F.)"
        f"B_SPLINE_SURFACE_WITH_KNOTS(({counts}),(2,2),({knots}),(0.,1.),.UNSPECIFIED.)GEOMETRIC_REPRESENTATION_ITEM()"
        f"RATIONAL_B_SPLINE_SURFACE(({weighed}))REPRESENTATION_ITEM('')SURFACE())"
    )
    # its own normal turns from along the rim to across it
    along = np.cross(rim.circle.normal, rim.first)
    across = beyond[0] - near[0]
    outward = float(np.cross(along, across) @ rim.first) > 0
    return surface, outward == convex


def _control_points(arc: Arc) -> tuple[Floats, Floats]:
    """(2 p + 1, 3) control points and their weights of an arc as p quadratic pieces, none beyond a quarter."""
    pieces = max(int(np.ceil(arc.sweep / (0.5 * np.pi) - 1e-9)), 1)
    points = arc.at(np.arange(2 * pieces + 1) / (2 * pieces))
    weights = np.ones(len(points))
    weights[1::2] = np.cos(arc.sweep / (2 * pieces))
    points[1::2] = arc.circle.center + (points[1::2] - arc.circle.center) / weights[1::2, None]
    return points, weights


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
