"""How regular a face is: the evidence that a guess at its true shape is right.

People draw things made of right angles, parallels, equal lengths and mirror symmetry far more often than chance would.
A candidate shape is scored by the logarithm of the odds of its angles and lengths under "made that way" (a narrow
normal density, as wide as the drawing's noise makes it) against "by chance" (a uniform density). The relations
between edges under projection are those of Lipson and Shpitalni, "Optimization-based reconstruction of a 3D object
from a single freehand line drawing" (1996); the odds, and the use of noise as their width, are ours.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sketch2shape.lifting.classes import parallel_classes
from sketch2shape.lifting.face import all_pairs, edge_rows, ring_ends
from sketch2shape.model import Bools, Floats, Ints

#: least width of a relation's density, radians: drawings are rounded to pixels even when nothing else is wrong
_FLOOR = np.deg2rad(0.25)

#: part of all faces that have no special angles
_IRREGULAR = 0.3

#: prior odds that a right angle was meant: between any two directions, and how much more between adjacent edges
_RIGHT, _RIGHT_AT_CORNER = 0.18, 0.27

#: the same where a face's edges have two directions only
_SQUARE = 0.5

#: other angles between adjacent edges, and the prior odds that such an angle was meant
_ANGLES = np.deg2rad([60.0, 45.0, 72.0, 30.0])
_MEANT = np.array([0.05, 0.08, 0.03, 0.03])

#: prior odds that two edges of different kinds were meant to be equally long
_ALIKE = 0.05

#: spread of how many times more a view shortens one direction than another (of the logarithm)
_UNEVEN = 0.8

#: standard deviation of a place between two guesses of a grid, part of its step
BETWEEN = 0.3

#: the height of a normal density of width one
_PEAK = 1.0 / np.sqrt(2.0 * np.pi)


@dataclass(frozen=True)
class Relations:
    """What could be regular about a face, found once in a reference shape and then scored in many.

    All vectors are sums of vertices, so that they can be taken from any candidate shape by one product.

    outer    : vertices of the outer ring
    rows     : (r, m) coefficients of the vectors: of the k edge directions, parallel edges summed; of s mirror axes;
               of the s chords they should halve at right angles; of the edges whose lengths are compared
    drawn    : (r,) their lengths in the drawing, pixels
    weight   : (k + 2 s,) how much the vertices' noise adds up in each direction, axis and chord
    lengths  : (k,) length in the drawing that each direction rests on, pixels
    edges    : (k,) number of edges summed in each direction
    angles   : the two directions of each of p pairs
    adjacent : (p,) bool, does a corner of the face have this pair?
    belief   : (s,) prior odds that this symmetry was meant
    sides    : the two edges of each of q pairs whose lengths may be equal, of different directions
    """

    outer: int
    rows: Floats
    drawn: Floats
    weight: Floats
    lengths: Floats
    edges: Ints
    angles: tuple[Ints, Ints]
    adjacent: Bools
    belief: Floats
    sides: tuple[Ints, Ints]


@dataclass(frozen=True)
class Candidates:
    """The vectors of a face's relations in g guesses at its true shape.

    x, y    : (g, r) components, one column for each of `Relations.rows`
    area    : (g,) true area over drawn area
    stretch : (g,) the most that a length grows from the drawing to the true shape
    step    : (g,) by how much the logarithm of that differs from the next guess's, where the guesses are a grid
    """

    x: Floats
    y: Floats
    area: Floats
    stretch: Floats
    step: Floats


@dataclass(frozen=True)
class Bearings:
    """(g, k + 2 s) angles of the directions, axes and chords of `Relations`, and their standard deviations, radians."""

    angle: Floats
    spread: Floats


def find_relations(shape: Floats, sizes: list[int], drawn: Floats, noise: float) -> Relations:
    """Relations worth scoring in a face.

    shape : (m, 2) a reference shape, in which parallel edges are parallel (any affine image of the true face does)
    sizes : vertices of each ring
    drawn : (m, 2) the face as drawn, pixels
    noise : standard deviation of a drawn vertex, pixels
    """
    start, finish = ring_ends(sizes)
    way = drawn[finish] - drawn[start]
    long = np.hypot(way[:, 0], way[:, 1])
    label, sign = parallel_classes(shape[finish] - shape[start], long, noise)
    edges = np.bincount(label)
    k, m = len(edges), len(shape)
    sides = edge_rows(sizes)
    directions = (sign * (label == np.arange(k)[:, None])) @ sides
    first, second = all_pairs(k)
    if sizes[0] == 4 and len(set(label[:4].tolist())) == 2:
        # a rectangle's symmetries and a rhombus's say again what its edges say
        axes, belief = np.zeros((2, 0, m)), np.zeros(0)
    else:
        axes, belief = _symmetries(shape, sizes[0], noise * _stretch(shape, drawn))
    corner = np.zeros((k, k), bool)
    before = np.empty(m, np.intp)
    before[finish] = label[start]
    corner[before, label] = corner[label, before] = True
    chosen = _one_each(label, long, noise)
    one, other = all_pairs(len(chosen))
    apart = label[chosen][one] != label[chosen][other]
    rows = np.concatenate([directions, *axes, sides[chosen]])
    weight = np.concatenate([np.sqrt(2.0 * edges), np.sqrt((axes**2).sum(axis=2)).ravel()])
    vectors = rows @ drawn
    return Relations(
        sizes[0],
        rows,
        np.hypot(vectors[:, 0], vectors[:, 1]),
        weight,
        np.sqrt(np.bincount(label, long**2)),
        edges,
        (first, second),
        corner[first, second],
        belief,
        (one[apart], other[apart]),
    )


def find_edge_relations(points: Floats, ends: Ints, outer: int, noise: float) -> Relations:
    """Relations worth scoring between the straight edges of a face that has arcs as well.

    points : (m, 2) of the face as drawn, pixels
    ends   : (e, 2) the two points of each edge
    outer  : points of the outer ring, which come first
    noise  : standard deviation of a drawn vertex, pixels
    """
    e, m = len(ends), len(points)
    sides = np.zeros((e, m))
    sides[np.arange(e), ends[:, 1]], sides[np.arange(e), ends[:, 0]] = 1.0, -1.0
    way = sides @ points
    long = np.hypot(way[:, 0], way[:, 1])
    label, sign = parallel_classes(way, long, noise) if e else (np.zeros(0, np.intp), np.zeros(0))
    edges = np.bincount(label)
    k = len(edges)
    first, second = all_pairs(k)
    corner = np.zeros((k, k), bool)
    one, other = np.nonzero(ends[:, 1][:, None] == ends[:, 0])
    corner[label[one], label[other]] = corner[label[other], label[one]] = True
    chosen = _one_each(label, long, noise) if e else []
    left, right = all_pairs(len(chosen))
    apart = label[chosen][left] != label[chosen][right]
    rows = np.concatenate([(sign * (label == np.arange(k)[:, None])) @ sides, sides[chosen]])
    vectors = rows @ points
    return Relations(
        outer,
        rows,
        np.hypot(vectors[:, 0], vectors[:, 1]),
        np.sqrt(2.0 * edges),
        np.sqrt(np.bincount(label, long**2)),
        edges,
        (first, second),
        corner[first, second],
        np.zeros(0),
        (left[apart], right[apart]),
    )


def candidates(relations: Relations, shapes: Floats, maps: Floats) -> Candidates:
    """The vectors of relations in (g, m, 2) shapes; maps (g, 2, 2) are the linear part of drawing -> shape (rows)."""
    area = maps[:, 0, 0] * maps[:, 1, 1] - maps[:, 0, 1] * maps[:, 1, 0]
    square = (maps**2).sum(axis=(1, 2))
    stretch = np.sqrt(0.5 * (square + np.sqrt(np.maximum(square**2 - 4.0 * area**2, 0.0))))
    x, y = shapes[..., 0] @ relations.rows.T, shapes[..., 1] @ relations.rows.T
    return Candidates(x, y, np.abs(area), stretch, np.zeros(len(area)))


def bearings(relations: Relations, found: Candidates, noise: float) -> Bearings:
    """Directions of the relations' vectors; noise is the standard deviation of a drawn vertex, pixels.

    A map that makes areas `area` times as large shifts the tip of a vector sideways by area * drawn / true length for
    each pixel of noise across the drawn one. Between two guesses of a grid it turns by up to sine * cosine * step.
    """
    w = len(relations.weight)
    x, y = found.x[:, :w], found.y[:, :w]
    reach = noise * relations.weight * relations.drawn[:w]
    square = np.maximum(x * x + y * y, 1e-24)
    grid = BETWEEN * found.step[:, None] * x * y
    return Bearings(np.arctan2(y, x), np.sqrt((found.area[:, None] * reach) ** 2 + grid**2) / square)


def score(relations: Relations, found: Candidates, turned: Bearings, noise: float) -> Floats:
    """(g,) log odds of each candidate shape against chance.

    turned : their `bearings`
    noise  : standard deviation of a drawn vertex, pixels
    """
    total: Floats = _angle_odds(relations, turned) + _length_odds(relations, found, noise)
    return total + _symmetry_odds(relations, turned) if len(relations.belief) else total


def log_odds(deviation: Floats, spread: Floats, belief: Floats | float, span: float) -> Floats:
    """Log odds of a deviation: a normal density of this spread with this belief, against chance over `span`."""
    odds: Floats = np.log((1.0 - belief) + (belief * span) * _density(deviation, spread))
    return odds


def uneven_odds(times: Floats) -> Floats:
    """Log odds of a view that shortens one direction so much more than another: things are as long as they look."""
    odds: Floats = -0.5 * (np.log(times) / _UNEVEN) ** 2
    return odds


def between(first: Floats, second: Floats | float) -> Floats:
    """Angle between two undirected lines, 0 to pi / 2; their directions are between -pi and pi."""
    turn = np.abs(np.abs(first - second) - np.pi)
    angle: Floats = np.minimum(turn, np.pi - turn)
    return angle


def _density(deviation: Floats, spread: Floats) -> Floats:
    normal: Floats = np.exp(-0.5 * (deviation / spread) ** 2) * (_PEAK / spread)
    return normal


def _angle_odds(relations: Relations, turned: Bearings) -> Floats:
    """Right angles between all pairs of directions; other special angles only at corners."""
    i, j = relations.angles
    if not len(i):
        return np.zeros(len(turned.angle))
    turn = between(turned.angle[:, i], turned.angle[:, j])
    variance = turned.spread[:, : len(relations.edges)] ** 2
    sharp = 1.0 / np.sqrt(variance[:, i] + variance[:, j] + _FLOOR**2)
    corner = np.flatnonzero(relations.adjacent)
    crossed = len(relations.edges) == 2
    right = _SQUARE if crossed else _RIGHT + _RIGHT_AT_CORNER * relations.adjacent
    odds = (np.pi * _PEAK * right) * sharp * np.exp(-0.5 * ((turn - np.pi / 2) * sharp) ** 2)
    odds += 1.0 - right - _MEANT.sum() * relations.adjacent
    sharp = sharp[:, corner]
    others = np.exp(-0.5 * ((turn[:, corner, None] - _ANGLES) * sharp[..., None]) ** 2)
    odds[:, corner] += (others @ (0.5 * np.pi * _PEAK * _MEANT)) * sharp
    told = np.log(odds)
    if crossed:
        return np.asarray(told[:, 0])
    if len(relations.edges) == 3:
        # of a triangle's three angles two say all
        total = told.sum(axis=1) - told.min(axis=1)
    else:
        # many pairs of few directions repeat one another: their evidence grows with the directions, not the pairs
        total = told.sum(axis=1) * (2.0 / (len(relations.edges) - 1.0))
    # some faces are not made of special angles at all
    odds_of_face: Floats = np.logaddexp(np.log(1.0 - _IRREGULAR) + total, np.log(_IRREGULAR))
    return odds_of_face


def _symmetry_odds(relations: Relations, turned: Bearings) -> Floats:
    k, s = len(relations.edges), len(relations.belief)
    axis, chord = slice(k, k + s), slice(k + s, k + 2 * s)
    turn = between(turned.angle[:, axis], turned.angle[:, chord])
    width = np.sqrt(turned.spread[:, axis] ** 2 + turned.spread[:, chord] ** 2 + _FLOOR**2)
    odds = log_odds(turn - np.pi / 2, width, relations.belief, np.pi)
    # symmetries of one face imply one another: the best counts whole, further ones less
    odds.sort(axis=1)
    total: Floats = odds[:, ::-1] @ (1.0 / (1.0 + np.arange(s)))
    return total


def _length_odds(relations: Relations, found: Candidates, noise: float) -> Floats:
    """Equal lengths of edges of different directions; those of parallel edges are drawn so in any view."""
    i, j = relations.sides
    if not len(i):
        return np.zeros(len(found.x))
    w = len(relations.weight)
    square = np.maximum(found.x[:, w:] ** 2 + found.y[:, w:] ** 2, 1e-24)
    spread = (2.0 * noise**2) * found.stretch[:, None] ** 2 / square + (BETWEEN * found.step[:, None]) ** 2
    long = 0.5 * np.log(square)
    odds = log_odds(long[:, i] - long[:, j], np.sqrt(spread[:, i] + spread[:, j] + 0.005**2), _ALIKE, 3.0)
    total: Floats = odds.sum(axis=1) / (square.shape[1] - 1.0)
    return total


def _one_each(label: Ints, long: Floats, noise: float) -> list[int]:
    """An edge of each direction and length, sixteen at most."""
    steps = np.round(long / max(4.0 * noise, 0.01 * float(long.max())))
    kinds: dict[tuple[int, float], int] = {}
    for edge, kind in enumerate(zip(label.tolist(), steps.tolist(), strict=True)):
        kinds.setdefault(kind, edge)
    return [kinds[kind] for kind in sorted(kinds)][:16]


def _symmetries(shape: Floats, n: int, noise: float) -> tuple[Floats, Floats]:
    """Skewed mirror symmetries of the outer ring: coefficients of axis and chord, and how much each is believed.

    Under any affine map the chords of a mirror symmetry stay parallel and their middles stay on a line; the two
    directions were at right angles. (2, s, m) coefficients, (s,) beliefs.
    """
    ring = shape[:n] - shape[:n].sum(axis=0) / n
    limit = max(3.0 * noise, 0.004 * float(np.sqrt((ring**2).sum() / n)))
    mates = _mates(n)
    far = ring[mates]
    # the chords of each guess, then their middles
    spans = np.concatenate([ring - far, 0.5 * (ring + far)])
    ways = _main_directions(spans)
    off = _off(spans, ways)
    chords, middles, across, along = spans[:n], spans[n:], ways[:n], ways[n:]
    sine = along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]
    found = np.flatnonzero((np.maximum(off[:n], off[n:]) <= limit) & (np.abs(sine) >= 0.17))
    rows = np.zeros((2, len(found), len(shape)))
    if len(found):
        # what each vertex adds, it adds to its mirror image too, or takes from it
        mirrored = mates[found]
        half = 0.5 * (middles[found] @ along[found, :, None])[..., 0]
        span = (chords[found] @ across[found, :, None])[..., 0]
        rows[0, :, :n] = half + np.take_along_axis(half, mirrored, axis=1)
        rows[1, :, :n] = span - np.take_along_axis(span, mirrored, axis=1)
        rows /= np.maximum(np.abs(rows).sum(axis=2, keepdims=True), 1e-300)
    return rows, np.array([_SYMMETRY_BELIEF.get((n, k % 2), 0.8) for k in found.tolist()])


@lru_cache(maxsize=256)
def _mates(n: int) -> Ints:
    """(n, n) the mirror image of each vertex in each of a ring's n symmetries; read-only."""
    every = np.arange(n)
    mates = (every[:, None] - every) % n
    mates.flags.writeable = False
    return mates


#: odds that a symmetry was meant where polygons have it without meaning it: every triangle, every trapezoid (its axis
#: halves two sides: k is odd); a kite's axis goes through two vertices
_SYMMETRY_BELIEF = {(3, 0): 0.15, (3, 1): 0.15, (4, 1): 0.2, (4, 0): 0.6}


def _main_directions(vectors: Floats) -> Floats:
    """(n, 2) unit direction along which most of each (n, m, 2) set of vectors lies."""
    x, y = vectors[..., 0], vectors[..., 1]
    lean = 0.5 * np.arctan2(2.0 * (x * y).sum(axis=1), (x * x - y * y).sum(axis=1))
    return np.stack([np.cos(lean), np.sin(lean)], axis=1)


def _off(vectors: Floats, along: Floats) -> Floats:
    """(n,) how far the farthest of each (n, m, 2) set of vectors is from the line along (n, 2)."""
    away = vectors[..., 0] * along[:, 1, None] - vectors[..., 1] * along[:, 0, None]
    off: Floats = np.abs(away).max(axis=1)
    return off


def _stretch(shape: Floats, drawn: Floats) -> float:
    """Size of the reference shape over the size of the drawing."""
    if shape is drawn:
        return 1.0
    return float(np.linalg.norm(np.ptp(shape, axis=0))) / max(float(np.linalg.norm(np.ptp(drawn, axis=0))), 1e-9)
