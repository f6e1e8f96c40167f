"""How the two faces of a drawing are related: the three nested families and how well each fits.

The faces of a two-face object lie in parallel planes and their connecting lines meet in one point or are parallel, so
their images are always related by a planar homology (Hartley and Zisserman, Multiple View Geometry, section A7.2): its
centre is the image of the connecting direction, its axis the vanishing line of the faces. Special cases are the
homothety (axis at infinity: a frustum in a parallel view, or a prism facing the viewer in perspective) and the
translation (both at infinity: a prism in a parallel view).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sketch2shape.model import Bools, Floats


@dataclass(frozen=True)
class FaceRelation:
    """Translation, homothety and homology fitted to f1 -> f2; rms is of one coordinate of one vertex, pixels.

    first, second   : (m, 2) the corresponding vertices, pixels
    d               : (2,) translation, pixels
    translation_rms : residual of the translation
    scale, shift    : homothety f2 = scale * f1 + shift, (2,) pixels
    homothety_rms   : residual of the homothety
    """

    first: Floats
    second: Floats
    d: Floats
    translation_rms: float
    scale: float
    shift: Floats
    homothety_rms: float

    @cached_property
    def _meeting(self) -> tuple[Floats, float]:
        # most drawings are parallel and never ask
        return _meeting_point(self.first, self.second)

    @property
    def centre(self) -> Floats:
        """(3,) homogeneous point where the connecting lines meet, unit vector."""
        return self._meeting[0]

    @property
    def centre_rms(self) -> float:
        """Residual of the connecting lines, as if one coordinate of each vertex were off."""
        return self._meeting[1]


def relate_faces(first: Floats, second: Floats, known: Bools | None = None) -> FaceRelation:
    """Fit the families to corresponding vertices.

    first, second : (m, 2) pixels
    known         : (m,) which pairs count; all if fewer than three do

    Residuals are per vertex of either face: a pair's difference has twice the variance of one vertex.
    """
    if known is not None and int(known.sum()) >= 3:
        first, second = first[known], second[known]
    m = len(first)
    middle, far = first.sum(axis=0) / m, second.sum(axis=0) / m
    a, b = (first - middle).ravel(), (second - far).ravel()
    spread, off, apart = float(a @ a), b - a, 2.0 * (2 * m - 2)
    scale = float(a @ b) / spread if spread > 0 else 1.0
    left = b - scale * a
    homothety = math.sqrt(float(left @ left) / ((1.0 + scale**2) * max(2 * m - 3, 1)))
    translation = math.sqrt(float(off @ off) / apart)
    return FaceRelation(first, second, far - middle, translation, scale, far - scale * middle, homothety)


def _meeting_point(first: Floats, second: Floats) -> tuple[Floats, float]:
    """Least-squares common point of the connecting lines, homogeneous, and the rms distance by which they miss it.

    The residual of a line is how far its two vertices must be moved across it, so long and short lines weigh alike in
    pixels; two reweighted passes are enough.
    """
    middle = 0.5 * (first + second).mean(axis=0)
    size = float(max(np.abs(first - middle).max(), np.abs(second - middle).max())) or 1.0
    p, q = (first - middle) / size, (second - middle) / size
    (px, py), (qx, qy) = p.T, q.T
    lines = np.stack([py - qy, qx - px, px * qy - py * qx])
    x, y, z = 0.0, 0.0, 1.0
    weight = np.ones(len(p))
    for _ in range(3):
        rows = lines * weight
        x, y, z = np.linalg.eigh(rows @ rows.T)[1][:, 0].tolist()
        # moving p and q by e across the line changes line . point by about e * hypot(|q - point|, |p - point|)
        reach = (px * z - x) ** 2 + (py * z - y) ** 2 + (qx * z - x) ** 2 + (qy * z - y) ** 2
        weight = 1.0 / np.maximum(np.sqrt(reach), 1e-9)
    off = (x * lines[0] + y * lines[1] + z * lines[2]) * weight
    rms = float(np.sqrt((off @ off) / max(len(p) - 2, 1))) * size
    moved = np.array([x * size + middle[0] * z, y * size + middle[1] * z, z])
    return moved / np.sqrt(moved @ moved), rms
