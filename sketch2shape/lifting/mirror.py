"""Mirror symmetry of a face that was drawn nearly symmetric, as constraints that make it exact."""

from __future__ import annotations

import numpy as np

from sketch2shape.lifting.shape import Shape
from sketch2shape.model import Floats, Ints

#: rings of fewer vertices have symmetries that no one means
_LEAST = 5

#: the mean square move to the symmetric ring, over the noise's variance, that still is noise; less for rings of few
#: vertices, which are nearly symmetric by chance more often
_NOISE, _FEW, _OF_FEW = 6.0, 6, 1.0


def find_mirror(shape: Shape, noise: float) -> Ints | None:
    """(n,) the image of each vertex of the outer ring in its best mirror symmetry, None if it has none.

    noise : standard deviation of a vertex, pixels of the drawing
    """
    n = shape.sizes[0]
    if n < _LEAST or len(shape.sizes) > 1:
        return None
    ring = shape.flat - shape.flat.mean(axis=0)
    every = np.arange(n)
    mates = (every[:, None] - every) % n
    across = _across(ring, _angles(ring), mates)
    images = ring[mates]
    reflected = images - 2.0 * (images @ across[:, :, None]) * across[:, None]
    off = (((reflected - ring) @ shape.to_drawing) ** 2).sum(axis=(1, 2)) / (4.0 * n)
    best = int(off.argmin())
    return np.asarray(mates[best]) if off[best] < (_OF_FEW if n <= _FEW else _NOISE) * noise**2 else None


def mirror_rows(ring: Floats, mates: Ints, angles: Floats | None = None) -> Floats:
    """(c, n, 2) linear constraints of a mirror symmetry.

    ring   : (n, 2) vertices
    mates  : (n,) the image of each
    angles : (n,) directions that the edges shall have, radians; None as they have
    """
    (across,) = _across(ring, _angles(ring) if angles is None else angles, mates[None])
    return _rows(mates, across)


def _angles(ring: Floats) -> Floats:
    x, y = (np.roll(ring, -1, axis=0) - ring).T
    angles: Floats = np.arctan2(y, x)
    return angles


def _across(ring: Floats, angles: Floats, mates: Ints) -> Floats:
    """(s, 2) unit vectors along the chords of mirror symmetries with these (s, n) images.

    The mirror halves the angle between each edge and its image, which fixes it up to quarter turns.
    """
    x, y = (ring - ring[mates]).transpose(2, 0, 1)
    lean = 0.5 * np.arctan2(2.0 * (x * y).sum(axis=1), (x * x - y * y).sum(axis=1))
    image = np.roll(mates, -1, axis=1)
    long = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
    doubled = long * np.exp(2j * angles)
    halves = 0.25 * np.angle(doubled[image] @ doubled)
    lean += (halves - lean + np.pi / 4) % (np.pi / 2) - np.pi / 4
    return np.stack([np.cos(lean), np.sin(lean)], axis=1)


def _rows(mates: Ints, across: Floats) -> Floats:
    """Chords run across the mirror, and their middles lie on it."""
    along = np.array([-across[1], across[0]])
    n = len(mates)
    pairs = [(i, j) for i, j in enumerate(mates.tolist()) if i <= j]
    rows: list[Floats] = []
    for i, j in pairs:
        if i != j:
            rows.append(np.zeros((n, 2)))
            rows[-1][i], rows[-1][j] = along, -along
    (a, b), *others = pairs
    for i, j in others:
        rows.append(np.zeros((n, 2)))
        for vertex, sign in ((i, 0.5), (j, 0.5), (a, -0.5), (b, -0.5)):
            rows[-1][vertex] += sign * across
    return np.array(rows).reshape(-1, n, 2)
