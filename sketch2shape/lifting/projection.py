"""A two-face object made ready for lifting: its faces, how they are related, and how shaky its vertices are."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sketch2shape.lifting.bent import Bent, bent_faces
from sketch2shape.lifting.face_relation import FaceRelation, relate_faces
from sketch2shape.model import Bools, Floats, Ints, Side, TwoFaceObject

#: least standard deviation of a drawn vertex, pixels: nothing is known better than this
_LEAST_NOISE = 0.3

#: how much more a hand shakes its vertices than its lines shake about their own middles, which is what is told
_UNSEEN = 1.5

#: the vertices of a four-sided object, numbered f1 then f2, by its other two pairs of opposite sides
OTHER_PAIRS = (
    np.array([0, 1, 5, 4, 3, 2, 6, 7]),
    np.array([1, 2, 6, 5, 0, 3, 7, 4]),
)


@dataclass(frozen=True)
class Drawing:
    """A two-face object ready for lifting.

    first, second : (m, 2) pixels, all rings of either face
    sizes         : vertices of each ring
    relation      : how the faces are related
    noise         : standard deviation assumed of a drawn vertex, pixels
    diagonal      : size of the whole object, pixels
    known         : (m,) bool, where f2 was seen, not inferred
    hidden        : do dashed or missing lines tell which face is in front?
    to_picture    : (3, 3) homography from these pixels to those of the picture
    bent          : how the points belong together where some edges are arcs; then points on these follow the vertices
    pointed       : does the object come to a point? All of the second face is then there
    front         : the nearer face of a round or pointed object, where the drawing tells it
    """

    first: Floats
    second: Floats
    sizes: list[int]
    relation: FaceRelation
    noise: float
    diagonal: float
    known: Bools
    hidden: bool
    to_picture: Floats
    bent: Bent | None = None
    pointed: bool = False
    front: Side | None = None

    @property
    def is_box(self) -> bool:
        """Has each face four straight sides, so that any two opposite sides could be the faces?"""
        return self.sizes == [4] and self.bent is None and not self.pointed

    @property
    def outer(self) -> Floats:
        """(n, 2) the first face's outer ring."""
        return self.first[: self.sizes[0]] if self.bent is None else self.first[self.bent.outline]

    def middle(self, face: Floats) -> Floats:
        """(2,) what counts as the middle of a face (m, 2): an object tapers towards that of the other face."""
        return np.asarray(face[: self.sizes[0]].mean(axis=0) if self.bent is None else self.bent.middle @ face)

    @cached_property
    def pairs(self) -> list[tuple[Drawing, Ints | None]]:
        """Each pair of opposite sides that can pass for f1 and f2, and its vertices in the old numbers.

        The first is the pair as given, with None; there are two more if the face has four sides and no hole, unless a
        side crosses itself, as that of no solid does.
        """
        found: list[tuple[Drawing, Ints | None]] = [(self, None)]
        if not self.is_box:
            return found
        points = np.concatenate([self.first, self.second])
        seen = np.concatenate([np.ones(4, bool), self.known])
        for order in OTHER_PAIRS:
            first, second = points[order[:4]], points[order[4:]]
            if _is_bow(first) or _is_bow(second):
                return found[:1]
            known = seen[order[:4]] & seen[order[4:]]
            relation = relate_faces(first, second, known)
            found.append((replace(self, first=first, second=second, relation=relation, known=known), order))
        return found


def prepare(obj: TwoFaceObject) -> Drawing:
    """Split an object into what the lifting needs."""
    drawn, bent = _points(obj)
    points, to_picture = _rectified(drawn, obj.page)
    m = len(points) // 2
    first, second = points[:m], points[m:]
    known = np.ones(m, bool)
    if obj.f2_drawn is not None and not obj.is_pointed:
        known[: len(obj.f2_drawn)] = obj.f2_drawn
    relation = relate_faces(first, second, known)
    diagonal = float(np.linalg.norm(np.ptp(points, axis=0)))
    return Drawing(
        first,
        second,
        [len(r.f1) for r in obj.rings],
        relation,
        max(_UNSEEN * float(obj.noise), _LEAST_NOISE),
        max(diagonal, 1e-6),
        known,
        obj.lines != "wire",
        to_picture,
        bent,
        obj.is_pointed,
        obj.front,
    )


def _points(obj: TwoFaceObject) -> tuple[Floats, Bent | None]:
    """(2m, 2) the points of both faces, those on arcs too, and how they belong together."""
    if obj.is_round:
        first, second, bent = bent_faces(obj)
        return np.concatenate([first, second]), bent
    if obj.is_pointed:
        return np.concatenate([obj.f1, np.repeat(obj.f2, len(obj.f1), axis=0)]), None
    return obj.vertices.astype(np.float64), None


def _is_bow(quad: Floats) -> bool:
    """Do two opposite edges of a (4, 2) ring cross?"""
    p = quad.tolist()
    side = [_turn(p[i - 1], p[i], p[(i + 1) % 4]) for i in range(4)]
    return sum(s > 0.0 for s in side) == 2 and sum(s < 0.0 for s in side) == 2


def _turn(a: list[float], b: list[float], c: list[float]) -> float:
    """Twice the signed area of a triangle."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _rectified(points: Floats, page: Floats | None) -> tuple[Floats, Floats]:
    """Points as they lie on the page, if the page was photographed at a tilt, in about their size in the picture.

    With the homography (3, 3) back to the picture. One that sends a point to infinity cannot be that of the page, and
    is ignored.
    """
    if page is None:
        return points, np.eye(3)
    mapped = np.c_[points, np.ones(len(points))] @ np.asarray(page, np.float64).T
    depth = mapped[:, 2]
    if not np.isfinite(mapped).all() or np.abs(depth).min() < 1e-9 or np.ptp(np.sign(depth)) > 0:
        return points, np.eye(3)
    flat: Floats = mapped[:, :2] / depth[:, None]
    size = float(np.linalg.norm(np.ptp(flat, axis=0)))
    if size <= 0.0:
        return points, np.eye(3)
    scale = float(np.linalg.norm(np.ptp(points, axis=0))) / size
    middle, goal = flat.mean(axis=0), points.mean(axis=0)
    place = np.array([[scale, 0.0, goal[0] - scale * middle[0]], [0.0, scale, goal[1] - scale * middle[1]], [0, 0, 1]])
    placed: Floats = (flat - middle) * scale + goal
    back: Floats = np.linalg.inv(place @ np.asarray(page, np.float64))
    return placed, back
