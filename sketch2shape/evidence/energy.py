"""Energy: what a hypothesis and the drawing under it cost together, in nats.

A minimum description length (J. Rissanen, "Modeling by shortest data description", Automatica 1978). The drawing is
told as: the object (its front vertices, the plane map to the back, what misses the map), the hand's noise, how hidden
edges are drawn, what should be there and is not, and foreign ink, path by path. The hypothesis with the least energy
wins; a vertex stays if it costs less than the ink it explains.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from sketch2shape.evidence.visibility import edge_samples, hidden_depth
from sketch2shape.geometry import homology, map_fits
from sketch2shape.hypotheses import Rings, stack
from sketch2shape.ink import Group
from sketch2shape.model import Bools, Floats, Ints, Lines
from sketch2shape.strokes import Skeleton

MOST_POINTS = 2000
STYLES: tuple[Lines, Lines, Lines] = ("wire", "dashed", "removed")
UNIT = 0.01
CORRELATED = 0.08
LEAST_NOISE, PEN_NOISE = 0.4, 0.05
MOST_NOISE = 0.015
NOISE_STEP = 1.5
WITHIN = 3.0
FOREIGN, FOREIGN_PATH, FOREIGN_LONG = 2.5, 16.0, 0.25
SMALL_PIECE = 0.2
DASH = 0.6
STRAIGHT = 0.95
MISSING = 3.0
GAP, GAP_SHARE = 3.0, 0.25
DASHED = 0.3
HAND = 0.0025
SPARE = 1.15
SPREAD = 2.5


@dataclass(frozen=True, eq=False)
class View:
    """What all hypotheses of one drawing are compared with.

    skeleton : of the ink
    points   : (k, 2) float, pixels of its paths, thinned out
    path     : (k,) int, the path of each
    length   : (k,) float, pixels of ink that each stands for; ink of small pieces counts for little
    pen      : stroke width, pixels
    size     : diagonal of the ink, pixels
    """

    skeleton: Skeleton
    points: Floats
    path: Ints
    length: Floats
    pen: float
    size: float

    @property
    def unit(self) -> float:
        """Pixels to which ink is independent."""
        return max(self.pen, UNIT * self.size)

    @cached_property
    def noises(self) -> Floats:
        """Standard deviations of a hand that are tried, pixels."""
        least = LEAST_NOISE + PEN_NOISE * self.pen
        count = 1 + int(max(0.0, np.log(max(MOST_NOISE * self.size, 1.5 * least) / least) / np.log(NOISE_STEP)))
        return np.asarray(least * NOISE_STEP ** np.arange(count))


def observe(group: Group, skeleton: Skeleton) -> View:
    """The view of a group of ink."""
    paths = [p for p in skeleton.paths if len(p)] or [np.zeros((0, 2), np.int32)]
    pixels = np.concatenate(paths)
    owner = np.repeat(np.arange(len(paths)), [len(p) for p in paths])
    step = max(1, -(-len(pixels) // MOST_POINTS))
    points, owner = pixels[::step], owner[::step]
    solid = group.solid[points[:, 1], points[:, 0]]
    chord = np.array([np.hypot(*(p[-1] - p[0])) if len(p) else 0.0 for p in paths])
    straight = chord > STRAIGHT * np.array([_walked(p) for p in paths])
    length = np.where(solid, 1.0, np.where(straight[owner], DASH, SMALL_PIECE)) * step
    size = float(np.linalg.norm(np.ptp(skeleton.points, axis=0))) if len(skeleton.points) else 1.0
    return View(skeleton, points.astype(float), owner, length, skeleton.pen_width, size)


def _walked(path: Ints) -> float:
    """Length of a path of pixels, pixels."""
    return float(np.hypot(*np.diff(path, axis=0).T).sum()) if len(path) > 1 else 0.0


class Energy(NamedTuple):
    """The parts of the energy, nats.

    noise    : standard deviation of the hand that tells the drawing most briefly, pixels
    residual : how the ink strays from the lines
    foreign  : ink that the object does not explain
    missing  : visible edges without ink
    hidden   : hidden edges
    shape    : vertices, plane map, and what misses it
    lines    : how hidden edges are drawn
    digit    : of a coordinate
    """

    noise: float
    residual: float
    foreign: float
    missing: float
    hidden: float
    shape: float
    lines: Lines
    digit: float

    @property
    def total(self) -> float:
        """Nats."""
        return self.residual + self.foreign + self.missing + self.hidden + self.shape

    @property
    def vertex(self) -> float:
        """What a vertex of the front costs, nats."""
        return 2.0 * self.digit

    @property
    def unexplained(self) -> float:
        """Nats that another hypothesis could save."""
        return self.foreign + self.missing


def energy(rings: Rings, view: View, drawn: Bools, margin: float, spread: float = 1e3) -> Energy:
    """The energy of a hypothesis.

    drawn  : (m,) bool, back vertices that ink shows; the others follow from the plane map
    margin : pixels, see `hidden_depth`
    """
    one = stack([rings])
    samples = edge_samples(one)
    depth = hidden_depth(one, samples, margin)[0]
    samples = samples[0]
    v, edges = rings.vertices, one.frame.edges
    a, span = v[edges[:, 0]], v[edges[:, 1]] - v[edges[:, 0]]
    lengths = np.hypot(span[:, 0], span[:, 1])
    visible, hidden = depth == 0, depth == 2
    off = looked_up_distance(view.skeleton, samples)
    seen = _distances(view.points, a, span, ~hidden)
    every = _distances(view.points, a, span, np.ones_like(hidden)) if hidden.any() else seen
    room = lengths * SPARE
    each = (lengths / samples.shape[1] / view.unit)[:, None]
    n = samples.shape[1]
    end = np.minimum(np.arange(n), np.arange(n)[::-1]) * (lengths / n)[:, None] < GAP * view.pen
    wanted = np.where(visible, MISSING * each, 0.0) * np.where(end, GAP_SHARE, 1.0)
    best: Energy | None = None
    for noise in view.noises[view.noises <= max(view.noises[0], SPREAD * spread)]:
        near = off <= WITHIN * noise + 0.5
        missing = float(wanted[~near].sum())
        behind = float((hidden * each).sum())
        bare = float((hidden * each)[~near].sum())
        digit = float(np.log(max(view.size / noise, 2.0)))
        shape = _shape(rings, view, drawn, noise)
        for lines, cost, distance in (
            ("wire", MISSING * bare, every),
            ("dashed", DASHED * behind, every),
            ("removed", 0.0, seen),
        ):
            residual, foreign = _ink(distance, room, view, noise)
            found = Energy(float(noise), residual, foreign, missing, cost, shape, lines, digit)
            if best is None or found.total < best.total:
                best = found
    assert best is not None
    return best


def nearest_edges(points: Floats, a: Floats, span: Floats) -> tuple[Floats, Ints]:
    """(k,) distance of each point to the nearest edge, pixels, and (k,) that edge."""
    return _distances(points, a, span, np.ones((len(a), 1), bool))


def looked_up_distance(skeleton: Skeleton, points: Floats) -> Floats:
    import cv2

    at = points.astype(np.float32)
    return np.asarray(
        cv2.remap(skeleton.distance, at, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=1e4), float
    )


def _distances(points: Floats, a: Floats, span: Floats, shown: Bools) -> tuple[Floats, Ints]:
    """(k,) distance of each point to the nearest shown part of an edge, pixels, and (k,) that edge."""
    some = np.flatnonzero(shown.any(axis=1))
    if not len(some):
        return np.full(len(points), np.inf), np.zeros(len(points), np.intp)
    p, a, s = points.astype(np.float32), a[some].astype(np.float32), span[some].astype(np.float32)
    n = shown.shape[1]
    t = ((p[:, None] - a) * s).sum(axis=2) / ((s * s).sum(axis=1) + 1e-9)
    t = np.clip(t, 0.0, 1.0)
    dx = p[:, :1] - a[:, 0] - t * s[:, 0]
    dy = p[:, 1:] - a[:, 1] - t * s[:, 1]
    d = dx * dx + dy * dy
    index = np.minimum((t * n).astype(np.intp), n - 1)
    d[~shown[some][np.arange(len(some)), index]] = np.inf
    nearest = d.argmin(axis=1)
    return np.sqrt(d[np.arange(len(d)), nearest]), some[nearest]


def _ink(nearest: tuple[Floats, Ints], room: Floats, view: View, noise: float) -> tuple[float, float]:
    distance, edge = nearest
    near = distance <= WITHIN * noise + 0.5
    scale = max(view.pen, CORRELATED * view.size)
    spread = 0.5 * (distance[near] / noise) ** 2 + np.log(noise / view.noises[0])
    residual = float((view.length[near] * spread).sum()) / scale
    left = np.bincount(view.path[~near], view.length[~near], minlength=1) / view.unit
    crowd = np.bincount(edge[near], view.length[near], minlength=len(room)) - room
    residual += FOREIGN * float(np.maximum(crowd, 0.0).sum()) / view.unit
    return residual, float(np.minimum(FOREIGN * left, FOREIGN_PATH + FOREIGN_LONG * left)[left > 0].sum())


def _shape(rings: Rings, view: View, drawn: Bools, noise: float) -> float:
    digit = float(np.log(max(view.size / noise, 2.0)))
    front, back = np.concatenate(rings.front), np.concatenate(rings.back)
    seen = drawn if drawn.sum() >= 2 else np.ones(len(front), bool)
    slack = 1.5 * noise + HAND * view.size
    cost = np.inf
    for parameters, fit in zip((2, 3, 5), map_fits(front[seen], back[seen]), strict=False):
        off = np.linalg.norm(homology.apply(fit, front[seen]) - back[seen], axis=1)
        if np.isfinite(off).all():
            cost = min(cost, parameters * digit + float(np.minimum(0.5 * (off / slack) ** 2, 2 * digit).sum()))
    return 2 * digit * len(front) + cost
