"""A shaded view of solids with their edges, painted in plain NumPy: no GPU, no display, the same bytes on each run.

Strategy: a depth buffer, kept as nearness 1/z because that is what varies linearly over a triangle in perspective
(Blinn, "Hyperbolic Interpolation", 1992). Each triangle is filled over its own bounding box; concave solids come out
right because depth is decided point by point. Edges are then walked in small steps and drawn where nothing is nearer.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.model import Answer, Bools, Floats, Ints, Solid, TwoFaceObject
from sketch2shape.pictures.canvas import Pixels
from sketch2shape.pictures.facets import Surface, stand, surface
from sketch2shape.pictures.palette import BACKDROP, INK, MUTED, PAPER, SHADE, mix

_OVERSAMPLE = 2
_DISTANCE = 4.2  # camera distance in radii of the scene: mild perspective
_LIGHT = np.array([-0.45, -0.8, -0.55]) / np.linalg.norm([-0.45, -0.8, -0.55])


@dataclass(frozen=True)
class _Scene:
    """Points on the enlarged screen: xy (v, 2) pixels, near (v,) 1/distance, and the turned vertices (v, 3)."""

    xy: Floats
    near: Floats
    turned: Floats


def preview(
    solids: Sequence[Solid],
    size: tuple[int, int] = (960, 720),
    *,
    drawing: TwoFaceObject | None = None,
    view: tuple[float, float] | None = None,
) -> Pixels:
    """The solids, set up as the first one is drawn.

    size    : width, height, pixels
    drawing : what the first solid was lifted from; the picture then shows the sides that the drawing shows
    view    : how far the viewer walks to the right and up, degrees; None: as `drawing` tells

    Returns (height, width, 3) uint8 RGB.
    """
    w, h = size[0] * _OVERSAMPLE, size[1] * _OVERSAMPLE
    image = _backdrop(w, h)
    if solids:
        up = stand(solids[0], drawing)
        shape, rotation = surface(solids, up.rotation), turn(*(view or up.view))
        scene = _project(shape.vertices, rotation, w, h)
        if (rotation @ [0, 1, 0])[2] > -1e-9:  # from below the floor would hide the solid
            image = _shadow(image, shape, rotation)
        depth = _fill(image, shape, scene)
        _draw_edges(image, shape, scene, depth)
    return cv2.resize(image, size, interpolation=cv2.INTER_AREA).astype(np.uint8)


def preview_of(result: Answer, size: tuple[int, int] = (960, 720)) -> Pixels:
    """The result's solids from the side that the drawing shows; see `preview`."""
    return preview(result.solids, size, drawing=result.objects[0] if result.objects else None)


def turn(yaw: float, pitch: float) -> Floats:
    """(3, 3) rotation of the scene for a viewer who walked `yaw` degrees to the right and `pitch` up."""
    a, b = np.radians([-yaw, -pitch])
    about_y = np.array([[np.cos(a), 0, -np.sin(a)], [0, 1, 0], [np.sin(a), 0, np.cos(a)]])
    about_x = np.array([[1, 0, 0], [0, np.cos(b), np.sin(b)], [0, -np.sin(b), np.cos(b)]])
    return np.asarray(about_x @ about_y)


def _backdrop(w: int, h: int) -> Pixels:
    """White above, a breath of grey below."""
    part = np.linspace(0, 1, h)[:, None, None]
    column = np.array(PAPER) * (1 - part) + np.array(mix(BACKDROP, MUTED, 0.12)) * part
    return np.rint(np.broadcast_to(column, (h, w, 3))).astype(np.uint8)


def _project(points: Floats, rotation: Floats, w: int, h: int, like: Floats | None = None) -> _Scene:
    """Project points, framed so that `like` (or they themselves) fill the screen."""
    frame = points if like is None else like
    centre = (frame.min(axis=0) + frame.max(axis=0)) / 2
    radius = float(np.linalg.norm(frame - centre, axis=1).max()) or 1.0

    def screen(p: Floats) -> tuple[Floats, Floats, Floats]:
        turned = (p - centre) / radius @ rotation.T
        near = 1 / (turned[:, 2] + _DISTANCE)
        return turned[:, :2] * near[:, None], near, turned

    seen = screen(frame)[0]
    low, high = seen.min(axis=0), seen.max(axis=0)
    zoom = 0.78 * float(np.min(np.array([w, h]) / np.maximum(high - low, 1e-9)))
    xy, near, turned = screen(points)
    return _Scene((xy - (low + high) / 2) * zoom + np.array([w, h]) / 2, near, turned)


def _shadow(image: Pixels, shape: Surface, rotation: Floats) -> Pixels:
    """Darken the floor, the level of the lowest vertex, where the solid stands in the light's way."""
    h, w = image.shape[:2]
    floor = shape.vertices[:, 1].max()
    light = np.array([0.32, 1.0, 0.2])  # falls steeply, so that the shadow stays near the solid
    drop = (floor - shape.vertices[:, 1])[:, None] / light[1]
    on_floor = _project(shape.vertices + drop * light, rotation, w, h, like=shape.vertices).xy
    mask = np.zeros((h, w), np.uint8)
    for triangle in np.clip(on_floor, -8000, 8000)[shape.triangles]:
        cv2.fillConvexPoly(mask, np.rint(triangle * 16).astype(np.int32), 255, cv2.LINE_8, 4)
    soft = cv2.GaussianBlur(mask, (0, 0), max(w, h) / 110).astype(np.float64)[..., None] / 255
    return np.rint(image * (1 - 0.2 * soft) + np.array(INK) * 0.2 * soft).astype(np.uint8)


def _fill(image: Pixels, shape: Surface, scene: _Scene) -> Floats:
    """Paint all triangles, nearest on top; returns the (h, w) nearness of what is seen (0 where nothing is)."""
    h, w = image.shape[:2]
    depth = np.zeros((h, w))
    for triangle in shape.triangles:
        _fill_triangle(image, depth, scene.xy[triangle], scene.near[triangle], _shade(scene.turned[triangle]))
    return depth


def _shade(corners: Floats) -> Floats:
    """(3,) colour of a flat facet: paler towards the light, as seen from outside or inside alike."""
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    length = float(np.linalg.norm(normal))
    if length == 0:
        return np.array(SHADE, float)
    normal = normal / length
    view = corners.mean(axis=0) + np.array([0, 0, _DISTANCE])
    if normal @ view > 0:
        normal = -normal
    light = 0.5 + 0.5 * float(normal @ _LIGHT)
    return np.array(mix(mix(SHADE, INK, 0.42), mix(SHADE, PAPER, 0.62), light), float)


def _fill_triangle(image: Pixels, depth: Floats, xy: Floats, near: Floats, colour: Floats) -> None:
    """Paint one triangle where it is the nearest, by barycentric coordinates over its bounding box."""
    h, w = depth.shape
    x0, y0 = np.maximum(np.floor(xy.min(axis=0)).astype(int), 0)
    x1, y1 = np.minimum(np.ceil(xy.max(axis=0)).astype(int) + 1, [w, h])
    (ax, ay), (bx, by), (cx, cy) = xy
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if abs(area) < 1e-9 or x0 >= x1 or y0 >= y1:
        return
    x, y = np.arange(x0, x1)[None, :], np.arange(y0, y1)[:, None]
    u = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
    v = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
    here = near[0] + u * (near[1] - near[0]) + v * (near[2] - near[0])
    patch = depth[y0:y1, x0:x1]
    seen = (u >= -1e-6) & (v >= -1e-6) & (u + v <= 1 + 1e-6) & (here > patch)
    patch[seen] = here[seen]
    image[y0:y1, x0:x1][seen] = np.rint(colour).astype(np.uint8)


def _draw_edges(image: Pixels, shape: Surface, scene: _Scene, depth: Floats) -> None:
    """Draw hidden edges thin and dashed, then visible ones on top."""
    width = max(image.shape[:2]) / 480
    edges = np.concatenate([shape.edges, _outline(shape, scene)])
    runs = [(edge, *run) for edge in edges for run in _edge_runs(scene, edge, depth)]
    for edge, start, stop, seen in sorted(runs, key=lambda r: bool(r[3])):
        ends = scene.xy[edge]
        along = ends[1] - ends[0]
        length = float(np.linalg.norm(along))
        if seen:
            _stroke(image, ends[0] + start * along, ends[0] + stop * along, INK, width)
            continue
        step = 6 * width
        for k in range(int(start * length / step), int(stop * length / step) + 1):
            a, b = max(start, (k + 0.2) * step / length), min(stop, (k + 0.65) * step / length)
            if a < b:
                _stroke(image, ends[0] + a * along, ends[0] + b * along, mix(SHADE, INK, 0.45), width / 2)


def _outline(shape: Surface, scene: _Scene) -> Ints:
    """(c, 2) the edges within curved sides at which these turn away from the viewer."""
    if not len(shape.contours):
        return shape.contours[:, :2]
    a, b, c = scene.xy[shape.triangles].swapaxes(0, 1)
    toward = cross(b - a, c - a) > 0
    beside = toward[shape.contours[:, 2:]]
    return shape.contours[beside[:, 0] != beside[:, 1], :2]


def _edge_runs(scene: _Scene, edge: Floats, depth: Floats) -> list[tuple[float, float, bool]]:
    """Pieces (from, to, seen) of an edge, 0..1 along it."""
    h, w = depth.shape
    ends = scene.xy[edge]
    count = int(np.clip(np.linalg.norm(ends[1] - ends[0]) / 2, 2, 4000))
    t = (np.arange(count) + 0.5) / count
    at = np.rint(ends[0] + t[:, None] * (ends[1] - ends[0])).astype(int)
    near = scene.near[edge[0]] + t * (scene.near[edge[1]] - scene.near[edge[0]])
    # the farthest of the surroundings decides: beside an edge in view there is always something not nearer than it
    around = [depth[np.clip(at[:, 1] + dy, 0, h - 1), np.clip(at[:, 0] + dx, 0, w - 1)] for dx, dy in _AROUND]
    seen: Bools = near >= np.min(around, axis=0) - 2e-4
    cuts = [0, *(np.flatnonzero(np.diff(seen)) + 1), count]
    return [(a / count, b / count, bool(seen[a])) for a, b in pairwise(cuts)]


_AROUND = [(dx, dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]


def _stroke(image: Pixels, a: Floats, b: Floats, colour: tuple[int, int, int], width: float) -> None:
    p, q = (tuple(int(v) for v in np.rint(e * 16)) for e in (a, b))
    cv2.line(image, p, q, colour, max(1, round(width)), cv2.LINE_AA, 4)
