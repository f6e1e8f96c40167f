"""The plane map that carries the front face of a two-face object onto its back face.

In every projection the two faces are related by a planar homology: all connecting lines pass through one centre V, and
lines of the face meet their images on one axis. With homogeneous points it is ``H = I + v a^T``, v the centre and a
the axis. A parallel view of a prism gives a translation, a parallel view of a frustum (and a one-point perspective
seen face on) a similarity about the centre, any other perspective the general case (Hartley and Zisserman, Multiple
View Geometry, section A7.2).
"""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Bools, Floats


def apply(maps: Floats, points: Floats) -> Floats:
    """Points (k, 2) under maps (..., 3, 3): (..., k, 2). Points sent to infinity come back as inf."""
    q = points @ np.swapaxes(maps[..., :2], -1, -2) + maps[..., None, :, 2]
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
    p, q = src.mean(axis=-2), dst.mean(axis=-2)
    a, b = src - p[..., None, :], dst - q[..., None, :]
    s = np.maximum((a * b).sum(axis=(-2, -1)) / ((a * a).sum(axis=(-2, -1)) + 1e-12), 1e-3)
    maps = translation(q - s[..., None] * p)
    maps[..., 0, 0] = maps[..., 1, 1] = s
    return maps


def similarity_of_seen(src: Floats, dst: Floats, seen: Bools, least: float = 1e-3, most: float = np.inf) -> Floats:
    """`similarity` of the seen (..., k) of corresponding points (..., k, 2): (..., 3, 3); of one a translation.

    least, most : bounds of s
    """
    some, count = seen[..., None], np.maximum(seen.sum(axis=-1), 1)
    p, q = ((points * some).sum(axis=-2) / count[..., None] for points in (src, dst))
    a, b = (src - p[..., None, :]) * some, (dst - q[..., None, :]) * some
    s = np.clip((a * b).sum(axis=(-2, -1)) / ((a * a).sum(axis=(-2, -1)) + 1e-12), least, most)
    s = np.where(count == 1, 1.0, s)
    maps = translation(q - s[..., None] * p)
    maps[..., 0, 0] = maps[..., 1, 1] = s
    return maps


def homology(src: Floats, dst: Floats, weights: Floats | None = None) -> Floats:
    """Homology through corresponding points (..., k, 2), k >= 3: (..., 3, 3).

    weights : (..., k) float, of the points; leading dimensions as of a stack of maps for the same points

    The centre is the point nearest to all connecting lines, the axis follows by least squares.
    """
    shift = src.mean(axis=-2)
    size = np.maximum(np.abs(src - shift[..., None, :]).max(axis=(-2, -1)), 1e-9)[..., None, None]
    p, q = (src - shift[..., None, :]) / size, (dst - shift[..., None, :]) / size
    lines = _cross(p, q)
    turned = np.swapaxes(lines, -1, -2)
    # eigenvectors come in the order of their eigenvalues, the smallest first
    v = np.linalg.eigh((turned if weights is None else turned * weights[..., None, :]) @ lines)[1][..., 0]
    qv, qp = _cross(q, v[..., None, :2], v[..., None, 2:]), _cross(q, p)
    amount = -(qp * qv).sum(axis=-1) / ((qv * qv).sum(axis=-1) + 1e-12)
    at = np.concatenate([p, np.ones((*p.shape[:-1], 1))], axis=-1)
    turned = np.swapaxes(at, -1, -2)
    if weights is not None:
        turned = turned * weights[..., None, :]
    axis = np.linalg.solve(turned @ at + 1e-12 * np.eye(3), turned @ amount[..., None])[..., 0]
    core = np.eye(3) + v[..., :, None] * axis[..., None, :]
    # back from points about the shift, in units of the size
    maps: Floats = core.copy()
    maps[..., :2, 2:] *= size
    maps[..., 2:, :2] /= size
    maps[..., :, 2] -= (maps[..., :2] @ shift[..., None])[..., 0]
    maps[..., :2, :] += shift[..., None] * maps[..., 2:, :]
    return maps


def _cross(p: Floats, q: Floats, last: Floats | float = 1.0) -> Floats:
    """Cross product of the homogeneous points (p, 1) and (q, last)."""
    px, py, qx, qy = p[..., 0], p[..., 1], q[..., 0], q[..., 1]
    w = last if isinstance(last, float) else last[..., 0]
    return np.stack([py * w - qy, qx - px * w, px * qy - py * qx], axis=-1)
