"""Right prisms in perspective: camera, pose and true face from the drawing.

With the principal point assumed, the drawing of a right prism leaves one number free, the focal length. In calibrated
coordinates r (a pixel minus the principal point, over the focal length, with a third coordinate 1) the front face
lies in the plane N . X = 1, so X1 = r1 / (N . r1), and the back face is X2 = X1 + depth N. Hence r2 is proportional to
r1 + depth (N . r1) N: a homology with three unknowns, fitted by Gauss-Newton for many focal lengths at a time. The
focal length is then the one that fits the drawing and makes the face regular.

Two places are tried for the principal point: the middle of the object (one looks at what one draws) and level with the
meeting point of the connecting edges (a two-point drawing: the line of sight is level, uprights stay parallel). A prism
that faces the viewer (one-point drawing) shows its true face, and its focal length not at all.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sketch2shape.lifting.evidence import converging_odds, shaking
from sketch2shape.lifting.projection import Drawing
from sketch2shape.lifting.regularity import (
    Relations,
    bearings,
    candidates,
    find_edge_relations,
    find_relations,
    score,
    uneven_odds,
)
from sketch2shape.lifting.roundness import circle_odds
from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats

#: focal length over the diagonal of the object's picture: the usual value and its spread (of the logarithm)
USUAL_FOCAL, _FOCAL_SPREAD = 1.9, 0.4

#: focal lengths tried, over the diagonal
_FOCALS = np.geomspace(0.7, 8.0, 24)

#: focal lengths tried in turn near the best of them, over it
_NEARER = np.geomspace(0.9, 1.0 / 0.9, 13)

#: Gauss-Newton steps: the start is good
_STEPS = 3

_TWO, _THREE = np.arange(2), np.arange(3)

#: depth over the distance of the front face beyond which a reading is nonsense
_DEEPEST = 20.0


@dataclass(frozen=True)
class Cameras:
    """Candidate cameras and the prism each sees.

    focal  : (g,) pixels
    centre : (g, 2) principal point, pixels
    normal : (g, 3) unit normal of the faces, away from the viewer
    depth  : (g,) distance between the faces, front face at distance 1 along the normal; negative if f2 is nearer
    rss    : (g,) sum of squared residuals of the fit, pixels^2
    """

    focal: Floats
    centre: Floats
    normal: Floats
    depth: Floats
    rss: Floats


@dataclass(frozen=True)
class Seen:
    """Prisms as candidate cameras see them.

    cameras   : g of them
    shapes    : (g, m, 2) true face
    maps      : (g, 2, 2) linear part of drawing -> true face
    odds      : (g,) log odds, -inf where the camera sees no prism
    usual     : (g,) how usual each camera is
    relations : what could be regular about the face
    """

    cameras: Cameras
    shapes: Floats
    maps: Floats
    odds: Floats
    usual: Floats
    relations: Relations | None

    @property
    def best(self) -> int:
        """The likeliest."""
        return int(self.odds.argmax())

    @property
    def whole(self) -> float:
        """Log odds of there being such a camera."""
        top = float(self.odds.max())
        return top + math.log(float(np.exp(self.odds - top).sum() / self.usual.sum()))


def seen_by_cameras(drawing: Drawing) -> Seen:
    """The right prism as each of the usual cameras sees it."""
    middle = np.concatenate([drawing.first, drawing.second]).mean(axis=0)
    return _seen(drawing, *_candidates(drawing.relation.centre, middle, drawing.diagonal))


def perspective_shape(drawing: Drawing, seen: Seen | None = None) -> Shape | None:
    """The right prism seen by the best camera, its focal length refined; None if no camera sees one.

    seen : what `seen_by_cameras` gives, if that is known already
    """
    seen = seen or seen_by_cameras(drawing)
    best = seen.best
    if not np.isfinite(seen.odds[best]):
        return None
    level = best >= len(_FOCALS)
    near = seen.cameras.focal[best] * _NEARER
    fine = _seen(drawing, near, np.repeat(seen.cameras.centre[best : best + 1], len(near), axis=0), seen.relations)
    if fine.odds.max() >= seen.odds[best]:
        seen, best = fine, fine.best
    cameras, first = seen.cameras, drawing.first
    pose = np.array([*(axis[best] for axis in _plane(cameras.normal)), cameras.normal[best]])
    # the drawn and the true object shall have about one size
    size = float(np.linalg.norm(np.ptp(first, axis=0)))
    size /= float(np.linalg.norm(np.ptp((seen.shapes[best] @ pose[:2])[:, :2], axis=0)))
    evidence = {
        "focal_px": round(float(cameras.focal[best]), 1),
        "principal_point": [round(float(c), 1) for c in cameras.centre[best]],
        "vanishing_point": _finite(drawing.relation.centre),
        "log_odds": round(float(seen.odds[best]), 2),
        "level_line_of_sight": level,
        "fit_rms_px": round(float(np.sqrt(cameras.rss[best] / (2.0 * first.size))), 3),
    }
    return Shape(
        "perspective",
        seen.shapes[best] * size,
        pose,
        pose[2] * size,
        float(cameras.depth[best]) * size,
        _pinhole(float(cameras.focal[best]), cameras.centre[best], 0.0),
        seen.maps[best] * size,
        drawing.sizes,
        evidence=evidence,
    )


def _seen(drawing: Drawing, focal: Floats, centre: Floats, relations: Relations | None = None) -> Seen:
    """The prism as cameras of these focal lengths (g,) and principal points (g, 2) see it.

    relations : what could be regular about its face, if that is known already
    """
    first = drawing.first
    one, two = (_rays(face, focal, centre) for face in (first, drawing.second))
    cameras = _fit(one, two, focal, centre, drawing.relation.centre)
    shapes, maps = _true_faces(first, _front(one, two, cameras), cameras)
    usual = np.exp(-0.5 * (np.log(focal / drawing.diagonal / USUAL_FOCAL) / _FOCAL_SPREAD) ** 2)
    possible = np.isfinite(cameras.rss) & np.isfinite(shapes).all(axis=(1, 2)) & (np.abs(cameras.depth) < _DEEPEST)
    if not possible.any():
        return Seen(cameras, shapes, maps, np.full(len(focal), -np.inf), usual, relations)
    shapes, maps = np.where(possible[:, None, None], shapes, 0.0), np.where(possible[:, None, None], maps, np.eye(2))
    rss = np.where(possible, 0.5 * cameras.rss, np.inf)
    noise = shaking(float(rss.min()), 2 * len(first) - 4, drawing.noise)
    if relations is None:
        relations = relations_of(drawing, first, shapes[int(rss.argmin())], noise)
    found = candidates(relations, shapes, maps)
    odds = score(relations, found, bearings(relations, found, noise), noise) + np.log(usual)
    for arc in drawing.bent.arcs if drawing.bent else ():
        odds[possible] += circle_odds(shapes[possible][:, arc.rows], first[arc.rows], noise)
    odds += converging_odds(rss, drawing.relation, drawing.noise)
    depth = np.abs(cameras.depth) / max(float(np.hypot(*drawing.relation.d)), 1e-9)
    least, most = np.maximum(found.area / found.stretch, 1e-12), found.stretch
    odds += uneven_odds(np.maximum(most, depth) / np.maximum(np.minimum(least, depth), 1e-12))
    return Seen(cameras, shapes, maps, odds, usual, relations)


def relations_of(drawing: Drawing, drawn: Floats, shape: Floats, noise: float) -> Relations:
    """What could be regular about the face; of one with arcs, about its straight edges.

    drawn : (m, 2) the face as drawn, pixels
    shape : (m, 2) the same in a shape in which parallel edges are parallel, of any size
    noise : standard deviation of a drawn vertex, pixels
    """
    if drawing.bent is None:
        return find_relations(shape, drawing.sizes, drawn, noise)
    scale = float(np.linalg.norm(np.ptp(drawn, axis=0)) / np.linalg.norm(np.ptp(shape, axis=0)))
    return find_edge_relations(scale * shape, drawing.bent.ends, 0, noise)


def facing_shape(drawing: Drawing, face: Floats) -> Shape:
    """A prism that faces the viewer: the face (m, 2) as drawn, the depth from an assumed focal length.

    The back face is drawn z1 / (z1 + depth) times as large as the front face, with z1 the focal length if the front
    face is to keep its size in pixels. Nothing in the drawing tells that focal length.
    """
    r = drawing.relation
    focal = USUAL_FOCAL * drawing.diagonal
    middle = r.shift / (1.0 - r.scale)
    depth = focal * (1.0 / r.scale - 1.0)
    evidence = {"focal_px": round(focal, 1), "vanishing_point": [round(float(c), 1) for c in middle]}
    warning = (
        f"one vanishing point: a focal length of {USUAL_FOCAL} times the object's picture is assumed; "
        "it could also be a tapered object (projection oblique)"
    )
    return Shape(
        "perspective",
        face,
        np.eye(3),
        np.zeros(3),
        depth,
        _pinhole(focal, middle, focal) @ _shifted(-middle),
        np.eye(2),
        drawing.sizes,
        free=True,
        evidence=evidence,
        warnings=(warning,),
    )


def _pinhole(focal: float, centre: Floats, away: float) -> Floats:
    """(3, 4) camera with this focal length and principal point, that far before the origin."""
    return np.array(
        [[focal, 0.0, centre[0], centre[0] * away], [0.0, focal, centre[1], centre[1] * away], [0, 0, 1, away]]
    )


def _shifted(by: Floats) -> Floats:
    """(4, 4) shift to the side."""
    shift = np.eye(4)
    shift[:2, 3] = by
    return shift


def _finite(point: Floats) -> list[float] | None:
    """A homogeneous point in pixels, None if it is too far away to matter."""
    if abs(point[2]) < 1e-7 * float(np.hypot(point[0], point[1])):
        return None
    return [round(float(c), 1) for c in point[:2] / point[2]]


def _candidates(meeting: Floats, middle: Floats, diagonal: float) -> tuple[Floats, Floats]:
    """Focal lengths (g,) and principal points (g, 2) to try."""
    focals = _FOCALS * diagonal
    points = [middle]
    if abs(meeting[1]) < 20.0 * diagonal * abs(meeting[2]) + 20.0 * abs(meeting[0]) and meeting[2] != 0.0:
        points.append(np.array([middle[0], meeting[1] / meeting[2]]))
    return np.tile(focals, len(points)), np.repeat(np.array(points), len(focals), axis=0)


def _rays(points: Floats, focal: Floats, centre: Floats) -> Floats:
    """(g, m, 3) calibrated coordinates of (m, 2) pixels."""
    flat = (points[None] - centre[:, None]) / focal[:, None, None]
    return np.concatenate([flat, np.ones((*flat.shape[:2], 1))], axis=2)


def _fit(one: Floats, two: Floats, focal: Floats, centre: Floats, meeting: Floats) -> Cameras:
    """Fit normal and depth for each camera, from the rays (g, m, 3) of both faces."""
    start = np.stack(
        [
            (meeting[0] - centre[:, 0] * meeting[2]) / focal,
            (meeting[1] - centre[:, 1] * meeting[2]) / focal,
            np.full(len(focal), meeting[2]),
        ],
        axis=1,
    )
    normal = start / np.linalg.norm(start, axis=1, keepdims=True)
    normal *= np.where((one @ normal[:, :, None]).mean(axis=(1, 2)) < 0, -1.0, 1.0)[:, None]
    depth = _first_depth(one, two, normal)
    sign = np.where(depth < 0, -1.0, 1.0)
    m = normal * np.sqrt(np.abs(depth))[:, None]
    rss = np.full(len(focal), np.inf)
    for _ in range(_STEPS):
        residual, jacobian = _transfer(one, two, m, sign, focal)
        rss = (residual**2).sum(axis=1)
        across = np.swapaxes(jacobian, 1, 2)
        square = across @ jacobian
        own = square[:, _THREE, _THREE]
        square[:, _THREE, _THREE] = own + np.maximum(1e-10 * own.sum(axis=1), 1e-22)[:, None]
        step = np.linalg.solve(square, across @ residual[..., None])[..., 0]
        m = m - np.where(np.isfinite(step), step, 0.0)
    size = np.linalg.norm(m, axis=1)
    normal = m / np.maximum(size, 1e-12)[:, None]
    facing = (one @ normal[:, :, None])[..., 0]
    good = (facing.min(axis=1) > 0.02) | (facing.max(axis=1) < -0.02)
    normal = normal * np.sign(facing[:, :1])
    return Cameras(focal, centre, normal, sign * size**2, np.where(good & np.isfinite(rss), rss, np.inf))


def _first_depth(one: Floats, two: Floats, normal: Floats) -> Floats:
    """(g,) depth by linear least squares, the normal known: two x (one + depth (one . normal) normal) = 0."""
    (x, y, _), (u, v, _) = one.transpose(2, 0, 1), two.transpose(2, 0, 1)
    a, b, c = normal.T[:, :, None]
    facing = a * x + b * y + c
    base = np.stack([v - y, x - u, u * y - v * x])
    way = np.stack([c * v - b, a - c * u, b * u - a * v]) * facing
    depth: Floats = -(base * way).sum(axis=(0, 2)) / np.maximum((way * way).sum(axis=(0, 2)), 1e-18)
    return depth


def _transfer(one: Floats, two: Floats, m: Floats, sign: Floats, focal: Floats) -> tuple[Floats, Floats]:
    """Residuals (g, 2m) of the back face, pixels, and their derivatives (g, 2m, 3) by m."""
    facing = one @ m[:, :, None]
    signed = sign[:, None, None] * facing
    point = one + signed * m[:, None]
    z = point[..., 2:]
    z = np.where(np.abs(z) < 1e-6, 1e-6, z)
    flat = point[..., :2] / z
    residual = (flat - two[..., :2]) * focal[:, None, None]
    # the point moves by sign (facing change + m (one . change)); what is seen of that is left of the line of sight
    jacobian = (m[:, None, :2] - flat * m[:, None, 2:])[..., None] * one[:, :, None]
    jacobian[..., _TWO, _TWO] += facing
    jacobian[..., 2] -= flat * facing
    jacobian *= ((sign * focal)[:, None, None] / z)[..., None]
    g = len(m)
    return residual.reshape(g, -1), jacobian.reshape(g, -1, 3)


def _true_faces(first: Floats, front: Floats, cameras: Cameras) -> tuple[Floats, Floats]:
    """(g, m, 2) the face in its own plane, second axis down, and (g, 2, 2) the mean linear map from the drawing.

    first : (m, 2) the face as drawn, pixels
    front : (g, m, 3) where it is in space
    """
    shapes = front @ np.stack(_plane(cameras.normal), axis=2)
    centred = first - first.mean(axis=0)
    maps = np.linalg.pinv(centred) @ (shapes - shapes.mean(axis=1, keepdims=True))
    return shapes, maps


def _front(one: Floats, two: Floats, cameras: Cameras) -> Floats:
    """(g, m, 3) front face: the mean of what both drawn faces say, by their rays (g, m, 3)."""
    normal, depth = cameras.normal[:, None], cameras.depth[:, None, None]
    column = cameras.normal[:, :, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        near = one / (one @ column)
        far = two / (two @ column) * (1.0 + depth) - depth * normal
    mean: Floats = 0.5 * (near + far)
    return mean


def _plane(normal: Floats) -> tuple[Floats, Floats]:
    """Unit axes (g, 3) of each plane: one that looks level, and the one that looks down across it."""
    x, y, z = normal.T
    size = np.maximum(np.hypot(y, z), 1e-12)
    down = np.stack([np.zeros_like(x), z / size, -y / size], axis=1)
    right = np.stack([size, -x * y / size, -x * z / size], axis=1)
    return right, down
