"""The paper's step 5, and further: the edges of a two-face object from the vertices of both faces.

The second face is the first one moved (a prism in a parallel drawing) or moved and scaled about a vanishing point
(one-point perspective, or a frustum). So the faces must agree: each vertex has its partner, and both rings have the
same order.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sketch2shape.connectors.connection import Connection
from sketch2shape.connectors.points import check_points
from sketch2shape.connectors.polygon import canonical, ring_edges_of, ring_is_simple
from sketch2shape.connectors.split_faces import Placement, match, placements
from sketch2shape.connectors.stage import connect_detailed
from sketch2shape.errors import PointsError
from sketch2shape.geometry import size_of
from sketch2shape.model import Floats, Ints

#: log odds against a split for each step of its misfit: the noise of one corner, as a part of the size
MISFIT = 0.006


@dataclass(frozen=True)
class FaceConnection:
    """The edges of a two-face object.

    points        : (2n, 2) float, the first face's points then the second's, or as given if they came unlabelled
    first, second : (n,) indices into points in ring order; first[i] joins second[i]
    scale, shift  : the second face is scale * first + shift, shift (2,) in units of the points
    misfit        : rms distance from that, units of the points
    face          : how the ring was found
    violated      : what does not hold, in words
    alternatives  : other splits of unlabelled points that fit about as well, best first
    """

    points: Floats
    first: Ints
    second: Ints
    scale: float
    shift: Floats
    misfit: float
    face: Connection
    violated: tuple[str, ...] = ()
    alternatives: tuple[tuple[Ints, Ints], ...] = ()

    @property
    def edges(self) -> Ints:
        """(3n, 2) indices into points: first face's ring, second face's ring, connecting edges."""
        joins = np.column_stack((self.first, self.second))
        return np.concatenate((ring_edges_of(self.first), ring_edges_of(self.second), joins))

    @property
    def sureness(self) -> float | None:
        """0..1 probability that the ring's order is right, for methods that can tell."""
        return self.face.sureness


def connect_faces(f1: ArrayLike, f2: ArrayLike | None = None, method: str = "auto", **parameters: Any) -> Ints:
    """Edges of the two-face object whose faces have the vertices f1 and f2.

    f1, f2     : (n, 2) vertices of each face in any order; or f1 alone: the (2n, 2) vertices of both, unlabelled
    method     : connector for the rings, a name from `methods()`
    parameters : what that method takes

    Returns (3n, 2) indices into the rows of f1 followed by those of f2: n edges of the first ring, n of the second, n
    between corresponding vertices. Raises PointsError if the faces differ in size, if unlabelled points are not two
    copies of one face, or as `connect` does.
    """
    return connect_faces_detailed(f1, f2, method, **parameters).edges


def connect_faces_detailed(
    f1: ArrayLike, f2: ArrayLike | None = None, method: str = "auto", **parameters: Any
) -> FaceConnection:
    """As `connect_faces`, but also say how the faces correspond, what does not hold, and which other splits fit."""
    if f2 is None:
        return _from_unlabelled(check_points(f1), method, parameters)
    first, second = check_points(f1, method=method), check_points(f2, method=method)
    if len(first) != len(second):
        raise PointsError(f"expected two faces of the same number of vertices, got {len(first)} and {len(second)}")
    points = np.concatenate((first, second))
    if method == "split-walk":
        return _by_rank(points, parameters)
    return _ordered(points, match(first, second), method, parameters)


def _by_rank(points: Floats, parameters: dict[str, Any]) -> FaceConnection:
    """As in the paper: the i-th vertex of the first face's walk joins the i-th of the second's."""
    n = len(points) // 2
    faces = [connect_detailed(half, "split-walk", **parameters) for half in (points[:n], points[n:])]
    first, second = faces[0].order, faces[1].order + n
    fitted = Placement.fitted(points, first, second)
    best = match(points[:n], points[n:])
    violated = faces[0].violated
    if fitted.misfit > best.misfit + 1e-9 * size_of(points):
        violated = (*violated, "joining by rank does not fit one common displacement: the faces are split differently")
    return FaceConnection(points, first, second, fitted.scale, fitted.shift, fitted.misfit, faces[0], violated)


def _ordered(points: Floats, placement: Placement, method: str, parameters: dict[str, Any]) -> FaceConnection:
    """Order the first face and carry the order over to the second."""
    first, second = points[placement.first], points[placement.second]
    if method == "auto":  # both copies are evidence for one face
        face = connect_detailed((first + (second - placement.shift) / placement.scale) / 2, method, **parameters)
        violated = face.violated
    else:
        face = connect_detailed(first, method, **parameters)
        other = connect_detailed(second, method, **parameters)
        violated = face.violated
        if canonical(face.order) != canonical(other.order):
            violated = (*violated, "the method orders the two faces differently: the first face's order is used")
    if not ring_is_simple(second[face.order]):
        violated = (*violated, "the second ring crosses or touches itself")
    return FaceConnection(
        points, placement.first[face.order], placement.second[face.order], placement.scale, placement.shift,
        placement.misfit, face, violated,
    )  # fmt: skip


def _from_unlabelled(points: Floats, method: str, parameters: dict[str, Any]) -> FaceConnection:
    if len(points) % 2:
        raise PointsError(f"expected an even number of unlabelled points, got {len(points)}")
    if len(points) < 6:
        raise PointsError(f"expected at least 6 unlabelled points (two triangles), got {len(points)}")
    found = [_ordered(points, placement, method, parameters) for placement in placements(points)]
    if not found:
        raise PointsError(
            f"expected two copies of one face, moved or scaled, got {len(points)} points that do not split so",
            remedy="give the faces separately: connect_faces(f1, f2)",
        )
    ranked = sorted(found, key=lambda answer: _doubt(answer, size_of(points)))
    best = ranked[0]
    limit = _doubt(best, size_of(points)) + 1.0
    rivals = [answer for answer in ranked[1:] if _doubt(answer, size_of(points)) <= limit]
    if not rivals:
        return best
    said = (*best.violated, f"{len(rivals)} other splits of the points fit about as well")
    return FaceConnection(
        points, best.first, best.second, best.scale, best.shift, best.misfit, best.face, said,
        tuple((answer.first, answer.second) for answer in rivals),
    )  # fmt: skip


def _doubt(answer: FaceConnection, size: float) -> float:
    """Lower is better: the misfit in noise steps, crossings, and how unsure the order is."""
    crossing = 0.0 if answer.face.simple and answer.face.complete else 100.0
    sureness = answer.face.sureness if answer.face.sureness is not None else 1.0
    return (answer.misfit / (MISFIT * size)) ** 2 / 2 + crossing - float(np.log(max(sureness, 1e-9)))
