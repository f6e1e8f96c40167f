"""Energy: what a hypothesis and the drawing under it cost together, in nats.

A minimum description length (J. Rissanen, "Modeling by shortest data description", Automatica 1978). The drawing is
told as: the object (its front vertices, the plane map to the back, what misses the map), the hand's noise, how hidden
edges are drawn, what should be there and is not, and foreign ink, path by path. The hypothesis with the least energy
wins; a vertex stays if it costs less than the ink it explains.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sketch2shape.evidence.overlaps import coincidences
from sketch2shape.evidence.score import grown
from sketch2shape.evidence.view import View, foreign_price
from sketch2shape.evidence.visibility import edge_samples, hidden_depth, in_picture
from sketch2shape.geometry import homology, map_fits
from sketch2shape.hypotheses import Rings, split, stack
from sketch2shape.model import Bools, Floats, Ints, Lines
from sketch2shape.strokes import interpolated

CORRELATED = 0.08
"""Fraction of the drawing's size over which a line strays in one way: its noise is told once for so much."""
WITHIN, BLUR = 3.0, 0.5
"""Standard deviations of the hand, and pixels more, up to which ink belongs to a line."""
CROWDED = 1.15
"""Length of ink that an edge can explain, over its own length: crossings, the ends of other lines."""
MISSING = 3.0
"""Nats for a unit of a visible edge without ink: one in twenty units is left out."""
GAP, GAP_PRICE = 3.0, 0.25
"""Pens from its end within which an edge may lack ink at a lower price, and that price over the full one."""
DASHED = 0.3
"""Nats for a unit of a dashed hidden edge: where the dashes lie."""
CARELESS = 0.0025
"""Fraction of the drawing's size by which a hand misplaces a back vertex even if its lines are straight."""
LEAST_APART, APART = 2.0, 0.5
"""Pixels, or pens if that is more, between two edges drawn as one line."""
LIKELY_HOLE = 12.0
"""Nats by which a closed line inside a face is likelier a hole than a foreign stroke."""
LEAST_DRAWN = 2
"""Back vertices that have to be drawn to tell the plane map."""
LEAST_DIGIT = float(np.log(2.0))
"""Nats of a coordinate at least."""
STEADY = 2.5
"""Noise of the best explanation over the hand's own up to which more noise is a reason at all."""
ROUGH, THICK = 4.0, 0.3
"""The same for thick pens, whose lines bend unnoticed, and that noise over the width of the pen at most."""


def near_line(noise: float) -> float:
    """Pixels from a line up to which ink belongs to it, under a hand of this noise, pixels."""
    return WITHIN * noise + BLUR


class Energy(NamedTuple):
    """The parts of the energy, nats.

    noise    : standard deviation of the hand that tells the drawing most briefly, pixels
    residual : how the ink strays from the lines
    foreign  : ink that the object does not explain
    missing  : visible edges without ink
    hidden   : hidden edges
    shape    : vertices, plane map, and what misses it
    lines    : how hidden edges are drawn
    digit    : a coordinate
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
        """All parts."""
        return self.residual + self.foreign + self.missing + self.hidden + self.shape

    @property
    def vertex(self) -> float:
        """What a vertex of the front costs."""
        return 2.0 * self.digit

    @property
    def unexplained(self) -> float:
        """What another hypothesis could save."""
        return self.foreign + self.missing


@dataclass(frozen=True, eq=False)
class Comparison:
    """A hypothesis held against a drawing, before anything is said of the hand.

    view    : the drawing
    lengths : (3m,) float, pixels, of the edges
    off     : (3m, n) float, pixels from each sample of each edge to the nearest ink
    wanted  : (3m, n) float, nats for each sample if it has no ink, for visible ones
    hidden  : (3m, n) float, units of hidden edge at each sample
    every   : distance of each point of ink to the nearest edge, pixels, and that edge
    seen    : the same for visible edges alone
    misses  : for each kind of plane map, its parameters and (k,) pixels by which drawn back vertices miss it
    front   : number of front vertices, or what tells as much
    laid    : edges along others, each an accident of the view that costs a coordinate
    holes   : number of holes
    """

    view: View
    lengths: Floats
    off: Floats
    wanted: Floats
    hidden: Floats
    every: tuple[Floats, Ints]
    seen: tuple[Floats, Ints]
    misses: tuple[tuple[int, Floats], ...]
    front: float
    laid: int = 0
    holes: int = 0

    @cached_property
    def _told(self) -> dict[float, Energy]:
        return {}

    @property
    def shown(self) -> Floats:
        """(3m,) fraction of each edge that is seen."""
        return np.asarray((self.wanted > 0).mean(axis=1))

    def energy(self, hand: float) -> Energy:
        """The least energy under a hand whose lines have this noise, pixels."""
        noises = self.view.noises
        most = max(noises[0], STEADY * hand, min(ROUGH * hand, THICK * self.view.pen))
        return min((self._under(n) for n in noises[noises <= most]), key=lambda e: e.total)

    def _under(self, noise: float) -> Energy:
        """What is told once of each noise: hypotheses are priced again whenever another one is found."""
        if noise not in self._told:
            self._told[noise] = self._priced(noise)
        return self._told[noise]

    def _priced(self, noise: float) -> Energy:
        near = self.off <= near_line(noise)
        missing, bare = float(self.wanted[~near].sum()), float(self.hidden[~near].sum())
        digit = max(float(np.log(self.view.size / noise)), LEAST_DIGIT)
        r1, f1 = self._ink(self.every, noise)
        r2, f2 = (r1, f1) if self.seen is self.every else self._ink(self.seen, noise)
        ways: list[tuple[float, float, float, Lines]] = [
            (MISSING * bare, r1, f1, "wire"),
            (DASHED * float(self.hidden.sum()), r1, f1, "dashed"),
            (0.0, r2, f2, "removed"),
        ]
        hidden, residual, foreign, lines = min(ways, key=lambda w: w[0] + w[1] + w[2])
        return Energy(float(noise), residual, foreign, missing, hidden, self._shape(noise, digit), lines, digit)

    def _ink(self, nearest: tuple[Floats, Ints], noise: float) -> tuple[float, float]:
        """Nats for how ink strays from its edge, and for foreign ink."""
        distance, edge = nearest
        view = self.view
        near = distance <= near_line(noise)
        spread = 0.5 * (distance[near] / noise) ** 2 + np.log(noise / view.noises[0])
        residual = float((view.length[near] * spread).sum()) / max(view.pen, CORRELATED * view.size)
        crowd = np.bincount(edge[near], view.length[near], len(self.lengths)) - CROWDED * self.lengths
        residual += foreign_price(float(np.maximum(crowd, 0.0).sum()) / view.unit)
        left = np.bincount(view.path[~near], view.length[~near], len(view.units)) / view.unit
        return residual, view.foreign(left)

    def _shape(self, noise: float, digit: float) -> float:
        least = min(map_price(p, off, noise, digit, self.view.size) for p, off in self.misses)
        return (2 * self.front + self.laid) * digit + least - LIKELY_HOLE * self.holes


def compare(rings: Rings, view: View, drawn: Bools, margin: float) -> Comparison:
    """Hold a hypothesis against a drawing.

    drawn  : (m,) bool, back vertices that ink shows; the others follow from the plane map
    margin : pixels, see `hidden_depth`
    """
    one = stack([rings])
    samples = edge_samples(one)
    depth = hidden_depth(one, margin)[0]
    v = rings.vertices
    a, span = rings.segments
    lengths = np.hypot(span[:, 0], span[:, 1])
    n = samples.shape[2]
    each = (lengths / n / view.unit)[:, None]
    place = np.arange(n)
    end = np.minimum(place, n - 1 - place) * (lengths / n)[:, None] < GAP * view.pen
    # where an edge dives behind another it may end a little early
    end |= grown(depth[None] >= 1, lengths[None], GAP * view.pen)[0]
    shows = True if view.cut is None else in_picture(samples[0], view.cut)
    wanted = np.where((depth == 0) & shows, MISSING * each * np.where(end, GAP_PRICE, 1.0), 0.0)
    hidden = (depth == 2) & shows
    every, seen = _nearest_to_ink(view, a, span, ~hidden)
    m = len(v) // 2
    reach = max(LEAST_APART, APART * view.pen)
    laid = coincidences(a, span, lengths + 1e-9, np.asarray((depth == 0).mean(axis=1)), reach)
    off = interpolated(view.skeleton.distance, samples[0])
    misses = _misses(v[:m], v[m:], drawn, view)
    holes = len(rings.sizes) - 1
    return Comparison(view, lengths, off, wanted, hidden * each, every, seen, misses, m, laid, holes)


_Nearest: TypeAlias = tuple[Floats, Ints]
"""(k,) distances, pixels, and (k,) edges."""


def _nearest_to_ink(view: View, a: Floats, span: Floats, shown: Bools) -> tuple[_Nearest, _Nearest]:
    """The same as `nearest_edges` for the ink of a drawing, and for the shown parts of the edges alone.

    shown : (e, n) bool, which of n equal parts of each edge are

    Any line through a blot runs on the ink there.
    """
    squares, t = _squares(view.points, a, span)
    every = _on_ink(view, *_nearest(squares))
    return every, every if shown.all() else _on_ink(view, *_nearest(_of_shown(squares, t, shown)))


def _on_ink(view: View, distance: Floats, edge: Ints) -> _Nearest:
    """With the distances less what any line may run beside the ink."""
    return np.maximum(distance - view.slack, 0.0), edge


def nearest_edges(points: Floats, a: Floats, span: Floats, shown: Bools | None = None) -> _Nearest:
    """(k,) distance of each point to the nearest shown part of an edge, pixels, and (k,) that edge.

    a, span : (e, 2) float, where each edge begins and the way to its end
    shown   : (e, n) bool, which of n equal parts of each edge are shown; None: all
    """
    squares, t = _squares(points, a, span)
    return _nearest(squares if shown is None else _of_shown(squares, t, shown))


def _of_shown(squares: NDArray[np.float32], t: NDArray[np.float32], shown: Bools) -> NDArray[np.float32]:
    """The squares, made infinite in place where the nearest place of an edge is not shown."""
    n = shown.shape[1]
    part = np.minimum((t * n).astype(np.intp), n - 1) + np.arange(0, shown.size, n)
    squares[~shown.ravel().take(part)] = np.inf
    return squares


def _squares(points: Floats, a: Floats, span: Floats) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """(k, e) squares of the distances of points from edges, and how far along each, 0..1, the nearest place is."""
    (px, py), (ax, ay), (sx, sy) = (both.T.astype(np.float32) for both in (points, a, span))
    dx, dy = px[:, None] - ax, py[:, None] - ay
    t = dx * sx
    t += dy * sy
    t /= sx * sx + sy * sy + np.float32(1e-9)
    np.minimum(np.maximum(t, 0.0, out=t), 1.0, out=t)
    dx -= t * sx
    dy -= t * sy
    dx *= dx
    dy *= dy
    dx += dy
    return dx, t


def _nearest(squares: NDArray[np.float32]) -> _Nearest:
    """The least of the squares (k, e) of each point's distances."""
    nearest = squares.argmin(axis=1)
    return np.sqrt(squares[np.arange(len(squares)), nearest]).astype(float), nearest


def map_price(numbers: int, off: Floats, noise: float, digit: float, size: float) -> float:
    """Nats for a plane map of so many numbers, and for what misses it: off (k,), pixels."""
    return numbers * digit + float(np.minimum(0.5 * (off / _slack(noise, size)) ** 2, 2 * digit).sum())


def _slack(noise: float, size: float) -> float:
    """Pixels by which a hand of this noise misses a plane map."""
    return 1.5 * noise + CARELESS * size


def with_hidden(rings: Rings, drawn: Bools, energy: Energy, size: float) -> Rings:
    """The rings with the hidden back vertices where the plane map of the energy has them.

    drawn : (m,) bool, back vertices that ink shows
    size  : of the drawing, pixels
    """
    v, m = rings.vertices, len(drawn)
    if drawn.all() or np.count_nonzero(drawn) < LEAST_DRAWN:
        return rings
    maps = [
        (map_price(p, np.hypot(*o.T), energy.noise, energy.digit, size), h) for p, h, o in _maps(v[:m], v[m:], drawn)
    ]
    placed = homology.apply(min(maps, key=lambda told: told[0])[1], v[:m][~drawn])
    if not np.isfinite(placed).all():
        return rings
    v[m:][~drawn] = placed
    return split(v, rings.sizes)


def _misses(front: Floats, back: Floats, drawn: Bools, view: View) -> tuple[tuple[int, Floats], ...]:
    """See `Comparison.misses`; no richer map where one misses less, under any hand, than one more number costs."""
    told: list[tuple[int, Floats]] = []
    for numbers, _, misses in _maps(front, back, drawn):
        off = np.hypot(misses[:, 0], misses[:, 1])
        told.append((numbers, off))
        if 0.5 * float(((off / _slack(view.noises[0], view.size)) ** 2).sum()) < LEAST_DIGIT:
            break
    return tuple(told)


def _maps(front: Floats, back: Floats, drawn: Bools) -> Iterator[tuple[int, Floats, Floats]]:
    """Plane maps: their numbers, they themselves, and by how much the drawn back vertices miss them (k, 2), pixels."""
    seen = drawn if drawn.sum() >= LEAST_DRAWN else np.ones(len(front), bool)
    src, dst = front[seen], back[seen]
    for numbers, h in zip((2, 3, 5), map_fits(src, dst), strict=False):
        off = homology.apply(h, src) - dst
        if np.isfinite(off).all():
            yield numbers, h, off
