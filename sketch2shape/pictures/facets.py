"""A solid's surface as triangles and drawn edges in one index space, for the pictures and the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sketch2shape.model import Floats, Ints, Solid, TwoFaceObject
from sketch2shape.solids import Tessellation, contour_candidates, smooth_edges, tessellated

YAW, PITCH = 28.0, 22.0
"""Where a viewer stands by default: to the right and above, degrees."""


@dataclass(frozen=True)
class Surface:
    """What a renderer needs of one or several solids.

    vertices  : (v, 3) float, right-handed, x right, y down, z away from the viewer
    triangles : (t, 3) indices, outward by the right-hand rule
    edges     : (e, 2) indices of the edges to draw, arcs by chords; smooth joints are left out
    contours  : (c, 4) indices of the ends of edges within curved sides, and of the triangles on either side: drawn only
                where one of these faces the viewer and the other not
    """

    vertices: Floats
    triangles: Ints
    edges: Ints
    contours: Ints


@dataclass(frozen=True)
class Stand:
    """How a solid is set up to be looked at.

    rotation : (3, 3) from the solid's coordinates to right, down, away, with its own axes along these
    view     : yaw and pitch, degrees, from which it shows the sides that its drawing shows
    """

    rotation: Floats
    view: tuple[float, float]


def surface(solids: Sequence[Solid], rotation: Floats | None = None) -> Surface:
    """The surfaces of the solids, side by side, all turned by the rotation."""
    if not solids:
        none = np.zeros((0, 3), np.intp)
        return Surface(np.zeros((0, 3)), none, none[:, :2], np.zeros((0, 4), np.intp))
    forms = [tessellated(solid.boundary) for solid in solids]
    smooth = [smooth_edges(solid.boundary) for solid in solids]
    starts = np.cumsum([0] + [len(form.vertices) for form in forms[:-1]])
    rows = np.cumsum([0] + [len(form.triangles) for form in forms[:-1]])
    return Surface(
        np.concatenate([form.vertices for form in forms]) @ (np.eye(3) if rotation is None else rotation).T,
        np.concatenate([form.triangles + k for form, k in zip(forms, starts, strict=True)]),
        np.concatenate([_chords(form, left) + k for form, left, k in zip(forms, smooth, starts, strict=True)]),
        np.concatenate(
            [
                contour_candidates(form, left) + [k, k, row, row]
                for form, left, k, row in zip(forms, smooth, starts, rows, strict=True)
            ]
        ),
    )


def _chords(form: Tessellation, left: frozenset[int]) -> Ints:
    """(e, 2) the edges of a solid by chords, without those left out."""
    pieces = [np.stack([path[:-1], path[1:]], axis=1) for k, path in enumerate(form.paths) if k not in left]
    return np.concatenate([np.zeros((0, 2), np.intp), *pieces])


def stand(solid: Solid, drawing: TwoFaceObject | None = None) -> Stand:
    """How to set a solid up: upright as in its drawing, but squarely.

    The linear map that takes the solid's vertices nearest to their places in the drawing (least squares) tells which of
    its directions look right, down and away there; without a drawing its camera tells, or else its coordinates are
    taken to be the viewer's.
    """
    drawn = _drawn_as(solid, drawing)
    looks = np.array([drawn[0], drawn[1], np.cross(drawn[0], drawn[1])])
    along = _own_axes(solid) @ (looks / np.linalg.norm(looks, axis=1, keepdims=True)).T
    axes = _own_axes(solid)
    d = int(np.abs(along[:, 1]).argmax())
    a = max((k for k in range(3) if k != d), key=lambda k: abs(along[k, 2]))
    down, away = axes[d] * np.sign(along[d, 1]), axes[a] * np.sign(along[a, 2])
    return Stand(np.array([np.cross(down, away), down, away]), _view(drawn @ away, float(np.linalg.norm(drawn[0]))))


def _drawn_as(solid: Solid, drawing: TwoFaceObject | None) -> Floats:
    """(2, 3) linear map from the solid's directions to those of the drawing."""
    default = np.array([[1.0, 0.0, 0.35], [0.0, 1.0, -0.35]])
    if drawing is None or len(drawing.vertices) != len(solid.vertices) or solid.boundary.is_round:
        return default if solid.camera is None else _seen_by(solid.camera, solid.boundary.extremes(np.eye(3)).mean(0))
    space = solid.vertices - solid.vertices.mean(axis=0)
    plane = drawing.vertices - drawing.vertices.mean(axis=0)
    drawn = np.linalg.lstsq(space, plane, rcond=None)[0].T
    return np.asarray(drawn) if np.linalg.matrix_rank(drawn, 1e-6) == 2 else default


def _seen_by(camera: Floats, point: Floats) -> Floats:
    """(2, 3) how directions at a point (3,) appear in the picture of a camera (3, 4)."""
    x, y, w = camera @ np.append(point, 1.0)
    return np.asarray((camera[:2, :3] - np.outer([x / w, y / w], camera[2, :3])) / w)


def _own_axes(solid: Solid) -> Floats:
    """(3, 3) rows: the solid's own directions, those of its coordinates if it has none that span space."""
    axes = np.eye(3) if solid.axes is None else solid.axes
    return axes if abs(np.linalg.det(axes)) > 0.5 else np.eye(3)


def _view(away: Floats, size: float) -> tuple[float, float]:
    """Yaw and pitch from which depth runs as in the drawing: `away` for a depth of one, `size` for a width of one."""
    length = float(np.hypot(*away))
    if length < 0.03 * size:
        return YAW, PITCH  # drawn from straight ahead
    right, up = np.clip(np.array([away[0], -away[1]]) / length / 0.4, -1, 1)
    return round(float(right) * YAW, 1), round(float(up) * PITCH, 1)
