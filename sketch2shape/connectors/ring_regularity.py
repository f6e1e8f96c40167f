"""How regular a ring is: a sum over its edges and over pairs of its edges, with weights fitted to drawn faces.

Faces of made things repeat themselves: edges are parallel, of equal length, in one line, at right angles, mirrored;
corners are not spikes; edges do not pass close to other corners. Each such cue is a number for an edge, or for a pair
of edges, so the energy of a ring is x'Wx over its edge set x and one exchange of edges can be judged without looking
at the rest.

Strategy: the weights are those of a conditional logit: among all simple rings through the points, ring r is right with
probability proportional to exp(-energy(r)). `scripts/fit_regularity.py` fits them to its own random faces, so
differences of energy are log odds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sketch2shape.connectors.symmetry import symmetries
from sketch2shape.geometry import cross, distances, segment_distance, size_of
from sketch2shape.model import Bools, Floats, Ints

#: directions that differ by this much (radians) are one step apart; short edges get more, see `_direction_slack`
PARALLEL = 0.025
#: position error of a corner, as a part of the size of the points
PLACEMENT = 0.004
#: relative difference of two lengths that are one step apart
EQUAL_LENGTH = 0.03
#: energy of a crossing; far more than any cue, so that no sum of cues outweighs it
CROSSING = 1e3

EDGE_CUES = ("length", "length2", "clear", "gabriel", "hull", "swept", "rank")
PAIR_CUES = (
    "parallel", "parallel_loose", "in_line", "parallel_equal", "equal", "perpendicular", "symmetric",
    "spike", "sharp", "acute", "straight", "right", "near",
)  # fmt: skip


@dataclass(frozen=True)
class Edges:
    """Edges between points, and what the cues need of them.

    ends     : (m, 2) indices
    vector   : (m, 2) from the first end to the second, in sizes of the points
    length   : (m,)
    """

    points: Floats
    ends: Ints
    vector: Floats
    length: Floats


def edges_between(points: Floats, ends: Ints) -> Edges:
    """Edges in coordinates where the points have size 1."""
    scaled = (points - points.mean(axis=0)) / size_of(points)
    vector = scaled[ends[:, 1]] - scaled[ends[:, 0]]
    return Edges(scaled, ends, vector, np.hypot(vector[:, 0], vector[:, 1]))


def edge_cues(edges: Edges, hull: Ints) -> Floats:
    """(m, 7) the EDGE_CUES of each edge.

    Its length and length squared; how close it passes other points, and how many lie in the circle on it; whether it
    is on the hull; how many points lie between its ends as seen from the mean; how near the ends are to each other
    among all points.
    """
    a, b = edges.points[edges.ends[:, 0]], edges.points[edges.ends[:, 1]]
    rest = np.ones((len(a), len(edges.points)), dtype=bool)
    np.put_along_axis(rest, edges.ends, False, axis=1)
    gap = segment_distance(edges.points[None], a[:, None], b[:, None])
    close = np.where(rest, np.exp(-gap / 0.02), 0.0).sum(axis=1)
    apart = np.linalg.norm(edges.points[None] - (a + b)[:, None] / 2, axis=2)
    inside = (rest & (apart < 0.499 * edges.length[:, None])).sum(axis=1)
    on_hull = np.isin(edges.ends, hull).all(axis=1) & _hull_neighbours(edges.ends, hull)
    cues = (edges.length, edges.length**2, close, np.minimum(inside, 4), on_hull, _swept(edges), _rank(edges))
    return np.column_stack(cues).astype(np.float64)


def _swept(edges: Edges) -> Floats:
    """How many points lie between the ends of each edge in angle about the mean (at its ends: half), 3 at most."""
    radius = np.hypot(edges.points[:, 0], edges.points[:, 1])
    angle = np.arctan2(edges.points[:, 1], edges.points[:, 0])
    first, second = angle[edges.ends[:, 0]], angle[edges.ends[:, 1]]
    span = np.mod(second - first + np.pi, 2 * np.pi) - np.pi  # the shorter way round
    offset = np.mod((angle[None] - first[:, None]) * np.sign(span)[:, None], 2 * np.pi)
    offset[offset > 2 * np.pi - 1e-9] = 0.0
    width = np.abs(span)[:, None]
    between = (offset > 1e-9) & (offset < width - 1e-9)
    at_end = (offset <= 1e-9) | (np.abs(offset - width) <= 1e-9)
    central = radius < 1e-9
    count = (between & ~central).sum(axis=1) + 0.5 * ((at_end & ~central).sum(axis=1) - 2)
    touches = central[edges.ends].any(axis=1)  # seen from itself the middle has no direction
    return np.where(touches, 0.0, np.clip(count, 0.0, 3.0))


def _rank(edges: Edges) -> Floats:
    """Log of how many points are as near to one end as the other end is, mean over both ends."""
    gaps = distances(edges.points)
    a, b = edges.ends[:, 0], edges.ends[:, 1]
    logs = []
    for end, other in ((a, b), (b, a)):
        reach = gaps[end, other][:, None]
        nearer = (gaps[end] < reach * (1 - 1e-9)).sum(axis=1)  # the end itself among them
        equal = (np.abs(gaps[end] - reach) <= 1e-9 * reach).sum(axis=1)
        logs.append(np.log(nearer + 0.5 * (equal - 1)))
    return np.asarray((logs[0] + logs[1]) / 2)


def _hull_neighbours(ends: Ints, hull: Ints) -> Bools:
    place = np.full(int(ends.max()) + 1, -9)
    place[hull] = np.arange(len(hull))
    step = np.abs(place[ends[:, 0]] - place[ends[:, 1]])
    return np.asarray((step == 1) | (step == len(hull) - 1))


def pair_cues(edges: Edges) -> tuple[Floats, ...]:
    """The PAIR_CUES of each pair of edges, an (m, m) array each, symmetric; the diagonals mean nothing."""
    length, unit = edges.length, edges.vector / edges.length[:, None]
    sine = np.abs(cross(unit[:, None], unit[None]))
    cosine = np.abs(unit @ unit.T)
    slack = PARALLEL + PLACEMENT / np.minimum(length[:, None], length[None])
    parallel = np.exp(-0.5 * (sine / slack) ** 2)
    loose = np.exp(-0.5 * (sine / (3 * slack)) ** 2)
    perpendicular = np.exp(-0.5 * (cosine / slack) ** 2)
    ratio = np.log(length[:, None] / length[None])
    spread = EQUAL_LENGTH + PLACEMENT * (1 / length[:, None] + 1 / length[None])
    equal = np.exp(-0.5 * (ratio / spread) ** 2)
    shared, angle_cos = _corners(edges, unit)
    corner, apart = shared.astype(np.float64), (~shared).astype(np.float64)
    angle = np.arccos(np.clip(angle_cos, -1, 1))
    in_line = parallel * apart * np.exp(-0.5 * (_offset(edges, unit) / (2 * PLACEMENT)) ** 2)
    return (
        parallel * apart,
        loose * apart,
        in_line,
        parallel * equal * apart,
        equal,
        perpendicular,
        _symmetric(edges),
        corner * np.exp(-0.5 * (angle / 0.2) ** 2),
        corner * np.exp(-0.5 * (angle / 0.45) ** 2),
        corner * np.clip(np.cos(angle), 0.0, None),
        corner * np.exp(-0.5 * ((np.pi - angle) / 0.12) ** 2),
        corner * perpendicular,
        apart * np.exp(-_separation(edges) / 0.03),
    )  # fmt: skip


def _corners(edges: Edges, unit: Floats) -> tuple[Bools, Floats]:
    """Which pairs share exactly one end, and the cosine of the angle between them there."""
    a, b = edges.ends[:, 0], edges.ends[:, 1]
    tail, head = a[:, None] == a[None], b[:, None] == b[None]
    chain = (a[:, None] == b[None]) | (b[:, None] == a[None])
    corner = (tail ^ head) | chain
    cosine = unit @ unit.T
    return corner, np.where(tail ^ head, cosine, -cosine)


def _offset(edges: Edges, unit: Floats) -> Floats:
    """Distance between the lines of nearly parallel edges, symmetric."""
    middle = (edges.points[edges.ends[:, 0]] + edges.points[edges.ends[:, 1]]) / 2
    normal = np.column_stack((-unit[:, 1], unit[:, 0]))
    off = np.abs(normal @ middle.T - (normal * middle).sum(axis=1)[:, None])
    return np.asarray(np.maximum(off, off.T))


def _separation(edges: Edges) -> Floats:
    """Smallest distance from an end of one edge to the other edge, symmetric."""
    a, b = edges.points[edges.ends[:, 0]], edges.points[edges.ends[:, 1]]
    gap = segment_distance(edges.points[:, None], a[None], b[None])  # (n, m)
    near = np.minimum(gap[edges.ends[:, 0]], gap[edges.ends[:, 1]])
    return np.minimum(near, near.T)


def _symmetric(edges: Edges) -> Floats:
    """How strongly each pair of edges is exchanged by a symmetry of the point set."""
    m = len(edges.ends)
    image_of = np.zeros((m, m))
    found = symmetries(edges.points)
    if not found:
        return image_of
    n = len(edges.points)
    place = np.full((n, n), -1, dtype=np.intp)
    place[edges.ends[:, 0], edges.ends[:, 1]] = place[edges.ends[:, 1], edges.ends[:, 0]] = np.arange(m)
    for permutation, strength in found:
        image = place[permutation[edges.ends[:, 0]], permutation[edges.ends[:, 1]]]
        known = np.flatnonzero(image >= 0)
        image_of[known, image[known]] += strength / len(found)
    return np.maximum(image_of, image_of.T)
