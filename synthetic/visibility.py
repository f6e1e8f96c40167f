"""Which parts of an object's edges a viewer sees: exact for flat faces, holes included.

Strategy. Every face (two caps with holes, one quadrilateral for each edge of each ring) is a plane region, and the
depth key of a `View` is affine in the picture on it. An edge can change between seen and hidden only where its picture
crosses the picture of another face's border or where it pierces a face; between those places one test point decides.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sketch2shape.model import Floats, ring_edges

Interval = tuple[float, float]


@dataclass(frozen=True)
class Face:
    """A flat face in the picture.

    rings : outer border and holes, each (k, 2) picture points
    plane : (3,) depth key = plane . (x, y, 1)
    """

    rings: tuple[Floats, ...]
    plane: Floats

    def contains(self, point: Floats) -> bool:
        """Whether a picture point lies inside, by crossing parity over all rings."""
        inside = False
        for r in self.rings:
            a, b = r, np.roll(r, -1, 0)
            spans = (a[:, 1] > point[1]) != (b[:, 1] > point[1])
            with np.errstate(divide="ignore", invalid="ignore"):
                x = a[:, 0] + (point[1] - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
            inside ^= bool(np.count_nonzero(spans & (x > point[0])) % 2)
        return inside


def faces_of(projected: Floats, sizes: list[int]) -> list[Face]:
    """Faces of a two-face object from its projected vertices (2m, 3): x, y, depth key; `sizes` of rings, sum m."""
    half = sum(sizes)
    starts = np.cumsum([0, *sizes])
    caps = [[np.arange(s, s + n) + back for s, n in zip(starts, sizes, strict=False)] for back in (0, half)]
    sides = []
    for s, n in zip(starts, sizes, strict=False):
        for i in range(n):
            a, b = s + i, s + (i + 1) % n
            sides.append([np.array([a, b, b + half, a + half])])
    found = [face_of(projected, rings) for rings in caps + sides]
    return [f for f in found if f is not None]


def face_of(projected: Floats, rings: list[np.ndarray]) -> Face | None:
    """None for a face seen edge-on: it hides nothing."""
    points = projected[np.concatenate(rings)]
    centred = points[:, :2] - points[:, :2].mean(0)
    spread = np.linalg.svd(centred, compute_uv=False)
    if spread[1] < 1e-6 * spread[0]:
        return None
    system = np.c_[points[:, :2], np.ones(len(points))]
    plane = np.linalg.lstsq(system, points[:, 2], rcond=None)[0]
    return Face(tuple(projected[r, :2] for r in rings), plane)


def seen_intervals(projected: Floats, sizes: list[int]) -> list[tuple[int, int, list[Interval]]]:
    """For each edge (a, b): the intervals of 0..1 from a to b (along the picture) that are not hidden."""
    return seen_parts(projected, faces_of(projected, sizes), [(int(a), int(b)) for a, b in ring_edges(sizes)])


def seen_parts(
    projected: Floats, faces: list[Face], edges: list[tuple[int, int]]
) -> list[tuple[int, int, list[Interval]]]:
    """The same for any edges among any flat faces."""
    size = float(np.ptp(projected[:, :2], axis=0).max())
    depth = float(np.ptp(projected[:, 2])) or 1.0
    low = np.array([np.min([r.min(0) for r in f.rings], axis=0) for f in faces]).reshape(-1, 2)
    high = np.array([np.max([r.max(0) for r in f.rings], axis=0) for f in faces]).reshape(-1, 2)
    out = []
    for a, b in edges:
        ends = projected[[a, b], :2]
        # A face whose box the edge does not reach neither cuts nor hides it.
        near = np.flatnonzero((low <= ends.max(0)).all(1) & (high >= ends.min(0)).all(1))
        out.append((a, b, _seen(projected[a], projected[b], [faces[k] for k in near], size, depth)))
    return out


def _seen(a: Floats, b: Floats, faces: list[Face], size: float, depth: float) -> list[Interval]:
    length = float(np.linalg.norm(b[:2] - a[:2]))
    if length < 1e-9 * size:
        return []
    cuts = np.unique(np.concatenate([np.array([0.0, 1.0]), *(_events(a, b, f) for f in faces)]))
    seen: list[Interval] = []
    for t0, t1 in pairwise(cuts):
        if t1 - t0 < 1e-9:
            continue
        middle = a + (b - a) * (t0 + t1) / 2
        if any(_before(f, middle, depth) for f in faces):
            continue
        if seen and abs(seen[-1][1] - t0) < 1e-6:
            seen[-1] = (seen[-1][0], float(t1))
        else:
            seen.append((float(t0), float(t1)))
    return seen


def _before(face: Face, point: Floats, depth: float) -> bool:
    """Whether the face lies between the viewer and the point (x, y, key)."""
    key = float(face.plane @ np.array([point[0], point[1], 1.0]))
    return key < point[2] - 1e-6 * depth and face.contains(point[:2])


def _events(a: Floats, b: Floats, face: Face) -> Floats:
    """Parameters in 0..1 where the picture of a-b crosses the face's border, or the edge pierces the face's plane."""
    found = []
    d = b[:2] - a[:2]
    for r in face.rings:
        p, e = r, np.roll(r, -1, 0) - r
        cross = d[0] * e[:, 1] - d[1] * e[:, 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            t = ((p[:, 0] - a[0]) * e[:, 1] - (p[:, 1] - a[1]) * e[:, 0]) / cross
            s = ((p[:, 0] - a[0]) * d[1] - (p[:, 1] - a[1]) * d[0]) / cross
        found.append(t[np.isfinite(t) & (t > 0) & (t < 1) & (s > -1e-9) & (s < 1 + 1e-9)])
    key_a, key_b = (face.plane @ np.array([p[0], p[1], 1.0]) - p[2] for p in (a, b))
    if key_a * key_b < 0:
        found.append(np.array([key_a / (key_a - key_b)]))
    return np.concatenate(found)
