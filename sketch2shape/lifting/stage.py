"""The stage itself: weigh the readings, lift, tidy, measure and turn."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.errors import PointsError, UsageError
from sketch2shape.lifting.beautify import beautified
from sketch2shape.lifting.decision import Reading, all_readings
from sketch2shape.lifting.face import edge_vectors, ring_area
from sketch2shape.lifting.frame import frame, own_axes, standing
from sketch2shape.lifting.measure import measured
from sketch2shape.lifting.options import LiftOptions
from sketch2shape.lifting.parallel import along_a_vector
from sketch2shape.lifting.projection import Drawing, prepare
from sketch2shape.lifting.shape import Shape
from sketch2shape.lifting.tangency import exact_arcs
from sketch2shape.lifting.trust import Option, options_of, sureness
from sketch2shape.model import Alternative, Floats, Projection, Solid, TwoFaceObject

#: a connecting vector shorter than this part of the object's size says nothing about the depth
_FLAT = 0.01

#: how sure the proportions are where no depth or no face can be read off
_ASSUMED = 0.1

#: an axis drawn with no more than this slope from the vertical stands upright
_PLUMB = 0.3

#: a face with less area than this part of its diagonal squared is seen from its edge
_EDGE_ON = 0.004


def lift(
    obj: TwoFaceObject, *, picture_size: tuple[int, int] | None = None, options: LiftOptions | None = None
) -> Solid:
    """The solid that a two-face object is a drawing of.

    obj          : the object in the picture's plane; f1 is taken as the front face (see `choose_front`)
    picture_size : width and height of the picture, pixels; kept in the evidence
    options      : what the user fixes

    The solid has one vertex for each of `obj.vertices`, in that order. It stands upright on z = 0, x to the right and y
    away, unless `options.up` says otherwise. What the drawing leaves free is set to a default that `Solid.warnings`
    states.

    Raises PointsError if a coordinate is not finite, UsageError if there is no such reading.
    """
    options = options or LiftOptions()
    if not np.isfinite(obj.vertices).all():
        raise PointsError("a vertex of the object is not a finite number")
    drawing = prepare(obj)
    problem = _degenerate(drawing)
    if problem:
        assumed = _solid(_sized(_default(drawing, problem), options), drawing, options, picture_size)
        return replace(assumed, confidence=_ASSUMED)
    ways = options_of(_allowed(all_readings(drawing, options.depth_ratio), options), wire=obj.lines == "wire")
    if options.reading > len(ways):
        if len(ways) == 1:
            raise UsageError("there is only one reading of this drawing", remedy="--necker for its mirror image")
        remedy = f"--reading with a number from 1 to {len(ways)}"
        raise UsageError(f"there are only {len(ways)} readings of this drawing", remedy=remedy)
    chosen = options.reading - 1
    sized = [_sized(shape, options) for shape in _tidied(ways, drawing, options)]
    others = tuple(
        Alternative(way.reading.name, way.mirrored, s.projection(picture_size), s.dimensions, round(way.probability, 4))
        for k, (way, s) in enumerate(zip(ways, sized, strict=True))
        if k != chosen
    )
    solid = _solid(sized[chosen], drawing, options, picture_size)
    return replace(solid, confidence=sureness(ways, chosen), alternatives=others)


def _allowed(readings: list[Reading], options: LiftOptions) -> list[Reading]:
    """The readings of the projection asked for; if there are none, those of all parallel ones, the likeliest first."""
    if options.projection == "auto":
        return readings
    return [r for r in readings if r.family == options.projection] or [r for r in readings if r.family != "perspective"]


def _tidied(ways: list[Option], drawing: Drawing, options: LiftOptions) -> list[Shape]:
    """The shapes made regular, with what is to be said about them."""
    done: dict[tuple[int, float], Shape] = {}
    shapes: list[Shape] = []
    for way in ways:
        shape = _described(way, drawing, options)
        if shape.bent is not None:
            shape = exact_arcs(shape, regular=options.beautify)
        elif options.beautify and shape.free_axis == 2:  # another one is made with right angles
            shape = _regular(shape, way, done)
        mirrored = (way.mirrored != options.necker) != _from_behind(drawing, shape)
        shapes.append(_mirrored(shape) if mirrored else shape)
    return shapes


def _regular(shape: Shape, way: Option, done: dict[tuple[int, float], Shape]) -> Shape:
    """The shape made regular; oblique readings that differ in depth alone share their face, mirrored ones all."""
    oblique = shape.family == "oblique"
    key = id(way.shape.flat if oblique else way.shape), shape.taper
    if key not in done:
        done[key] = beautified(shape)
    fine = done[key]
    return replace(shape, flat=fine.flat, evidence={**fine.evidence, **shape.evidence}) if oblique else fine


def _from_behind(drawing: Drawing, shape: Shape) -> bool:
    """Is the front face of a round or pointed object that tapers the far one?

    Where the drawing does not tell, things are seen from above: it is drawn below the smaller end where the object
    stands, and above it where it lies.
    """
    if shape.taper >= 1.0 or shape.free_axis != 2 or not (drawing.pointed or drawing.bent):
        return False
    if drawing.front is not None:
        return drawing.front == "f2"
    right, down = (drawing.second.mean(axis=0) - drawing.middle(drawing.first)).tolist()
    plumb = abs(right) <= _PLUMB * abs(down)
    return down < 0 if plumb else down > 0 and drawing.pointed


def _described(way: Option, drawing: Drawing, options: LiftOptions) -> Shape:
    """The shape with its evidence and warnings."""
    shape, r = way.shape, drawing.relation
    warnings = list(shape.warnings)
    if options.projection == "perspective" and shape.family != "perspective":
        warnings.append("nothing converges: read as a parallel view")
    if shape.taper != 1.0 and not shape.pointed and shape.bent is None:
        times = f"{shape.taper:.2f} times the front face"
        warnings.append(f"the back face is {times}: taken as a tapered object with a straight axis")
    evidence = {
        "reading": way.reading.name,
        "log_odds": round(min(max(way.reading.odds, -1e3), 1e3), 2),
        "translation_rms_px": round(r.translation_rms, 3),
        "homothety_rms_px": round(r.homothety_rms, 3),
        "face_scale": round(r.scale, 4),
    }
    return replace(shape, evidence={**evidence, **shape.evidence}, warnings=tuple(warnings))


@dataclass(frozen=True)
class _Sized:
    """A shape and the sizes it shall have.

    shape    : it, in pixels
    vertices : (2m, 3) its vertices in the viewer's axes, pixels
    looks    : (3, 3) unit rows: right, up and away of it set upright, in the viewer's axes
    own      : (3,) width, height and depth, pixels
    factors  : (3,) what they are to be multiplied by
    warnings : what is to be said about the sizes
    """

    shape: Shape
    vertices: Floats
    looks: Floats
    own: Floats
    factors: Floats
    warnings: tuple[str, ...]

    @property
    def dimensions(self) -> tuple[float, float, float]:
        """Width, height and depth in the unit asked for."""
        width, height, depth = (self.own * self.factors).tolist()
        return width, height, depth

    def projection(self, picture_size: tuple[int, int] | None) -> Projection:
        """How it is projected."""
        seen = {} if picture_size is None else {"picture_size": [int(n) for n in picture_size]}
        return Projection(self.shape.family, {**self.shape.evidence, **seen})


def _sized(shape: Shape, options: LiftOptions) -> _Sized:
    vertices = shape.vertices
    if shape.bent is None and not shape.pointed:
        through = _through(vertices)
        edges, extremes = edge_vectors(vertices[: len(shape.flat)], shape.sizes), vertices
    else:
        through = shape.depth * shape.pose[2]
        edges, extremes = shape.edges, shape.boundary.extremes(shape.pose)
    looks = standing(own_axes(edges, through))
    if shape.bent is not None:
        extremes = shape.boundary.extremes(looks)
    deep = int(np.abs(looks @ through).argmax())
    own = np.ptp(extremes @ looks.T, axis=0)
    loose = int(np.abs(looks @ shape.pose[shape.free_axis]).argmax())  # not `deep`: of a box others may be the faces
    factors, warnings = measured(own, loose if shape.free else None, options, deep if shape.arcs else None)
    return _Sized(shape, vertices, looks, own, factors, (*shape.warnings, *warnings))


def _solid(sized: _Sized, drawing: Drawing, options: LiftOptions, picture_size: tuple[int, int] | None) -> Solid:
    """The solid in the size, unit and frame asked for."""
    looks, shape = sized.looks, sized.shape
    turn = frame(looks, options.up)
    place = np.eye(4)
    place[:3, :3] = turn @ (looks.T * sized.factors) @ looks
    moved, origin = sized.vertices @ place[:3, :3].T, np.zeros(3)
    if options.up != "camera":
        straight = shape.bent is None and not shape.pointed
        reach = moved if straight else shape.placed_boundary(moved, place[:3, :3]).extremes(np.eye(3))
        origin = 0.5 * (reach.min(axis=0) + reach.max(axis=0))
        height = 2 if options.up == "z" else 1
        origin[height] = reach[:, height].min()
        place[:3, 3] = -origin
    boundary = shape.placed_boundary(moved - origin, place[:3, :3], -origin)
    camera = drawing.to_picture @ shape.camera @ np.linalg.inv(place)
    return Solid(
        boundary,
        sized.projection(picture_size),
        options.solid_unit,
        sized.warnings,
        looks @ turn.T,
        options.up,
        camera / np.linalg.norm(camera[2]),
    )


def _degenerate(drawing: Drawing) -> str | None:
    """Why no depth or no face can be read off, if so."""
    outer = drawing.outer
    off = drawing.second.mean(axis=0) - drawing.middle(drawing.first)
    if drawing.pointed and float(np.hypot(*off)) < _FLAT * drawing.diagonal:
        return "the point is drawn over the middle of its base"
    if np.hypot(*drawing.relation.d) < _FLAT * drawing.diagonal and drawing.relation.translation_rms < (
        _FLAT * drawing.diagonal
    ):
        return "the two faces coincide in the drawing"
    if ring_area(outer) < _EDGE_ON * float((np.ptp(outer, axis=0) ** 2).sum()):
        return "the face is seen from its edge"
    return None


def _default(drawing: Drawing, problem: str) -> Shape:
    """The face as drawn, as deep as half its mean extent."""
    face = drawing.first
    depth = 0.25 * float(np.ptp(face, axis=0).sum()) or 1.0
    warning = f"{problem}: taken as facing the viewer, with half its mean extent as depth"
    still, origin = np.eye(3), np.zeros(3)
    camera = along_a_vector(drawing.relation.d / depth)
    shape = Shape(
        "oblique", face, still, origin, depth, camera, np.eye(2), drawing.sizes, free=True, warnings=(warning,)
    )
    return exact_arcs(replace(shape, bent=drawing.bent, pointed=drawing.pointed), regular=False)


def _mirrored(shape: Shape) -> Shape:
    """The other reading of the same drawing: near and far exchanged."""
    flip = np.array([1.0, 1.0, -1.0])
    pose = shape.pose * flip
    pose[2] *= -1.0
    camera = shape.camera * np.append(flip, 1.0)
    return replace(shape, pose=pose, origin=shape.origin * flip, depth=-shape.depth, camera=camera)


def _through(vertices: Floats) -> Floats:
    """(3,) from the middle of the front face to the middle of the back face."""
    half = len(vertices) // 2
    between: Floats = vertices[half:].mean(axis=0) - vertices[:half].mean(axis=0)
    return between
