"""Random faces for fitting and comparing connectors: all profiles, and views of them."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import named_profiles as named
import random_profiles as polygons
from named_profiles import Random, Ring

PROFILES: dict[str, Callable[[Random], Ring]] = {
    "triangle": named.triangle,
    "rect": named.rect,
    "trapezoid": named.trapezoid,
    "parallelogram": named.parallelogram,
    "wedge": named.wedge,
    "house": named.house,
    "pentagon": named.regular(5),
    "hexagon": named.regular(6),
    "heptagon": named.regular(7),
    "octagon": named.regular(8),
    "star": named.star,
    "L": named.l_shape,
    "T": named.t_shape,
    "U": named.u_shape,
    "plus": named.plus,
    "Z": named.z_shape,
    "I": named.i_shape,
    "H": named.h_shape,
    "stairs": named.stairs,
    "comb": named.comb,
    "hook": named.hook,
    "spiral": named.spiral,
    "arrow": named.arrow,
    "double-arrow": named.double_arrow,
    "chevron": named.chevron,
    "notch": named.notch,
    "bolt": named.bolt,
    "bolt2": named.bolt2,
    "chamfered": named.chamfered,
    "dovetail": named.dovetail,
    "keyway": named.keyway,
    "V": named.v_shape,
    "rectilinear": polygons.rectilinear,
    "star-shaped": polygons.star_shaped,
    "blob": polygons.blob,
    "simple": polygons.simple,
}
#: profiles whose turns are all right angles
RECTILINEAR = ("rect", "L", "T", "U", "plus", "Z", "I", "H", "stairs", "comb", "hook", "spiral", "rectilinear")
VIEWS = ("frontal", "turned", "sheared", "affine", "perspective")


def view(ring: Ring, kind: str, rng: Random) -> Ring:
    """A view of a ring, scaled so that its larger side is 300 units."""
    if rng.random() < 0.5:
        ring = ring * [-1.0, 1.0]
    ring = ring @ _turn(float(rng.integers(4)) * np.pi / 2).T
    if kind == "turned":
        ring = ring @ _turn(rng.uniform(0, 2 * np.pi)).T
    elif kind == "sheared":
        ring = ring @ np.array([[1.0, 0.0], [rng.uniform(-0.7, 0.7), rng.uniform(0.6, 1.3)]])
    elif kind == "affine":
        ring = ring @ _parallel(rng)
    elif kind == "perspective":
        ring = _perspective(ring, rng)
    ring = ring - ring.min(axis=0)
    return ring * (300.0 / float(np.ptp(ring, axis=0).max()))


def _turn(angle: float) -> Ring:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def _parallel(rng: Random) -> Ring:
    """(2, 2) linear part of a parallel view of a plane, tilted by up to 60 degrees."""
    tilt = rng.uniform(0.2, np.pi / 3)
    return _turn(rng.uniform(0, np.pi)) @ np.diag([1.0, np.cos(tilt)]) @ _turn(rng.uniform(0, np.pi))


def _perspective(ring: Ring, rng: Random) -> Ring:
    centred = ring - ring.mean(axis=0)
    centred /= np.abs(centred).max()
    tilt, spin, distance = rng.uniform(0.2, 0.9), rng.uniform(0, 2 * np.pi), rng.uniform(4.0, 12.0)
    turned = centred @ _turn(spin if rng.random() < 0.5 else 0.0).T
    axis = rng.uniform(0, np.pi)
    u = np.array([np.cos(axis), np.sin(axis)])
    v = np.array([-u[1], u[0]])
    along, across = turned @ u, turned @ v
    depth = distance + across * np.sin(tilt)
    return (np.outer(along, u) + np.outer(across * np.cos(tilt), v)) / depth[:, None]


def faces(
    rng: Random,
    names: tuple[str, ...] = tuple(PROFILES),
    views: tuple[str, ...] = VIEWS,
    count: int = 1,
    noise: float = 0.0,
) -> Iterator[tuple[str, str, Ring]]:
    """(profile, view, ring) of each profile in each view, `count` times, vertices moved by Gaussian noise."""
    for name in names:
        for kind in views:
            for _ in range(count):
                ring = view(PROFILES[name](rng), kind, rng)
                yield name, kind, ring + rng.normal(0, noise, ring.shape) if noise else ring
