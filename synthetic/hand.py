"""How a hand departs from the ruler: strokes as polylines with wobble, bow, overshoot, gaps and repeats."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

import numpy as np

from sketch2shape.model import Floats
from synthetic.scenes import Scene


@dataclass(frozen=True)
class Hand:
    """Departures from exact drawing; lengths in pixels unless said otherwise.

    wobble   : amplitude of the slow side-to-side wander
    bow      : sagitta of a stroke, part of its length (standard deviation)
    over     : strokes run on past the corner by up to this
    gap      : strokes stop short of the corner by up to this
    miss     : standard deviation of a stroke's end around the corner
    shift    : standard deviation of each vertex from its exact place (faces are then no exact translations)
    twice    : probability that a stroke is drawn twice
    rounding : radius by which the corners of the faces are rounded off
    blobs    : probability that the pen rests at a stroke's end and leaves a blot
    short    : every stroke stops this far from each of its corners, more or less, but never loses most of its length
    """

    wobble: float = 0.0
    bow: float = 0.0
    over: float = 0.0
    gap: float = 0.0
    miss: float = 0.0
    shift: float = 0.0
    twice: float = 0.0
    rounding: float = 0.0
    blobs: float = 0.0
    short: float = 0.0

    def scaled(self, factor: float) -> Hand:
        """The same hand on a sheet `factor` times as large."""
        lengths = {
            k: factor * getattr(self, k) for k in ("wobble", "over", "gap", "miss", "shift", "rounding", "short")
        }
        return replace(self, **lengths)


RULER = Hand()
STEADY = Hand(wobble=0.7, bow=0.006, over=2.0, gap=1.0, miss=0.6, shift=0.8)
LOOSE = Hand(wobble=1.3, bow=0.012, over=5.0, gap=3.0, miss=1.4, shift=2.0, twice=0.2)
TABLET = Hand(wobble=1.2, bow=0.03, over=6.0, gap=5.0, miss=3.0, shift=4.0, twice=0.05, blobs=0.25)
SLOPPY = Hand(wobble=2.2, bow=0.03, over=11.0, gap=7.0, miss=5.0, shift=7.0, twice=0.15, blobs=0.1)
HEAVY = Hand(wobble=3.0, bow=0.02, over=7.0, gap=4.0, miss=2.2, shift=3.0, twice=0.25)


@dataclass(frozen=True)
class Stroke:
    """One pull of the pen.

    path   : (k, 2) polyline, pixels
    hidden : a hidden edge (dashed, dotted)
    weight : factor on the pen's width
    """

    path: Floats
    hidden: bool = False
    weight: float = 1.0


def moved_vertices(scene: Scene, hand: Hand, rng: np.random.Generator) -> Floats:
    """Where the hand puts the vertices, (2m, 2)."""
    return scene.points + rng.normal(0, 1, scene.points.shape) * hand.shift


def strokes_of(scene: Scene, points: Floats, lines: str, hand: Hand, rng: np.random.Generator) -> list[Stroke]:
    """Strokes of one object; `lines` says what happens to the hidden parts."""
    strokes: list[Stroke] = []
    rounded = hand.rounding if lines == "wire" else 0.0
    if rounded:
        strokes += _round_corners(scene, points, rounded)
    for a, b, seen in scene.edges:
        if lines == "wire":
            pieces = [(0.0, 1.0, False)]
        else:
            pieces = [(t0, t1, False) for t0, t1 in seen]
            if lines == "dashed":
                pieces += [(t0, t1, True) for t0, t1 in _hidden(seen)]
        for t0, t1, hidden in pieces:
            p, q = points[a] + t0 * (points[b] - points[a]), points[a] + t1 * (points[b] - points[a])
            if hand.short:
                p, q = _stopped_short(p, q, hand.short, rng)
            if rounded and (a < scene.half) == (b < scene.half):
                p, q = _shortened(p, q, rounded)
            strokes += _pulls(p, q, hidden, hand, rng)
    order = rng.permutation(len(strokes))
    return [strokes[i] for i in order]


def freehand(path: Floats, hand: Hand, rng: np.random.Generator) -> Floats:
    """A polyline as the hand draws it: resampled every few pixels and disturbed, shape (k, 2)."""
    pieces = [_wavy(p, q, hand, rng) for p, q in itertools.pairwise(path)]
    return np.vstack(pieces)


def wandering(path: Floats, hand: Hand, rng: np.random.Generator) -> Floats:
    """A curve as the hand draws it in one pull: it wanders off and back over long stretches, (k, 2)."""
    if len(path) == 2 or hand.wobble == 0:
        return freehand(path, hand, rng)
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    s = np.linspace(0, steps[-1], max(int(steps[-1] / 4), 12))
    fine = np.c_[np.interp(s, steps, path[:, 0]), np.interp(s, steps, path[:, 1])]
    ahead = np.gradient(fine, axis=0)
    normal = np.c_[-ahead[:, 1], ahead[:, 0]] / np.maximum(np.linalg.norm(ahead, axis=1), 1e-9)[:, None]
    side = np.zeros(len(s))
    for wave in (1.0, 2.1, 3.7):
        # The slow waves are the large ones: a hand draws eggs and open ends, no scallops.
        turns = wave * max(steps[-1] / 400, 0.6)
        side += rng.normal(0, hand.wobble) / wave * np.sin(2 * np.pi * (turns * s / steps[-1] + rng.random()))
    wandered: Floats = fine + side[:, None] * normal
    return wandered


def pulled(path: Floats, hidden: bool, hand: Hand, rng: np.random.Generator) -> list[Stroke]:
    """Strokes of one line, straight or curved, with the gaps and repeats of the hand."""
    if len(path) == 2:
        p, q = _stopped_short(path[0], path[1], hand.short, rng) if hand.short else path
        return _pulls(p, q, hidden, hand, rng)
    times = 2 if not hidden and rng.random() < hand.twice else 1
    return [Stroke(wandering(path, hand, rng), hidden, float(rng.uniform(0.9, 1.1))) for _ in range(times)]


def _pulls(p: Floats, q: Floats, hidden: bool, hand: Hand, rng: np.random.Generator) -> list[Stroke]:
    times = 2 if rng.random() < hand.twice else 1
    if hidden:
        times = 1
    out = []
    for _ in range(times):
        length = float(np.linalg.norm(q - p))
        along = (q - p) / max(length, 1e-9)
        ends = []
        for sign in (-1, 1):
            reach = float(rng.uniform(-hand.gap, hand.over)) if not hidden else 0.0
            reach = max(reach, -0.15 * length)
            ends.append(sign * reach * along + rng.normal(0, 1, 2) * min(hand.miss, 0.05 * length))
        out.append(Stroke(_wavy(p + ends[0], q + ends[1], hand, rng), hidden, float(rng.uniform(0.9, 1.1))))
        if hand.blobs and not hidden and rng.random() < hand.blobs:
            out.append(Stroke(np.array([q + ends[1], q + ends[1] + 0.5]), False, float(rng.uniform(1.4, 2.2))))
    return out


def _wavy(p: Floats, q: Floats, hand: Hand, rng: np.random.Generator) -> Floats:
    """A stroke from p to q with bow and wobble, a point about every 3 pixels."""
    length = float(np.linalg.norm(q - p))
    if hand.wobble == 0 and hand.bow == 0:
        return np.array([p, q])
    k = max(int(length / 3), 2)
    t = np.linspace(0, 1, k + 1)
    normal = np.array([-(q - p)[1], (q - p)[0]]) / max(length, 1e-9)
    side = rng.normal(0, hand.bow) * length * 4 * t * (1 - t)
    waves = max(int(length / 60), 1)
    for _ in range(3):
        frequency = rng.uniform(0.5, 1.6) * waves
        side = side + rng.normal(0, hand.wobble / 2) * np.sin(2 * np.pi * (frequency * t + rng.random()))
    # A wandering pen still starts and ends where it was put down.
    side = side - (side[0] * (1 - t) + side[-1] * t)
    path: Floats = p + t[:, None] * (q - p) + side[:, None] * normal
    return path


def _hidden(seen: list[tuple[float, float]]) -> list[tuple[float, float]]:
    ends = [0.0, *[t for s in seen for t in s], 1.0]
    return [(a, b) for a, b in zip(ends[::2], ends[1::2], strict=True) if b - a > 1e-6]


def _stopped_short(p: Floats, q: Floats, short: float, rng: np.random.Generator) -> tuple[Floats, Floats]:
    """The stroke without about `short` pixels at each end, at most three tenths of it."""
    length = float(np.linalg.norm(q - p))
    cut = np.minimum(short * rng.uniform(0.85, 1.15, 2), 0.3 * length) / max(length, 1e-9)
    return p + cut[0] * (q - p), q - cut[1] * (q - p)


def _shortened(p: Floats, q: Floats, radius: float) -> tuple[Floats, Floats]:
    length = float(np.linalg.norm(q - p))
    cut = min(radius, 0.3 * length) / max(length, 1e-9) * (q - p)
    return p + cut, q - cut


def _round_corners(scene: Scene, points: Floats, radius: float) -> list[Stroke]:
    """Arcs (quadratic) that join the shortened edges of each ring."""
    out, start = [], 0
    for n in scene.sizes:
        for base in (start, start + scene.half):
            ring = points[base : base + n]
            for i in range(n):
                before = _shortened(ring[i], ring[i - 1], radius)[0]
                after = _shortened(ring[i], ring[(i + 1) % n], radius)[0]
                t = np.linspace(0, 1, 9)[:, None]
                out.append(Stroke((1 - t) ** 2 * before + 2 * t * (1 - t) * ring[i] + t**2 * after))
        start += n
    return out
