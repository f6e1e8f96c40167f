"""How regular a face is: the evidence that a guess at its true shape is right.

People draw things made of right angles, parallels, equal lengths and mirror symmetry far more often than chance would.
A candidate shape is scored by the logarithm of the odds of its angles and lengths under "made that way" (a narrow
normal density, as wide as the drawing's noise makes it) against "by chance" (a uniform density). The relations
between edges under projection are those of Lipson and Shpitalni, "Optimization-based reconstruction of a 3D object
from a single freehand line drawing" (1996); the odds, and the use of noise as their width, are ours.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.lift.face import ring_ends
from sketch2shape.model import Floats, Ints

#: least width of a relation's density, radians: drawings are rounded to pixels even when nothing else is wrong
_FLOOR = np.deg2rad(0.25)

#: part of all faces that have no special angles
_IRREGULAR = 0.3

#: angle between adjacent edges, prior odds that such an angle was meant
_ANGLES = ((90.0, 0.45), (60.0, 0.08), (45.0, 0.08), (72.0, 0.03), (30.0, 0.03))


@dataclass(frozen=True)
class Relations:
    """What could be regular about a face, found once in a reference shape and then scored in many.

    All vectors are sums of vertices, so that they can be taken from any candidate shape by one product.

    outer      : vertices of the outer ring
    directions : (k, m) coefficients of the k edge directions, parallel edges summed
    lengths    : (k,) length in the drawing that each direction rests on, pixels
    edges      : (k,) number of edges summed in each direction
    angles     : (p, 2) pairs of directions
    adjacent   : (p,) bool, does a corner of the face have this pair?
    axes       : (s, 2, m) coefficients of a mirror axis and of the chords it should halve at right angles
    belief     : (s,) prior odds that this symmetry was meant
    sides      : (q, m) coefficients of the edges whose lengths are compared
    """

    outer: int
    directions: Floats
    lengths: Floats
    edges: Ints
    angles: Ints
    adjacent: Floats
    axes: Floats
    belief: Floats
    sides: Floats


def find_relations(shape: Floats, sizes: list[int], drawn: Floats, noise: float) -> Relations:
    """Relations worth scoring in a face.

    shape : (m, 2) a reference shape, in which parallel edges are parallel (any affine image of the true face does)
    sizes : vertices of each ring
    drawn : (m, 2) the face as drawn, pixels
    noise : standard deviation of a drawn vertex, pixels
    """
    start, finish = ring_ends(sizes)
    vectors, long = shape[finish] - shape[start], np.linalg.norm(drawn[finish] - drawn[start], axis=1)
    label, sign = parallel_classes(vectors, long, noise)
    k, m = int(label.max()) + 1, len(shape)
    directions = np.zeros((k, m))
    np.add.at(directions, (label, finish), sign)
    np.add.at(directions, (label, start), -sign)
    first, second = np.triu_indices(k, 1)
    corner = {frozenset(p) for p in zip(label[_previous(sizes)].tolist(), label.tolist(), strict=True)}
    adjacent = np.array([frozenset(p) in corner for p in zip(first.tolist(), second.tolist(), strict=True)], float)
    axes, belief = _symmetries(shape, sizes[0], noise * _stretch(shape, drawn))
    if sizes[0] == 4 and len(set(label[:4].tolist())) == 2:
        # a rectangle's symmetries and a rhombus's say again what its edges say
        axes, belief = axes[:0], belief[:0]
    sides = np.zeros((len(start), m))
    rows = np.arange(len(start))
    sides[rows, finish], sides[rows, start] = 1.0, -1.0
    lengths = np.sqrt(np.bincount(label, long**2))
    one_each = sides[
        np.unique(np.c_[label, np.round(long / max(4.0 * noise, 0.01 * long.max()))], axis=0, return_index=True)[1]
    ]
    return Relations(
        sizes[0], directions, lengths, np.bincount(label), np.c_[first, second], adjacent, axes, belief, one_each[:16]
    )


def score(relations: Relations, shapes: Floats, maps: Floats, noise: float) -> Floats:
    """(g,) log odds of each candidate shape against chance.

    shapes : (g, m, 2) candidates for the true face
    maps   : (g, 2, 2) the linear part of drawing -> candidate (row vectors: candidate = drawn @ map)
    noise  : standard deviation of a drawn vertex, pixels
    """
    along = np.einsum("km,gmd->gkd", relations.directions, shapes)
    angle, spread = _bearings(along, relations.edges, maps, noise)
    total: Floats = _angle_odds(relations, angle, spread)
    total = total + _symmetry_odds(relations, shapes, maps, noise)
    return total + _length_odds(relations, shapes, maps, noise)


def bearings(relations: Relations, shapes: Floats, maps: Floats, noise: float) -> tuple[Floats, Floats]:
    """(g, k) angle of each edge direction in each candidate and its standard deviation, radians."""
    along = np.einsum("km,gmd->gkd", relations.directions, shapes)
    return _bearings(along, relations.edges, maps, noise)


def log_odds(deviation: Floats, spread: Floats, belief: Floats | float, span: float) -> Floats:
    """Log odds of a deviation: a normal density of this spread with this belief, against chance over `span`."""
    density = np.exp(-0.5 * (deviation / spread) ** 2) / (spread * np.sqrt(2.0 * np.pi))
    odds: Floats = np.log((1.0 - belief) + belief * density * span)
    return odds


def between(first: Floats, second: Floats) -> Floats:
    """Angle between two undirected lines, 0 to pi / 2."""
    turn = np.abs(first - second) % np.pi
    angle: Floats = np.minimum(turn, np.pi - turn)
    return angle


def _angle_odds(relations: Relations, angle: Floats, spread: Floats) -> Floats:
    """Right angles between all pairs of directions; other special angles only at corners."""
    if not len(relations.angles):
        return np.zeros(len(angle))
    i, j = relations.angles.T
    turn, width = between(angle[:, i], angle[:, j]), np.hypot(spread[:, i], spread[:, j])
    width = np.hypot(width, _FLOOR)
    span = np.pi / 2
    odds, left = np.zeros_like(turn), np.ones_like(turn)
    for degrees, belief in _ANGLES:
        share = belief * (relations.adjacent if degrees != 90.0 else 0.4 + 0.6 * relations.adjacent)
        target = np.deg2rad(degrees)
        density = np.exp(-0.5 * ((turn - target) / width) ** 2) / (width * np.sqrt(2.0 * np.pi))
        odds += share * density * (span if degrees != 90.0 else 2.0 * span)
        left -= share
    # many pairs of few directions repeat one another: their evidence grows with the number of directions, not of pairs
    share = 2.0 / max(angle.shape[1] - 1.0, 2.0)
    total: Floats = share * np.log(left + odds).sum(axis=1)
    # some faces are not made of special angles at all
    odds_of_face: Floats = np.logaddexp(np.log(1.0 - _IRREGULAR) + total, np.log(_IRREGULAR))
    return odds_of_face


def _symmetry_odds(relations: Relations, shapes: Floats, maps: Floats, noise: float) -> Floats:
    if not len(relations.belief):
        return np.zeros(len(shapes))
    vectors = np.einsum("sam,gmd->gsad", relations.axes, shapes)
    weight = np.sqrt((relations.axes**2).sum(axis=2))
    angle = np.arctan2(vectors[..., 1], vectors[..., 0])
    wide = _transverse(angle.reshape(len(shapes), -1), maps).reshape(angle.shape)
    spread = noise * weight * wide / np.maximum(np.linalg.norm(vectors, axis=3), 1e-12)
    turn = between(angle[..., 0], angle[..., 1])
    width = np.sqrt((spread**2).sum(axis=2) + _FLOOR**2)
    odds = log_odds(turn - np.pi / 2, width, relations.belief, np.pi)
    # symmetries of one face imply one another: the best counts whole, further ones less
    ranked = np.sort(odds, axis=1)[:, ::-1]
    total: Floats = ranked @ (1.0 / (1.0 + np.arange(ranked.shape[1])))
    return total


def _length_odds(relations: Relations, shapes: Floats, maps: Floats, noise: float) -> Floats:
    """Equal lengths between neighbouring kinds of edges."""
    sides = np.einsum("qm,gmd->gqd", relations.sides, shapes)
    long = np.maximum(np.linalg.norm(sides, axis=2), 1e-12)
    if long.shape[1] < 2:
        return np.zeros(len(shapes))
    stretch = np.linalg.norm(maps, ord=2, axis=(1, 2))
    spread = noise * np.sqrt(2.0) * stretch[:, None] / long
    i, j = np.triu_indices(long.shape[1], 1)
    width = np.sqrt(spread[:, i] ** 2 + spread[:, j] ** 2 + 0.005**2)
    odds = log_odds(np.log(long[:, i] / long[:, j]), width, 0.05, 3.0)
    total: Floats = odds.sum(axis=1) / (long.shape[1] - 1.0)
    return total


def _bearings(along: Floats, edges: Ints, maps: Floats, noise: float) -> tuple[Floats, Floats]:
    angle = np.arctan2(along[..., 1], along[..., 0])
    true = np.maximum(np.linalg.norm(along, axis=2), 1e-12)
    spread = noise * np.sqrt(2.0 * edges) * _transverse(angle, maps) / true
    return angle, spread


def _transverse(angle: Floats, maps: Floats) -> Floats:
    """(g, k) how much a drawn pixel's error grows across each direction."""
    across = np.stack([-np.sin(angle), np.cos(angle)], axis=-1)
    grown: Floats = np.linalg.norm(np.einsum("gij,gkj->gki", maps, across), axis=2)
    return grown


def _previous(sizes: list[int]) -> Ints:
    starts = np.cumsum([0, *sizes[:-1]])
    return np.concatenate([s + np.roll(np.arange(n), 1) for s, n in zip(starts, sizes, strict=True)])


def parallel_classes(vectors: Floats, lengths: Floats, noise: float) -> tuple[Ints, Floats]:
    """Class of each edge's direction and the sign that turns it along its class; long edges lead."""
    label, sign = np.full(len(vectors), -1), np.ones(len(vectors))
    sums: list[Floats] = []
    for e in np.argsort(-lengths, kind="stable"):
        tolerance = np.clip(3.0 * noise / max(lengths[e], 1e-9), np.deg2rad(1.0), np.deg2rad(12.0))
        best, turn = -1, tolerance
        for k, s in enumerate(sums):
            cross, dot = s[0] * vectors[e, 1] - s[1] * vectors[e, 0], s @ vectors[e]
            off = abs(np.arctan2(cross, abs(dot)))
            if off < turn:
                best, turn = k, off
        if best < 0:
            sums.append(vectors[e].copy())
            label[e] = len(sums) - 1
        else:
            sign[e] = 1.0 if sums[best] @ vectors[e] >= 0 else -1.0
            sums[best] += sign[e] * vectors[e]
            label[e] = best
    return label, sign


def _symmetries(shape: Floats, n: int, noise: float) -> tuple[Floats, Floats]:
    """Skewed mirror symmetries of the outer ring: coefficients of axis and chord, and how much each is believed.

    Under any affine map the chords of a mirror symmetry stay parallel and their middles stay on a line; the two
    directions were at right angles.
    """
    ring = shape[:n] - shape[:n].mean(axis=0)
    size = float(np.sqrt((ring**2).sum() / n))
    limit = max(3.0 * noise, 0.004 * size)
    found, belief = [], []
    for k in range(n):
        mate = (k - np.arange(n)) % n
        chord, middle = ring - ring[mate], 0.5 * (ring + ring[mate])
        across = np.linalg.svd(chord)[2][0]
        along = np.linalg.svd(middle)[2][0]
        miss = max(np.abs(_cross(chord, across)).max(), np.abs(_cross(middle, along)).max())
        if miss > limit or abs(_cross(along[None], across)[0]) < 0.17:
            continue
        rows = np.zeros((2, len(shape)))
        half = middle @ along
        rows[0, :n] += half / 2
        np.add.at(rows[0], mate, half / 2)
        span = chord @ across
        rows[1, :n] += span
        np.add.at(rows[1], mate, -span)
        found.append(rows / np.abs(rows).sum(axis=1, keepdims=True))
        belief.append(_SYMMETRY_BELIEF.get((n, k % 2), 0.8))
    return np.array(found).reshape(-1, 2, len(shape)), np.array(belief)


#: odds that a symmetry was meant where polygons have it without meaning it: every triangle, every trapezoid (its axis
#: halves two sides: k is odd); a kite's axis goes through two vertices
_SYMMETRY_BELIEF = {(3, 0): 0.15, (3, 1): 0.15, (4, 1): 0.2, (4, 0): 0.6}


def _cross(vectors: Floats, unit: Floats) -> Floats:
    cross: Floats = vectors[:, 0] * unit[1] - vectors[:, 1] * unit[0]
    return cross


def _stretch(shape: Floats, drawn: Floats) -> float:
    """Size of the reference shape over the size of the drawing."""
    return float(np.linalg.norm(np.ptp(shape, axis=0))) / max(float(np.linalg.norm(np.ptp(drawn, axis=0))), 1e-9)
