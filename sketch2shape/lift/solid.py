"""The stage itself: tell the projection apart, lift, tidy, scale and turn."""

from __future__ import annotations

from typing import Literal

import numpy as np

from sketch2shape.lift.options import LiftOptions
from sketch2shape.lift.parallel import read_axonometric, read_oblique
from sketch2shape.model import Floats, Projection, Solid, TwoFaceObject


def lift(
    obj: TwoFaceObject, *, picture_size: tuple[int, int] = (640, 480), options: LiftOptions | None = None
) -> Solid:
    """The solid shown by a two-face object."""
    del picture_size
    options = options or LiftOptions()
    half = len(obj.vertices) // 2
    first, second = obj.vertices[:half], obj.vertices[half:]
    sizes = [len(r.f1) for r in obj.rings]
    d = (second - first).mean(axis=0)
    face = 0.5 * (first + second - d)
    noise = max(obj.noise, 0.3)
    flat, slanted = read_oblique(face, sizes, noise), read_axonometric(face, sizes, d, noise)
    odds = flat.odds - slanted.odds
    if odds >= 0:
        front = np.c_[face, np.zeros(half)]
        through = np.array([*d, np.hypot(*d) / 0.5])
    else:
        t = d / np.hypot(*d)
        front = np.c_[face, -(face - face.mean(axis=0)) @ t * np.tan(slanted.slant)]
        through = np.array([*d, np.hypot(*d) / np.tan(slanted.slant)])
    if odds >= 0:
        through[:2] = 0.0
    vertices: Floats = np.concatenate([front, front + through])
    family: Literal["oblique", "axonometric"] = "oblique" if odds >= 0 else "axonometric"
    return Solid(vertices, tuple(sizes), Projection(family, {"odds": odds, **slanted.evidence}), options.solid_unit)
