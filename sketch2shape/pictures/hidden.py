"""Which parts of a drawn object's edges lie behind its own material.

Strategy: cut the object by planes between its front (s = 0) and its back (s = 1). In the drawing the cut at s is the
ring f1 + s (f2 - f1), in parallel and perspective views alike, and nearer cuts cover farther ones. A point of an edge
at depth s is hidden if some cut with a smaller s covers it. Cuts and edges are sampled: exact enough for a picture.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sketch2shape.model import Bools, FacePair, Floats, TwoFaceObject

_CUTS = 48
_SLACK = 0.004  # of the object's size: a point this near to a cut's outline is not called covered


def visible_runs(obj: TwoFaceObject, samples: int = 48) -> list[list[tuple[float, float, bool]]]:
    """For each edge of `obj.edges`, its pieces as (from, to, visible) with from and to in 0..1 along the edge."""
    seen = _visible_samples(obj, samples)
    return [_runs(flags) for flags in seen]


def visible_edges(obj: TwoFaceObject) -> Bools:
    """(3m,) True where the most part of an edge of `obj.edges` is in view."""
    return np.asarray(_visible_samples(obj, 24).mean(axis=1) > 0.5)


def _visible_samples(obj: TwoFaceObject, samples: int) -> Bools:
    """(edges, samples) True where the sample in the middle of each of `samples` equal pieces is in view."""
    half = len(obj.vertices) // 2
    depth_of = np.repeat([0.0, 1.0], half)
    t = (np.arange(samples) + 0.5) / samples
    i, j = obj.edges.T
    points = obj.vertices[i][:, None] * (1 - t)[:, None] + obj.vertices[j][:, None] * t[:, None]
    depth = depth_of[i][:, None] * (1 - t) + depth_of[j][:, None] * t
    flat, flat_depth = points.reshape(-1, 2), depth.ravel()
    slack = _SLACK * float(np.ptp(obj.vertices, axis=0).max())
    hidden = np.zeros(len(flat), bool)
    for s in (np.arange(_CUTS) + 0.5) / _CUTS:
        behind = np.flatnonzero((flat_depth > s) & ~hidden)
        hidden[behind] = _covered(flat[behind], _cut(obj, float(s)), slack)
    return ~hidden.reshape(depth.shape)


def _cut(obj: TwoFaceObject, s: float) -> list[Floats]:
    """The rings of the object's cut at depth s."""
    return [_between(pair, s) for pair in obj.rings]


def _between(pair: FacePair, s: float) -> Floats:
    cut: Floats = pair.f1 + s * (pair.f2 - pair.f1)
    return cut


def _covered(points: Floats, rings: list[Floats], slack: float) -> Bools:
    """(k,) True for points inside an odd number of the rings and farther than `slack` from all of them."""
    inside = np.zeros(len(points), bool)
    near = np.full(len(points), np.inf)
    for ring in rings:
        inside ^= _inside(points, ring)
        near = np.minimum(near, _distance(points, ring))
    return np.asarray(inside & (near > slack))


def _inside(points: Floats, ring: Floats) -> Bools:
    """(k,) True for points inside the ring (even-odd crossings of a ray to the right)."""
    x, y = points[:, :1], points[:, 1:]
    (ax, ay), (bx, by) = ring.T, np.roll(ring, -1, axis=0).T
    straddles = (ay <= y) != (by <= y)
    run = np.where(by == ay, 1.0, by - ay)
    right = ax + (y - ay) * (bx - ax) / run > x
    return np.asarray((straddles & right).sum(axis=1) % 2 == 1)


def _distance(points: Floats, ring: Floats) -> Floats:
    """(k,) distance of each point to the ring's outline."""
    along = np.roll(ring, -1, axis=0) - ring
    length = np.maximum((along**2).sum(axis=1), 1e-12)
    rel = points[:, None] - ring
    t = np.clip((rel * along).sum(axis=2) / length, 0, 1)
    gaps: Floats = np.linalg.norm(rel - t[..., None] * along, axis=2).min(axis=1)
    return gaps


def _runs(flags: Bools) -> list[tuple[float, float, bool]]:
    """Equal neighbours joined: (from, to, value) pieces of 0..1."""
    ends = [0, *(np.flatnonzero(np.diff(flags)) + 1), len(flags)]
    return [(a / len(flags), b / len(flags), bool(flags[a])) for a, b in pairwise(ends)]
