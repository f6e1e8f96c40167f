"""The stage itself: tell the projection apart, lift, tidy, measure and turn."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.errors import PointsError
from sketch2shape.lifting.beautify import beautified
from sketch2shape.lifting.box import is_box_like, lean, receding, simplest_pair, standing_pairs, true_pair
from sketch2shape.lifting.face import ring_area
from sketch2shape.lifting.frame import own_axes, upright
from sketch2shape.lifting.measure import measured
from sketch2shape.lifting.options import LiftOptions
from sketch2shape.lifting.parallel import axonometric_maps, axonometric_shape, oblique_shape
from sketch2shape.lifting.perspective import facing_shape, perspective_shape, seen_by_cameras
from sketch2shape.lifting.projection import Drawing, converges, kind_of, prepare
from sketch2shape.lifting.reading import ParallelReading, read_parallel, refined_pose
from sketch2shape.lifting.regularity import find_relations
from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats, Ints, Projection, Solid, TwoFaceObject, two_face_boundary

#: a connecting vector shorter than this part of the object's size says nothing about the depth
_FLAT = 0.01

#: a face with less area than this part of its diagonal squared is seen from its edge
_EDGE_ON = 0.004

#: vertices are never taken as shakier than this part of the object's diagonal
_SHAKIEST = 0.02

#: log odds by which a prism in perspective, turned a little, must be likelier than a frustum
_RATHER = 2.0

#: log odds that a degree of lean costs a prism over a parallelogram
_LEAN = 0.12

#: a face drawn smaller than this, all facing the viewer, is a tapered object's, not a far one's
_FAR_SCALE = 0.64


def lift(
    obj: TwoFaceObject, *, picture_size: tuple[int, int] | None = None, options: LiftOptions | None = None
) -> Solid:
    """The solid that a two-face object is a drawing of.

    obj          : the object in the picture's plane; f1 is taken as the front face (see `choose_front`)
    picture_size : width and height of the picture, pixels; kept in the evidence
    options      : what the user fixes

    The solid has one vertex for each of `obj.vertices`, in that order. Unless `options.up` is given its axes are the
    viewer's: x right, y down, z away. What the drawing leaves free is set to a default that `Solid.warnings` states.

    Raises PointsError if a coordinate is not finite.
    """
    options = options or LiftOptions()
    if not np.isfinite(obj.vertices).all():
        raise PointsError("a vertex of the object is not a finite number")
    drawing = prepare(obj)
    shape = _read(drawing, options)
    if options.beautify:
        shape = beautified(shape, max(shape.noise, drawing.noise))
    if options.necker:
        shape = _mirrored(shape)
    shape = measured(shape, options)
    vertices = shape.vertices
    axes = own_axes(vertices[: len(shape.flat)], _through(vertices), shape.sizes)
    if options.up is not None:
        vertices, axes = upright(vertices, axes, options.up)
    evidence = dict(shape.evidence)
    if picture_size is not None:
        evidence["picture_size"] = [int(n) for n in picture_size]
    projection = Projection(shape.family, evidence)
    boundary = two_face_boundary(vertices, shape.sizes)
    return Solid(boundary, projection, options.solid_unit, shape.warnings, axes)


def _read(drawing: Drawing, options: LiftOptions) -> Shape:
    """The shape shown, by the family that fits or the one imposed."""
    problem = _degenerate(drawing)
    if problem:
        return _default(drawing, problem)
    pair, order = simplest_pair(drawing)
    if order is not None:
        pair, order = _front_first(pair, order, drawing.relation.d)
        shape = _by_kind(pair, options)
        return replace(shape, order=order if shape.order is None else order[shape.order])
    return _by_kind(drawing, options)


def _by_kind(drawing: Drawing, options: LiftOptions) -> Shape:
    """The shape of a drawing whose faces are the ones meant."""
    kind, evidence = kind_of(drawing)
    shape: Shape | None = None
    if kind == "converging" and options.projection in ("auto", "perspective"):
        shape = _converging(drawing, sure=options.projection == "perspective")
        kind = "parallel" if shape is None else kind
    if shape is None and kind == "scaled":
        shape = _scaled(drawing, options)
    if shape is None:
        shape = _parallel(drawing, options, taper=1.0)
        if options.projection == "perspective":
            shape = replace(shape, warnings=(*shape.warnings, "nothing converges: read as a parallel view"))
        elif kind == "converging":
            shape = replace(shape, warnings=(*shape.warnings, "the drawing converges, which was ignored"))
    return replace(shape, evidence={**evidence, **shape.evidence})


@dataclass(frozen=True)
class _Pair:
    """A pair of opposite sides taken as front and back face of a parallel drawing.

    drawing   : with this pair as its faces
    order     : number of each vertex in the object, None for the pair as given
    face, d   : (m, 2) the face as both drawn ones have it, (2,) the connecting vector, pixels
    reading   : how likely it is oblique, and axonometric
    """

    drawing: Drawing
    order: Ints | None
    face: Floats
    d: Floats
    reading: ParallelReading


def _parallel(drawing: Drawing, options: LiftOptions, taper: float) -> Shape:
    """Oblique or axonometric, whichever is more likely; a frustum if `taper` is not 1."""
    # two faces that should be alike tell how shaky the hand was, better than the lines do
    residual = drawing.relation.translation_rms if taper == 1.0 else drawing.relation.homothety_rms
    noise = max(drawing.noise, min(residual, _SHAKIEST * drawing.diagonal))
    box = taper == 1.0 and is_box_like(replace(drawing, noise=noise)) and len(drawing.pairs) == 3
    pairs = [_read_pair(replace(p, noise=noise), order, taper) for p, order in drawing.pairs[: 3 if box else 1]]
    drawing = pairs[0].drawing
    true, likeliest = pairs[true_pair(drawing) if box else 0], pairs[0]
    if box:
        likeliest = max((pairs[k] for k in standing_pairs(drawing)), key=lambda p: p.reading.axonometric - _leaning(p))
    odds = true.reading.oblique - max(p.reading.axonometric for p in pairs)
    oblique = odds >= 0 if options.projection not in ("oblique", "axonometric") else options.projection == "oblique"
    chosen = true if oblique else likeliest
    turned, order = chosen.drawing, chosen.order
    face, d = chosen.face, chosen.d
    if order is not None:
        turned, order = _front_first(turned, order, drawing.relation.d)
        face, d = _mean_face(turned, taper)
    if oblique:
        shape = oblique_shape(face, drawing.sizes, d, options.depth_ratio, noise)
    else:
        pose = refined_pose(chosen.reading)
        shape = axonometric_shape(face, drawing.sizes, pose.turned(d), pose.slant)
    own = chosen.reading.oblique if oblique else chosen.reading.axonometric
    evidence = {"log_odds": _rounded_odds(own), "oblique_log_odds": _rounded_odds(odds), **shape.evidence}
    return replace(shape, taper=taper, order=order, noise=noise, evidence=evidence)


def _read_pair(drawing: Drawing, order: Ints | None, taper: float) -> _Pair:
    face, d = _mean_face(drawing, taper)
    relations = find_relations(face, drawing.sizes, face, drawing.noise)
    return _Pair(drawing, order, face, d, read_parallel(face, d, relations, drawing.noise))


def _leaning(pair: _Pair) -> float:
    """Log odds that a pair's face, seen at its slant, costs for being no rectangle."""
    return _LEAN * lean(pair.face @ axonometric_maps(np.array([pair.reading.pose.slant]), pair.d)[0])


def _rounded_odds(odds: float) -> float:
    return round(min(max(odds, -1e3), 1e3), 2)


def _front_first(pair: Drawing, order: Ints, d: Floats) -> tuple[Drawing, Ints]:
    """Another pair of a box's sides with the nearer one in front; d is the connecting vector of the pair as given."""
    chosen, swapped = receding(pair, d)
    return chosen, np.roll(order, 4) if swapped else order


def _converging(drawing: Drawing, sure: bool) -> Shape | None:
    """A prism in perspective; a box by the likeliest pair of its sides. None if it explains no more than shaking would.

    sure : it is known to be in perspective
    """
    readings = [(seen_by_cameras(pair), pair, order) for pair, order in drawing.pairs if _meets(pair, drawing)]
    seen, pair, order = max(readings, key=lambda r: float(r[0].odds.max()))
    shape = perspective_shape(pair, seen)
    if shape is None:
        return None
    rss = 2.0 * drawing.first.size * float(shape.evidence["fit_rms_px"]) ** 2
    if not sure and not converges(drawing, rss):
        return None
    return replace(shape, order=order)


def _meets(pair: Drawing, given: Drawing) -> bool:
    """Do the connecting edges of this pair of sides meet in one point, about as well as those of the pair given?"""
    return pair.relation.centre_rms <= 3.0 * max(given.relation.centre_rms, given.noise)


def _scaled(drawing: Drawing, options: LiftOptions) -> Shape:
    """Faces alike but of two sizes: a prism that faces the viewer in perspective, or a tapered object."""
    scale = drawing.relation.scale
    tapered = _parallel(drawing, options, taper=scale)
    far = min(scale, 1.0 / scale) >= _FAR_SCALE and not (drawing.hidden and scale > 1.0)
    if options.projection == "perspective" or (options.projection == "auto" and far and tapered.family == "oblique"):
        return facing_shape(drawing)
    if options.projection == "auto" and tapered.family == "axonometric":
        turned = _converging(drawing, sure=True)
        if turned is not None and turned.evidence["log_odds"] > tapered.evidence["log_odds"] + _RATHER:
            return turned
    note = f"the back face is {scale:.2f} times the front face: taken as a tapered object with a straight axis"
    return replace(tapered, warnings=(*tapered.warnings, note))


def _mean_face(drawing: Drawing, taper: float) -> tuple[Floats, Floats]:
    """(m, 2) the face as both drawn ones have it, and (2,) the vector between their centres, pixels."""
    n = drawing.sizes[0]
    first, second, known = drawing.first, drawing.second, drawing.known
    if taper == 1.0:
        d = drawing.relation.d
        weight = 0.5 * known[:, None]
        return first + weight * (second - d - first), d
    back = (second - drawing.relation.shift) / taper
    weight = taper**2 / (1.0 + taper**2) * known[:, None]
    face = first + weight * (back - first)
    middle = face[:n].mean(axis=0)
    return face, taper * middle + drawing.relation.shift - middle


def _degenerate(drawing: Drawing) -> str | None:
    """Why no depth or no face can be read off, if so."""
    outer = drawing.first[: drawing.sizes[0]]
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
    return Shape("oblique", face, still, origin, depth, np.eye(2), drawing.sizes, free=True, warnings=(warning,))


def _mirrored(shape: Shape) -> Shape:
    """The other reading of the same drawing: near and far exchanged."""
    flip = np.array([1.0, 1.0, -1.0])
    pose = shape.pose * flip
    pose[2] *= -1.0
    return replace(shape, pose=pose, origin=shape.origin * flip, depth=-shape.depth)


def _through(vertices: Floats) -> Floats:
    """(3,) from the middle of the front face to the middle of the back face."""
    half = len(vertices) // 2
    between: Floats = vertices[half:].mean(axis=0) - vertices[:half].mean(axis=0)
    return between
