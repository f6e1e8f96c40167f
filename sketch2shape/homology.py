"""The plane map that carries the front face of a two-face object onto its back face.

In every projection the two faces are related by a planar homology: all connecting lines pass through one centre V, and
lines of the face meet their images on one axis. With homogeneous points it is ``H = I + v a^T``, v the centre and a
the axis. A parallel view of a prism gives a translation, a parallel view of a frustum (and a one-point perspective
seen face on) a similarity about the centre, any other perspective the general case (Hartley and Zisserman, Multiple
View Geometry, section A7.2).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats


def apply(maps: Floats, points: Floats) -> Floats:
    """Points (k, 2) under maps (..., 3, 3): (..., k, 2). Points sent to infinity come back as inf."""
    q = np.c_[points, np.ones(len(points))] @ np.swapaxes(maps, -1, -2)
    w = q[..., 2:]
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(w > 1e-9, q[..., :2] / w, np.inf)


def translation(d: Floats) -> Floats:
    """(..., 3, 3) from vectors (..., 2)."""
    maps = np.zeros((*d.shape[:-1], 3, 3))
    maps[..., [0, 1, 2], [0, 1, 2]] = 1.0
    maps[..., :2, 2] = d
    return maps


def similarity(src: Floats, dst: Floats) -> Floats:
    """Best x -> s x + t with s > 0 (no rotation), (..., 3, 3), for corresponding points (..., k, 2)."""
    a, b = src - src.mean(axis=-2, keepdims=True), dst - dst.mean(axis=-2, keepdims=True)
    s = np.maximum((a * b).sum(axis=(-2, -1)) / ((a * a).sum(axis=(-2, -1)) + 1e-12), 1e-3)
    maps = translation(dst.mean(axis=-2) - s[..., None] * src.mean(axis=-2))
    maps[..., 0, 0] = maps[..., 1, 1] = s
    return maps


def homology(src: Floats, dst: Floats) -> Floats:
    """Homology through corresponding points (..., k, 2), k >= 3: (..., 3, 3).

    The centre is the point nearest to all connecting lines, the axis follows by least squares.
    """
    shift = src.mean(axis=-2, keepdims=True)
    size = np.maximum(np.abs(src - shift).max(axis=(-2, -1), keepdims=True), 1e-9)
    p, q = _homogeneous((src - shift) / size), _homogeneous((dst - shift) / size)
    lines = np.cross(p, q)
    _, _, vt = np.linalg.svd(lines)
    v = vt[..., -1, :][..., None, :]
    qv = np.cross(q, v)
    amount = -(np.cross(q, p) * qv).sum(axis=-1) / ((qv * qv).sum(axis=-1) + 1e-12)
    axis = (np.linalg.pinv(p) @ amount[..., None])[..., 0]
    core = np.eye(3) + np.swapaxes(v, -1, -2) * axis[..., None, :]
    norm = translation(-shift[..., 0, :])
    norm[..., :2, :] /= size
    back = translation(shift[..., 0, :])
    back[..., 0, 0] = back[..., 1, 1] = size[..., 0, 0]
    maps: Floats = back @ core @ norm
    return maps


def _homogeneous(points: Floats) -> Floats:
    return np.concatenate([points, np.ones((*points.shape[:-1], 1))], axis=-1)
