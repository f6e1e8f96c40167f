"""Pieces: the lines and arcs that a ring is made of.

All circles of an object's faces are seen as ellipses of one shape: drawn out along one direction, they are circles
again. In that frame a ring is cut into lines and arcs so that telling it takes the fewest nats (minimum description
length; the best cut by dynamic programming, as in J.-C. Perez and E. Vidal, "Optimum polygonal approximation of
digitized curves", Pattern Recognition Letters 1994). How far the frame has to be drawn out, the arcs say themselves.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product
from typing import NamedTuple

import cv2
import numpy as np

from sketch2shape.geometry import cross
from sketch2shape.model import Bools, Floats, Ints
from sketch2shape.sweeps.outlines import Circle, Frame, Outline

LEAST_RATIO, MOST_RATIO = 0.08, 1.15
"""Short over long axis of circles as seen, of such as can be told; a hand makes more than 1 of 1."""
NOISES = (0.5, 1.0, 2.0, 4.0)
"""Standard deviations of the hand that are tried, over the finest."""
FINEST, PEN_NOISE = 0.5, 0.05
"""Noise of a ruled line, pixels, and what a thick pen adds, as a fraction of its width."""
CORRELATED = (0.02, 0.08)
"""Fractions of the ring's size over which a line strays in one way: a ruled one, and a hand's."""
MOST_BREAKS = 72
"""Places at which a ring may be cut."""
LEAST_SWEEP, MOST_SWEEP = 0.35, 6.0
"""Angles of an arc as seen, radians: less is a bent line, more is a whole circle."""
ABOUT, FACE_ON = 0.012, 0.03
"""Rms misfit over the size with which a ring may still be an ellipse, and how near to 1 its ratio is a circle's."""
FAR_JOINT = 0.15
"""Fraction of the ring's size up to which a joint may lie from where the ring was cut."""
TANGENT = 0.3
"""Radians between a line and an arc up to which they may run into each other smoothly."""


class Cut(NamedTuple):
    """A ring cut into pieces.

    outline : in the picture
    frame   : of its circles
    cost    : nats
    """

    outline: Outline
    frame: Frame
    cost: float


FREE_ARC, TANGENT_ARC = 3, 1
"""Numbers that tell an arc and the vertex it begins at: by themselves, and between two lines it runs into."""


def cut_ring(ring: Floats, along: Floats, pen: float, hints: tuple[float, ...] = ()) -> Iterator[Cut]:
    """The cheapest ways to tell a ring by lines and arcs, for ruled lines and a hand's, where arcs are dear or cheap.

    ring  : (k, 2) float, pixels, closed, about one pixel apart
    along : (2,) float of unit length, the direction in which circles are seen shortened
    pen   : pixels
    hints : ratios of ellipses that the drawing shows elsewhere

    An arc between two lines that it is tangent to takes one number, any other three.
    """
    cuts: list[Cut] = []
    every = _Runs.of(ring, along, pen)
    if (round_ := every.ellipse()) is not None:
        frame = Frame(along, float(round_.ratios[0]))
        cuts.append(Cut(_outlined(ring, round_, frame, every), frame, round_.cost))
        yield cuts[0]
    for correlated, numbers in product(CORRELATED, (FREE_ARC, TANGENT_ARC)):
        runs = replace(every, correlated=correlated)
        free = runs.best(None, numbers)
        some = dict.fromkeys(round(float(r), 3) for r in (*hints, 1.0, *free.ratios) if LEAST_RATIO < r < MOST_RATIO)
        best, ratio = min(((runs.best(r, numbers), r) for r in some), key=lambda t: t[0].cost)
        frame = Frame(along, ratio)
        outline = _outlined(ring, best, frame, runs)
        if len(best.breaks) > 1 and (turn := outline.turns)[0] < TANGENT:
            # a ring begun in the midst of a piece has it twice
            other = int(turn.argmax()) if turn.max() > TANGENT else len(turn) // 2
            again = runs.turned(int(best.breaks[other]))
            better = again.best(ratio, numbers)
            if better.cost < best.cost:
                best, outline = better, _outlined(ring, better, frame, again)
        if not any(_is_alike(outline, cut.outline) for cut in cuts):
            cuts.append(Cut(outline, frame, best.cost))
            yield cuts[-1]


def rounded(ring: Floats, frame: Frame) -> Outline:
    """The circle of a frame that is nearest to a closed line (k, 2), pixels."""
    none = np.zeros(0)
    return Outline(frame, np.zeros((0, 2)), none, none.astype(np.bool_), _circle_of(frame.flat(ring)))


def _is_alike(a: Outline, b: Outline) -> bool:
    return np.array_equal(a.curved, b.curved) and np.array_equal(a.smooth, b.smooth)


class _Told(NamedTuple):
    """One way to tell a ring.

    breaks : (n,) int, points at which pieces begin; none for a whole ellipse
    curved : (n,) bool
    ratios : (m,) float, of the arcs
    cost   : nats
    """

    breaks: Ints
    curved: Bools
    ratios: Floats
    cost: float


@dataclass(frozen=True, eq=False)
class _Runs:
    """All runs of a ring from one possible break to another.

    points : (k, 2) float, pixels along and across the frame's direction
    breaks : (b,) int, points at which the ring may be cut, the sharpest corner first
    sums   : (2k + 1, 13) running sums of products over the points, twice round
    pen    : pixels
    correlated : fraction of its size over which the line strays in one way
    """

    points: Floats
    breaks: Ints
    sums: Floats
    pen: float
    correlated: float = CORRELATED[0]

    @classmethod
    def of(cls, ring: Floats, along: Floats, pen: float) -> _Runs:
        """The runs of a ring of the picture."""
        across = np.array([-along[1], along[0]])
        points = np.stack([ring @ along, ring @ across], axis=1)
        points = points - points.mean(axis=0)
        return cls(points, _breaks(ring), _running_sums(points), pen)

    @property
    def size(self) -> float:
        """Diagonal, pixels."""
        return float(np.hypot(*np.ptp(self.points, axis=0)))

    def ellipse(self) -> _Told | None:
        """As one ellipse, if it is about one."""
        misfit, ratios, _ = _conics(self.sums[[len(self.points)]] - self.sums[[0]], None)
        off = float(np.sqrt(misfit[0] / len(self.points)))
        if off > ABOUT * self.size or not LEAST_RATIO < ratios[0] < 1 / LEAST_RATIO:
            return None
        ratio = 1.0 if abs(ratios[0] - 1.0) < FACE_ON else float(ratios[0])
        return min(self._whole(NOISES[0], ratio), key=lambda t: t.cost, default=None)

    def turned(self, first: int) -> _Runs:
        """The same with the ring begun at another break."""
        k = len(self.points)
        breaks = np.sort(self.breaks % k)
        at = int(np.searchsorted(breaks, first % k))
        return replace(self, breaks=np.concatenate([breaks[at:], breaks[:at] + k]))

    def best(self, ratio: float | None, numbers: int) -> _Told:
        """The cheapest way with circles of this ratio, or each of its own; an arc takes so many numbers."""
        n, k = len(self.breaks), len(self.points)
        ends = np.append(self.breaks, self.breaks[0] + k)
        i, j = np.triu_indices(n + 1, 1)
        first, last = ends[i], ends[j]
        trim = np.minimum(int(1 + 0.5 * self.pen), (last - first) // 4)
        sums = self.sums[last - trim] - self.sums[first + trim]
        line, (conic, ratios, sweep) = _line_misfit(sums), _conics(sums, ratio)
        turned = (last - first) / np.maximum(sweep, 1e-9)
        arc = np.where((turned > LEAST_SWEEP) & (turned < MOST_SWEEP) & np.isfinite(ratios), conic, np.inf)
        price = numbers + (ratio is None)
        told = [self._cheapest(noise, i, j, line, arc, ratios, price) for noise in NOISES]
        told += [t for noise in NOISES for t in self._whole(noise, ratio)]
        return min(told, key=lambda t: t.cost)

    def _prices(self, noise: float) -> tuple[float, float, float]:
        """Noise in pixels, nats of a number, and pixels over which the line strays in one way."""
        sigma = noise * (FINEST + PEN_NOISE * self.pen)
        return sigma, float(np.log(max(self.size / sigma, 2.0))), max(self.pen, self.correlated * self.size)

    def _cheapest(
        self, noise: float, i: Ints, j: Ints, line: Floats, arc: Floats, ratios: Floats, numbers: int
    ) -> _Told:
        sigma, digit, correlated = self._prices(noise)
        straight = 2 * digit + 0.5 * line / (sigma * sigma * correlated)
        bent = numbers * digit + 0.5 * arc / (sigma * sigma * correlated)
        cost, n = np.minimum(straight, bent), len(self.breaks)
        table = np.full((n + 1, n + 1), np.inf)
        table[i, j] = cost
        if n > 1:
            table[0, n] = np.inf  # one piece all round is no ring
        least, before = np.zeros(n + 1), np.zeros(n + 1, np.intp)
        for end in range(1, n + 1):
            ways = least[:end] + table[:end, end]
            before[end] = ways.argmin()
            least[end] = ways[before[end]]
        chain = [n]
        while chain[-1] > 0:
            chain.append(int(before[chain[-1]]))
        chain = chain[::-1]
        number = np.zeros((n + 1, n + 1), np.intp)
        number[i, j] = np.arange(len(i))
        own = number[chain[:-1], chain[1:]]
        curved = bent[own] < straight[own]
        spread = len(self.points) * float(np.log(noise)) / correlated
        return _Told(self.breaks[chain[:-1]], curved, ratios[own][curved], float(least[n]) + spread)

    def _whole(self, noise: float, ratio: float | None) -> list[_Told]:
        """As one ellipse."""
        sigma, digit, correlated = self._prices(noise)
        misfit, ratios, _ = _conics(self.sums[[len(self.points)]] - self.sums[[0]], ratio)
        if not np.isfinite(ratios[0]):
            return []
        cost = (4 if ratio is None else 3) * digit + 0.5 * float(misfit[0]) / (sigma * sigma * correlated)
        spread = len(self.points) * float(np.log(noise)) / correlated
        return [_Told(np.zeros(0, np.intp), np.ones(1, np.bool_), ratios, cost + spread)]


def _breaks(ring: Floats) -> Ints:
    """Points at which a ring may turn or begin to bend, the sharpest corner first, then round the ring."""
    closed = ring.astype(np.float32)[:, None]
    tolerance = 0.8
    while True:
        bends = cv2.approxPolyDP(closed, tolerance, True)[:, 0]
        if len(bends) <= MOST_BREAKS:
            break
        tolerance *= 1.3
    place = np.sort(np.linalg.norm(ring[:, None] - bends[None], axis=2).argmin(axis=0))
    place = np.unique(place)
    v = ring[place]
    before, after = v - np.roll(v, 1, axis=0), np.roll(v, -1, axis=0) - v
    turn = np.abs(np.arctan2(cross(before, after), (before * after).sum(axis=1)))
    reach = np.minimum(np.hypot(*before.T), np.hypot(*after.T))
    first = int((turn * np.minimum(reach, 12.0)).argmax())
    return np.concatenate([place[first:], place[:first] + len(ring)])


def _running_sums(points: Floats) -> Floats:
    x, y = np.concatenate([points, points]).T
    columns = [np.ones_like(x), x, y, x * x, x * y, y * y, x**3, x * x * y, x * y * y, y**3]
    columns += [x**4, x * x * y * y, y**4]
    table = np.zeros((len(x) + 1, len(columns)))
    np.cumsum(np.stack(columns, axis=1), axis=0, out=table[1:])
    return table


def _line_misfit(s: Floats) -> Floats:
    """(r,) sum of the squared distances to the best line."""
    n = np.maximum(s[:, 0], 1e-9)
    xx, xy, yy = s[:, 3] - s[:, 1] ** 2 / n, s[:, 4] - s[:, 1] * s[:, 2] / n, s[:, 5] - s[:, 2] ** 2 / n
    return np.asarray(np.maximum(0.5 * (xx + yy) - np.sqrt(0.25 * (xx - yy) ** 2 + xy * xy), 0.0))


def _conics(s: Floats, ratio: float | None) -> tuple[Floats, Floats, Floats]:
    """Best ellipses a x x + y y + d x + e y + f = 0 through runs with these sums (r, 13), a given by a ratio or free.

    Returns (r,) sum of squared distances, (r,) ratios (nan: no ellipse), (r,) mean radius as seen, pixels.
    """
    if ratio is None:
        matrix = np.stack([s[:, [10, 6, 7, 3]], s[:, [6, 3, 4, 1]], s[:, [7, 4, 5, 2]], s[:, [3, 1, 2, 0]]], axis=1)
        right = -np.stack([s[:, 11], s[:, 8], s[:, 9], s[:, 5]], axis=1)
        constant = s[:, 12]
    else:
        a0 = ratio**-2
        matrix = np.stack([s[:, [3, 4, 1]], s[:, [4, 5, 2]], s[:, [1, 2, 0]]], axis=1)
        right = -np.stack([a0 * s[:, 6] + s[:, 8], a0 * s[:, 7] + s[:, 9], a0 * s[:, 3] + s[:, 5]], axis=1)
        constant = s[:, 12] + 2 * a0 * s[:, 11] + a0 * a0 * s[:, 10]
    diagonal = np.einsum("rii->ri", matrix)
    solved = np.linalg.solve(
        matrix + 1e-9 * diagonal[:, :, None] * np.eye(matrix.shape[1]) + 1e-12 * np.eye(matrix.shape[1]),
        right[..., None],
    )[..., 0]
    a = solved[:, 0] if ratio is None else np.full(len(s), a0)
    d, e, f = solved[:, -3:].T
    algebraic = np.maximum(constant - (right * solved).sum(axis=1), 0.0)
    slope = (
        4 * a * a * s[:, 3] + 4 * a * d * s[:, 1] + d * d * s[:, 0] + 4 * s[:, 5] + 4 * e * s[:, 2] + e * e * s[:, 0]
    )
    with np.errstate(invalid="ignore", divide="ignore"):
        ratios = np.where(a > 0, 1.0 / np.sqrt(np.maximum(a, 1e-12)), np.nan)
        square = d * d / (4 * a) + 0.25 * e * e - f
        radius = np.sqrt(np.maximum(square, 1e-9) * np.minimum(ratios, 1.0))
    ratios = np.where((square > 1.0) & (ratios > LEAST_RATIO) & (ratios < 1 / LEAST_RATIO), ratios, np.nan)
    return algebraic / np.maximum(slope / np.maximum(s[:, 0], 1.0), 1e-9), ratios, radius


class _Straight(NamedTuple):
    point: Floats
    direction: Floats


def _outlined(ring: Floats, told: _Told, frame: Frame, runs: _Runs) -> Outline:
    """The ring with its vertices where its pieces meet."""
    flat = frame.flat(ring)
    if not len(told.breaks):
        return rounded(ring, frame)
    n, k = len(told.breaks), len(ring)
    shapes, middles = [], []
    for m in range(n):
        first = int(told.breaks[m])
        count = (int(told.breaks[(m + 1) % n]) - first) % k or k
        trim = min(int(1 + 0.5 * runs.pen), count // 4)
        own = flat[(first + np.arange(trim, count - trim + 1)) % k]
        shapes.append(_circle_of(own) if told.curved[m] else _line_of(own))
        middles.append(flat[(first + count // 2) % k])
    breaks = flat[told.breaks % k]
    joints = [_joint(shapes[m - 1], shapes[m], breaks[m]) for m in range(n)]
    corners = np.array([p for p, _ in joints])
    long = np.hypot(*(np.roll(breaks, -1, axis=0) - breaks).T)
    # lines and arcs of a short piece are told by few points, and meet anywhere
    reach = np.minimum(FAR_JOINT * float(np.hypot(*np.ptp(flat, axis=0))), 0.5 * np.minimum(long, np.roll(long, 1)))
    far = np.hypot(*(corners - breaks).T) > reach
    corners[far] = breaks[far]
    smooth = np.array([is_smooth for _, is_smooth in joints], np.bool_) & ~far
    bulges = [
        _bulge(corners[m], corners[(m + 1) % n], shape, middles[m]) if isinstance(shape, Circle) else 0.0
        for m, shape in enumerate(shapes)
    ]
    return Outline(frame, frame.seen(corners), np.array(bulges), smooth)


def _circle_of(p: Floats) -> Circle:
    middle = p.mean(axis=0)
    q = p - middle
    solved = np.linalg.lstsq(np.c_[q, np.ones(len(q))], -(q * q).sum(axis=1), rcond=None)[0]
    centre = -0.5 * solved[:2]
    return Circle(centre + middle, float(np.sqrt(max(centre @ centre - solved[2], 1e-9))))


def _line_of(p: Floats) -> _Straight:
    middle = p.mean(axis=0)
    return _Straight(middle, np.linalg.svd(p - middle, full_matrices=False)[2][0])


def _joint(before: Circle | _Straight, after: Circle | _Straight, near: Floats) -> tuple[Floats, bool]:
    """Where two pieces meet, near a point, and whether they run into each other smoothly."""
    if isinstance(before, Circle):
        return _circles_meet(before, after, near) if isinstance(after, Circle) else _line_meets(after, before, near)
    return _line_meets(before, after, near) if isinstance(after, Circle) else _lines_meet(before, after)


def _lines_meet(a: _Straight, b: _Straight) -> tuple[Floats, bool]:
    det = float(cross(a.direction, b.direction))
    t = float(cross(b.point - a.point, b.direction)) / (det or 1e-9)
    return a.point + t * a.direction, False


def _line_meets(line: _Straight, circle: Circle, near: Floats) -> tuple[Floats, bool]:
    foot = line.point + ((circle.centre - line.point) @ line.direction) * line.direction
    off = float(np.hypot(*(circle.centre - foot)))
    if off >= circle.radius * np.cos(TANGENT):
        return foot, True
    half = np.sqrt(circle.radius**2 - off * off)
    ways = foot + np.array([[half], [-half]]) * line.direction
    return ways[np.hypot(*(ways - near).T).argmin()], False


def _circles_meet(a: Circle, b: Circle, near: Floats) -> tuple[Floats, bool]:
    between = b.centre - a.centre
    apart = float(np.hypot(*between)) + 1e-9
    u = between / apart
    x = (apart * apart + a.radius**2 - b.radius**2) / (2 * apart)
    if abs(x) >= a.radius * np.cos(0.5 * TANGENT):
        return a.centre + np.sign(x) * a.radius * u, True
    half = np.sqrt(max(a.radius**2 - x * x, 0.0))
    ways = a.centre + x * u + np.array([[half], [-half]]) * np.array([-u[1], u[0]])
    return ways[np.hypot(*(ways - near).T).argmin()], False


def _bulge(a: Floats, b: Floats, circle: Circle, middle: Floats) -> float:
    """Of the arc from a to b that is nearest to a circle, on the side of a point of it."""
    chord = b - a
    half = 0.5 * float(np.hypot(*chord)) + 1e-9
    normal = np.array([-chord[1], chord[0]]) / (2 * half)
    mid = 0.5 * (a + b)
    side = 1.0 if (middle - mid) @ normal > 0 else -1.0
    turn = float(np.arctan2(half, -side * float((circle.centre - mid) @ normal)))
    return 0.0 if turn > 0.5 * MOST_SWEEP else side * float(np.tan(0.5 * turn))
