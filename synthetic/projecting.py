"""Projections of a solid onto the paper: oblique, axonometric, perspective; all as one projective map with a depth.

A `View` sends homogeneous solid coordinates to (x, y, key, w); the picture point is (x, y) / w and key / w grows with
the distance from the viewer. Both kinds of depth used here (z of a parallel view, -1/z of a perspective one) are
affine functions of the picture point on any plane, which is what makes exact visibility easy (`visibility`).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sketch2shape.model import Floats


@dataclass(frozen=True)
class View:
    """A projection.

    matrix : (4, 4), solid (x, y, z, 1) to (x w, y w, key w, w)
    facts  : family, kind and parameters, ready for JSON
    """

    matrix: Floats
    facts: dict[str, Any] = field(default_factory=dict)

    def __call__(self, points: Floats) -> Floats:
        """(m, 3) solid points to (m, 3): picture x, y and depth key (smaller is nearer)."""
        h = np.c_[points, np.ones(len(points))] @ self.matrix.T
        seen: Floats = h[:, :3] / h[:, 3:]
        return seen

    def placed(self, scale: float, shift: Floats) -> View:
        """The same view with the picture scaled, then shifted."""
        fit = np.diag([scale, scale, 1.0, 1.0])
        fit[:2, 3] = shift
        return View(fit @ self.matrix, self.facts)


def turn_x(angle: float) -> Floats:
    """Rotation about x by `angle` radians."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def turn_y(angle: float) -> Floats:
    """Rotation about y by `angle` radians."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def oblique(kind: str, ratio: float, angle: float) -> View:
    """Front face in true shape; depth drawn `ratio` times as long in direction `angle` (radians, up is positive)."""
    m = np.eye(4)
    m[0, 2], m[1, 2] = ratio * np.cos(angle), -ratio * np.sin(angle)
    facts = {"family": "oblique", "kind": kind, "ratio": ratio, "angle_deg": float(np.degrees(angle))}
    return View(m, facts)


def axonometric(kind: str, azimuth: float, elevation: float, lying: bool = False) -> View:
    """Parallel view after a turn; `lying` puts the front face on top of the object (or below it)."""
    m = np.eye(4)
    m[:3, :3] = turn_x(elevation) @ turn_y(azimuth) @ _pose(lying, elevation)
    facts = {
        "family": "axonometric",
        "kind": kind,
        "azimuth_deg": float(np.degrees(azimuth)),
        "elevation_deg": float(np.degrees(elevation)),
        "pose": "lying" if lying else "standing",
    }
    return View(m, facts)


def upright(kind: str, azimuth: float, elevation: float) -> View:
    """Parallel view of an object that stands: the front face on top seen from above, or below seen from below."""
    m = np.eye(4)
    m[:3, :3] = turn_x(elevation) @ turn_y(azimuth) @ turn_x(-np.copysign(np.pi / 2, elevation))
    facts = {
        "azimuth_deg": float(np.degrees(azimuth)),
        "elevation_deg": float(np.degrees(elevation)),
        "pose": "upright",
    }
    return View(m, {"family": "axonometric", "kind": kind} | facts)


def perspective(kind: str, rotation: Floats, offset: Floats) -> View:
    """Pinhole view: solid turned by `rotation`, its centre at `offset` (x, y, z) before the camera, focal length 1."""
    m = np.zeros((4, 4))
    camera = np.c_[rotation, offset]
    m[:2], m[2, 3], m[3] = camera[:2] * offset[2], -offset[2], camera[2]
    facts = {"family": "perspective", "kind": kind, "distance": float(offset[2])}
    return View(m, facts)


def _pose(lying: bool, elevation: float) -> Floats:
    return turn_x(np.copysign(np.pi / 2, elevation)) if lying else np.eye(3)


def random_view(family: str, rng: np.random.Generator) -> View:
    """A view of the family as people choose them: the usual angles often, free ones as well."""
    return VIEWS[family](rng)


def _random_oblique(rng: np.random.Generator) -> View:
    kind = str(rng.choice(["cabinet", "cavalier", "free"], p=[0.45, 0.25, 0.3]))
    ratio = {"cabinet": 0.5, "cavalier": 1.0}.get(kind) or float(rng.uniform(0.35, 0.95))
    if rng.random() < 0.7:
        angle = np.radians(rng.choice([30, 45, 60, 135, 150, 120, -30, -45, -60, 210, 225]))
    else:
        angle = rng.uniform(-np.pi, np.pi)
    return oblique(kind, ratio, float(angle))


def _random_axonometric(rng: np.random.Generator) -> View:
    kind = str(rng.choice(["isometric", "dimetric", "trimetric"], p=[0.4, 0.2, 0.4]))
    side = float(rng.choice([-1, 1]))
    if kind == "isometric":
        azimuth, elevation = np.pi / 4, float(np.arcsin(np.tan(np.pi / 6)))
    elif kind == "dimetric":
        azimuth, elevation = np.pi / 4, float(np.radians(rng.uniform(18, 50)))
    else:
        azimuth, elevation = float(np.radians(rng.uniform(22, 65))), float(np.radians(rng.uniform(16, 48)))
    if rng.random() < 0.15:
        elevation = -elevation
    return axonometric(kind, side * azimuth, elevation, bool(rng.random() < 0.35))


def _random_upright(rng: np.random.Generator) -> View:
    """Any side to the front, from above as a rule."""
    elevation = float(np.radians(rng.uniform(14, 45))) * (-1 if rng.random() < 0.1 else 1)
    return upright("trimetric", float(rng.uniform(-np.pi, np.pi)), elevation)


def _random_below(rng: np.random.Generator) -> View:
    """Any side to the front, from below."""
    elevation = -float(np.radians(rng.uniform(14, 45)))
    return upright("trimetric", float(rng.uniform(-np.pi, np.pi)), elevation)


def _random_perspective(rng: np.random.Generator) -> View:
    kind = str(rng.choice(["one-point", "two-point", "three-point"]))
    distance, side = rng.uniform(2.4, 4.5), float(rng.choice([-1, 1]))
    lateral = rng.uniform(0.35, 0.9, 2) * rng.choice([-1, 1], 2)
    if kind == "one-point":
        return perspective(kind, np.eye(3), np.array([*lateral, distance]))
    azimuth = turn_y(side * np.radians(rng.uniform(25, 60)))
    if kind == "two-point":
        return perspective(kind, azimuth, np.array([0.0, lateral[1], distance]))
    elevation = np.radians(rng.uniform(18, 40)) * (-1 if rng.random() < 0.15 else 1)
    pose = _pose(bool(rng.random() < 0.35), elevation)
    return perspective(kind, turn_x(elevation) @ azimuth @ pose, np.array([0.0, 0.0, distance]))


VIEWS = {
    "oblique": _random_oblique,
    "axonometric": _random_axonometric,
    "upright": _random_upright,
    "below": _random_below,
    "perspective": _random_perspective,
}
