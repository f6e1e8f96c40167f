"""Judging meshes: against the object they come from, against the true solid, and against a true mesh."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from PIL import Image
from scipy.optimize import linear_sum_assignment
from scipy.spatial import cKDTree

from evaluation import metrics
from sketch2shape.model import Floats, Ints

Mesh = Any  # trimesh ships no types that mypy can follow

SAMPLES = 2000
"""Surface points of each mesh whose distance from the other is taken."""
DENSE = 15 * SAMPLES
"""Points that stand for a surface when the distance from it is taken: far closer to each other than `NEAR`."""
NEAR = 0.03
"""Largest distance from the true surface, as a fraction of the object's largest extent."""
NEAR_PIXELS = 2.0
"""Added to that: what the drawing's own lines leave open, pixels."""
ENOUGH = 99
"""Percentage of the samples that must be near."""
AREA = 0.04
"""Largest relative difference of the surface areas."""
FLAT, SHARP = 0.01, 0.2
"""Greatest angle between the triangles of one plane, and least of a sharp edge, radians: facets of a rounding turn by
one between."""
DOT = 2.0
"""Radius of the dots that the drawings of CAD parts have at their vertices, pixels."""
INK = 128
"""Grey level below which a pixel of those drawings is ink."""


def is_sound(mesh: Mesh, vertices: int, holes: int) -> bool:
    """Watertight, outward, of the right genus, with exactly the object's vertices."""
    tight = mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0
    return bool(tight and len(mesh.vertices) == vertices and mesh.euler_number == 2 - 2 * holes)


def overlap(truth: dict[str, Any], answer: dict[str, Any], faces: Ints, match: Ints) -> tuple[float, float]:
    """Intersection over union and Chamfer distance (fraction of the diagonal) of the solids, after alignment.

    faces : (k, 3) triangles over the answer's vertices
    match : (2m,) the true vertex of each answered one

    Not a number where the drawing does not fix the depth, and for faces with holes.
    """
    want = metrics.true_solid(truth)
    if want is None or truth.get("holes") or metrics.family(truth) == "oblique":
        return float("nan"), float("nan")
    got = metrics.nearest_reading(truth, metrics.outer_vertices(truth, answer, match), want)
    pair = [_outward(trimesh.Trimesh(v, match[faces], process=False)) for v in (want, got)]
    common = trimesh.boolean.intersection(pair, engine="manifold").volume
    clouds = [samples(m, SAMPLES) for m in pair]
    apart = [cKDTree(a).query(b)[0].mean() for a, b in (clouds, clouds[::-1])]
    union = sum(m.volume for m in pair) - common
    return float(common / union), float(np.mean(apart) / np.linalg.norm(np.ptp(want, axis=0)))


def _outward(mesh: Mesh) -> Mesh:
    if mesh.volume < 0:
        mesh.invert()
    return mesh


def samples(mesh: Mesh, count: int) -> Floats:
    """(count, 3) points of the surface, evenly spread, always the same."""
    points: Floats = np.asarray(trimesh.sample.sample_surface(mesh, count, seed=0)[0], float)
    return points


def in_picture(mesh: Mesh, camera: list[list[float]] | None) -> Mesh | None:
    """The mesh in the picture's frame: x right and y down in pixels, depth at the same scale.

    camera : (3, 4) solid -> pixels, homogeneous; None where the solid lies in the picture's frame already

    None for a perspective camera: the drawings with a true mesh are parallel views.
    """
    if camera is None:
        return mesh
    rows = np.array(camera, float) / camera[2][3]
    if np.abs(rows[2, :3]).max() > 1e-9:
        return None
    across, down = rows[0, :3], rows[1, :3]
    away = np.cross(across, down)
    away *= np.sqrt(np.linalg.norm(across) * np.linalg.norm(down)) / max(float(np.linalg.norm(away)), 1e-12)
    placed = mesh.vertices @ np.stack([across, down, away]).T + [rows[0, 3], rows[1, 3], 0]
    return trimesh.Trimesh(placed, mesh.faces, process=False)


def true_mesh(file: Path, picture: Path) -> Mesh:
    """The true mesh, seen along z as drawn with y up, laid over the ink of its picture."""
    mesh: Mesh = trimesh.load(file, force="mesh", process=False)
    with Image.open(picture) as opened:
        y, x = np.nonzero(np.asarray(opened.convert("L")) < INK)
    low, high = mesh.vertices[:, :2].min(0), mesh.vertices[:, :2].max(0)
    longer = int(np.argmax(high - low))
    scale = (np.array([np.ptp(x), np.ptp(y)]) - 2 * DOT)[longer] / (high - low)[longer]
    vertices = mesh.vertices * [scale, -scale, scale]
    middle = (vertices[:, :2].min(0) + vertices[:, :2].max(0)) / 2
    vertices[:, :2] += [(x.min() + x.max()) / 2, (y.min() + y.max()) / 2] - middle
    return trimesh.Trimesh(vertices, mesh.faces, process=False)


def corners(truth: Mesh) -> Floats:
    """(k, 2) pixels, where three or more sharp edges of a true mesh meet (see `true_mesh`); none if a side is round."""
    whole = trimesh.Trimesh(truth.vertices, truth.faces)
    angles = whole.face_adjacency_angles
    if ((angles > FLAT) & (angles < SHARP)).any():
        return np.zeros((0, 2))
    sharp = whole.face_adjacency_edges[angles > SHARP]
    met = np.bincount(sharp.ravel(), minlength=len(whole.vertices)) >= 3
    return np.asarray(whole.vertices[met, :2], float)


def has_corners(points: Floats, corners: Floats) -> bool:
    """Whether points (k, 2) lie one to one at these corners (k, 2), pixels, as near as meshes have to."""
    if len(points) != len(corners):
        return False
    apart = np.linalg.norm(points[:, None] - corners, axis=2)
    near = NEAR * float(np.ptp(corners, axis=0).max()) + NEAR_PIXELS
    one, other = linear_sum_assignment(apart)
    return bool(apart[one, other].max(initial=0.0) <= near)


def difference(mesh: Mesh | None, truth: Mesh) -> str:
    """What sets a mesh apart from the true one, in a few words; empty if nothing. Mirrored in depth it is right too."""
    if mesh is None:
        return "read as a perspective drawing"
    if not mesh.is_watertight:
        return "the mesh is not watertight"
    if abs(mesh.area / truth.area - 1) > AREA:
        return f"the area is {mesh.area / truth.area:.2f} of the true one"
    want, got = samples(truth, DENSE), samples(mesh, DENSE)
    limit = NEAR * float(np.ptp(truth.vertices, axis=0).max()) + NEAR_PIXELS
    off = min(_away(want, _facing(got, sign, want)) for sign in (1.0, -1.0))
    return "" if off < limit else f"the surface is off by {off:.0f} px (allowed {limit:.0f})"


def _facing(points: Floats, sign: float, target: Floats) -> Floats:
    """The points, perhaps mirrored, with their depth centred on the target's."""
    placed = points * [1, 1, sign]
    ends = [p[:, 2].min() + p[:, 2].max() for p in (target, placed)]
    moved: Floats = placed + [0, 0, (ends[0] - ends[1]) / 2]
    return moved


def _away(want: Floats, got: Floats) -> float:
    """Distance of the farthest sample but the few that `ENOUGH` lets go, both ways.

    The first samples are a fair part of all: they are drawn independently of each other.
    """
    there, back = cKDTree(want).query(got[:SAMPLES])[0], cKDTree(got).query(want[:SAMPLES])[0]
    return float(max(np.percentile(there, ENOUGH), np.percentile(back, ENOUGH)))
