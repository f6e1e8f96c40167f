"""Sets of faces that connectors are compared on: shuffled points whose order is known."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).parent))
from connector_profiles import PROFILES, faces

from sketch2shape.connectors.polygon import canonical, ring_is_simple

Ring = NDArray[np.float64]
RANDOM = ("star-shaped", "blob", "simple")
NAMED = tuple(name for name in PROFILES if name not in (*RANDOM, "rectilinear"))
SETS = {
    "frontal": (NAMED, ("frontal", "turned")),
    "affine": (NAMED, ("sheared", "affine")),
    "rectilinear": (("rectilinear",), ("frontal", "turned", "sheared", "affine")),
    "random": (("star-shaped", "blob"), ("frontal", "affine")),
    "simple": (("simple",), ("frontal", "affine")),
}


@dataclass(frozen=True)
class Face:
    """Shuffled points and their true order."""

    profile: str
    points: Ring
    order: tuple[int, ...]


def shuffled(name: str, ring: Ring, rng: np.random.Generator) -> Face:
    place = rng.permutation(len(ring))
    points = np.empty_like(ring)
    points[place] = ring
    return Face(name, points, canonical(place))


def face_set(name: str, count: int, noise: float, seed: int) -> list[Face]:
    profiles, views = SETS[name]
    repeat = count if len(profiles) > 5 else count * 12 // len(profiles)
    clean = np.random.default_rng(seed)
    rng = np.random.default_rng(seed + 1)
    found = []
    for profile, _, ring in faces(clean, profiles, views, repeat):
        moved = ring + rng.normal(0, noise, ring.shape)
        if ring_is_simple(moved):
            found.append(shuffled(profile, moved, rng))
    return found


def with_a_vertex_missing(face: Face, rng: np.random.Generator) -> Face:
    """The face without one vertex; right is the ring without it."""
    gone = int(rng.integers(len(face.points)))
    order = [i - (i > gone) for i in face.order if i != gone]
    return Face(face.profile, np.delete(face.points, gone, axis=0), canonical(np.array(order)))


def with_an_extra_vertex(face: Face, rng: np.random.Generator) -> Face:
    """The face and one stray point in its box; right is the ring that leaves it out."""
    low, high = face.points.min(axis=0), face.points.max(axis=0)
    return Face(face.profile, np.concatenate((face.points, rng.uniform(low, high)[None])), face.order)
