"""Symmetries of a point set in any parallel view.

A parallel view of a symmetric face is not symmetric, but it has an affine map onto itself. Whitening (making the
covariance the identity) turns every such map into a rotation or a mirroring about the mean, because an affine map
that permutes the points keeps their mean and covariance.
"""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats, Ints

#: rms distance between a point and the image of its partner, whitened units, that is one step from perfect
MISFIT = 0.04


def symmetries(points: Floats) -> list[tuple[Ints, float]]:
    """(permutation (n,), strength 0..1) of each rotation and mirroring of the points, without the identity.

    Strategy: some point furthest out must go to a point about as far out; that fixes one rotation and one mirroring
    each. Those that bring every point near one of its own are kept. O(n^3).
    """
    white = _whitened(points)
    radius = np.hypot(white[:, 0], white[:, 1])
    pivot = int(np.argmax(radius))
    targets = np.flatnonzero(radius > radius[pivot] - 5 * MISFIT)
    z = white[:, 0] + 1j * white[:, 1]
    turn = z[targets] / z[pivot]
    turn /= np.abs(turn)
    mirror = z[targets] / np.conj(z[pivot])
    mirror /= np.abs(mirror)
    images = np.concatenate((turn[:, None] * z[None], mirror[:, None] * np.conj(z)[None]))
    gap = np.abs(images[:, :, None] - z[None, None])
    nearest = gap.argmin(axis=2)
    misfit = np.sqrt((gap.min(axis=2) ** 2).mean(axis=1))
    found: dict[bytes, tuple[Ints, float]] = {}
    indices = np.arange(len(z))
    for k in np.flatnonzero(misfit < 3 * MISFIT).tolist():
        permutation = nearest[k]
        if np.array_equal(np.sort(permutation), indices) and not np.array_equal(permutation, indices):
            strength = float(np.exp(-0.5 * (misfit[k] / MISFIT) ** 2))
            key = permutation.tobytes()
            if key not in found or found[key][1] < strength:
                found[key] = permutation, strength
    return list(found.values())


def _whitened(points: Floats) -> Floats:
    centred = points - points.mean(axis=0)
    values, vectors = np.linalg.eigh(centred.T @ centred / len(points))
    return np.asarray(centred @ (vectors / np.sqrt(np.maximum(values, 1e-12 * values[-1]))))
