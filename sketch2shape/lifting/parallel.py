"""Prisms in parallel drawings: oblique, where the face has its true shape, and axonometric, where it is foreshortened.

In an orthographic view of a right prism the connecting vector d is the image of the face's normal. With t along d and n
across it, the true face is the drawn one stretched by 1 / cos(slant) along t, its depth |d| / sin(slant): one unknown.
"""

from __future__ import annotations

import math

import numpy as np

from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats

#: drawn over true length of the receding edges of a cabinet drawing, the commonest oblique one
CABINET = 0.5

#: the same of a cavalier drawing
CAVALIER = 1.0

#: log odds of a cavalier drawing against a cabinet one
_CAVALIER = -1.1

#: how likely the depth is as long as some edge, how far off such lengths are drawn, and the range of their logarithm
_SAME, _SLOPPY, _RANGE = 0.4, 0.015, 3.0

_ROOT_TWO_PI = math.sqrt(2.0 * math.pi)


def axonometric_maps(slants: Floats, d: Floats) -> Floats:
    """(g, 2, 2) maps from the drawn face to the true one, in the picture's own directions: stretched along d."""
    t = d / np.hypot(*d)
    along = np.outer(t, t)
    return np.eye(2) + (1.0 / np.cos(slants) - 1.0)[:, None, None] * along


def axonometric_shape(face: Floats, sizes: list[int], d: Floats, slant: float) -> Shape:
    """The right prism drawn so in an orthographic view; see `reading.read_parallel`, slant in radians."""
    length = float(np.hypot(*d))
    t = d / length
    n = np.array([-t[1], t[0]])
    along = np.array([*(t * np.cos(slant)), -np.sin(slant)])
    across = np.array([*n, 0.0])
    pose = np.array([t[0] * along + n[0] * across, t[1] * along + n[1] * across, [*(t * np.sin(slant)), np.cos(slant)]])
    stretch = axonometric_maps(np.array([slant]), d)[0]
    middle = face[: sizes[0] or len(face)].mean(axis=0)
    flat = (face - middle) @ stretch
    evidence = {"slant_deg": round(float(np.rad2deg(slant)), 2), "foreshortening": round(float(np.cos(slant)), 4)}
    depth = length / float(np.sin(slant))
    camera = along_a_vector(np.zeros(2))
    return Shape("axonometric", flat, pose, np.array([*middle, 0.0]), depth, camera, stretch, sizes, evidence=evidence)


def along_a_vector(d: Floats) -> Floats:
    """(3, 4) parallel camera that sees right and down as they are, and each unit away as the vector d (2,)."""
    camera = np.zeros((3, 4))
    camera[0, 0] = camera[1, 1] = camera[2, 3] = 1.0
    camera[:2, 2] = d
    return camera


def oblique_shape(face: Floats, sizes: list[int], d: Floats, ratio: float, *, free: bool) -> Shape:
    """The face as drawn, with the depth that the ratio of drawn to true receding lengths gives.

    free : is the ratio only assumed?
    """
    evidence = {
        "depth_ratio": ratio,
        "receding_deg": round(float(np.rad2deg(np.arctan2(-d[1], d[0]))), 2),
    }
    depth = float(np.hypot(*d)) / ratio
    camera = along_a_vector(d / depth)
    return Shape("oblique", face, np.eye(3), np.zeros(3), depth, camera, np.eye(2), sizes, free=free, evidence=evidence)


def cavalier_odds(edges: Floats, length: float, noise: float) -> float:
    """Log odds of a cavalier against a cabinet drawing: which one makes the depth as long as edges of the face?

    edges  : (e,) lengths of the face's edges, pixels
    length : of the receding edges, pixels
    noise  : standard deviation of a drawn vertex, pixels
    """
    full, half = (_alike(edges, times * length, noise) for times in (1.0, 2.0))
    return _CAVALIER + full - half


def _alike(edges: Floats, depth: float, noise: float) -> float:
    """Log odds that a depth was meant to be as long as an edge."""
    spread = np.hypot(_SLOPPY, noise / np.maximum(edges, 1e-9))
    density = np.exp(-0.5 * (np.log(np.maximum(edges, 1e-9) / depth) / spread) ** 2) / (spread * _ROOT_TWO_PI)
    return math.log(1.0 - _SAME + _SAME * _RANGE * float(density.mean()))
